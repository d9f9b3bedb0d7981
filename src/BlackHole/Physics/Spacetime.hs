-- | The spacetimes that light can travel through.
module BlackHole.Physics.Spacetime
  ( Spacetime (..),
    pullOfGravity,
  )
where

-- | A spacetime with a black body of radius one at its origin.
data Spacetime
  = -- | Around a hole that does not rotate; the Schwarzschild radius is 1.
    Schwarzschild
  | -- | Without gravity: straight rays, and a black ball in place of the hole.
    Flat
  deriving (Eq, Show, Read, Enum, Bounded)

-- | The factor of @−h² x / r⁵@ in a photon's acceleration: 3/2 around a hole, 0 without
-- gravity.
pullOfGravity :: Spacetime -> Double
pullOfGravity Schwarzschild = 1.5
pullOfGravity Flat = 0
{-# INLINE pullOfGravity #-}
