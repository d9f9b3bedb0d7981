{-# LANGUAGE BangPatterns #-}

-- | One light path in its plane, cut into cells of swept angle: how
-- "BlackHole.Physics.SweptPath" gets at the inverse radius @u = 1\/r@.
--
-- In the middle of each cell the path knows @u@ and its slope; from there the
-- path's own differential equation continues it ('expand').
module BlackHole.Physics.Sweep
  ( Sweep (..),
    SweepEnd (..),
    Waypoints (..),
    sweepSpacing,
    waypoint,
    orbitSweep,
    lineSweep,

    -- * Around a waypoint
    Expansion (..),
    expand,
    expansionValue,
    expansionSlope,
  )
where

import BlackHole.Physics.Orbit
import Data.Primitive.PrimArray (PrimArray, indexPrimArray)

-- | A path from its start to its end. Angles in radians, counted from the
-- start.
data Sweep = Sweep
  { sweepEnd :: !SweepEnd,
    -- | The angle swept up to the end, at least 0.
    sweepAngle :: {-# UNPACK #-} !Double,
    -- | Into how many cells of equal angle it is cut, at least 1.
    sweepCells :: {-# UNPACK #-} !Int,
    sweepWaypoints :: !Waypoints
  }

-- | Where a path ends.
data SweepEnd
  = -- | At infinity: cosine and sine of the swept angle.
    Leaves {-# UNPACK #-} !Double {-# UNPACK #-} !Double
  | -- | At the horizon.
    FallsIn
  | -- | Nowhere: only for a start that is critical in every bit.
    CirclesOn

-- | Where the values in the middles of the cells come from.
data Waypoints
  = -- | Two rows of a table of neighbouring paths and the weights of
    -- Hermite's interpolation between them.
    BetweenRows
      !(PrimArray Double)
      {-# UNPACK #-} !Int -- first waypoint of the one row
      {-# UNPACK #-} !Int -- first waypoint of the other
      {-# UNPACK #-} !Double
      {-# UNPACK #-} !Double
      {-# UNPACK #-} !Double
      {-# UNPACK #-} !Double
  | -- | The closed form.
    OfOrbit !Orbit
  | -- | A straight line: u and du/dφ at its start.
    OfLine {-# UNPACK #-} !Double {-# UNPACK #-} !Double

-- | The angle of one cell.
sweepSpacing :: Sweep -> Double
sweepSpacing sweep = sweepAngle sweep / fromIntegral (sweepCells sweep)
{-# INLINE sweepSpacing #-}

-- | @u@ and @du\/dφ@ in the middle of a cell, given the angle of a cell and the
-- cell's number, from 0 to the number of cells less one.
waypoint :: Waypoints -> Double -> Int -> (Double, Double)
waypoint source !spacing !cell = case source of
  BetweenRows table row row' v0 d0 v1 d1 ->
    let at k = indexPrimArray table (row + 4 * cell + k)
        at' k = indexPrimArray table (row' + 4 * cell + k)
        mixed k = v0 * at k + d0 * at (k + 1) + v1 * at' k + d1 * at' (k + 1)
     in -- The table holds the slope per cell, which stays finite for light
        -- that falls straight in.
        (mixed 0, mixed 2 / spacing)
  OfOrbit path -> orbitInverseRadiusAndSlope path ((fromIntegral cell + 0.5) * spacing)
  OfLine u slope ->
    let angle = (fromIntegral cell + 0.5) * spacing
        c = cos angle
        s = sin angle
     in (u * c + slope * s, slope * c - u * s)
{-# NOINLINE waypoint #-}

-- | The widest cell, in radians. A path's nearest singularity is some two
-- radians away, so that the terms left out of 'Expansion' are below 1e-9.
widestCell :: Double
widestCell = 0.4

-- | A path in closed form.
orbitSweep :: Orbit -> Sweep
orbitSweep path = case orbitFate path of
  Escapes angle -> sweep (Leaves (cos angle) (sin angle)) angle
  Captured angle -> sweep FallsIn angle
  Circles -> sweep CirclesOn 100
  where
    sweep end angle = Sweep end angle (max 2 (ceiling (angle / widestCell))) (OfOrbit path)

-- | A straight line that passes the centre at the distance @b@, from the
-- inverse radius and slope at its start, which ends on the black ball of radius
-- one if it meets it.
lineSweep :: Double -> Double -> Sweep
lineSweep u slope
  | meets = sweep FallsIn (angleAt 1)
  | otherwise = sweep (Leaves (cos leaving) (sin leaving)) leaving
  where
    steepest = sqrt (u * u + slope * slope)
    -- u = steepest · sin(φ + start).
    start = atan2 u slope
    meets = slope > 0 && steepest > 1
    angleAt v = asin (min 1 (v / steepest)) - start
    leaving = pi - start
    sweep end angle = Sweep end angle (max 2 (ceiling (angle / widestCell))) (OfLine u slope)

-- | A path around a waypoint, by powers of the angle from it.
data Expansion
  = Expansion
      {-# UNPACK #-} !Double
      {-# UNPACK #-} !Double
      {-# UNPACK #-} !Double
      {-# UNPACK #-} !Double
      {-# UNPACK #-} !Double
      {-# UNPACK #-} !Double
      {-# UNPACK #-} !Double
      {-# UNPACK #-} !Double
      {-# UNPACK #-} !Double

-- | @expand pull u slope@: the solution of @u'' = pull u² − u@ with these
-- values, where the pull is 3\/2 around a hole and 0 in empty space. The
-- coefficients follow from each other by comparing powers.
expand :: Double -> Double -> Double -> Expansion
expand !pull !u !slope = Expansion c0 c1 c2 c3 c4 c5 c6 c7 c8
  where
    !c0 = u
    !c1 = slope
    !c2 = (pull * (c0 * c0) - c0) * (1 / 2)
    !c3 = (2 * pull * (c0 * c1) - c1) * (1 / 6)
    !c4 = (pull * (2 * c0 * c2 + c1 * c1) - c2) * (1 / 12)
    !c5 = (2 * pull * (c0 * c3 + c1 * c2) - c3) * (1 / 20)
    !c6 = (pull * (2 * (c0 * c4 + c1 * c3) + c2 * c2) - c4) * (1 / 30)
    !c7 = (2 * pull * (c0 * c5 + c1 * c4 + c2 * c3) - c5) * (1 / 42)
    !c8 = (pull * (2 * (c0 * c6 + c1 * c5 + c2 * c4) + c3 * c3) - c6) * (1 / 56)
{-# INLINE expand #-}

-- | @u@ at an angle from the waypoint.
expansionValue :: Expansion -> Double -> Double
expansionValue (Expansion c0 c1 c2 c3 c4 c5 c6 c7 c8) t =
  c0 + t * (c1 + t * (c2 + t * (c3 + t * (c4 + t * (c5 + t * (c6 + t * (c7 + t * c8)))))))
{-# INLINE expansionValue #-}

-- | @du\/dφ@ at an angle from the waypoint.
expansionSlope :: Expansion -> Double -> Double
expansionSlope (Expansion _ c1 c2 c3 c4 c5 c6 c7 c8) t =
  c1 + t * (2 * c2 + t * (3 * c3 + t * (4 * c4 + t * (5 * c5 + t * (6 * c6 + t * (7 * c7 + t * (8 * c8)))))))
{-# INLINE expansionSlope #-}
