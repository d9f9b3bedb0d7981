{-# LANGUAGE BangPatterns #-}

-- | A light path in its plane, cut into cells of swept angle.
--
-- In the middle of each cell the inverse radius @u = 1\/r@ and its slope are known;
-- from there the path's differential equation continues them ('expand').
-- "BlackHole.Spacetime.Schwarzschild.TablePath" follows light along such paths.
module BlackHole.Spacetime.Schwarzschild.OrbitSeries
  ( OrbitSeries (..),
    Waypoints (..),
    seriesSpacing,
    waypoint,
    orbitSeries,
    lineSeries,

    -- * Around a waypoint
    Expansion (..),
    expand,
    expansionValue,
    expansionSlope,
  )
where

import BlackHole.Spacetime.Fate
import BlackHole.Spacetime.Schwarzschild.Orbit
import BlackHole.Vector.XY (XY (..))
import Data.Primitive.PrimArray (PrimArray, indexPrimArray)

-- | A path from its start to its end. Angles are in radians from the start.
data OrbitSeries = OrbitSeries
  { seriesFate :: !(Fate XY),
    -- | The angle swept up to the end, at least 0; some angle for a path without end.
    seriesAngle :: {-# UNPACK #-} !Double,
    -- | The number of cells of equal angle, at least 1.
    seriesCells :: {-# UNPACK #-} !Int,
    seriesWaypoints :: !Waypoints
  }

-- | The source of the values in the middles of the cells.
data Waypoints
  = -- | Two rows of a table of neighbouring paths, and the weights of Hermite's
    -- interpolation between them.
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
  | -- | A straight line; u and du/dφ at its start.
    OfLine {-# UNPACK #-} !Double {-# UNPACK #-} !Double

-- | The angle of one cell in radians.
seriesSpacing :: OrbitSeries -> Double
seriesSpacing series = seriesAngle series / fromIntegral (seriesCells series)
{-# INLINE seriesSpacing #-}

-- | @u@ and @du\/dφ@ in the middle of a cell, from the angle of a cell and the number
-- of the cell, counted from 0.
waypoint :: Waypoints -> Double -> Int -> (Double, Double)
waypoint source !spacing !cell = case source of
  BetweenRows table row row' v0 d0 v1 d1 ->
    let at k = indexPrimArray table (row + 4 * cell + k)
        at' k = indexPrimArray table (row' + 4 * cell + k)
        mixed k = v0 * at k + d0 * at (k + 1) + v1 * at' k + d1 * at' (k + 1)
     in -- The table holds the slope per cell, which stays finite for light that falls
        -- straight in.
        (mixed 0, mixed 2 / spacing)
  OfOrbit path -> orbitInverseRadiusAndSlope path ((fromIntegral cell + 0.5) * spacing)
  OfLine u slope ->
    let angle = (fromIntegral cell + 0.5) * spacing
        c = cos angle
        s = sin angle
     in (u * c + slope * s, slope * c - u * s)
{-# NOINLINE waypoint #-}

-- | The widest cell in radians. The nearest singularity of a path is about two radians
-- away, so the terms omitted from 'Expansion' are below 1e-9.
widestCell :: Double
widestCell = 0.4

-- | The path of an orbit in closed form.
orbitSeries :: Orbit -> OrbitSeries
orbitSeries path =
  OrbitSeries (orbitFate path) angle (max 2 (ceiling (angle / widestCell))) (OfOrbit path)
  where
    angle
      | isInfinite (orbitSweep path) = 100
      | otherwise = orbitSweep path

-- | The straight line that passes the centre at the distance @b@, from the inverse
-- radius and slope at its start. It ends on the black ball of radius one if it hits it.
lineSeries :: Double -> Double -> OrbitSeries
lineSeries u slope
  | meets = series Captured (angleAt 1)
  | otherwise = series (Escaped (XY (cos leaving) (sin leaving))) leaving
  where
    steepest = sqrt (u * u + slope * slope)
    -- u = steepest · sin(φ + start).
    start = atan2 u slope
    meets = slope > 0 && steepest > 1
    angleAt v = asin (min 1 (v / steepest)) - start
    leaving = pi - start
    series end angle = OrbitSeries end angle (max 2 (ceiling (angle / widestCell))) (OfLine u slope)

-- | A power series of a path in the angle from a waypoint.
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

-- | @expand pull u slope@ is the solution of @u'' = pull u² − u@ with the given values
-- at the waypoint. The pull is 3\/2 around a hole and 0 in empty space. The
-- coefficients follow by comparing powers.
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
  c1 + t
    * ( 2 * c2
          + t * (3 * c3 + t * (4 * c4 + t * (5 * c5 + t * (6 * c6 + t * (7 * c7 + t * (8 * c8))))))
      )
{-# INLINE expansionSlope #-}
