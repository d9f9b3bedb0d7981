{-# LANGUAGE BangPatterns #-}

-- | Catalogues of point stars in order of brightness, and a random one made from a
-- seed: with as many stars of each magnitude as the real sky, the colours of bright
-- stars, and denser towards the plane of the galaxy.
--
-- A star of the random catalogue depends on the seed and its number alone: a longer
-- catalogue only adds fainter stars.
module BlackHole.Trace.StarCatalogue
  ( StarCatalogue,
    Star (..),
    catalogueOf,
    starCatalogue,
    starCount,
    starDirection,
    starMagnitude,
    starFlux,
    starTemperature,
    fluxOfMagnitude,
  )
where

import BlackHole.Noise.PerlinG (Seed (..))
import BlackHole.Noise.SipHash (SipKey (..), sipHash2)
import BlackHole.Numeric.Parallel (inParallel)
import BlackHole.Trace.Galaxy (fromGalactic)
import BlackHole.Vector.XYZ (XYZ (..))
import Control.Monad (forM_)
import Data.Bits (shiftR, (.&.))
import qualified Data.Vector.Unboxed as U
import qualified Data.Vector.Unboxed.Mutable as M
import Data.Word (Word64)
import GHC.Float (double2Float, float2Double)

-- | Stars by their number from 0, the brightest first. 20 bytes a star.
newtype StarCatalogue = StarCatalogue (U.Vector Float)

-- | Numbers stored for a star: direction, magnitude, temperature.
starNumbers :: Int
starNumbers = 5

-- | A star: its direction (unit length), apparent magnitude, and temperature in
-- kelvin.
data Star = Star !XYZ !Double !Double

-- | The catalogue with this many stars, each computed from its number, counted from 0; the
-- magnitudes must not fall. All idle processors share the work.
catalogueOf :: Int -> (Int -> Star) -> StarCatalogue
catalogueOf count starAt =
  StarCatalogue (U.concat (inParallel (map piece [0, pieceSize .. count - 1])))
  where
    pieceSize = 5000
    piece from = U.create $ do
      let here = min pieceSize (count - from)
      numbers <- M.new (starNumbers * here)
      forM_ [0 .. here - 1] $ \i -> do
        let !(Star (XYZ x y z) magnitude temperature) = starAt (from + i)
            put k = M.unsafeWrite numbers (starNumbers * i + k) . double2Float
        put 0 x
        put 1 y
        put 2 z
        put 3 magnitude
        put 4 temperature
      pure numbers
{-# INLINE catalogueOf #-}

-- | The random catalogue of the given number of brightest stars under a seed. Takes
-- 0.2 µs a star.
starCatalogue :: Seed -> Int -> StarCatalogue
starCatalogue (Seed seed) count = catalogueOf count (star seed)

-- | One star by its number.
star :: Word64 -> Int -> Star
star seed i =
  Star
    (fromGalactic (XYZ (s * cos l) (s * sin l) height))
    (magnitudeOfRank (fromIntegral i + uniform 2 upper))
    (temperatureOfQuantile (uniform 2 lower))
  where
    hash :: Word64 -> Word64
    hash = sipHash2 (SipKey seed 0x7374617273) (fromIntegral i)
    uniform k half = (fromIntegral (half (hash k)) + 0.5) / 4294967296 :: Double
    upper, lower :: Word64 -> Word64
    upper h = h `shiftR` 32
    lower h = h .&. 0xffffffff
    -- Bright stars are near and hardly concentrated towards the plane: the share of
    -- stars that are grows with the rank, up to half.
    inPlane = 0.5 * fromIntegral i / (fromIntegral i + 2000)
    u = uniform 0 lower
    height
      | uniform 0 upper >= inPlane = 2 * u - 1
      | u < 0.5 = exponentialHeight (2 * u)
      | otherwise = negate (exponentialHeight (2 * u - 1))
    l = 2 * pi * uniform 1 upper
    s = sqrt (max 0 (1 - height * height))

-- | A height over the galactic plane (sine of the latitude, 0 … 1) from a
-- quantile, falling off as e^{−height/0.16}.
exponentialHeight :: Double -> Double
exponentialHeight u = negate (scaleHeight * log (1 - u * (1 - exp (-1 / scaleHeight))))
  where
    scaleHeight = 0.16

-- | The magnitude up to which the whole sky has this number of stars:
-- log₁₀ N = 0.5 m + 0.704, and below magnitude 2 the law 0.6 m + 0.504 of an
-- even distribution in space. It has 50 stars up to 2 and 9000 up to 6.5, as
-- our sky does (Allen's Astrophysical Quantities, §"star counts").
magnitudeOfRank :: Double -> Double
magnitudeOfRank rank
  | rank <= rankOfTwo = (logBase 10 rank - 0.504) / 0.6
  | otherwise = (logBase 10 rank - 0.704) / 0.5
  where
    rankOfTwo = 10 ** 1.704

-- | Flux of a star by its magnitude (Pogson 1856), in units of the flux of
-- magnitude 0.
fluxOfMagnitude :: Double -> Double
fluxOfMagnitude m = exp (-0.4 * log 10 * m)

-- | Surface temperature in kelvin by quantile: the mix of spectral types among
-- the stars that the naked eye sees (after the Bright Star Catalogue: M 6 %, K
-- 26 %, G 14 %, F 14 %, A 22 %, B and O 18 %), even within each type.
temperatureOfQuantile :: Double -> Double
temperatureOfQuantile q = go 0 types
  where
    go _ [] = 20000
    go before ((upTo, cool, hot) : rest)
      | q < upTo = cool + (hot - cool) * (q - before) / (upTo - before)
      | otherwise = go upTo rest
    types =
      [ (0.06, 3000, 3800),
        (0.32, 3800, 5200),
        (0.46, 5200, 6000),
        (0.60, 6000, 7400),
        (0.82, 7400, 10000),
        (1, 10000, 20000)
      ]

-- | How many stars there are.
starCount :: StarCatalogue -> Int
starCount (StarCatalogue numbers) = U.length numbers `quot` starNumbers

number :: StarCatalogue -> Int -> Int -> Double
number (StarCatalogue numbers) i k = float2Double (U.unsafeIndex numbers (starNumbers * i + k))
{-# INLINE number #-}

-- | A star's direction (unit length to single precision). Here and in the following,
-- the star's number must be at least 0 and less than 'starCount'.
starDirection :: StarCatalogue -> Int -> XYZ
starDirection stars i = XYZ (number stars i 0) (number stars i 1) (number stars i 2)
{-# INLINE starDirection #-}

-- | A star's apparent magnitude.
starMagnitude :: StarCatalogue -> Int -> Double
starMagnitude stars i = number stars i 3

-- | A star's flux, 1 at magnitude 0.
starFlux :: StarCatalogue -> Int -> Double
starFlux stars i = fluxOfMagnitude (starMagnitude stars i)

-- | A star's surface temperature in kelvin.
starTemperature :: StarCatalogue -> Int -> Double
starTemperature stars i = number stars i 4
