-- | Random vectors, directions and photons for the properties.
module Support.Generators
  ( Coordinates (..),
    Plane (..),
    Direction (..),
    Outside (..),
    inRange,
  )
where

import BlackHole.Vector.XY (XY (..))
import BlackHole.Vector.XYZ (XYZ (..), (*^))
import Test.QuickCheck

-- | A vector of space with components of moderate size.
newtype Coordinates = Coordinates XYZ
  deriving (Show)

instance Arbitrary Coordinates where
  arbitrary = Coordinates <$> (XYZ <$> component <*> component <*> component)
    where
      component = inRange (-100) 100

-- | A vector of the plane, likewise.
newtype Plane = Plane XY
  deriving (Show)

instance Arbitrary Plane where
  arbitrary = Plane <$> (XY <$> inRange (-100) 100 <*> inRange (-100) 100)

-- | A unit vector, evenly over the sphere (Archimedes).
newtype Direction = Direction XYZ
  deriving (Show)

instance Arbitrary Direction where
  arbitrary = do
    z <- inRange (-1) 1
    phi <- inRange 0 (2 * pi)
    let s = sqrt (max 0 (1 - z * z))
    pure (Direction (XYZ (s * cos phi) (s * sin phi) z))

-- | A place between the photon sphere and @r = 40@.
newtype Outside = Outside XYZ
  deriving (Show)

instance Arbitrary Outside where
  arbitrary = do
    r <- inRange 1.6 40
    Direction d <- arbitrary
    pure (Outside (r *^ d))

-- | A number from an interval.
inRange :: Double -> Double -> Gen Double
inRange low high = choose (low, high)
