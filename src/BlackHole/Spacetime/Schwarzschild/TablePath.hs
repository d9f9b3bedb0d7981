{-# LANGUAGE BangPatterns #-}

-- | Light paths evaluated only where they pass through the gas.
--
-- The plane of a path cuts the disk's plane every half turn, at swept angles that
-- follow from the directions alone. Each of these crossings lies in an interval in
-- which the path can be inside the gas; outside these intervals nothing needs to be
-- evaluated. Within an interval the path is a power series ("BlackHole.Spacetime.Schwarzschild.OrbitSeries").
module BlackHole.Spacetime.Schwarzschild.TablePath
  ( followTable,
    tableFate,
    criticalOffset,
    seriesOf,
  )
where

import BlackHole.Numeric.Angle (arcTangent2)
import BlackHole.Spacetime.Fate
import BlackHole.Spacetime.LightPath
import BlackHole.Spacetime.Photon
import BlackHole.Spacetime.Schwarzschild.LensTable
import BlackHole.Spacetime.Schwarzschild.OrbitSeries
import BlackHole.Spacetime.Types (Spacetime (..), pullOfGravity)
import BlackHole.Vector.XYZ (XYZ (..), (*^), (^+^), (^-^))
import qualified BlackHole.Vector.XYZ as XYZ
import Data.Maybe (fromMaybe)

-- | The path of a photon of unit energy, by its radial and tangential velocity, from
-- the table of its starting point; a straight line without gravity.
seriesOf :: Spacetime -> LensTable -> Double -> Double -> OrbitSeries
seriesOf Flat table radial tangential = lineSeries u (negate radial * u / tangential)
  where
    u = 1 / lensTableRadius table
seriesOf _ table radial tangential = lensSeries table radial tangential
{-# NOINLINE seriesOf #-}

-- | Follows a photon of unit energy ('withUnitEnergy') that starts at the table's
-- radius to its end. The phase, 0 to 1, is the length of the first segment in the gas
-- as a fraction of a whole step. Give neighbouring pixels different phases; otherwise
-- they all sample the gas at the same places.
-- Costs one step per segment of gas and about fifty nanoseconds per crossing.
followTable ::
  Spacetime ->
  LensTable ->
  Region ->
  Double ->
  Photon ->
  (a -> PathSegment -> Continue a) ->
  a ->
  Followed a
followTable space table region phase photon gather = start
  where
    !(Launch e1 e2 radial tangential) = launch table photon
    !r0 = lensTableRadius table
    !b = r0 * tangential
    !(OrbitSeries ending lastAngle cellCount waypoints) = seriesOf space table radial tangential
    !spacing = lastAngle / fromIntegral cellCount
    !pull = pullOfGravity space

    end !n state = case ending of
      Leaves c s -> Followed (Escaped (c *^ e1 ^+^ s *^ e2)) state n
      FallsIn -> Followed Captured state n
      CirclesOn -> Followed StepLimit state n

    -- The sine of the latitude along the path is sine1 cos φ + sine2 sin φ.
    !(XYZ _ sine1 _) = e1
    !(XYZ _ sine2 _) = e2
    tilt = sqrt (sine1 * sine1 + sine2 * sine2)
    !flare = regionFlare region
    !height = regionHalfHeight region
    uOuter = 1 / regionRadius region
    uInner = 1 / max 1e-3 (regionInnerRadius region)
    -- The greatest sine of the gas's latitude where 1/r is u.
    steepest u = height * u + flare
    -- Light that starts outside the horizon never passes inside.
    steepestAll = steepest (min uInner (max 1 (1 / r0)))

    start state
      | height < 0 || regionRadius region <= 0 = end 0 state
      -- The path stays as close to the plane as the gas does.
      | steepestAll >= tilt = cells 0 phase 0 lastAngle (1 / 0) state
      | otherwise = crossing 0 (if firstCrossing - pi + widest < 0 then firstCrossing else firstCrossing - pi) state

    firstCrossing =
      let angle = negate (arcTangent2 sine1 sine2)
       in if angle <= 0 then angle + pi else angle

    crossing !n !angle !state
      | angle - widest > lastAngle = end n state
      | otherwise =
        let !cell = cellOf angle
            !(u, slope) = waypoint waypoints spacing cell
            !path = expand pull u slope
            !offset = angle - (fromIntegral cell + 0.5) * spacing
            !v = expansionValue path offset
            !reachable = 1.5 * abs (expansionSlope path offset) * widest
         in if v + reachable < uOuter || v - reachable > uInner
              then crossing n (angle + pi) state
              else
                let half = min widest (arcSine (steepest v / tilt))
                    refined side = min widest (arcSine (steepest (max 0 (expansionValue path (offset + side))) / tilt))
                    -- The ends of the interval. Where the gas's height depends on the
                    -- radius, they follow from the radius found there, unless it varies
                    -- so much within the interval that one evaluation proves nothing.
                    (before, after)
                      | height <= 0 || widest > 0.2 || height * abs (expansionSlope path offset) > 0.25 * tilt = (widest, widest)
                      | otherwise = (refined (negate half), refined half)
                 in cells n phase (max 0 (angle - before)) (min lastAngle (angle + after)) (angle + pi) state
    widest = arcSine (min 1 (steepestAll / tilt))

    cellOf angle = max 0 (min (cellCount - 1) (truncate (angle / spacing)))

    -- Gathers between two angles, cell by cell, and continues with the next crossing.
    cells !n !lead !from !to !next !state
      | from >= to = crossing n next state
      | otherwise =
        let !cell = cellOf from
            !middle = (fromIntegral cell + 0.5) * spacing
            -- Rounding may leave an angle at the far end of its cell.
            !upper = if cell == cellCount - 1 then to else min to (max (from + 1e-9) (middle + 0.5 * spacing))
            !(u, slope) = waypoint waypoints spacing cell
            !path = expand pull u slope
            !t0 = from - middle
            !t1 = upper - middle
            !u0 = expansionValue path t0
            !u1 = expansionValue path t1
            !slope0 = expansionSlope path t0
            !slope1 = expansionSlope path t1
            highest
              | slope0 > 0 && slope1 < 0 = min (u0 + slope0 * (t1 - t0)) (u1 - slope1 * (t1 - t0))
              | otherwise = max u0 u1
         in if highest < uOuter || min u0 u1 > uInner
              then cells n lead upper to next state
              else
                let -- Where the path enters and leaves the gas's outer radius, if
                    -- within the cell. Newton's steps may end anywhere if the path only just fails to
                    -- reach it.
                    !begin = if u0 < uOuter && slope0 > 0 then within t0 t1 (reaching path t0) else t0
                    !leaving = if u1 < uOuter && slope1 < 0 then within begin t1 (reaching path t1) else t1
                    !final = ofOneScale path begin leaving
                    !cosine = cos middle
                    !sine = sin middle
                    !outward = cosine *^ e1 ^+^ sine *^ e2
                    !onward = cosine *^ e2 ^-^ sine *^ e1
                    rate t = rateAt (expansionValue path t) (expansionSlope path t) (latitude t) (climb t)
                    !(XYZ _ latitude0 _) = outward
                    !(XYZ _ climb0 _) = onward
                    latitude t = latitude0 + t * (climb0 - 0.5 * t * latitude0)
                    climb t = climb0 - t * latitude0
                    -- The length of a step varies little within a cell. Computing it
                    -- for each step would make each step wait for the previous one.
                    !turn = 2 / (rate begin + rate final)
                    -- Whether the path is above or below the gas all the time. The
                    -- series of the latitude is accurate to a few thousandths.
                    far = abs (latitude t0) `min` abs (latitude t1) > steepest highest + 0.003 && latitude t0 * latitude t1 > 0
                    -- A last step ends with the gas; a step that ends with the cell
                    -- continues into the next cell.
                    !limit = if final < leaving || upper < to && final >= t1 then 1 / 0 else final
                    !done = if final < leaving then middle + final else upper
                    -- Where the path turns back just outside the gas, Newton's steps
                    -- find nothing.
                    missed = u0 < uOuter && slope0 > 0 && expansionValue path begin < 0.98 * uOuter
                 in if far || missed
                      then cells n lead upper to next state
                      else samples n begin (lead * turn) final limit turn path outward onward done middle to next state

    -- The part of a cell in which the radius changes by less than a factor of eight, so
    -- that one step length suits all of it.
    ofOneScale path begin end'
      | min u0 u1 * 8 < max u0 u1 && end' - begin > 1e-9 = ofOneScale path begin (0.5 * (begin + end'))
      | otherwise = end'
      where
        u0 = expansionValue path begin
        u1 = expansionValue path end'

    -- The curve is concave there, so Newton's steps never overshoot.
    reaching path t = step (step (step t))
      where
        step x = x + (uOuter - expansionValue path x) / expansionSlope path x

    -- Where the path turns back just outside the gas, Newton's steps lead anywhere.
    within low high t
      | t > low = if t < high then t else high
      | otherwise = low

    samples !n !t !wanted !final !limit !turn !path !outward0 !onward0 !upper !middle !to !next !state
      | t >= final = cells n 1 (max upper (middle + t)) to next state
      | otherwise =
        let !step = if limit - t < 1.4 * wanted then limit - t else wanted
            !tM = t + 0.5 * step
            !u = expansionValue path tM
            !slope = expansionSlope path tM
            !t2 = tM * tM
            !c = 1 - t2 * (0.5 - t2 * (1 / 24 - t2 * (1 / 720 - t2 * (1 / 40320))))
            !s = tM * (1 - t2 * (1 / 6 - t2 * (1 / 120 - t2 * (1 / 5040 - t2 * (1 / 362880)))))
            !outward = c *^ outward0 ^+^ s *^ onward0
            !onward = c *^ onward0 ^-^ s *^ outward0
            !(XYZ _ sineLatitude _) = outward
            -- Far from the plane the gas varies slowly.
            !growth = max 1 (min core (abs sineLatitude * core / steepest u))
            !grown = turn * growth
            goOn = samples (n + 1) (t + step) grown final limit turn path outward0 onward0 upper middle to next
            {-# INLINE goOn #-}
         in if abs sineLatitude > steepest u || u < uOuter || u > uInner
              then goOn state
              else
                let place' = (1 / u) *^ outward
                    velocity' = (negate b * slope) *^ outward ^+^ (b * u) *^ onward
                 in case gather state (PathSegment place' velocity' (step / (b * u * u))) of
                      Continue state' -> goOn state'
                      Stop state' -> Followed Opaque state' (n + 1)

    -- The number of segments per radian for which neither the length of a segment
    -- exceeds the region's fraction of the radius nor its climb that of the half
    -- height.
    rateAt u slope sineLatitude climbing =
      max
        (sqrt (slope * slope + u * u) / (longest * u))
        (abs (climbing * room - sineLatitude * height * slope) / (vertical * room * room))
      where
        room = steepest u
    !longest = regionLongestStep region
    !vertical = regionVerticalStep region
    !core = 1 / regionCore region
{-# INLINE followTable #-}

-- | The fate of the path that 'followTable' follows, if nothing is in the way.
tableFate :: Spacetime -> LensTable -> Photon -> Fate
tableFate space table photon = case end of
  Leaves c s -> Escaped (c *^ e1 ^+^ s *^ e2)
  FallsIn -> Captured
  CirclesOn -> StepLimit
  where
    !(Launch e1 e2 radial tangential) = launch table photon
    end = case space of
      Flat -> seriesEnd (seriesOf Flat table radial tangential)
      _ -> lensEnd table radial tangential

-- | The 'lensOffset' of a photon of unit energy at the table's radius.
criticalOffset :: LensTable -> Photon -> Double
criticalOffset table photon = case launch table photon of
  Launch _ _ radial tangential -> lensOffset table radial tangential

-- | The start of a photon: unit vectors outwards and onwards, which span its plane, and
-- its velocity along them.
data Launch
  = Launch
      {-# UNPACK #-} !XYZ
      {-# UNPACK #-} !XYZ
      {-# UNPACK #-} !Double
      {-# UNPACK #-} !Double

-- | The 'Launch' of a photon at the table's radius. A photon that moves straight
-- towards the hole or away from it sweeps no angle, so its neighbour within 1e-9
-- radians, in an arbitrary plane, replaces it.
launch :: LensTable -> Photon -> Launch
launch table (Photon place velocity)
  | across2 > 1e-18 * XYZ.normSquared velocity = let t = sqrt across2 in Launch e1 ((1 / t) *^ across) radial t
  | otherwise = Launch e1 (fromMaybe (XYZ.perpendicular e1) (XYZ.normalize across)) radial (1e-9 * XYZ.norm velocity)
  where
    !e1 = (1 / lensTableRadius table) *^ place
    !radial = XYZ.dot velocity e1
    !across = velocity ^-^ radial *^ e1
    !across2 = XYZ.normSquared across
{-# INLINE launch #-}

-- | The arc sine on [0, 1]. Most arguments are small.
arcSine :: Double -> Double
arcSine x
  | x < 0.15 = x * (1 + x2 * (1 / 6 + x2 * (3 / 40 + x2 * (15 / 336))))
  | otherwise = asin (min 1 x)
  where
    x2 = x * x
{-# INLINE arcSine #-}
