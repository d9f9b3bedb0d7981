{-# LANGUAGE BangPatterns #-}

-- | Where a light path in its plane passes through the layer of gas around the disk's
-- plane, and how finely it is sampled there. Angles are swept angles, in radians, and a
-- path is given by its power series ("BlackHole.Spacetime.Schwarzschild.OrbitSeries").
module BlackHole.Spacetime.Schwarzschild.GasLayer
  ( GasLayer (..),
    gasLayer,
    steepest,
    growthAt,
    arcSine,
    Reach (..),
    reachOfCrossing,
    CellPart (..),
    partOfCell,
  )
where

import BlackHole.Spacetime.LightPath
import BlackHole.Spacetime.Schwarzschild.OrbitSeries

-- | A region prepared for paths given by their inverse radius @u@.
data GasLayer = GasLayer
  { layerHeight :: {-# UNPACK #-} !Double,
    layerFlare :: {-# UNPACK #-} !Double,
    -- | @u@ at the outer and the inner radius.
    layerOuter :: {-# UNPACK #-} !Double,
    layerInner :: {-# UNPACK #-} !Double,
    layerLongest :: {-# UNPACK #-} !Double,
    layerVertical :: {-# UNPACK #-} !Double,
    -- | The inverse of 'regionCore'.
    layerCore :: {-# UNPACK #-} !Double
  }

-- | The layer of a region.
gasLayer :: Region -> GasLayer
gasLayer region =
  GasLayer
    { layerHeight = regionHalfHeight region,
      layerFlare = regionFlare region,
      layerOuter = 1 / regionRadius region,
      layerInner = 1 / max 1e-3 (regionInnerRadius region),
      layerLongest = regionLongestStep region,
      layerVertical = regionVerticalStep region,
      layerCore = 1 / regionCore region
    }
{-# INLINE gasLayer #-}

-- | The greatest sine of the gas's latitude at an inverse radius.
steepest :: GasLayer -> Double -> Double
steepest layer u = layerHeight layer * u + layerFlare layer
{-# INLINE steepest #-}

-- | How much longer a segment may be at this inverse radius and sine of the latitude than
-- in the core: far from the plane the gas varies slowly.
growthAt :: GasLayer -> Double -> Double -> Double
growthAt layer u sineLatitude =
  max 1 (min (layerCore layer) (abs sineLatitude * layerCore layer / steepest layer u))
{-# INLINE growthAt #-}

-- | The number of segments per radian for which neither the length of a segment exceeds
-- the region's fraction of the radius nor its climb that of the half height; from @u@,
-- its slope, the sine of the latitude and its slope.
segmentsPerRadian :: GasLayer -> Double -> Double -> Double -> Double -> Double
segmentsPerRadian layer u slope sineLatitude climbing =
  max
    (sqrt (slope * slope + u * u) / (layerLongest layer * u))
    ( abs (climbing * room - sineLatitude * layerHeight layer * slope)
        / (layerVertical layer * room * room)
    )
  where
    room = steepest layer u
{-# INLINE segmentsPerRadian #-}

-- | How far the gas reaches before and after a crossing of the plane.
data Reach
  = -- | The path crosses the plane outside the gas's radii.
    NoReach
  | Reach
      {-# UNPACK #-} !Double
      {-# UNPACK #-} !Double

-- | @reachOfCrossing layer tilt widest path offset@ is the reach of the crossing at an
-- offset from a path's waypoint. The tilt is the sine of the angle between the plane of
-- the path and the disk's, and nothing reaches farther than @widest@.
reachOfCrossing :: GasLayer -> Double -> Double -> Expansion -> Double -> Reach
reachOfCrossing layer tilt widest path offset
  | v + reachable < layerOuter layer || v - reachable > layerInner layer = NoReach
  -- The ends follow from the radius found there where the gas's height depends on the
  -- radius, unless it varies so much in between that one evaluation proves nothing.
  | layerHeight layer <= 0 || widest > 0.2 || layerHeight layer * abs slope > 0.25 * tilt =
    Reach widest widest
  | otherwise = Reach (refined (negate half)) (refined half)
  where
    !v = expansionValue path offset
    !slope = expansionSlope path offset
    !reachable = 1.5 * abs slope * widest
    half = min widest (arcSine (steepest layer v / tilt))
    refined side =
      min widest (arcSine (steepest layer (max 0 (expansionValue path (offset + side))) / tilt))
{-# INLINE reachOfCrossing #-}

-- | The part of a cell in which the path can be in the gas.
data CellPart
  = Missed
  | -- | The offsets from the waypoint at which to begin and to end, the one at which the
    -- path leaves the gas or the cell, and the length of a step.
    CellPart
      {-# UNPACK #-} !Double
      {-# UNPACK #-} !Double
      {-# UNPACK #-} !Double
      {-# UNPACK #-} !Double

-- | @partOfCell layer path latitude climb t0 t1@ is the part between two offsets from a
-- path's waypoint, at which the sine of the latitude and its slope are the given ones.
partOfCell :: GasLayer -> Expansion -> Double -> Double -> Double -> Double -> CellPart
partOfCell layer path latitude0 climb0 t0 t1
  | highest < uOuter || min u0 u1 > layerInner layer || far || missed = Missed
  | otherwise = CellPart begin final leaving turn
  where
    uOuter = layerOuter layer
    !u0 = expansionValue path t0
    !u1 = expansionValue path t1
    !slope0 = expansionSlope path t0
    !slope1 = expansionSlope path t1
    highest
      | slope0 > 0 && slope1 < 0 = min (u0 + slope0 * (t1 - t0)) (u1 - slope1 * (t1 - t0))
      | otherwise = max u0 u1
    -- Where the path enters and leaves the gas's outer radius, if within the cell.
    -- Newton's steps may end anywhere if the path only just fails to reach it.
    begin = if u0 < uOuter && slope0 > 0 then within t0 t1 (reaching t0) else t0
    leaving = if u1 < uOuter && slope1 < 0 then within begin t1 (reaching t1) else t1
    final = ofOneScale path begin leaving
    -- Where the path turns back just outside the gas, Newton's steps find nothing.
    missed = u0 < uOuter && slope0 > 0 && expansionValue path begin < 0.98 * uOuter
    -- Whether the path is above or below the gas all the time. The series of the latitude
    -- is accurate to a few thousandths.
    far =
      abs (latitude t0) `min` abs (latitude t1) > steepest layer highest + 0.003
        && latitude t0 * latitude t1 > 0
    latitude t = latitude0 + t * (climb0 - 0.5 * t * latitude0)
    climb t = climb0 - t * latitude0
    -- The length of a step varies little within a cell. Computing it for each step would
    -- make each step wait for the previous one.
    turn = 2 / (rate begin + rate final)
    rate t =
      segmentsPerRadian layer (expansionValue path t) (expansionSlope path t) (latitude t) (climb t)
    -- The curve is concave there, so Newton's steps never overshoot.
    reaching t = step (step (step t))
    step x = x + (uOuter - expansionValue path x) / expansionSlope path x
    within low high t
      | t > low = if t < high then t else high
      | otherwise = low
{-# INLINE partOfCell #-}

-- | The end of the part of a cell in which the radius changes by less than a factor of
-- eight, so that one step length suits all of it.
ofOneScale :: Expansion -> Double -> Double -> Double
ofOneScale path begin end
  | min u0 u1 * 8 < max u0 u1 && end - begin > 1e-9 = ofOneScale path begin (0.5 * (begin + end))
  | otherwise = end
  where
    u0 = expansionValue path begin
    u1 = expansionValue path end

-- | The arc sine on [0, 1]. Most arguments are small.
arcSine :: Double -> Double
arcSine x
  | x < 0.15 = x * (1 + x2 * (1 / 6 + x2 * (3 / 40 + x2 * (15 / 336))))
  | otherwise = asin (min 1 x)
  where
    x2 = x * x
{-# INLINE arcSine #-}
