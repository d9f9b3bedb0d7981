-- | The spaces that light can be followed through.
module BlackHole.Physics.Spacetime
  ( Spacetime (..),
    pullOfGravity,
  )
where

-- | A space with a black body of radius one at its origin.
data Spacetime
  = -- | Around a hole that does not rotate; Schwarzschild radius 1.
    Schwarzschild
  | -- | Without gravity: straight rays, and a black ball instead of a hole.
    Flat
  deriving (Eq, Show, Read, Enum, Bounded)

-- | The factor of @−h² x / r⁵@ in a photon's acceleration.
pullOfGravity :: Spacetime -> Double
pullOfGravity Schwarzschild = 1.5
pullOfGravity Flat = 0
{-# INLINE pullOfGravity #-}
