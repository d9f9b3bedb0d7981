-- | Photons as the renderer follows them: backwards in time from the camera into the
-- scene, as particles in pseudo-space.
--
-- Schwarzschild light obeys @u'' = (3/2) u² − u@, where @u = 1/r@ is a function of the
-- swept angle. A particle of unit mass in flat space under the central acceleration
-- @−(3/2) h² x / r⁵@ traces the same curve (Will Yager, "Accurately Rendering a Black
-- Hole", section "Gravitational Lensing", after Riccardo Antonelli). Position and
-- pseudo-velocity therefore describe a photon completely. Lengths are in Schwarzschild
-- radii.
module BlackHole.Spacetime.Photon
  ( Photon (..),
    angularMomentum,
    pseudoEnergy,
    impactParameter,
    withUnitEnergy,
    movesInward,
  )
where

import BlackHole.Vector.XYZ (XYZ, (*^))
import qualified BlackHole.Vector.XYZ as XYZ

-- | Position (Schwarzschild radii) and pseudo-velocity.
--
-- Pseudo-time is an affine parameter of the real light ray. The velocity's radial
-- component is the contravariant @k^r@ and its tangential component @L/r@ of the real
-- momentum, both up to one common factor, which 'withUnitEnergy' fixes.
data Photon = Photon
  { photonPosition :: {-# UNPACK #-} !XYZ,
    photonVelocity :: {-# UNPACK #-} !XYZ
  }
  deriving (Eq, Show)

-- | The angular momentum @h = x × v@, constant along the path.
angularMomentum :: Photon -> XYZ
angularMomentum (Photon x v) = XYZ.cross x v
{-# INLINE angularMomentum #-}

-- | The pseudo-energy @E = |v|²/2 − h²/(2r³)@, constant along the path.
pseudoEnergy :: Photon -> Double
pseudoEnergy p@(Photon x v) =
  0.5 * (XYZ.normSquared v - XYZ.normSquared (angularMomentum p) / (r2 * sqrt r2))
  where
    r2 = XYZ.normSquared x
{-# INLINE pseudoEnergy #-}

-- | The impact parameter @b = h / √(2E)@ in Schwarzschild radii: the distance at which
-- a straight continuation of the incoming path would pass the hole. 'Nothing' if the
-- energy is not positive, which means that the light cannot come from infinity.
impactParameter :: Photon -> Maybe Double
impactParameter p
  | e > 0 = Just (XYZ.norm (angularMomentum p) / sqrt (2 * e))
  | otherwise = Nothing
  where
    e = pseudoEnergy p

-- | The path with its velocity scaled so that @2E = 1@. Then @h@ is the impact
-- parameter, pseudo-time is the affine length in units in which the photon's energy at
-- infinity is one, and the speed tends to one far away. 'Nothing' if the energy is not
-- positive or not finite.
withUnitEnergy :: Photon -> Maybe Photon
withUnitEnergy p@(Photon x v)
  | e > 0 && e - e == 0 = Just (Photon x ((1 / sqrt (2 * e)) *^ v))
  | otherwise = Nothing
  where
    e = pseudoEnergy p

-- | Whether the distance from the hole is decreasing.
movesInward :: Photon -> Bool
movesInward (Photon x v) = XYZ.dot x v < 0
{-# INLINE movesInward #-}
