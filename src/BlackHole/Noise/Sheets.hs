{-# LANGUAGE BangPatterns #-}
-- Places and patterns are a dozen numbers, which go from caller to callee as they are,
-- not through the heap.
{-# OPTIONS_GHC -fmax-worker-args=24 #-}

-- | Noise for thin layers: gradient noise in the plane whose octaves are tilted against
-- each other in the third dimension.
--
-- Each octave is plane noise ("BlackHole.Noise.PerlinG"), extended along its own
-- slanted direction. No two heights look alike, and yet a value needs half the corners
-- of noise in space. The plane is periodic in its first coordinate, which is the angle
-- around a disk, and repeats in the second one after 'sheetsHeight'.
--
-- 'weave' combines the octaves into filaments and eddies, and blends two moving
-- patterns.
--
-- The gradients of all lattice points fit into a few kilobytes, so each is hashed only
-- once.
module BlackHole.Noise.Sheets
  ( Sheets,
    sheets,
    sheetsHeight,
    sheetsAmplitudes,
    sheetsValue,
    Weave (..),
    plainWeave,
    Strand (..),
    weave,
  )
where

import BlackHole.Noise.Gradient (gradientNumber2, interpolateGradients2)
import BlackHole.Noise.Lattice (clampedLevel, latticePoint2)
import BlackHole.Noise.PerlinG (Seed, latticeHash2)
import BlackHole.Numeric.Floor
import Data.Bits (bit, unsafeShiftL, unsafeShiftR, (.&.))
import Data.Primitive.PrimArray
import Data.Word (Word8)

-- | Several octaves of noise.
data Sheets = Sheets
  { -- | For each octave the amplitude, and the tilt along both coordinates.
    sheetsReals :: !(PrimArray Double),
    -- | Gradient numbers of all octaves, from coarse to fine, row by row.
    sheetsGradients :: !(PrimArray Word8)
  }

-- | @sheets seed count gain@ is noise whose coarsest octave has eight cells around.
-- Each of the @count@ octaves (0 to 8) is twice as fine and @gain@ times as strong as
-- the previous one; the moduli of the amplitudes add up to 1.
sheets :: Seed -> Int -> Double -> Sheets
sheets seed count gain =
  Sheets
    { sheetsReals =
        primArrayFromList (concat [[a / total, cos t, sin t] | (a, t) <- zip amplitudes tilts]),
      sheetsGradients = mconcat (map octave [0 .. octaveCount - 1])
    }
  where
    octaveCount = max 0 (min 8 count)
    amplitudes = take octaveCount (iterate (* gain) 1)
    total = max 1e-300 (sum (map abs amplitudes))
    -- Multiples of the golden angle, so that no two directions come close.
    tilts = iterate (+ 2.399963229728653) 0.7
    octave i = generatePrimArray (bit (rowBits + columnBits + 2 * i)) $ \k ->
      let x = fromIntegral (k .&. (bit (columnBits + i) - 1))
          y = fromIntegral (k `unsafeShiftR` (columnBits + i))
          point = latticePoint2 (clampedLevel (rowBits + i)) x y
       in fromIntegral (gradientNumber2 (latticeHash2 seed point))

-- | Cells of the coarsest octave: 2^3 around, and 2^5 along the second coordinate.
columnBits, rowBits :: Int
columnBits = 3
rowBits = 5

-- | The number of cells of the coarsest octave along the second coordinate after which
-- the noise repeats.
sheetsHeight :: Double
sheetsHeight = 2 ^ rowBits

-- | The amplitudes, from coarse to fine.
sheetsAmplitudes :: Sheets -> [Double]
sheetsAmplitudes noise = [indexPrimArray reals i | i <- [0, 3 .. sizeofPrimArray reals - 1]]
  where
    reals = sheetsReals noise

-- | @sheetsValue noise count turns v height@ is the noise at an angle in turns (−1 to
-- 1), a second coordinate and a height, both in cells of the coarsest octave and within
-- ±2^40. Only the first @count@ octaves contribute; a fractional @count@ weights the
-- last one by its fraction. Allocates nothing.
sheetsValue :: Sheets -> Double -> Double -> Double -> Double -> Double
sheetsValue noise count turns v height =
  weave noise plainWeave count v (Strand 1 turns height) (Strand 0 0 0)
{-# INLINE sheetsValue #-}

-- | What is made of the octaves.
data Weave = Weave
  { -- | The part, 0 … 1, that filaments have in the octaves after the first: crests
    -- along the lines on which an octave is 0, a sixth of a cell wide.
    weaveFilaments :: {-# UNPACK #-} !Double,
    -- | How far the sum of the coarser octaves bends each octave along the second
    -- coordinate, in cells of the coarsest.
    weaveBend :: {-# UNPACK #-} !Double,
    -- | How much stronger an octave is per unit of the sum of the coarser ones,
    -- and how much weaker where it is negative.
    weaveGrowth :: {-# UNPACK #-} !Double
  }
  deriving (Eq, Show)

-- | Nothing: the sum of the octaves as they are.
plainWeave :: Weave
plainWeave = Weave 0 0 0

-- | A pattern: its weight, and the angle in turns and the height at which it is
-- read. The squares of the weights of two patterns should add up to 1, which keeps
-- the variance of an octave, and with it the look of what is made of it.
data Strand
  = Strand
      {-# UNPACK #-} !Double
      {-# UNPACK #-} !Double
      {-# UNPACK #-} !Double

-- | @weave noise how count v strand strand@: the sum of the octaves of two
-- patterns at a second coordinate, by the rules and within the ranges of
-- 'sheetsValue'. A pattern without weight costs nothing. An octave's filaments need
-- the next octave's resolution, and count as that does. Its mean is not 0 except
-- for 'plainWeave'. Nothing is allocated.
weave :: Sheets -> Weave -> Double -> Double -> Strand -> Strand -> Double
weave
  (Sheets reals gradients)
  (Weave filaments bend growth)
  !count
  !v
  (Strand weight1 turns1 height1)
  (Strand weight2 turns2 height2) = go 0 count 0 1 0
    where
      !octaves = sizeofPrimArray reals `quot` 3
      go :: Int -> Double -> Int -> Double -> Double -> Double
      go !i !left !first !scale !total
        | i >= octaves || left <= 0 = total
        | otherwise =
          let !columns = columnBits + i
              !rows = rowBits + i
              !amplitude = indexPrimArray reals (3 * i)
              !tiltU = indexPrimArray reals (3 * i + 1)
              !tiltV = indexPrimArray reals (3 * i + 2)
              !weight = if left >= 1 then amplitude else left * amplitude
              !bent = v + bend * total
              strand share turns height
                | share < 1e-6 = 0
                | otherwise =
                  share
                    * layer
                      gradients
                      first
                      columns
                      rows
                      (scale * (8 * turns + tiltU * height))
                      (scale * (bent + tiltV * height))
              {-# INLINE strand #-}
              !noise1 = strand weight1 turns1 height1
              !noise2 = strand weight2 turns2 height2
              !noise = noise1 + noise2
              !part
                | filaments == 0 || i == 0 || left <= 1.5 = noise
                | otherwise =
                  let q = filaments * min 1 (left - 1.5) in noise + q * (crest noise - noise)
           in go (i + 1) (left - 1) (first + 1 `unsafeShiftL` (columns + rows)) (2 * scale) $
                total + weight * max 0 (1 + growth * total) * part

-- | A crest where noise of the variance 0.0962 is 0, of about that noise's mean and
-- variance.
crest :: Double -> Double
crest noise = 1 / (1 + 69 * noise * noise) - 0.38
{-# INLINE crest #-}

-- | One octave at a position given in its own cells.
layer :: PrimArray Word8 -> Int -> Int -> Int -> Double -> Double -> Double
layer gradients !first !columns !rows !x !y =
  interpolateGradients2 fx fy at
  where
    !(Floor cx fx) = floorOf x
    !(Floor cy fy) = floorOf y
    !columnMask = 1 `unsafeShiftL` columns - 1
    !rowMask = 1 `unsafeShiftL` rows - 1
    !x0 = cx .&. columnMask
    !x1 = (cx + 1) .&. columnMask
    !y0 = first + ((cy .&. rowMask) `unsafeShiftL` columns)
    !y1 = first + (((cy + 1) .&. rowMask) `unsafeShiftL` columns)
    at i j =
      fromIntegral
        (indexPrimArray gradients ((if i == 0 then x0 else x1) + (if j == 0 then y0 else y1)))
    {-# INLINE at #-}
{-# INLINE layer #-}
