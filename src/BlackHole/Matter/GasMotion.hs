-- | The four-velocity of the gas around a hole without spin: circular geodesics down to
-- the innermost stable orbit at r = 3, and free fall inside it. The falling gas keeps the
-- energy and angular momentum of that orbit. All motion is right-handed about @+y@.
--
-- A thick disk also has gas off the equatorial plane, where no circular geodesic about
-- the axis exists. There the gas keeps the coordinate rates dφ/dt and dr/dt of the
-- equatorial orbit at the same distance r from the hole, so each sphere turns and falls
-- as one. The other common choice takes the rates of the equatorial orbit at the same
-- distance from the axis. The rule used here is slower than light everywhere outside
-- the horizon: the speed falls from the equator to the poles, whereas under the other
-- rule it grows without limit.
--
-- Units: G = c = r_s = 1; Schwarzschild coordinates t, r, φ.
module BlackHole.Matter.GasMotion
  ( FourVelocity (..),
    gasVelocity,
    frequencyIn,
    motionFrequency,
    keplerianRate,
  )
where

import BlackHole.Spacetime.Momentum

-- | Contravariant components of a four-velocity without motion in latitude.
data FourVelocity = FourVelocity
  { -- | dt/dτ, at least 1.
    velocityTime :: {-# UNPACK #-} !Double,
    -- | dr/dτ, negative for infalling gas.
    velocityRadial :: {-# UNPACK #-} !Double,
    -- | dφ/dτ, where φ is the right-handed angle about @+y@.
    velocityAzimuthal :: {-# UNPACK #-} !Double
  }
  deriving (Eq, Show)

-- | @gasVelocity r y@ is the four-velocity of the gas at the distance r from the hole
-- and the height y above the disk's plane. 'Nothing' at and inside the horizon, where
-- the disk has no gas, and if r is not a finite number. Heights beyond r count as r, so
-- rounding on the axis does no harm.
--
-- The result is continuous at r = 3 and normalised to −1 for every r > 1. The textbook
-- formulas contain cancelling differences, which this function avoids: E² −
-- (1−1/r)(1+L²/r²) is (3/r − 1)³/9 for the plunge, and the norm that determines dt/dτ
-- is (1−1/r)² (1 + L² y²/r⁴)/E².
gasVelocity :: Double -> Double -> Maybe FourVelocity
gasVelocity r y
  | r >= 3 && not (isInfinite r) =
    let timeRate = 1 / sqrt (1 - 1 / r - (1 - sinLatitude2) / (2 * r))
     in Just (FourVelocity timeRate 0 (timeRate * keplerianRate r))
  | r > 1 && r < 3 =
    let lapse2 = (r - 1) / r
        slowing =
          1
            / sqrt
              ( 1 + plungeAngularMomentum * plungeAngularMomentum * sinLatitude2
                  / (r * r)
              )
        below = 3 / r - 1
     in Just
          ( FourVelocity
              (slowing * plungeEnergy / lapse2)
              (negate (slowing * below * sqrt below / 3))
              (slowing * plungeAngularMomentum / (r * r))
          )
  | otherwise = Nothing
  where
    sinLatitude2
      | abs y < r = (y / r) * (y / r)
      | otherwise = 1
{-# INLINE gasVelocity #-}

-- | ν/E∞ = −k·u: the photon's frequency for an observer with this four-velocity.
-- Positive outside the horizon. The relative error is 1e-16 except for photons that
-- fall with infalling gas, where it grows to 1e-16/(1−1/r).
frequencyIn :: FourVelocity -> Momentum -> Double
frequencyIn (FourVelocity ut ur uphi) (Momentum kr lambda) =
  ut - kr * ur - lambda * uphi
{-# INLINE frequencyIn #-}

-- | @motionFrequency r y momentum@ is ν/E∞ of light in the frame of the gas at the distance
-- @r > 1@ from the hole and the height @y@. It agrees with 'gasVelocity' and
-- 'frequencyIn', and is faster for circling gas, which fills most of a picture.
motionFrequency :: Double -> Double -> Momentum -> Double
motionFrequency r y momentum@(Momentum _ lambda)
  | r >= 3 =
    (1 - sqrt (0.5 * u) * u * lambda) / sqrt (1 - u * (1.5 - 0.5 * sinLatitude * sinLatitude))
  | otherwise = case gasVelocity r y of
    Just moving -> frequencyIn moving momentum
    Nothing -> 1
  where
    u = 1 / r
    sinLatitude = y * u
{-# INLINE motionFrequency #-}

-- | dφ/dt of the circular orbit at r in radians per unit of coordinate time: 1/√(2r³),
-- Kepler's third law, which holds exactly in Schwarzschild's t and r. The orbit is a
-- geodesic for r > 3/2 and stable from r = 3 outwards.
keplerianRate :: Double -> Double
keplerianRate r = 1 / sqrt (2 * r * r * r)
{-# INLINE keplerianRate #-}

-- | Energy per unit mass on the innermost stable orbit and during the plunge from it,
-- √(8/9).
plungeEnergy :: Double
plungeEnergy = 0.9428090415820634

-- | Angular momentum per unit mass on the innermost stable orbit, √3.
plungeAngularMomentum :: Double
plungeAngularMomentum = 1.7320508075688772
