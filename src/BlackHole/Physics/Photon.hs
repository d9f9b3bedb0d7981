-- | A photon as the renderer follows it: backwards in time, from the camera
-- into the scene, as a particle in pseudo-space.
--
-- Schwarzschild light obeys @u'' = (3/2) u² − u@ for @u = 1/r@ against the
-- swept angle. A particle of unit mass in flat space under the central
-- acceleration @−(3/2) h² x / r⁵@ traces the same curve (report, "Gravitational
-- Lensing"; after R. Antonelli), so position and pseudo-velocity are all that
-- has to be known. Lengths are in units of the Schwarzschild radius.
module BlackHole.Physics.Photon
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
-- Pseudo-time is an affine parameter of the real light ray. The velocity's
-- radial part is the contravariant @k^r@ and its tangential part @L/r@ of the
-- real momentum, both up to one common factor, which 'withUnitEnergy' fixes.
data Photon = Photon
  { photonPosition :: {-# UNPACK #-} !XYZ,
    photonVelocity :: {-# UNPACK #-} !XYZ
  }
  deriving (Eq, Show)

-- | @h = x × v@, the same along the whole path.
angularMomentum :: Photon -> XYZ
angularMomentum (Photon x v) = XYZ.cross x v
{-# INLINE angularMomentum #-}

-- | @E = |v|²/2 − h²/(2r³)@, the same along the whole path.
pseudoEnergy :: Photon -> Double
pseudoEnergy p@(Photon x v) =
  0.5 * (XYZ.normSquared v - XYZ.normSquared (angularMomentum p) / (r2 * sqrt r2))
  where
    r2 = XYZ.normSquared x
{-# INLINE pseudoEnergy #-}

-- | @b = h / √(2E)@ in Schwarzschild radii: the distance at which the path
-- would pass the hole if it were straight. 'Nothing' where the energy is not
-- positive, which is light that no straight path far away leads to.
impactParameter :: Photon -> Maybe Double
impactParameter p
  | e > 0 = Just (XYZ.norm (angularMomentum p) / sqrt (2 * e))
  | otherwise = Nothing
  where
    e = pseudoEnergy p

-- | The same path with its velocity scaled so that @2E = 1@: then @h@ is the
-- impact parameter, pseudo-time is the affine length in units in which the
-- photon's energy at infinity is one, and the speed tends to one far away.
-- 'Nothing' where the energy is not positive.
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
