-- | The momentum of light, and the frequency that an observer at rest measures.
--
-- Photons here are physical ones, on their way from their source to the observer; a
-- caller that traces light backwards must reverse the direction. Everything is per unit
-- of the photon's energy at infinity, E∞ = −k_t, which is constant along its path.
-- Frequencies are therefore ν/E∞, and the observer enters through one number, ν_obs/E∞.
--
-- Units: G = c = r_s = 1; φ is the right-handed angle about @+y@.
module BlackHole.Spacetime.Momentum
  ( Momentum (..),
    momentumOf,
    staticFrequency,
  )
where

import BlackHole.Spacetime.Photon
import BlackHole.Vector.XYZ (XYZ (..), dot)

-- | Covariant components of a photon's momentum over its energy at infinity. k_t is −1.
-- The component in latitude is omitted because the gas does not move in latitude.
data Momentum = Momentum
  { -- | k_r, positive for a photon that moves away from the hole.
    momentumRadial :: {-# UNPACK #-} !Double,
    -- | k_φ = λ, the angular momentum about @+y@, a length.
    momentumAzimuthal :: {-# UNPACK #-} !Double
  }
  deriving (Eq, Show)

-- | The momentum of a photon in the space around a hole without spin, from its
-- pseudo-velocity, of any length, in the direction in which the light travels. 'Nothing'
-- at and inside the horizon, and for a velocity without a direction.
--
-- In pseudo-space h = |x × v| and 2E = v_r² + (1−1/r) h²/r² are constant, and the radial
-- component is v_r = (1−1/r) k_r √(2E).
momentumOf :: Photon -> Maybe Momentum
momentumOf (Photon position@(XYZ x _ z) velocity@(XYZ vx _ vz))
  | r > 1 && scale > 0 && not (isInfinite scale) =
    Just (Momentum (radial / (lapse2 * scale)) ((z * vx - x * vz) / scale))
  | otherwise = Nothing
  where
    r = sqrt (dot position position)
    lapse2 = (r - 1) / r
    radial = dot position velocity / r
    -- The squared speed is radial² + h²/r², which saves the cross product.
    tangential2 = max 0 (dot velocity velocity - radial * radial)
    scale = sqrt (radial * radial + lapse2 * tangential2)

-- | ν/E∞ = 1/√(1−1/r) of an observer at rest at r from a hole without spin. 'Nothing' at
-- and inside the horizon, where nothing can be at rest, and at infinity.
staticFrequency :: Double -> Maybe Double
staticFrequency r
  | r > 1 && not (isInfinite r) = Just (sqrt (r / (r - 1)))
  | otherwise = Nothing
