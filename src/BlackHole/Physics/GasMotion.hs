-- | How the gas moves: circular geodesics down to the innermost stable orbit,
-- r = 3, and from there the free fall of gas that left that orbit with its
-- energy and angular momentum. All motion is right-handed about @+y@.
--
-- A thick disk also has gas off the equatorial plane, where no circular
-- geodesic about the axis exists. There the gas keeps the coordinate rates
-- dφ/dt and dr/dt of the equatorial orbit at the same distance r from the
-- hole: each sphere turns (and falls) as one. Against the other common
-- choice, the rates of the equatorial orbit at the same distance from the axis,
-- this one is slower than light everywhere outside the horizon: the speed
-- falls from the equator to the poles, where the other one grows without limit.
--
-- Units: G = c = r_s = 1; Schwarzschild coordinates t, r, φ.
module BlackHole.Physics.GasMotion
  ( FourVelocity (..),
    gasVelocity,
    staticVelocity,
    keplerianRate,
    plungeEnergy,
    plungeAngularMomentum,
  )
where

-- | Contravariant components of a four-velocity without motion in latitude.
data FourVelocity = FourVelocity
  { -- | dt/dτ, at least 1.
    velocityTime :: {-# UNPACK #-} !Double,
    -- | dr/dτ, negative for falling gas.
    velocityRadial :: {-# UNPACK #-} !Double,
    -- | dφ/dτ, φ being the right-handed angle about @+y@.
    velocityAzimuthal :: {-# UNPACK #-} !Double
  }
  deriving (Eq, Show)

-- | @gasVelocity r y@: the gas at the distance r from the hole and the height
-- y above the disk plane. 'Nothing' at and inside the horizon (and where r is
-- no finite number), where the disk has no gas. Heights beyond r count as r,
-- so that rounding on the axis does no harm.
--
-- Continuous at r = 3 and normalised to −1 for every r > 1. The cancelling
-- differences of the textbook formulas are gone: E² − (1−1/r)(1+L²/r²) is
-- (3/r − 1)³/9 for the plunge, and the norm that fixes dt/dτ is
-- (1−1/r)² (1 + L² y²/r⁴)/E².
gasVelocity :: Double -> Double -> Maybe FourVelocity
gasVelocity r y
  | r >= 3 && not (isInfinite r) =
    let timeRate = 1 / sqrt (1 - 1 / r - (1 - sinLatitude2) / (2 * r))
     in Just (FourVelocity timeRate 0 (timeRate * keplerianRate r))
  | r > 1 && r < 3 =
    let lapse2 = (r - 1) / r
        stretch =
          1
            / sqrt
              ( 1 + plungeAngularMomentum * plungeAngularMomentum * sinLatitude2
                  / (r * r)
              )
        below = 3 / r - 1
     in Just
          ( FourVelocity
              (stretch * plungeEnergy / lapse2)
              (negate (stretch * below * sqrt below / 3))
              (stretch * plungeAngularMomentum / (r * r))
          )
  | otherwise = Nothing
  where
    sinLatitude2
      | abs y < r = (y / r) * (y / r)
      | otherwise = 1
{-# INLINE gasVelocity #-}

-- | Something at rest at r; 'Nothing' where nothing can be, at and inside the
-- horizon, and for infinity.
staticVelocity :: Double -> Maybe FourVelocity
staticVelocity r
  | r > 1 && not (isInfinite r) = Just (FourVelocity (sqrt (r / (r - 1))) 0 0)
  | otherwise = Nothing
{-# INLINE staticVelocity #-}

-- | dφ/dt of the circular orbit at r: Kepler's third law, 1/√(2r³), which
-- holds exactly in Schwarzschild's t and r. A geodesic for r > 3/2, stable
-- from r = 3 up.
keplerianRate :: Double -> Double
keplerianRate r = 1 / sqrt (2 * r * r * r)
{-# INLINE keplerianRate #-}

-- | Energy per mass of the innermost stable orbit and of what falls from it,
-- √(8/9).
plungeEnergy :: Double
plungeEnergy = 0.9428090415820634

-- | Angular momentum per mass of the innermost stable orbit, √3.
plungeAngularMomentum :: Double
plungeAngularMomentum = 1.7320508075688772
