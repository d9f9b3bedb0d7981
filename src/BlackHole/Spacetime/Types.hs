-- | The spacetimes that light can travel through, and their landmark radii, in
-- Schwarzschild radii.
module BlackHole.Spacetime.Types
  ( Spacetime (..),
    spacetimeSpin,
    pullOfGravity,
    spacetimeHorizon,
    spacetimeIsco,
    spacetimeCriticalImpact,
  )
where

import BlackHole.Spacetime.Kerr.Landmarks
import qualified BlackHole.Spacetime.Schwarzschild.Radii as Schwarzschild

-- | A spacetime with a black body at its origin: of radius one, or a rotating hole's
-- smaller horizon.
data Spacetime
  = -- | Around a hole that does not rotate; the Schwarzschild radius is 1.
    Schwarzschild
  | -- | Without gravity: straight rays, and a black ball in place of the hole.
    Flat
  | -- | Around a rotating hole of this spin.
    Kerr !Spin
  deriving (Eq, Show)

-- | The spin of the hole; none for the ball of flat space.
spacetimeSpin :: Spacetime -> Spin
spacetimeSpin space = case space of
  Kerr hole -> hole
  _ -> noSpin

-- | The factor of @−h² x / r⁵@ in a photon's acceleration in pseudo-space: 3/2 around a
-- hole, 0 without gravity. The paths around a rotating hole lie in no plane and have no
-- such law; what asks for it takes the hole for one without spin.
pullOfGravity :: Spacetime -> Double
pullOfGravity space = case space of
  Schwarzschild -> 1.5
  Kerr _ -> 1.5
  Flat -> 0
{-# INLINE pullOfGravity #-}

-- | The radius of the black body, at and inside which there is no gas.
spacetimeHorizon :: Spacetime -> Double
spacetimeHorizon space = case space of
  Kerr hole -> horizonRadius hole
  _ -> Schwarzschild.horizonRadius

-- | The innermost stable circular orbit of the right-handed gas; that of a hole without
-- spin in flat space, too, where the gas keeps its motion.
spacetimeIsco :: Spacetime -> Double
spacetimeIsco space = case space of
  Kerr hole -> iscoRadius RightHanded hole
  _ -> Schwarzschild.iscoRadius

-- | The impact parameter below which light from infinity falls into the hole. 'Nothing'
-- where one number does not decide that.
spacetimeCriticalImpact :: Spacetime -> Maybe Double
spacetimeCriticalImpact space = case space of
  Schwarzschild -> Just Schwarzschild.criticalImpactParameter
  _ -> Nothing
