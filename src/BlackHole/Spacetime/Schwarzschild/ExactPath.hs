{-# LANGUAGE BangPatterns #-}

-- | Light paths along exact orbits ("BlackHole.Spacetime.Schwarzschild.Orbit"), or along
-- straight lines without gravity.
--
-- Every point, the direction of escape and the fate come from the closed form. The step
-- length only decides where the gas is sampled.
module BlackHole.Spacetime.Schwarzschild.ExactPath
  ( followExact,
  )
where

import BlackHole.Spacetime.Fate
import BlackHole.Spacetime.LightPath
import BlackHole.Spacetime.March
import BlackHole.Spacetime.PathPlane
import BlackHole.Spacetime.Photon
import BlackHole.Spacetime.Schwarzschild.Orbit
import BlackHole.Spacetime.Types (Spacetime (..))
import BlackHole.Vector.XY (XY (..))
import BlackHole.Vector.XYZ (XYZ (..), (*^), (^+^))
import qualified BlackHole.Vector.XYZ as XYZ

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
followOrbit region photon gather
  | nearest >= reach = end 0
  | otherwise = go 0 0 u0 slope0
  where
    !r0 = XYZ.norm (photonPosition photon)
    !u0 = 1 / r0
    !(Launch plane radial tangential) = launch r0 photon
    !path = orbit r0 radial tangential
    !b = r0 * tangential
    !slope0 = negate radial / b
    !reach = enclosingRadius region
    nearest = case orbitTurningPoint path of
      Just (TurningPoint _ r) -> if radial < 0 then r else min r0 1
      Nothing -> if radial > 0 then r0 else 0
    !lastAngle = min 1000 (orbitSweep path)
    end !n state = Followed (inSpace plane <$> orbitFate path) state n
    -- Swept angle, and inverse radius and slope there: exact at the start, then
    -- extrapolated by a Taylor expansion from the last middle, which is accurate enough
    -- to choose the next step.
    go !n !angle !u !slope !state
      | angle >= lastAngle = end n state
      -- Outside the gas and moving outward: only the sky is left.
      | slope <= 0 && u * reach <= 1 = end n state
      | insideRegion region middle =
        case gather state (planarSegment (Photon middle velocity') (turn / (b * um * um))) of
          Continue state' -> go (n + 1) angle' u' slope' state'
          Stop state' -> Followed Opaque state' (n + 1)
      | otherwise = go (n + 1) angle' u' slope' state
      where
        here = inSpace plane (XY (cos angle / u) (sin angle / u))
        speed = sqrt (slope * slope + u * u)
        XYZ _ climbing _ =
          inSpace plane (XY (cos angle * slope + sin angle * u) (sin angle * slope - cos angle * u))
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
        outward = inSpace plane (XY c s)
        onward = onwardAt plane c s
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
        case gather state (planarSegment (Photon middle velocity) len) of
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
