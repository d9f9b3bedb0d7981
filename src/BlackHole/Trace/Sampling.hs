{-# LANGUAGE BangPatterns #-}

-- | The positions of a pixel's samples.
--
-- Every pixel draws its own samples, distributed like the reconstruction filter around
-- its middle (Ernst, Stamminger and Greiner 2006, "Filter importance sampling"). A
-- pixel is therefore a function of the scene and its position alone, and pictures can
-- be cut into bands anywhere. The points are the first two dimensions of Sobol's
-- sequence, shifted by random digits hashed from the seed and the pixel. For any k, the
-- first 4^k of them lie one in each cell of a grid.
--
-- Pixels on the photon ring spread the same points in other coordinates and weight
-- them by the filter ('curveSample').
module BlackHole.Trace.Sampling
  ( Sample (..),
    sampleOf,
    curveSample,
    filterDensity,
  )
where

import BlackHole.Noise.SipHash
import BlackHole.Numeric.Floor
import BlackHole.Scene.Filter
import BlackHole.Vector.XY (XY (..))
import Data.Bits (shiftR, testBit, unsafeShiftR, xor)
import Data.Primitive.PrimArray
import Data.Word (Word32, Word64, bitReverse32)

-- | A point of the picture in pixels from the top left corner, and its weight: for
-- 'sampleOf' 1, or −1 where the filter is negative.
data Sample = Sample
  { samplePlace :: {-# UNPACK #-} !XY,
    sampleWeight :: {-# UNPACK #-} !Double
  }
  deriving (Eq, Show)

-- | @sampleOf filter seed count column row index@ is a sample of a pixel; the index
-- starts at 0. If the count is 1, the sample sits in the middle of the pixel.
sampleOf :: Filter -> Word64 -> Int -> Int -> Int -> Int -> Sample
sampleOf reconstruction !seed !count !column !row !index
  | count == 1 = at 0.5 0.5 1
  | otherwise = case reconstruction of
    Box -> at u v 1
    Gaussian ->
      -- Both coordinates at once: the distance is distributed as 1 − e^(−2d²).
      let d = sqrt (-0.5 * log (1 - u * (1 - exp (-4.5))))
       in at (0.5 + d * cos (2 * pi * v)) (0.5 + d * sin (2 * pi * v)) 1
    Mitchell ->
      let (x, wx) = mitchellOffset u
          (y, wy) = mitchellOffset v
       in at (0.5 + x) (0.5 + y) (wx * wy)
  where
    at x y = Sample (XY (fromIntegral column + x) (fromIntegral row + y))
    XY u v = unitPoint seed column row index

-- | @curveSample filter seed normal distance column row index@ is a sample of a pixel on
-- a curve beside which the picture changes on every scale, as at the photon ring: there
-- each further image of the gas is 23 times thinner than the one before and 23 times
-- nearer to the curve.
--
-- The samples are stratified along and across the curve, whatever its direction. Along
-- it, they are distributed roughly like the filter. Across it, they follow a mixture: a
-- third of them like the filter, and the rest spread evenly over the logarithm of the
-- distance from the curve, down to a thirtieth of a pixel, so that as many meet each image.
-- One sequence of numbers is stratified over the whole mixture. The weights make up for the
-- distribution.
--
-- The function gives the distance of a point from the curve in pixels, positive on the
-- side of the normal, a unit vector, where the images are. Near the pixel it should grow
-- by one per pixel along the normal, but the weights are right, 1 on average, for any
-- function. The weight is 0 where there is no distance.
curveSample :: Filter -> Word64 -> XY -> (XY -> Maybe Double) -> Int -> Int -> Int -> Sample
curveSample reconstruction !seed (XY nx ny) distance !column !row !index =
  case distance (XY baseX baseY) of
    Nothing -> Sample (XY baseX baseY) 0
    Just d ->
      let low = asinh (max 0 (d - reach) / finest)
          high = asinh (max 0 (d + reach) / finest)
          across
            | high <= low = bell u
            | u < likeFilter = bell (u / likeFilter)
            | otherwise =
              finest * sinh (low + (u - likeFilter) / (1 - likeFilter) * (high - low)) - d
          offsetX = across * nx - along * ny
          offsetY = across * ny + along * nx
          density
            | high <= low = bellDensity across
            | d + across <= 0 = likeFilter * bellDensity across
            | otherwise =
              likeFilter * bellDensity across
                + (1 - likeFilter)
                  / ((high - low) * sqrt ((d + across) * (d + across) + finest * finest))
       in Sample
            (XY (middleX + offsetX) (middleY + offsetY))
            (filterDensity reconstruction offsetX offsetY / (bellDensity along * density))
  where
    XY u v = unitPoint seed column row index
    middleX = fromIntegral column + 0.5
    middleY = fromIntegral row + 0.5
    along = bell v
    baseX = middleX - along * ny
    baseY = middleY + along * nx
    finest = 1 / 30
    likeFilter = 0.3
    -- How far the filter reaches, whatever the direction of the curve, and the width of a
    -- logistic distribution like it; of a wide one only the flat top is used.
    (reach, width) = case reconstruction of
      Box -> (sqrt 0.5, 100)
      Gaussian -> (1.5, 0.55)
      Mitchell -> (sqrt 8, 0.66)
    edge = tanh (reach / width)
    bell p = width * atanh (edge * (2 * p - 1))
    bellDensity x = let t = tanh (x / width) in (1 - t * t) / (2 * width * edge)

-- | The filter at an offset from the pixel's middle; its integral is 1.
filterDensity :: Filter -> Double -> Double -> Double
filterDensity reconstruction x y = case reconstruction of
  Box -> if max (abs x) (abs y) <= 0.5 then 1 else 0
  Gaussian -> if d2 <= 2.25 then 2 / pi * exp (-2 * d2) / (1 - exp (-4.5)) else 0
  Mitchell -> mitchell x * mitchell y
  where
    d2 = x * x + y * y

-- | A pixel's points of the unit square.
unitPoint :: Word64 -> Int -> Int -> Int -> XY
unitPoint !seed !column !row !index = XY u v
  where
    shifts = sipHash2 (SipKey seed 0x73616d706c65) (fromIntegral column) (fromIntegral row)
    i = fromIntegral index :: Word32
    u = fraction (bitReverse32 i `xor` fromIntegral (shifts `shiftR` 32))
    v = fraction (sobolSecond i `xor` fromIntegral shifts)
    fraction w = (fromIntegral w + 0.5) / 4294967296
{-# INLINE unitPoint #-}

-- | The second dimension of Sobol's sequence: the binary digits times Pascal's triangle
-- modulo 2.
sobolSecond :: Word32 -> Word32
sobolSecond = go 0 0x80000000
  where
    go !digits !_ 0 = digits
    go !digits !column rest =
      go
        (if testBit rest 0 then digits `xor` column else digits)
        (column `xor` (column `unsafeShiftR` 1))
        (rest `unsafeShiftR` 1)

-- | The offset along one axis at a quantile of the filter's modulus, and the sign of
-- the filter there.
mitchellOffset :: Double -> (Double, Double)
mitchellOffset u = (x, if abs x > zeroOfMitchell then -1 else 1)
  where
    Floor i t = floorOf (u * fromIntegral quantileCount)
    a = indexPrimArray mitchellQuantiles i
    b = indexPrimArray mitchellQuantiles (min quantileCount (i + 1))
    x = a + t * (b - a)

-- | The offset at which the filter becomes negative.
zeroOfMitchell :: Double
zeroOfMitchell = 1.1428571428571428

-- | The filter of Mitchell and Netravali (1988) for B = C = 1\/3.
mitchell :: Double -> Double
mitchell x
  | d < 1 = (7 * d * d * d - 12 * d * d + 16 / 3) / 6
  | d < 2 = (-7 / 3 * d * d * d + 12 * d * d - 20 * d + 32 / 3) / 6
  | otherwise = 0
  where
    d = abs x

quantileCount :: Int
quantileCount = 4096

-- | The offsets at which the integral of the filter's modulus from −2 reaches each
-- 4096th of the whole.
mitchellQuantiles :: PrimArray Double
mitchellQuantiles = primArrayFromListN (quantileCount + 1) (go 0 0 (zip places sums))
  where
    steps = 20000 :: Int
    places = [-2 + 4 * fromIntegral k / fromIntegral steps | k <- [0 .. steps]] :: [Double]
    sums = scanl (+) 0 [abs (mitchell (p + 2 / fromIntegral steps)) | p <- places]
    whole = sums !!! steps
    xs !!! k = case drop k xs of
      x : _ -> x
      [] -> 1
    go :: Int -> Double -> [(Double, Double)] -> [Double]
    go k lastPlace rest
      | k > quantileCount = []
      | otherwise = case dropWhile ((< part) . snd) rest of
        found@((p, _) : _) -> p : go (k + 1) p found
        [] -> lastPlace : go (k + 1) lastPlace []
      where
        part = whole * fromIntegral k / fromIntegral quantileCount
{-# NOINLINE mitchellQuantiles #-}
