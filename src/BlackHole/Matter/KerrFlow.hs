-- | How the gas of a disk around a Kerr hole moves in the equatorial plane, and how
-- its light is shifted: right-handed circular geodesics down to the innermost
-- stable one, and inside it the fall that keeps that orbit's energy and angular
-- momentum (Bardeen, Press and Teukolsky 1972; Mummery and Balbus 2022).
module BlackHole.Matter.KerrFlow
  ( KerrFlow,
    kerrFlow,
    kerrOrbitalRate,
    kerrPlaneFrequency,
    Frequencies (..),
    kerrFrequencies,
  )
where

import BlackHole.Spacetime.Kerr.Landmarks
import BlackHole.Spacetime.Kerr.Sight (LightRay (..))
import BlackHole.Spacetime.Momentum

-- | The gas of one hole.
data KerrFlow = KerrFlow
  { flowSpinLength :: {-# UNPACK #-} !Double,
    flowOuterHorizon :: {-# UNPACK #-} !Double,
    flowInnerHorizon :: {-# UNPACK #-} !Double,
    flowIsco :: {-# UNPACK #-} !Double,
    -- | Energy and angular momentum per mass of the innermost stable orbit.
    flowEnergy :: {-# UNPACK #-} !Double,
    flowAngularMomentum :: {-# UNPACK #-} !Double
  }

-- | The gas around a hole, turning in the given sense. Left-handed gas around a
-- spin is the mirror image of right-handed gas around the opposite spin.
kerrFlow :: Spin -> KerrFlow
kerrFlow hole =
  KerrFlow
    { flowSpinLength = spinLength hole,
      flowOuterHorizon = horizonRadius hole,
      flowInnerHorizon = innerHorizonRadius hole,
      flowIsco = isco,
      flowEnergy = sqrt (1 - 1 / (3 * isco)),
      flowAngularMomentum = (1 + 2 * sqrt (6 * isco - 2)) / (3 * sqrt 3)
    }
  where
    isco = iscoRadius RightHanded hole

-- | dφ\/dt of the right-handed circular geodesic at a radius.
kerrOrbitalRate :: KerrFlow -> Double -> Double
kerrOrbitalRate flow r = 1 / (sqrt 2 * r * sqrt r + flowSpinLength flow)

-- | @kerrPlaneFrequency flow ray r momentum@: the frequency of the light of a ray in the
-- frame of the gas where the ray crosses the plane at a radius outside the horizon, over
-- that at infinity. The shift of the gas's light is 'rayObserved' over this.
--
-- In falling gas @r²ν = (P_u P − R_u R_k)\/Δ − (L − aE)(λ − a)@. Where light falls
-- with the gas both products grow without limit at the horizon, and the difference
-- is multiplied out.
kerrPlaneFrequency :: KerrFlow -> LightRay -> Double -> Momentum -> Double
kerrPlaneFrequency flow ray r (Momentum kr _)
  | r >= flowIsco flow =
    let root = sqrt 2 * r * sqrt r
     in (root + a - lambda) / sqrt (2 * r * r * r - 3 * r * r + 2 * a * root)
  | otherwise = plunging / (r * r)
  where
    a = flowSpinLength flow
    lambda = rayLambda ray
    energy = flowEnergy flow
    momentum = flowAngularMomentum flow
    delta = (r - flowOuterHorizon flow) * (r - flowInnerHorizon flow)
    kappa = rayKappa ray
    p = r * r + a * (a - lambda)
    gasP = (r * r + a * a) * energy - a * momentum
    gasK = (momentum - a * energy) * (momentum - a * energy)
    gasR = negate (r * r * sqrt ((flowIsco flow / r - 1) ** 3 / (3 * flowIsco flow)))
    lightR = (if kr < 0 then negate else id) (sqrt (max 0 (p * p - delta * kappa)))
    radialPart
      | gasR * lightR > 0 =
        (p * p * (gasK + r * r) + gasP * gasP * kappa - delta * kappa * (gasK + r * r))
          / (gasP * p + gasR * lightR)
      | otherwise = (gasP * p - gasR * lightR) / delta
    plunging = radialPart - (momentum - a * energy) * (lambda - a)

-- | Frequencies of light over that at infinity.
data Frequencies = Frequencies
  { -- | In the frame of the gas. It is also the length that the light covers in that frame
    -- per unit of the affine parameter for unit energy at infinity.
    frequencyInGas :: {-# UNPACK #-} !Double,
    -- | For the observer beside the gas without angular momentum, who is at rest around a
    -- hole without spin and otherwise turns with space.
    frequencyBeside :: {-# UNPACK #-} !Double
  }
  deriving (Eq, Show)

-- | @kerrFrequencies flow r c momentum@: the frequencies of light at a place outside the
-- horizon with @cos θ = c@. In a thick disk the gas off the plane has the dφ\/dt of the
-- plane's gas at the same radius, and its radial speed past the observer without angular
-- momentum: that is slower than light everywhere outside the horizon. In the plane it
-- agrees with 'kerrPlaneFrequency', but for its digits close to the horizon.
kerrFrequencies :: KerrFlow -> Double -> Double -> Momentum -> Frequencies
kerrFrequencies flow r c (Momentum kr lambda) = Frequencies inGas beside
  where
    a = flowSpinLength flow
    a2 = a * a
    s2 = max 1e-30 (1 - c * c)
    sigma = r * r + a2 * c * c
    delta = (r - flowOuterHorizon flow) * (r - flowInnerHorizon flow)
    wide = r * r + a2
    area = wide * wide - a2 * delta * s2
    dragging = a * r / area
    lapse = sqrt (sigma * delta / area)
    girth = sqrt (s2 * area / sigma)
    lightRadial = kr * sqrt (delta / sigma)
    energy = flowEnergy flow
    momentum = flowAngularMomentum flow
    -- dφ/dt, and the radial speed past the observer beside.
    (rate, infall)
      | r >= flowIsco flow = (kerrOrbitalRate flow r, 0)
      | otherwise =
        let below = flowIsco flow / r - 1
            timeRate = (wide + a2 / r) * energy - a * momentum / r
         in ( (a * energy / r + (1 - 1 / r) * momentum) / timeRate,
              negate (below * sqrt below / sqrt (3 * flowIsco flow))
                * sqrt (wide * wide - a2 * delta) / timeRate
            )
    around = girth * (rate - dragging) / lapse
    gamma = 1 / sqrt (max 1e-12 (1 - around * around - infall * infall))
    beside = (1 - dragging * lambda) / lapse
    inGas = gamma * (beside - around * lambda / girth - infall * lightRadial)
{-# INLINE kerrFrequencies #-}
