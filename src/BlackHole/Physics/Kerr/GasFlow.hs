-- | How the gas of a disk around a Kerr hole moves in the equatorial plane, and how
-- its light is shifted: right-handed circular geodesics down to the innermost
-- stable one, and inside it the fall that keeps that orbit's energy and angular
-- momentum (Bardeen, Press and Teukolsky 1972; Mummery and Balbus 2022).
module BlackHole.Physics.Kerr.GasFlow
  ( GasFlow,
    gasFlow,
    orbitalRate,
    planeFrequency,
  )
where

import BlackHole.Physics.Kerr.Landmarks
import BlackHole.Physics.Kerr.Sight (LightRay (..))

-- | The gas of one hole.
data GasFlow = GasFlow
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
gasFlow :: Spin -> GasFlow
gasFlow hole =
  GasFlow
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
orbitalRate :: GasFlow -> Double -> Double
orbitalRate flow r = 1 / (sqrt 2 * r * sqrt r + flowSpinLength flow)

-- | @planeFrequency flow ray r grows@: the frequency of the light of a ray in the
-- frame of the gas where the ray crosses the plane at a radius, over that at
-- infinity; @grows@ says whether the radius grows along the backward tracing there.
-- The shift of the gas's light is 'rayObserved' over this. 'Nothing' at and inside
-- the horizon.
--
-- In falling gas @r²ν = (P_u P − R_u R_k)\/Δ − (L − aE)(λ − a)@. Where light falls
-- with the gas both products grow without limit at the horizon, and the difference
-- is multiplied out.
planeFrequency :: GasFlow -> LightRay -> Double -> Bool -> Maybe Double
planeFrequency flow ray r grows
  | r >= flowIsco flow =
    let root = sqrt 2 * r * sqrt r
     in Just ((root + a - lambda) / sqrt (2 * r * r * r - 3 * r * r + 2 * a * root))
  | r > flowOuterHorizon flow = Just (plunging / (r * r))
  | otherwise = Nothing
  where
    a = flowSpinLength flow
    lambda = rayLambda ray
    energy = flowEnergy flow
    momentum = flowAngularMomentum flow
    delta = (r - flowOuterHorizon flow) * (r - flowInnerHorizon flow)
    kappa = rayEta ray + (lambda - a) * (lambda - a)
    p = r * r + a * (a - lambda)
    gasP = (r * r + a * a) * energy - a * momentum
    gasK = (momentum - a * energy) * (momentum - a * energy)
    -- The gas falls; the real photon moves against the tracing.
    gasR = negate (r * r * sqrt ((flowIsco flow / r - 1) ** 3 / (3 * flowIsco flow)))
    lightR = (if grows then negate else id) (sqrt (max 0 (p * p - delta * kappa)))
    radialPart
      | gasR * lightR > 0 =
        (p * p * (gasK + r * r) + gasP * gasP * kappa - delta * kappa * (gasK + r * r))
          / (gasP * p + gasR * lightR)
      | otherwise = (gasP * p - gasR * lightR) / delta
    plunging = radialPart - (momentum - a * energy) * (lambda - a)
