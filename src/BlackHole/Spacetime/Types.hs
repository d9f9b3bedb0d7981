-- | The spacetimes that light can travel through.
module BlackHole.Spacetime.Types
  ( Spacetime (..),
    pullOfGravity,
  )
where

import BlackHole.Spacetime.Kerr.Landmarks (Spin)

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

-- | The factor of @−h² x / r⁵@ in a photon's acceleration in pseudo-space: 3/2 around a
-- hole, 0 without gravity. The paths around a rotating hole lie in no plane and have no
-- such law; what asks for it takes the hole for one without spin.
pullOfGravity :: Spacetime -> Double
pullOfGravity space = case space of
  Schwarzschild -> 1.5
  Kerr _ -> 1.5
  Flat -> 0
{-# INLINE pullOfGravity #-}
