{-# LANGUAGE BangPatterns #-}

-- | Grain: a picture made of dots of ink, all of one size and closer where the picture is
-- brighter, as J.-P. Luminet drew his picture of 1979.
--
-- Every cell of a grid has a list of places for dots. The brighter the picture, the more of
-- them have one, so that the part of the area that the dots cover is the brightness. The
-- places depend on the seed and the cell alone.
module BlackHole.Light.Grain
  ( Grain (..),
    noGrain,
    grainCover,
  )
where

import Data.Bits (shiftR, xor, (.&.))
import Data.Word (Word64)

-- | The diameter of the dots in pixels, 0 for none, and their seed.
data Grain = Grain
  { grainDiameter :: !Double,
    grainSeed :: !Word64
  }
  deriving (Eq, Show)

-- | Continuous tones.
noGrain :: Grain
noGrain = Grain 0 0

-- | @grainCover grain column row brightness@: how much of the pixel the dots cover, 0 to 1,
-- where the picture has this linear brightness, 0 to 1. Its mean over many pixels is the
-- brightness within 0.03. Takes up to a microsecond. The diameter must be above 0.
grainCover :: Grain -> Int -> Int -> Double -> Double
grainCover (Grain diameter seed) column row brightness
  | wanted > 0 = 1 - go (cellX - 1) (cellY - 1) 0 1
  | otherwise = 0
  where
    radius = max 0.5 (0.5 * diameter)
    -- With its soft edge, which is one pixel wide. So many dots anywhere leave the wanted
    -- part of the area uncovered.
    area = pi * (radius * radius + 1 / 12)
    side = 4 * radius
    wanted = negate (log (max 0.002 (1 - brightness))) * side * side / area
    x = fromIntegral column + 0.5 :: Double
    y = fromIntegral row + 0.5
    cellX = floor (x / side) :: Int
    cellY = floor (y / side) :: Int
    -- The part of the pixel that the dots so far leave uncovered.
    go :: Int -> Int -> Int -> Double -> Double
    go !cx !cy !k !uncovered
      | cy > cellY + 1 = uncovered
      | cx > cellX + 1 = go (cellX - 1) (cy + 1) 0 uncovered
      | fromIntegral k >= wanted = go (cx + 1) cy 0 uncovered
      | fromIntegral k + fraction h >= wanted = go cx cy (k + 1) uncovered
      | otherwise =
        let dx = side * (fromIntegral cx + fraction (h `shiftR` 21)) - x
            dy = side * (fromIntegral cy + fraction (h `shiftR` 42)) - y
         in go
              cx
              cy
              (k + 1)
              (uncovered * (1 - max 0 (min 1 (radius + 0.5 - sqrt (dx * dx + dy * dy)))))
      where
        h =
          mixed
            ( seed + 0x9e3779b97f4a7c15 * fromIntegral k
                + mixed (fromIntegral cx + mixed (fromIntegral cy))
            )
    -- The low 21 bits as a fraction.
    fraction bits = (fromIntegral (bits .&. 0x1fffff) + 0.5) / 2097152

-- | The finaliser of SplitMix64 (Steele, Lea and Flood 2014).
mixed :: Word64 -> Word64
mixed z0 = z2 `xor` (z2 `shiftR` 31)
  where
    z1 = (z0 `xor` (z0 `shiftR` 30)) * 0xbf58476d1ce4e5b9
    z2 = (z1 `xor` (z1 `shiftR` 27)) * 0x94d049bb133111eb
