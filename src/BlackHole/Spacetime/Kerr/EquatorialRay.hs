-- | Light that comes from infinity in the equatorial plane of a Kerr hole, followed
-- forwards.
--
-- The closed form of "BlackHole.Spacetime.Kerr.Path" traces light backwards. Reversing
-- time turns a path of light into one around the hole of the opposite spin, with the
-- opposite angular momentum: that path, traced backwards, is this one forwards.
module BlackHole.Spacetime.Kerr.EquatorialRay
  ( EquatorialRay (..),
    equatorialRay,
    criticalAngularMomentum,
  )
where

import BlackHole.Spacetime.Fate
import BlackHole.Spacetime.Kerr.Landmarks
import BlackHole.Spacetime.Kerr.Path
import BlackHole.Spacetime.Kerr.Sight
import BlackHole.Vector.XYZ (XYZ (..))
import Data.Maybe (fromMaybe)

-- | A path in the equatorial plane.
data EquatorialRay = EquatorialRay
  { -- | Whether the light leaves the hole again.
    equatorialEscapes :: !Bool,
    -- | Boyer–Lindquist's radius and azimuth of points along the path, neighbours about
    -- @step@ times their radius apart.
    equatorialPoints :: [(Double, Double)]
  }

-- | The angular momentum over energy of light on the circular orbit in the plane,
-- negative for the left-handed one: @±3√(r\/2) − a@ (Bardeen, Press and Teukolsky 1972).
criticalAngularMomentum :: Handedness -> Spin -> Double
criticalAngularMomentum handedness hole =
  side * 3 * sqrt (0.5 * photonOrbitRadius handedness hole) - spinLength hole
  where
    side = if handedness == RightHanded then 1 else -1

-- | @equatorialRay hole farthest step φ λ@: the part within the radius @farthest@ of the
-- path of light with the angular momentum λ per energy that comes from the azimuth φ at
-- infinity. The radius must be greater than |λ| and than any photon orbit. A captured ray
-- ends 1e-4 of the radius above the horizon, where Boyer–Lindquist's azimuth diverges; one
-- that never ends has 100 000 points at most.
equatorialRay :: Spin -> Double -> Double -> Double -> Double -> EquatorialRay
equatorialRay hole farthest step comesFrom lambda = EquatorialRay escapes (points 0)
  where
    reversed = fromMaybe noSpin (spin (negate (dimensionlessSpin hole)))
    -- The past of the light leads to its azimuth at the greatest radius.
    past = kerrPath hole (BoyerLindquist 0) (planeRay hole farthest 1 lambda)
    entry = case kerrFate past of
      Escaped (XYZ x _ z) -> comesFrom - atan2 x z
      _ -> comesFrom
    path =
      kerrPath reversed (BoyerLindquist entry) (planeRay reversed farthest (-1) (negate lambda))
    escapes = case kerrFate path of
      Escaped _ -> True
      _ -> False
    points = take 100000 . from
    from time
      | time >= kerrMinoTime path || r <= 1.0001 * horizonRadius hole = []
      | pointGrows point && r > farthest = [place]
      | otherwise = place : from (time + step * r / speed)
      where
        point = kerrPoint path time
        r = pointRadius point
        place = (r, pointAzimuth point)
        a = spinLength hole
        p = r * r + a * (a - lambda)
        delta = kerrDelta hole r
        around = lambda - a + a * p / delta
        radialRate2 = p * p - delta * (lambda - a) * (lambda - a)
        speed = sqrt (max 0 radialRate2 + r * r * around * around)

-- | A ray in the plane at a radius: inwards along the tracing for the sign −1, outwards
-- for 1.
planeRay :: Spin -> Double -> Double -> Double -> LightRay
planeRay hole r side lambda =
  LightRay
    { rayRadius = r,
      rayCosine = 0,
      raySine = 1,
      rayRadialRate = side * sqrt (max 0 (p * p - kerrDelta hole r * kappa)),
      rayPolarRate = 0,
      rayLambda = lambda,
      rayEta = 0,
      rayKappa = kappa,
      rayObserved = 1
    }
  where
    a = spinLength hole
    p = r * r + a * (a - lambda)
    kappa = (lambda - a) * (lambda - a)
