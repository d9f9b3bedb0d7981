-- | World lines of observers on geodesics around a rotating hole: their position when their own
-- clock shows a given time. "BlackHole.Spacetime.Schwarzschild.FreeFall" is the case without spin.
module BlackHole.Spacetime.Kerr.WorldLine
  ( kerrInfallTime,
    kerrInfallRadius,
    kerrOrbitalPhase,
  )
where

import BlackHole.Numeric.Bisection (bisect)
import BlackHole.Spacetime.Kerr.Landmarks
import BlackHole.Spacetime.Kerr.Quadrature (integrate)

-- | @kerrInfallTime hole c from to@: the proper time in r_s\/c that an observer who falls
-- from rest at infinity without angular momentum takes between two radii, of which the
-- first is the greater, at @cos θ = c@: the integral of @Σ \/ √(r (r² + a²))@
-- (Doran 2000).
kerrInfallTime :: Spin -> Double -> Double -> Double -> Double
kerrInfallTime hole c from to = integrate 16 rate (sqrt (max 0 to)) (sqrt (max 0 from))
  where
    a2 = spinLength hole * spinLength hole
    -- Over the root of the radius, which takes out the singularity at 0.
    rate x = 2 * (r * r + a2 * c * c) / sqrt (r * r + a2)
      where
        r = x * x

-- | The radius of that observer after a proper time since a radius; 'Nothing' if the time
-- has run out at the centre.
kerrInfallRadius :: Spin -> Double -> Double -> Double -> Maybe Double
kerrInfallRadius hole c from time
  | time > kerrInfallTime hole c from 0 = Nothing
  -- Before the start the observer was farther out.
  | time < 0 = Just (bisect (\r -> kerrInfallTime hole c r from < negate time) from (farther from))
  | otherwise = Just (bisect (\r -> kerrInfallTime hole c from r > time) 0 from)
  where
    farther r
      | kerrInfallTime hole c r from < negate time = farther (2 * r)
      | otherwise = r

-- | @kerrOrbitalPhase hole r time@: the angle in radians, right-handed about @+y@, by which
-- an observer on the right-handed circular geodesic in the plane has turned after a
-- proper time; 'Nothing' where there is no such geodesic.
kerrOrbitalPhase :: Spin -> Double -> Double -> Maybe Double
kerrOrbitalPhase hole r time
  | r > photonOrbitRadius RightHanded hole =
    Just (time / sqrt (2 * r * r * r - 3 * r * r + 2 * a * root))
  | otherwise = Nothing
  where
    a = spinLength hole
    root = sqrt 2 * r * sqrt r
