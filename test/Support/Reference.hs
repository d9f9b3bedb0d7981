-- | The reference values in @test\/reference@: computed in 30-digit arithmetic
-- by two methods that agree beyond 1e-18.
module Support.Reference
  ( Deflection (..),
    readDeflections,
    Ray (..),
    RayFate (..),
    Crossing (..),
    readRays,
  )
where

import Data.Maybe (mapMaybe)
import Text.Read (readMaybe)

-- | One row of @deflection.csv@.
data Deflection = Deflection
  { deflectionImpactParameter :: Double,
    deflectionClosestApproach :: Double,
    -- | Radians.
    deflectionValue :: Double
  }
  deriving (Show)

-- | One row of @rays.csv@: a pixel of a static camera and, when the ray meets
-- the disk's plane, one such crossing. A ray with two crossings has two rows.
data Ray = Ray
  { rayCameraRadius :: Double,
    -- | Degrees from the axis +y.
    rayInclination :: Double,
    -- | Degrees from the inward radial direction.
    rayPsi :: Double,
    -- | Degrees, position angle from screen-right towards screen-up.
    rayEta :: Double,
    rayFate :: RayFate,
    rayImpactParameter :: Double,
    rayCrossing :: Maybe Crossing
  }
  deriving (Show)

-- | The fate of a reference ray.
data RayFate
  = -- | With the angle swept to infinity, in radians.
    RayEscapes Double
  | RayCaptured
  deriving (Show)

-- | A crossing of the plane @y = 0@.
data Crossing = Crossing
  { -- | Counted from 1.
    crossingNumber :: Int,
    crossingRadius :: Double,
    -- | @atan2 z x@, radians.
    crossingAzimuth :: Double,
    -- | Observed over emitted frequency of the orbiting gas.
    crossingRedshiftFactor :: Double
  }
  deriving (Show)

-- | All rows of @deflection.csv@; tests run in the package's root.
readDeflections :: IO [Deflection]
readDeflections = readRows row "test/reference/deflection.csv"
  where
    row [b, r0, value] = Deflection <$> readMaybe b <*> readMaybe r0 <*> readMaybe value
    row _ = Nothing

-- | All rows of @rays.csv@.
readRays :: IO [Ray]
readRays = readRows row "test/reference/rays.csv"
  where
    row [r, inclination, psi, eta, end, b, swept, number, radius, azimuth, g] =
      Ray <$> readMaybe r <*> readMaybe inclination <*> readMaybe psi <*> readMaybe eta
        <*> fate end swept
        <*> readMaybe b
        <*> pure
          (Crossing <$> readMaybe number <*> readMaybe radius <*> readMaybe azimuth <*> readMaybe g)
    row _ = Nothing
    fate "escaped" swept = RayEscapes <$> readMaybe swept
    fate "captured" _ = Just RayCaptured
    fate _ _ = Nothing

-- | The rows after the heading; a row that cannot be read is left out, so tests
-- also check how many there are.
readRows :: ([String] -> Maybe a) -> FilePath -> IO [a]
readRows row path = mapMaybe (row . fields) . drop 1 . lines <$> readFile path

fields :: String -> [String]
fields line = case break (== ',') line of
  (field, _ : rest) -> field : fields rest
  (field, []) -> [field]
