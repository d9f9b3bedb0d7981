-- | The frequency shift of light from the gas to the observer, g = ν_obs/ν_em, from the
-- photon's momentum and the four-velocity of the gas.
--
-- Photons here are physical ones, on their way from the gas to the observer; a caller
-- that traces light backwards must reverse the direction. Everything is per unit of the
-- photon's energy at infinity, E∞ = −k_t, which is constant along its path. Frequencies
-- are therefore ν/E∞, and the observer enters through one number, ν_obs/E∞.
--
-- Units: G = c = r_s = 1; φ is the right-handed angle about @+y@.
module BlackHole.Matter.Redshift
  ( PhotonMomentum (..),
    RadialSense (..),
    photonMomentum,
    momentumOfRay,
    frequencyIn,
    distantObserver,
    staticObserver,
    redshiftFactor,
    RedshiftParts (..),
    redshiftParts,
    gasRedshift,
    gasFrequency,
  )
where

import BlackHole.Matter.GasMotion
import BlackHole.Vector.XYZ (XYZ (..), dot)

-- | Covariant components of a photon's momentum over its energy at infinity. k_t is −1.
-- The component in latitude is omitted because the gas does not move in latitude.
data PhotonMomentum = PhotonMomentum
  { -- | k_r, positive for a photon that moves away from the hole.
    momentumRadial :: {-# UNPACK #-} !Double,
    -- | k_φ = λ, the angular momentum about @+y@, a length.
    momentumAzimuthal :: {-# UNPACK #-} !Double
  }
  deriving (Eq, Show)

-- | Whether the photon moves away from the hole or towards it.
data RadialSense = Outward | Inward
  deriving (Eq, Ord, Show, Read, Enum, Bounded)

-- | @photonMomentum sense b² λ r@ is the momentum at r > 1 of a photon with the squared
-- impact parameter b² and the angular momentum λ about @+y@, |λ| ≤ b: k_r = ±√(1 −
-- (1−1/r) b²/r²)/(1−1/r). At a turning point rounding may make the radicand negative;
-- it then counts as 0.
photonMomentum :: RadialSense -> Double -> Double -> Double -> PhotonMomentum
photonMomentum sense impactParameter2 lambda r =
  PhotonMomentum (signed (sqrt (max 0 radicand) / lapse2)) lambda
  where
    lapse2 = (r - 1) / r
    radicand = 1 - lapse2 * impactParameter2 / (r * r)
    signed = case sense of
      Outward -> id
      Inward -> negate
{-# INLINE photonMomentum #-}

-- | @momentumOfRay position velocity@ is the momentum of a photon at a position in
-- pseudo-space, from its pseudo-velocity there, of any length. 'Nothing' at and inside
-- the horizon, and for a velocity without a direction.
--
-- In pseudo-space h = |x × v| and 2E = v_r² + (1−1/r) h²/r² are constant, and b =
-- h/√(2E). The radial component is v_r = (1−1/r) k_r √(2E).
momentumOfRay :: XYZ -> XYZ -> Maybe PhotonMomentum
momentumOfRay position@(XYZ x _ z) velocity@(XYZ vx _ vz)
  | r > 1 && scale > 0 && not (isInfinite scale) =
    Just
      ( PhotonMomentum
          (radial / (lapse2 * scale))
          ((z * vx - x * vz) / scale)
      )
  | otherwise = Nothing
  where
    r = sqrt (dot position position)
    lapse2 = (r - 1) / r
    radial = dot position velocity / r
    -- The squared speed is radial² + h²/r², which saves the cross product.
    tangential2 = max 0 (dot velocity velocity - radial * radial)
    scale = sqrt (radial * radial + lapse2 * tangential2)
{-# INLINE momentumOfRay #-}

-- | ν/E∞ = −k·u: the photon's frequency for an observer with this four-velocity.
-- Positive outside the horizon. The relative error is 1e-16 except for photons that
-- fall with infalling gas, where it grows to 1e-16/(1−1/r).
--
-- It is also the length that the photon covers in that frame per unit of the affine
-- parameter with E∞ = 1, which is the pseudo-time of a ray scaled to 2E = 1. This is
-- the path length for emission and absorption.
frequencyIn :: FourVelocity -> PhotonMomentum -> Double
frequencyIn (FourVelocity ut ur uphi) (PhotonMomentum kr lambda) =
  ut - kr * ur - lambda * uphi
{-# INLINE frequencyIn #-}

-- | ν_obs/E∞ of an observer at rest at infinity: 1.
distantObserver :: Double
distantObserver = 1

-- | ν_obs/E∞ = 1/√(1−1/r) of an observer at rest at r, which is also this observer's g
-- for light from the sky. 'Nothing' at and inside the horizon.
staticObserver :: Double -> Maybe Double
staticObserver = fmap velocityTime . staticVelocity

-- | @redshiftFactor observed gas photon@ is g = ν_obs/ν_em from the observer's
-- ν_obs/E∞; above 1 for a blueshift. A black body of temperature T appears as one of
-- temperature g T, and its bolometric intensity is multiplied by g⁴.
redshiftFactor :: Double -> FourVelocity -> PhotonMomentum -> Double
redshiftFactor observed gas photon = observed / frequencyIn gas photon
{-# INLINE redshiftFactor #-}

-- | g split into two factors.
data RedshiftParts = RedshiftParts
  { -- | g of gas at rest at the same place: the gravitational factor, together with any
    -- motion that the observer's own factor contains.
    redshiftGravitational :: {-# UNPACK #-} !Double,
    -- | The Doppler factor of the gas relative to an observer at rest beside it; below
    -- 1 also for motion across the line of sight.
    redshiftDoppler :: {-# UNPACK #-} !Double
  }
  deriving (Eq, Show)

-- | @redshiftParts observed r gas photon@ splits g at r > 1 into the gravitational
-- factor ν_obs/E∞ √(1−1/r) and the Doppler factor of the gas.
redshiftParts :: Double -> Double -> FourVelocity -> PhotonMomentum -> RedshiftParts
redshiftParts observed r gas photon =
  RedshiftParts (observed * lapse) (1 / (lapse * frequencyIn gas photon))
  where
    lapse = sqrt ((r - 1) / r)
{-# INLINE redshiftParts #-}

-- | @gasRedshift observed position velocity@ is the shift of light that leaves the gas
-- at a position in the direction of the pseudo-velocity, which points towards the
-- observer. 'Nothing' at and inside the horizon, where there is no gas, and for a
-- velocity without a direction.
gasRedshift :: Double -> XYZ -> XYZ -> Maybe RedshiftParts
gasRedshift observed position@(XYZ _ y _) velocity = do
  photon <- momentumOfRay position velocity
  gas <- gasVelocity r y
  pure (redshiftParts observed r gas photon)
  where
    r = sqrt (dot position position)
{-# INLINE gasRedshift #-}

-- | @gasFrequency position r velocity@ is ν/E∞ of light in the frame of the gas at a
-- position at the distance @r > 1@ from the hole, from the /backward/ pseudo-velocity
-- of unit energy. It agrees with 'gasVelocity' and 'frequencyIn', and is faster for
-- circling gas, which fills most of a picture.
gasFrequency :: XYZ -> Double -> XYZ -> Double
gasFrequency position@(XYZ x y z) r velocity@(XYZ vx _ vz)
  | r >= 3 = (1 - sqrt (0.5 * u) * u * lambda) / sqrt (1 - u * (1.5 - 0.5 * sinLatitude * sinLatitude))
  | otherwise = case gasVelocity r y of
    Just moving -> frequencyIn moving (PhotonMomentum (negate (dot position velocity) / (r - 1)) lambda)
    Nothing -> 1
  where
    u = 1 / r
    sinLatitude = y * u
    lambda = x * vz - z * vx
{-# INLINE gasFrequency #-}
