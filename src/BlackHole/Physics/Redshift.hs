-- | The frequency shift of light from the gas to the observer,
-- g = ν_obs/ν_em, from the photon's momentum and the gas's four-velocity.
--
-- Photons here are the real ones, on their way from the gas to the observer;
-- who traces light backwards must turn the direction round. Everything is per
-- unit of the photon's energy at infinity, E∞ = −k_t, which does not change
-- along its path; frequencies are therefore ν/E∞, and the observer enters by
-- one number, his ν_obs/E∞.
--
-- Units: G = c = r_s = 1; φ is the right-handed angle about @+y@.
module BlackHole.Physics.Redshift
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

import BlackHole.Physics.GasMotion
import BlackHole.Vector.XYZ (XYZ (..), dot)

-- | Covariant components of a photon's momentum over its energy at infinity;
-- k_t is −1, and the component in latitude is of no concern to gas that does
-- not move in latitude.
data PhotonMomentum = PhotonMomentum
  { -- | k_r, positive for a photon that moves away from the hole.
    momentumRadial :: {-# UNPACK #-} !Double,
    -- | k_φ = λ, its angular momentum about @+y@, a length.
    momentumAzimuthal :: {-# UNPACK #-} !Double
  }
  deriving (Eq, Show)

-- | Whether the photon moves away from the hole or towards it.
data RadialSense = Outward | Inward
  deriving (Eq, Ord, Show, Read, Enum, Bounded)

-- | @photonMomentum sense b² λ r@: the momentum at r > 1 of a photon with the
-- squared impact parameter b² and the angular momentum λ about @+y@, |λ| ≤ b:
-- k_r = ±√(1 − (1−1/r) b²/r²)/(1−1/r). At a turning point rounding may leave a
-- negative radicand; it counts as 0.
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

-- | @momentumOfRay position velocity@: the same from a place in pseudo-space
-- and the photon's pseudo-velocity there, of any length. 'Nothing' at and
-- inside the horizon, and for a velocity without a direction.
--
-- In pseudo-space h = |x × v| and 2E = v_r² + (1−1/r) h²/r² are constants and
-- b = h/√(2E); the radial component is v_r = (1−1/r) k_r √(2E).
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
    -- v|² is radial² + h²/r², which saves the cross product.
    tangential2 = max 0 (dot velocity velocity - radial * radial)
    scale = sqrt (radial * radial + lapse2 * tangential2)
{-# INLINE momentumOfRay #-}

-- | ν/E∞ = −k·u: the photon's frequency for who moves with the four-velocity.
-- Positive outside the horizon; its relative error is 1e-16 except for photons
-- that fall with falling gas, where it grows to 1e-16/(1−1/r).
--
-- It is also the length that the photon covers in that frame per unit of the
-- affine parameter which has E∞ = 1 (and that is the pseudo-time of a ray
-- scaled to 2E = 1): the path length for emission and absorption.
frequencyIn :: FourVelocity -> PhotonMomentum -> Double
frequencyIn (FourVelocity ut ur uphi) (PhotonMomentum kr lambda) =
  ut - kr * ur - lambda * uphi
{-# INLINE frequencyIn #-}

-- | ν_obs/E∞ of an observer at rest at infinity: 1.
distantObserver :: Double
distantObserver = 1

-- | ν_obs/E∞ = 1/√(1−1/r) of an observer at rest at r; 'Nothing' at and inside
-- the horizon. Also his g for light of the sky.
staticObserver :: Double -> Maybe Double
staticObserver = fmap velocityTime . staticVelocity

-- | @redshiftFactor observed gas photon@: g = ν_obs/ν_em, above 1 for a blue
-- shift, from the observer's ν_obs/E∞. A black body of temperature T is seen
-- as one of g T; its bolometric intensity is multiplied by g⁴.
redshiftFactor :: Double -> FourVelocity -> PhotonMomentum -> Double
redshiftFactor observed gas photon = observed / frequencyIn gas photon
{-# INLINE redshiftFactor #-}

-- | g taken apart: their product is g.
data RedshiftParts = RedshiftParts
  { -- | g if the gas were at rest where it is: gravity's part, and with it
    -- whatever motion the observer's own factor contains.
    redshiftGravitational :: {-# UNPACK #-} !Double,
    -- | The part of the gas's motion against an observer at rest beside it;
    -- below 1 also for motion across the line of sight.
    redshiftDoppler :: {-# UNPACK #-} !Double
  }
  deriving (Eq, Show)

-- | @redshiftParts observed r gas photon@: g at r > 1 taken apart into
-- gravitation, ν_obs/E∞ √(1−1/r), and the gas's Doppler shift.
redshiftParts :: Double -> Double -> FourVelocity -> PhotonMomentum -> RedshiftParts
redshiftParts observed r gas photon =
  RedshiftParts (observed * lapse) (1 / (lapse * frequencyIn gas photon))
  where
    lapse = sqrt ((r - 1) / r)
{-# INLINE redshiftParts #-}

-- | @gasRedshift observed position velocity@: the shift of light that leaves
-- the gas at a place in the direction of the pseudo-velocity, which points
-- towards the observer. 'Nothing' where there is no gas, at and inside the
-- horizon, and for a velocity without a direction.
gasRedshift :: Double -> XYZ -> XYZ -> Maybe RedshiftParts
gasRedshift observed position@(XYZ _ y _) velocity = do
  photon <- momentumOfRay position velocity
  gas <- gasVelocity r y
  pure (redshiftParts observed r gas photon)
  where
    r = sqrt (dot position position)
{-# INLINE gasRedshift #-}

-- | @gasFrequency position r velocity@: ν/E∞ of light in the frame of the gas at
-- a place whose distance from the hole is @r > 1@, from the /backward/
-- pseudo-velocity of unit energy. The same as by 'gasVelocity' and
-- 'frequencyIn', worked out for the case that fills a picture: circling gas.
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
