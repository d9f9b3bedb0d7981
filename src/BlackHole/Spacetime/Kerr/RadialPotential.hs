-- | The potential of the radial motion of light around a Kerr hole, and its roots.
--
-- In Mino time @(dr\/dτ)² = R(r) = r⁴ + c₂r² + κr − a²η@, with @c₂ = a² − λ² − η@ and
-- @κ = η + (λ − a)²@. The roots are real expressions of Ferrari's (Gralla and Lupsasca
-- 2020, appendix A).
module BlackHole.Spacetime.Kerr.RadialPotential
  ( radialPotential,
    Roots (..),
    rootsOf,
    photonOrbitOffset,
    lightEscapes,
  )
where

import BlackHole.Numeric.Angle (arcTangent2)
import BlackHole.Spacetime.Kerr.Landmarks
import BlackHole.Spacetime.Kerr.Sight

-- | @R(r) = P² − Δκ@ with @P = r² + a² − aλ@: the square of @dr\/dτ@.
radialPotential :: Spin -> LightRay -> Double -> Double
radialPotential hole ray r = p * p - delta * kappa
  where
    a = spinLength hole
    lambda = rayLambda ray
    p = r * r + a * (a - lambda)
    delta = kerrDelta hole r
    kappa = rayKappa ray

-- | A smooth measure of how far a ray is from one that circles for ever on a photon
-- orbit: the squared half distance of the two greatest roots over the squared radius of
-- the orbit, positive for light that turns back there and negative for light that passes
-- through. 'Nothing' where these roots belong to no orbit outside the horizon.
photonOrbitOffset :: Spin -> LightRay -> Maybe Double
photonOrbitOffset hole ray
  | z > horizonRadius hole = Just (upper / (z * z))
  | otherwise = Nothing
  where
    Roots z upper _ = rootsOf hole ray

-- | Whether a ray from outside the horizon comes from the sky, and not from the hole.
lightEscapes :: Spin -> LightRay -> Bool
lightEscapes hole ray
  | upper < 0 || z + sqrt upper <= horizonRadius hole = rayRadialRate ray > 0
  | otherwise = rayRadius ray > z
  where
    Roots z upper _ = rootsOf hole ray

-- | The four roots of @R@, as @z ± √upper@ and @−z ± √lower@.
data Roots
  = Roots
      {-# UNPACK #-} !Double
      {-# UNPACK #-} !Double
      {-# UNPACK #-} !Double

-- | The roots for a ray, in closed form.
rootsOf :: Spin -> LightRay -> Roots
rootsOf hole ray =
  Roots z (negate (0.5 * c2 + z * z + kappa / (4 * z))) (kappa / (4 * z) - 0.5 * c2 - z * z)
  where
    a = spinLength hole
    lambda = rayLambda ray
    eta = rayEta ray
    c2 = (a - lambda) * (a + lambda) - eta
    kappa = rayKappa ray
    z = ferrari c2 kappa (negate (a * a * eta))

-- | Ferrari's @z > 0@ of @r⁴ + c₂r² + κr + c₀@ with κ > 0: minus half the sum of
-- the two smaller roots.
ferrari :: Double -> Double -> Double -> Double
ferrari c2 kappa c0 = sqrt (max 0 (0.5 * omegas - c2 / 6))
  where
    p = negate (c2 * c2 / 12) - c0
    q = negate (c2 / 3) * (c2 * c2 / 36 - c0) - kappa * kappa / 8
    discriminant = p * p * p / 27 + 0.25 * q * q
    omegas
      | discriminant >= 0 =
        -- Of the two cube roots the greater by amount; their product is −p/3.
        let big = cubeRoot (negate (0.5 * q) + (if q <= 0 then 1 else -1) * sqrt discriminant)
         in if big == 0 then 0 else big - p / (3 * big)
      | otherwise =
        2 * sqrt (negate p / 3)
          * cos (arcTangent2 (sqrt (negate discriminant)) (negate (0.5 * q)) / 3)
    cubeRoot x = signum x * abs x ** (1 / 3)
