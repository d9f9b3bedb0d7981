{-# LANGUAGE BangPatterns #-}

-- | The positions at which a picture samples the gas of a disk, and the noise at these
-- positions: with tabulated gradients, and with every lattice point hashed.
module GasPlaces
  ( Places,
    placesOf,
    placeCount,
    Field (..),
    fields,
    total,
    agreeing,
  )
where

import BlackHole.Noise.CachedNoise
import BlackHole.Noise.Gradient
import BlackHole.Noise.Lattice
import BlackHole.Noise.PerlinG
import BlackHole.Noise.Profile (normalised, octaves)
import BlackHole.Noise.Sheets
import BlackHole.Scene.Camera (Picture (..))
import BlackHole.Scene.Disk
import BlackHole.Scene.Scene
import BlackHole.Spacetime.LightPath
import BlackHole.Trace.Ray
import BlackHole.Trace.Tracer
import BlackHole.Vector.XY (XY (..))
import BlackHole.Vector.XYZ (XYZ (..), (*^), (^+^))
import Control.DeepSeq (NFData (..))
import Data.Maybe (fromMaybe)
import qualified Data.Vector.Storable as Vector

-- | Three coordinates per position.
newtype Places = Places (Vector.Vector Double)

instance NFData Places where
  rnf (Places numbers) = rnf numbers

-- | The first positions, up to this many, at which a picture of 640 × 360 pixels
-- samples gas. Takes every eleventh row and column.
placesOf :: Int -> Scene -> Places
placesOf count scene = Places (Vector.fromList (concatMap components (take count found)))
  where
    small = scene {scenePicture = Picture 640 360, sceneSamples = 1}
    components (XYZ x y z) = [x, y, z]
    found = fromMaybe [] $ do
      traced <- tracer small
      pure
        [ segmentMiddle segment
          | row <- [0, 11 .. 359 :: Int],
            column <- [0, 11 .. 639 :: Int],
            let point = XY (fromIntegral column + 0.5) (fromIntegral row + 0.5),
            Just sight <- [tracedSight traced point],
            segment <-
              reverse (followedState (followSight traced point sight (\s t -> Continue (t : s)) []))
        ]

-- | The number of positions.
placeCount :: Places -> Int
placeCount (Places numbers) = Vector.length numbers `quot` 3

-- | Two ways to compute the same noise.
data Field = Field
  { fieldName :: String,
    fieldCached :: XYZ -> Double,
    fieldHashed :: XYZ -> Double
  }

-- | The noise of a disk's arms, and that of its turbulence.
fields :: Disk -> [Field]
fields disk =
  [ Field
      ("arms of " ++ show (diskArmNoiseOctaves disk) ++ " octaves, in space")
      (cachedPerlin3 (cacheNoise 2000000 seed profile (armPlace low) (armPlace high)) 64 . armPlace)
      (perlin3 seed profile . armPlace),
    Field
      "turbulence of 4 octaves, in sheets"
      (onSheets (sheetsValue turbulence 64))
      (onSheets (hashedSheets (sheetsAmplitudes turbulence)))
  ]
  where
    seed = Seed 42
    profile = normalised (octaves (clampedLevel 28) (diskArmNoiseOctaves disk) 0.5)
    outer = diskOuterRadius disk
    top = 3 * diskThickness disk
    low = XYZ (negate outer) (negate top) (negate outer)
    high = XYZ outer top outer
    armPlace place = (16 * diskArmNoiseFrequency disk) *^ place ^+^ XYZ 5.3 5.3 5.3
    turbulence = sheets seed 4 0.6
    -- Coordinates of the right kind and range; their exact values do not affect the
    -- cost.
    onSheets noise (XYZ x y z) = noise (0.01 * x) (0.6 * z) y
    {-# INLINE onSheets #-}

-- | 'sheetsValue' of all octaves, with the hash of each lattice point computed every
-- time.
hashedSheets :: [Double] -> Double -> Double -> Double -> Double
hashedSheets amplitudes turns v height = go 0 (iterate (+ 2.399963229728653) 0.7) amplitudes 0
  where
    go :: Int -> [Double] -> [Double] -> Double -> Double
    go !i (tilt : tilts) (amplitude : rest) !sum' =
      go
        (i + 1)
        tilts
        rest
        ( sum' + amplitude
            * maybe
              0
              (inCell . cellAround2 l)
              (onGrid2 (XY (place (8 * turns + cos tilt * height)) (place (v + sin tilt * height))))
        )
      where
        l = clampedLevel (5 + i)
        inCell cell = interpolate2 cell (cornerHashes2 hash cell)
        place x = 2 ^ i * x / cellsPerUnit l
        hash p =
          latticeHash2
            (Seed 42)
            ( latticePoint2
                l
                ((pointX2 p - middleIndex l) `mod` (8 * 2 ^ i))
                ((pointY2 p - middleIndex l) `mod` (32 * 2 ^ i))
            )
    go _ _ _ sum' = sum'

-- | The sum of a field over all positions, starting from a number. A different number
-- forces GHC to compute the sum again.
total :: (XYZ -> Double) -> Places -> Double -> Double
total noise (Places numbers) = go 0
  where
    !n = Vector.length numbers
    go :: Int -> Double -> Double
    go !i !acc
      | i >= n = acc
      | otherwise = go (i + 3) (acc + noise (placeAt numbers i))

-- | Whether both ways give the same bits at every position.
agreeing :: Field -> Places -> Bool
agreeing field (Places numbers) =
  and
    [ fieldCached field p == fieldHashed field p
      | i <- [0, 3 .. Vector.length numbers - 3],
        let p = placeAt numbers i
    ]

placeAt :: Vector.Vector Double -> Int -> XYZ
placeAt numbers i = XYZ (at 0) (at 1) (at 2)
  where
    at k = Vector.unsafeIndex numbers (i + k)
