-- | The spaces that light can be followed through.
module BlackHole.Physics.Spacetime
  ( Spacetime (..),
    pullOfGravity,
    timeDilation,
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

-- | @√(1 − 1/r)@: how slowly the clock of an observer at rest at radius @r@
-- runs for one at rest at infinity. 'Nothing' at and inside the horizon, where
-- nobody can be at rest.
timeDilation :: Spacetime -> Double -> Maybe Double
timeDilation Flat _ = Just 1
timeDilation Schwarzschild r
  | r > 1 = Just (sqrt (1 - 1 / r))
  | otherwise = Nothing
