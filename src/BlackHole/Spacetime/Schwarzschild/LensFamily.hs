-- | All light paths through one point around a hole without spin, as a family with one
-- parameter.
--
-- The paths are rotations of each other except for the angle ψ between the line of sight
-- and the outward radius. /The parameter/ is @w = tan(ψ\/4)@: smooth and monotone from 0
-- (outwards) to 1 (inwards), and rational in the components of the velocity. Inside the
-- horizon, where no observer at rest exists to measure ψ, it refers to an observer who
-- falls in from rest at infinity.
module BlackHole.Spacetime.Schwarzschild.LensFamily
  ( Family,
    familyAt,
    familyRadius,
    familyCritical,
    parameterOf,
    velocityAt,
  )
where

import BlackHole.Numeric.Angle (quarterTangent)
import BlackHole.Spacetime.Schwarzschild.Radii (criticalImpactParameter)

-- | The paths through a point at one distance from the hole.
data Family = Family
  { -- | In Schwarzschild radii.
    familyRadius :: {-# UNPACK #-} !Double,
    -- | √(1 − 1/r), the lapse of an observer at rest; inside the horizon √(1/r), the
    -- speed of an observer who falls in from rest at infinity.
    _familyLapse :: {-# UNPACK #-} !Double,
    -- | The parameter of the critical photon.
    familyCritical :: {-# UNPACK #-} !Double
  }

-- | The family at the distance r > 0, in Schwarzschild radii.
familyAt :: Double -> Family
familyAt r = Family r (if r > 1 then sqrt (1 - 1 / r) else sqrt (1 / r)) (criticalParameter r)

-- | The parameter of the critical photon. With u = 1/r, cos ψ_c is −(1 − 3u/2)√(1 +
-- 3u), which is free of cancellation at r = 3/2.
criticalParameter :: Double -> Double
criticalParameter r
  | r <= 1 =
    let infall = sqrt (1 / r)
        t = criticalImpactParameter / r
     in fallingParameter infall (sqrt (1 + (infall * infall - 1) * t * t)) t
  | otherwise = quarterTangent cosine (criticalImpactParameter * sqrt (1 - u) * u)
  where
    u = 1 / r
    cosine = (1.5 * u - 1) * sqrt (1 + 3 * u)

-- | tan(ψ/4) for an observer who falls at this speed, from the velocity of a photon of
-- unit energy. Where an observer at rest exists, this is the aberration of what that
-- observer sees.
fallingParameter :: Double -> Double -> Double -> Double
fallingParameter infall radial tangential = half / (1 + sqrt (1 + half * half))
  where
    half = tangential * (1 + infall) / (1 + radial)
{-# INLINE fallingParameter #-}

-- | The parameter of a photon of unit energy.
parameterOf :: Family -> Double -> Double -> Double
parameterOf (Family r lapse _) radial tangential
  | r > 1 = quarterTangent radial (tangential * lapse)
  | otherwise = fallingParameter lapse radial tangential
{-# INLINE parameterOf #-}

-- | The radial and tangential pseudo-velocity of a member of the family. The tangential
-- component is negative beyond both ends of the parameter's range, where the family
-- continues as its mirror image.
velocityAt :: Family -> Double -> (Double, Double)
velocityAt (Family r lapse _) w
  | r > 1 =
    let halfCosine = (1 - w * w) / (1 + w * w)
        halfSine = 2 * w / (1 + w * w)
     in ( (halfCosine - halfSine) * (halfCosine + halfSine),
          2 * halfSine * halfCosine / lapse
        )
  | otherwise =
    let half = 2 * w / (1 - w * w)
        t = 2 * half / ((1 + lapse) - (lapse - 1) * half * half)
     in (sqrt (1 + (lapse * lapse - 1) * t * t), t)
