-- | The gradients at the corners of a cell, and the noise between them (Perlin 1985, "An
-- image synthesizer", with the smoother weights of Perlin 2002, "Improving noise").
--
-- Each corner represents a linear function that is 0 at the corner and rises along the
-- corner's gradient. The noise is the weighted mean of these functions; the weights are
-- polynomials that make the value and its first and second derivatives continuous across
-- every cell border.
module BlackHole.Noise.Gradient
  ( Corners2 (..),
    Corners3 (..),
    cornerHashes2,
    cornerHashes3,
    interpolate2,
    interpolate3,
    interpolateGradients2,
    interpolateGradients3,
    gradientNumber2,
    gradientNumber3,
    numberedGradient2,
    numberedGradient3,
    fade,
    noiseScale3,
  )
where

import BlackHole.Noise.Lattice
import BlackHole.Vector.XY (XY (..))
import qualified BlackHole.Vector.XY as XY
import BlackHole.Vector.XYZ (XYZ (..))
import qualified BlackHole.Vector.XYZ as XYZ
import Data.Bits (unsafeShiftR)
import Data.Primitive.PrimArray (PrimArray, indexPrimArray, primArrayFromList)
import Data.Word (Word64)

-- | The hashes of a plane cell's corners; the x neighbour varies fastest.
data Corners2
  = Corners2
      {-# UNPACK #-} !Word64
      {-# UNPACK #-} !Word64
      {-# UNPACK #-} !Word64
      {-# UNPACK #-} !Word64
  deriving (Eq, Show)

-- | The hashes of a space cell's corners; the x neighbour varies fastest, then y, then
-- z.
data Corners3
  = Corners3
      {-# UNPACK #-} !Word64
      {-# UNPACK #-} !Word64
      {-# UNPACK #-} !Word64
      {-# UNPACK #-} !Word64
      {-# UNPACK #-} !Word64
      {-# UNPACK #-} !Word64
      {-# UNPACK #-} !Word64
      {-# UNPACK #-} !Word64
  deriving (Eq, Show)

-- | Hashes the four corners of a cell.
cornerHashes2 :: (LatticePoint2 -> Word64) -> Cell2 -> Corners2
cornerHashes2 hash (Cell2 p _ _) = Corners2 (hash p) (corner 1 0) (corner 0 1) (corner 1 1)
  where
    corner i j = hash (latticePoint2 (pointLevel2 p) (pointX2 p + i) (pointY2 p + j))
    {-# INLINE corner #-}
{-# INLINE cornerHashes2 #-}

-- | Hashes the eight corners of a cell.
cornerHashes3 :: (LatticePoint3 -> Word64) -> Cell3 -> Corners3
cornerHashes3 hash (Cell3 p _ _ _) =
  Corners3
    (hash p)
    (corner 1 0 0)
    (corner 0 1 0)
    (corner 1 1 0)
    (corner 0 0 1)
    (corner 1 0 1)
    (corner 0 1 1)
    (corner 1 1 1)
  where
    corner i j k =
      hash (latticePoint3 (pointLevel3 p) (pointX3 p + i) (pointY3 p + j) (pointZ3 p + k))
    {-# INLINE corner #-}
{-# INLINE cornerHashes3 #-}

-- | The noise in a plane cell whose corners have these hashes.
interpolate2 :: Cell2 -> Corners2 -> Double
interpolate2 (Cell2 _ x y) (Corners2 h00 h10 h01 h11) = interpolateGradients2 x y at
  where
    at 0 0 = gradientNumber2 h00
    at 1 0 = gradientNumber2 h10
    at 0 1 = gradientNumber2 h01
    at _ _ = gradientNumber2 h11
    {-# INLINE at #-}
{-# INLINE interpolate2 #-}

-- | The noise at a position in a plane cell (each fraction 0 to 1). The function
-- returns the number of the gradient ('gradientNumber2') at a corner, given by its
-- offsets along x and y, each 0 or 1.
interpolateGradients2 :: Double -> Double -> (Int -> Int -> Int) -> Double
interpolateGradients2 x y gradientAt =
  -- The largest value before scaling is 0.695353, found by maximising the weighted sum
  -- of the corners' largest contributions over the cell.
  1.4381
    * mix
      (fade y)
      (mix u (ramp 0 0 x y) (ramp 1 0 (x - 1) y))
      (mix u (ramp 0 1 x (y - 1)) (ramp 1 1 (x - 1) (y - 1)))
  where
    u = fade x
    ramp i j a b = XY.dot (numberedGradient2 (gradientAt i j)) (XY a b)
    {-# INLINE ramp #-}
{-# INLINE interpolateGradients2 #-}

-- | The noise in a space cell whose corners have these hashes.
interpolate3 :: Cell3 -> Corners3 -> Double
interpolate3 (Cell3 _ x y z) (Corners3 h000 h100 h010 h110 h001 h101 h011 h111) =
  interpolateGradients3 x y z at
  where
    at 0 0 0 = gradientNumber3 h000
    at 1 0 0 = gradientNumber3 h100
    at 0 1 0 = gradientNumber3 h010
    at 1 1 0 = gradientNumber3 h110
    at 0 0 1 = gradientNumber3 h001
    at 1 0 1 = gradientNumber3 h101
    at 0 1 1 = gradientNumber3 h011
    at _ _ _ = gradientNumber3 h111
    {-# INLINE at #-}
{-# INLINE interpolate3 #-}

-- | The noise at a position in a space cell (each fraction 0 to 1). The function
-- returns the number of the gradient ('gradientNumber3') at a corner, given by its
-- offsets along x, y and z, each 0 or 1.
interpolateGradients3 :: Double -> Double -> Double -> (Int -> Int -> Int -> Int) -> Double
interpolateGradients3 x y z gradientAt =
  noiseScale3
    * mix
      (fade z)
      ( mix
          v
          (mix u (ramp 0 0 0 x y z) (ramp 1 0 0 (x - 1) y z))
          (mix u (ramp 0 1 0 x (y - 1) z) (ramp 1 1 0 (x - 1) (y - 1) z))
      )
      ( mix
          v
          (mix u (ramp 0 0 1 x y (z - 1)) (ramp 1 0 1 (x - 1) y (z - 1)))
          (mix u (ramp 0 1 1 x (y - 1) (z - 1)) (ramp 1 1 1 (x - 1) (y - 1) (z - 1)))
      )
  where
    u = fade x
    v = fade y
    ramp i j k a b c = XYZ.dot (numberedGradient3 (gradientAt i j k)) (XYZ a b c)
    {-# INLINE ramp #-}
{-# INLINE interpolateGradients3 #-}

-- | The factor that scales noise in space to −1 to 1. The largest value before scaling
-- is 0.792021, found as in the plane.
noiseScale3 :: Double
noiseScale3 = 1.2625

-- | The weight of the far end of an edge: it rises from 0 at 0 to 1 at 1, and its first
-- two derivatives vanish at both ends (Perlin 2002).
fade :: Double -> Double
fade t = t * t * t * (t * (t * 6 - 15) + 10)
{-# INLINE fade #-}

mix :: Double -> Double -> Double -> Double
mix t a b = a + t * (b - a)
{-# INLINE mix #-}

-- | The number, 0 to 15, of the gradient that a hash selects in the plane. The gradients
-- are the 16 unit vectors at odd multiples of 11.25°, with equal probability. None is
-- perpendicular to an edge of the lattice, so no edge stays flat, and all moments up to
-- order 15 are those of a uniformly random direction.
gradientNumber2 :: Word64 -> Int
gradientNumber2 h = fromIntegral (h `unsafeShiftR` 60)
{-# INLINE gradientNumber2 #-}

-- | The gradient with a number that the caller knows to be in 0 to 15.
numberedGradient2 :: Int -> XY
numberedGradient2 n = XY (indexPrimArray gradientsX2 n) (indexPrimArray gradientsY2 n)
{-# INLINE numberedGradient2 #-}

-- | The number, 0 to 47, of the gradient that a hash selects in space: the upper half of
-- the hash as a fraction of 2^32, times 48. The gradients are the 48 unit vectors whose
-- components are ±0.2666…, ±0.4225…, ±0.8662… in any order, with equal probability (to
-- 1 in 2^32). The three squares are the roots of t³ − t² + t\/5 − 1\/105, which makes
-- all moments up to order 7 those of a uniformly random direction, so no axis is
-- favoured. No component is 0, so no edge of the lattice stays flat.
gradientNumber3 :: Word64 -> Int
gradientNumber3 h = fromIntegral (((h `unsafeShiftR` 32) * 48) `unsafeShiftR` 32)
{-# INLINE gradientNumber3 #-}

-- | The gradient with a number that the caller knows to be in 0 to 47.
numberedGradient3 :: Int -> XYZ
numberedGradient3 n =
  XYZ (indexPrimArray gradientsX3 n) (indexPrimArray gradientsY3 n) (indexPrimArray gradientsZ3 n)
{-# INLINE numberedGradient3 #-}

-- | The components of the plane's gradients in one array each; the gradient's number is
-- the index into both.
gradientsX2, gradientsY2 :: PrimArray Double
gradientsX2 = primArrayFromList [x | XY x _ <- gradients2]
gradientsY2 = primArrayFromList [y | XY _ y <- gradients2]
{-# NOINLINE gradientsX2 #-}
{-# NOINLINE gradientsY2 #-}

gradients2 :: [XY]
gradients2 =
  [ XY x y
    | (a, b) <- [(cos11, sin11), (cos34, sin34), (sin34, cos34), (sin11, cos11)],
      x <- [a, negate a],
      y <- [b, negate b]
  ]
  where
    -- Sines and cosines of 11.25° and 33.75° as literals, because the system's
    -- trigonometry may differ in the last bit between machines.
    cos11 = 0.9807852804032304
    sin11 = 0.19509032201612828
    cos34 = 0.8314696123025452
    sin34 = 0.5555702330196022

-- | The components of the gradients in space, in one array each.
gradientsX3, gradientsY3, gradientsZ3 :: PrimArray Double
gradientsX3 = primArrayFromList [x | XYZ x _ _ <- gradients3]
gradientsY3 = primArrayFromList [y | XYZ _ y _ <- gradients3]
gradientsZ3 = primArrayFromList [z | XYZ _ _ z <- gradients3]
{-# NOINLINE gradientsX3 #-}
{-# NOINLINE gradientsY3 #-}
{-# NOINLINE gradientsZ3 #-}

gradients3 :: [XYZ]
gradients3 =
  [ XYZ x y z
    | (a, b, c) <-
        [ (short, middle, long),
          (short, long, middle),
          (middle, short, long),
          (middle, long, short),
          (long, short, middle),
          (long, middle, short)
        ],
      x <- [a, negate a],
      y <- [b, negate b],
      z <- [c, negate c]
  ]
  where
    short = 0.26663540151670473
    middle = 0.42251865376111153
    long = 0.8662468181078206
