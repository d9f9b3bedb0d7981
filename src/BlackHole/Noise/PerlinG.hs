{-# LANGUAGE BangPatterns #-}

-- | Gradient noise in the plane and in space, on the multi-level grid of
-- "BlackHole.Noise.Lattice" (Perlin 1985, "An image synthesizer", with the smoother
-- weights of Perlin 2002, "Improving noise").
--
-- Every lattice point has a random direction, the gradient, derived from the hash of
-- the point under the seed. Each corner of a cell represents a linear function that is
-- 0 at the corner and rises along the corner's gradient. The noise is the weighted mean
-- of these functions; the weights are polynomials that make the value and its first and
-- second derivatives continuous across every cell border. There are no seams: not
-- between cells, not at zero or at powers of two, and not at the edge of the grid,
-- which is a torus.
--
-- One level of noise is 0 at its lattice points, and a lattice point belongs to all
-- finer levels as well: at a coarse lattice point, such as the origin, all finer levels
-- vanish together. A caller whose subject lies there, or on a plane through such
-- points, should shift it by a fraction of a cell that is not a power of two.
--
-- Nothing is stored. A sample costs four hashes (plane) or eight hashes (space) per
-- level, anywhere. Hash, gradient and interpolation are separate functions, so a caller
-- that caches hashes gets identical bits.
module BlackHole.Noise.PerlinG
  ( -- * Noise
    Seed (..),
    noise2,
    noise3,
    perlin2,
    perlin3,

    -- * With hashes from the caller
    noise2With,
    noise3With,
    perlin2With,
    perlin3With,

    -- * Parts
    latticeHash2,
    latticeHash3,
    LatticeLine3,
    latticeLine3,
    lineHash3,
    gradient2,
    gradient3,
    Corners2 (..),
    Corners3 (..),
    cornerHashes2,
    cornerHashes3,
    interpolate2,
    interpolate3,
    interpolateGradients2,
    interpolateGradients3,
    gradientNumber2,
    gradientNumber3,
    numberedGradient3,
    fade,
    noiseScale3,
  )
where

import BlackHole.Noise.Lattice
  ( Cell2 (..),
    Cell3 (..),
    GridPlace2,
    GridPlace3,
    LatticePoint2,
    LatticePoint3,
    Level,
    cellAround2,
    cellAround3,
    latticePoint2,
    latticePoint3,
    levelNumber,
    onGrid2,
    onGrid3,
    pointLevel2,
    pointLevel3,
    pointX2,
    pointX3,
    pointY2,
    pointY3,
    pointZ3,
  )
import BlackHole.Noise.Profile (Profile, sumLayers)
import BlackHole.Noise.SipHash (SipKey (..), SipState, sipAfter2, sipHash2, sipHash3, sipThird)
import BlackHole.Vector.XY (XY (..))
import qualified BlackHole.Vector.XY as XY
import BlackHole.Vector.XYZ (XYZ (..))
import qualified BlackHole.Vector.XYZ as XYZ
import Data.Bits (unsafeShiftR)
import Data.Functor.Identity (Identity (..))
import Data.Primitive.PrimArray (PrimArray, indexPrimArray, primArrayFromList)
import Data.Word (Word64)

-- | The seed of a noise field. All values are equally good, and fields of different
-- seeds are independent.
newtype Seed = Seed Word64
  deriving (Eq, Ord, Show)

-- | Noise of one level in the plane. It lies in −1 to 1 (the tight bound is 0.99999)
-- and has mean 0 and variance 1.4381² · 96835\/2081079 ≈ 0.0962. It is 0 at the level's
-- lattice points, twice continuously differentiable, and has the period
-- 'BlackHole.Noise.Lattice.circumference' in each coordinate. 0 if a coordinate is not
-- finite.
noise2 :: Seed -> Level -> XY -> Double
noise2 !seed !l v = maybe 0 (plainNoise2 seed l) (onGrid2 v)

-- | Noise of one level in space. It lies in −1 to 1 (the tight bound is 0.99993) and
-- has mean 0 and variance 1.2625² · 17527135\/480729249 ≈ 0.0581. It is 0 at the
-- level's lattice points, twice continuously differentiable, and has the period
-- 'BlackHole.Noise.Lattice.circumference' in each coordinate. 0 if a coordinate is not
-- finite.
noise3 :: Seed -> Level -> XYZ -> Double
noise3 !seed !l v = maybe 0 (plainNoise3 seed l) (onGrid3 v)

-- | Noise of a profile in the plane: the sum of amplitude times 'noise2' over the
-- profile's levels. Its modulus is at most 'BlackHole.Noise.Profile.profileBound'.
perlin2 :: Seed -> Profile -> XY -> Double
perlin2 seed p v = case onGrid2 v of
  Nothing -> 0
  Just place -> runIdentity (sumLayers (\l -> Identity (plainNoise2 seed l place)) p)

-- | Noise of a profile in space: the sum of amplitude times 'noise3' over the profile's
-- levels. Its modulus is at most 'BlackHole.Noise.Profile.profileBound'.
perlin3 :: Seed -> Profile -> XYZ -> Double
perlin3 seed p v = case onGrid3 v of
  Nothing -> 0
  Just place -> runIdentity (sumLayers (\l -> Identity (plainNoise3 seed l place)) p)

-- | 'noise2' with the caller's hash of lattice points, in any monad. Bit-identical to
-- 'noise2' where the hashes agree with 'latticeHash2'.
noise2With :: Monad m => (LatticePoint2 -> m Word64) -> Level -> XY -> m Double
noise2With hash l v = case onGrid2 v of
  Nothing -> pure 0
  Just place -> cellNoise2 hash l place
{-# INLINE noise2With #-}

-- | 'noise3' with the caller's hash of lattice points, in any monad. Bit-identical to
-- 'noise3' where the hashes agree with 'latticeHash3'.
noise3With :: Monad m => (LatticePoint3 -> m Word64) -> Level -> XYZ -> m Double
noise3With hash l v = case onGrid3 v of
  Nothing -> pure 0
  Just place -> cellNoise3 hash l place
{-# INLINE noise3With #-}

-- | 'perlin2' with the caller's hash of lattice points, in any monad.
perlin2With :: Monad m => (LatticePoint2 -> m Word64) -> Profile -> XY -> m Double
perlin2With hash p v = case onGrid2 v of
  Nothing -> pure 0
  Just place -> sumLayers (\l -> cellNoise2 hash l place) p
{-# INLINE perlin2With #-}

-- | 'perlin3' with the caller's hash of lattice points, in any monad.
perlin3With :: Monad m => (LatticePoint3 -> m Word64) -> Profile -> XYZ -> m Double
perlin3With hash p v = case onGrid3 v of
  Nothing -> pure 0
  Just place -> sumLayers (\l -> cellNoise3 hash l place) p
{-# INLINE perlin3With #-}

-- One call per level: several inlined copies are no faster.
plainNoise2 :: Seed -> Level -> GridPlace2 -> Double
plainNoise2 seed l place = runIdentity (cellNoise2 (Identity . latticeHash2 seed) l place)
{-# NOINLINE plainNoise2 #-}

cellNoise2 :: Monad m => (LatticePoint2 -> m Word64) -> Level -> GridPlace2 -> m Double
cellNoise2 hash l place = interpolate2 cell <$> cornerHashes2 hash cell
  where
    cell = cellAround2 l place
{-# INLINE cellNoise2 #-}

-- One call per level: several inlined copies are no faster.
plainNoise3 :: Seed -> Level -> GridPlace3 -> Double
plainNoise3 seed l place = runIdentity (cellNoise3 (Identity . latticeHash3 seed) l place)
{-# NOINLINE plainNoise3 #-}

cellNoise3 :: Monad m => (LatticePoint3 -> m Word64) -> Level -> GridPlace3 -> m Double
cellNoise3 hash l place = interpolate3 cell <$> cornerHashes3 hash cell
  where
    cell = cellAround3 l place
{-# INLINE cellNoise3 #-}

-- The two hashes stay calls, so an interpolation does not contain a copy of SipHash for
-- each corner.

-- | The random bits of a lattice point in the plane: SipHash-2-4 of its coordinates x,
-- y. The key is the seed followed by dimension · 256 + level, which makes dimensions
-- and levels as independent as seeds.
latticeHash2 :: Seed -> LatticePoint2 -> Word64
latticeHash2 seed p =
  sipHash2 (latticeKey seed 2 (pointLevel2 p)) (pointX2 p) (pointY2 p)
{-# NOINLINE latticeHash2 #-}

-- | The random bits of a lattice point in space: SipHash-2-4 of its coordinates x, y, z
-- under the key of 'latticeHash2' with dimension 3.
latticeHash3 :: Seed -> LatticePoint3 -> Word64
latticeHash3 seed p =
  sipHash3 (latticeKey seed 3 (pointLevel3 p)) (pointX3 p) (pointY3 p) (pointZ3 p)
{-# NOINLINE latticeHash3 #-}

-- | The points of a level in space with common x and y.
data LatticeLine3 = LatticeLine3 {-# UNPACK #-} !Level {-# UNPACK #-} !SipState

-- | The line along z through a point. 'lineHash3' on it costs two thirds of
-- 'latticeHash3'.
latticeLine3 :: Seed -> LatticePoint3 -> LatticeLine3
latticeLine3 seed p =
  LatticeLine3 (pointLevel3 p) (sipAfter2 (latticeKey seed 3 (pointLevel3 p)) (pointX3 p) (pointY3 p))

-- | The 'latticeHash3' of the point of a line with this z, reduced around the torus.
lineHash3 :: LatticeLine3 -> Word64 -> Word64
lineHash3 (LatticeLine3 l state) z = sipThird state (pointZ3 (latticePoint3 l 0 0 z))

latticeKey :: Seed -> Word64 -> Level -> SipKey
latticeKey (Seed s) dimension l = SipKey s (256 * dimension + fromIntegral (levelNumber l))
{-# INLINE latticeKey #-}

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
cornerHashes2 :: Monad m => (LatticePoint2 -> m Word64) -> Cell2 -> m Corners2
cornerHashes2 hash (Cell2 p _ _) = do
  h00 <- hash p
  h10 <- corner 1 0
  h01 <- corner 0 1
  h11 <- corner 1 1
  pure (Corners2 h00 h10 h01 h11)
  where
    corner i j = hash (latticePoint2 (pointLevel2 p) (pointX2 p + i) (pointY2 p + j))
    {-# INLINE corner #-}
{-# INLINE cornerHashes2 #-}

-- | Hashes the eight corners of a cell.
cornerHashes3 :: Monad m => (LatticePoint3 -> m Word64) -> Cell3 -> m Corners3
cornerHashes3 hash (Cell3 p _ _ _) = do
  h000 <- hash p
  h100 <- corner 1 0 0
  h010 <- corner 0 1 0
  h110 <- corner 1 1 0
  h001 <- corner 0 0 1
  h101 <- corner 1 0 1
  h011 <- corner 0 1 1
  h111 <- corner 1 1 1
  pure (Corners3 h000 h100 h010 h110 h001 h101 h011 h111)
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

-- | The gradient that a hash selects in the plane: one of the 16 unit vectors at odd
-- multiples of 11.25°, with equal probability. None is perpendicular to an edge of the
-- lattice, so no edge stays flat, and all moments up to order 15 are those of a
-- uniformly random direction.
gradient2 :: Word64 -> XY
gradient2 h = numberedGradient2 (gradientNumber2 h)
{-# INLINE gradient2 #-}

-- | The number of a hash's gradient in the plane, 0 to 15.
gradientNumber2 :: Word64 -> Int
gradientNumber2 h = fromIntegral (h `unsafeShiftR` 60)
{-# INLINE gradientNumber2 #-}

-- | The gradient with a number that the caller knows to be in 0 to 15.
numberedGradient2 :: Int -> XY
numberedGradient2 n = XY (indexPrimArray gradientsX2 n) (indexPrimArray gradientsY2 n)
{-# INLINE numberedGradient2 #-}

-- | The gradient that a hash selects in space: one of the 48 unit vectors whose
-- components are ±0.2666…, ±0.4225…, ±0.8662… in any order, with equal probability (to
-- 1 in 2^32). The three squares are the roots of t³ − t² + t\/5 − 1\/105, which makes
-- all moments up to order 7 those of a uniformly random direction, so no axis is
-- favoured. No component is 0, so no edge of the lattice stays flat.
gradient3 :: Word64 -> XYZ
gradient3 h = numberedGradient3 (gradientNumber3 h)
{-# INLINE gradient3 #-}

-- | The number of a hash's gradient in space, 0 to 47: the upper half of the hash as a
-- fraction of 2^32, times 48.
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
