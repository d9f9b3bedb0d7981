{-# LANGUAGE BangPatterns #-}

-- | Light paths along exact orbits ("BlackHole.Spacetime.Schwarzschild.Orbit"), or along straight lines
-- without gravity.
--
-- Every point, the direction of escape and the fate come from the closed form. The step
-- length only decides where the gas is sampled.
module BlackHole.Spacetime.Schwarzschild.ExactPath
  ( followExact,
    straightImpact,
  )
where

import BlackHole.Spacetime.Fate
import BlackHole.Spacetime.LightPath
import BlackHole.Spacetime.March
import BlackHole.Spacetime.Photon
import BlackHole.Spacetime.Schwarzschild.Orbit (TurningPoint (..), orbit, orbitFate, orbitInverseRadiusAndSlope, orbitTurningPoint)
import qualified BlackHole.Spacetime.Schwarzschild.Orbit as Orbit
import BlackHole.Spacetime.Types (Spacetime (..))
import BlackHole.Vector.XYZ (XYZ (..), (*^), (^+^), (^-^))
import qualified BlackHole.Vector.XYZ as XYZ
import Data.Maybe (fromMaybe)

-- | Follows a photon of unit energy ('withUnitEnergy') to its end and passes the path
-- segments inside the region to the caller. Costs one evaluation of the orbit per
-- segment.
followExact ::
  Spacetime ->
  Region ->
  Photon ->
  (a -> PathSegment -> Continue a) ->
  a ->
  Followed a
followExact Flat = followStraight
followExact _ = followOrbit
{-# INLINE followExact #-}

followOrbit :: Region -> Photon -> (a -> PathSegment -> Continue a) -> a -> Followed a
followOrbit region (Photon place velocity) gather
  | nearest >= reach = end 0
  | otherwise = go 0 0 u0 slope0
  where
    !r0 = XYZ.norm place
    !u0 = 1 / r0
    !e1 = u0 *^ place
    !radial = XYZ.dot velocity e1
    across = velocity ^-^ radial *^ e1
    -- A photon that moves straight towards the hole or away from it sweeps no angle to
    -- march along, so this follows its neighbour within 1e-12 radians.
    !tangential = max (1e-12 * XYZ.norm velocity) (XYZ.norm across)
    !e2 = fromMaybe (XYZ.perpendicular e1) (XYZ.normalize across)
    !path = orbit r0 radial tangential
    !b = r0 * tangential
    !slope0 = negate radial / b
    !reach = enclosingRadius region
    nearest = case orbitTurningPoint path of
      Just (TurningPoint _ r) -> if radial < 0 then r else min r0 1
      Nothing -> if radial > 0 then r0 else 0
    fate = orbitFate path
    !lastAngle = case fate of
      Orbit.Escapes angle -> angle
      Orbit.Captured angle -> angle
      Orbit.Circles -> 1000
    end !n state = case fate of
      Orbit.Escapes angle -> Followed (Escaped (cos angle *^ e1 ^+^ sin angle *^ e2)) state n
      Orbit.Captured _ -> Followed Captured state n
      Orbit.Circles -> Followed StepLimit state n
    -- Swept angle, and inverse radius and slope there: exact at the start, then
    -- extrapolated by a Taylor expansion from the last middle, which is accurate enough
    -- to choose the next step.
    go !n !angle !u !slope !state
      | angle >= lastAngle = end n state
      -- Outside the gas and moving outward: only the sky is left.
      | slope <= 0 && u * reach <= 1 = end n state
      | insideRegion region middle =
        case gather state (PathSegment middle velocity' (turn / (b * um * um))) of
          Continue state' -> go (n + 1) angle' u' slope' state'
          Stop state' -> Followed Opaque state' (n + 1)
      | otherwise = go (n + 1) angle' u' slope' state
      where
        here = (cos angle / u) *^ e1 ^+^ (sin angle / u) *^ e2
        speed = sqrt (slope * slope + u * u)
        XYZ _ climbing _ =
          (cos angle * slope + sin angle * u) *^ e1
            ^+^ (sin angle * slope - cos angle * u) *^ e2
        wanted = marchLength region here (climbing / speed) * u * u / speed
        -- The last segment of a captured path ends at the horizon. The last segment of
        -- an escaping path is far outside the region.
        turn = min (min 0.3 wanted) (lastAngle - angle)
        angle' = angle + turn
        half = 0.5 * turn
        !angleM = angle + half
        (!um, !slopeM) = orbitInverseRadiusAndSlope path angleM
        !c = cos angleM
        !s = sin angleM
        outward = c *^ e1 ^+^ s *^ e2
        onward = c *^ e2 ^-^ s *^ e1
        middle = (1 / um) *^ outward
        velocity' = (negate b * slopeM) *^ outward ^+^ (b * um) *^ onward
        bend = (1.5 * um - 1) * um
        u' = um + half * (slopeM + half * 0.5 * bend)
        slope' = slopeM + half * bend
{-# INLINE followOrbit #-}

followStraight :: Region -> Photon -> (a -> PathSegment -> Continue a) -> a -> Followed a
followStraight region (Photon place velocity) gather = go 0 0
  where
    !reach = enclosingRadius region
    !along = XYZ.dot place velocity
    !impact = straightImpact (Photon place velocity)
    XYZ _ climb _ = velocity
    go !n !t state
      | t >= impact = Followed Captured state n
      | isInfinite impact && along + t >= 0 && XYZ.norm here >= reach = escaped
      | insideRegion region middle =
        case gather state (PathSegment middle velocity len) of
          Continue state' -> go (n + 1) (t + len) state'
          Stop state' -> Followed Opaque state' (n + 1)
      | otherwise = go (n + 1) (t + len) state
      where
        here = place ^+^ t *^ velocity
        len = min (marchLength region here climb) (impact - t)
        middle = here ^+^ (0.5 * len) *^ velocity
        escaped = Followed (Escaped velocity) state n
{-# INLINE followStraight #-}

-- | The distance along a straight path at which a photon of unit speed hits the black
-- ball of flat space; infinite if it misses.
straightImpact :: Photon -> Double
straightImpact (Photon place velocity)
  | closest2 < 1 && along < 0 = negate along - sqrt (1 - closest2)
  | otherwise = 1 / 0
  where
    along = XYZ.dot place velocity
    closest2 = XYZ.normSquared place - along * along
