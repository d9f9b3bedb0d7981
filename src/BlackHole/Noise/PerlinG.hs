{-# LANGUAGE BangPatterns #-}

-- | Gradient noise in the plane and in space, on the multi-level grid of
-- "BlackHole.Noise.Lattice".
--
-- Every lattice point has a random direction, the gradient, derived from the hash of
-- the point under the seed; "BlackHole.Noise.Gradient" interpolates between them. There
-- are no seams: not between cells, not at zero or at powers of two, and not at the edge
-- of the grid, which is a torus.
--
-- One level of noise is 0 at its lattice points, and a lattice point belongs to all
-- finer levels as well: at a coarse lattice point, such as the origin, all finer levels
-- vanish together. A caller whose subject lies there, or on a plane through such
-- points, should shift it by a fraction of a cell that is not a power of two.
--
-- Nothing is stored. A sample costs four hashes (plane) or eight hashes (space) per
-- level, anywhere. "BlackHole.Noise.CachedNoise" and "BlackHole.Noise.Sheets" store the
-- gradients of a box and of a torus, and return identical bits.
module BlackHole.Noise.PerlinG
  ( Seed (..),

    -- * Noise
    noise2,
    noise3,
    perlin2,
    perlin3,

    -- * Hashes of lattice points
    latticeHash2,
    latticeHash3,
    LatticeLine3,
    latticeLine3,
    lineHash3,
  )
where

import BlackHole.Noise.Gradient
import BlackHole.Noise.Lattice
import BlackHole.Noise.Profile (Profile, sumLayers)
import BlackHole.Noise.SipHash (SipKey (..), SipState, sipAfter2, sipHash2, sipHash3, sipThird)
import BlackHole.Vector.XY (XY)
import BlackHole.Vector.XYZ (XYZ)
import Data.Functor.Identity (Identity (..))
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

-- One call per level: several inlined copies are no faster.
plainNoise2 :: Seed -> Level -> GridPlace2 -> Double
plainNoise2 seed l place = interpolate2 cell (cornerHashes2 (latticeHash2 seed) cell)
  where
    cell = cellAround2 l place
{-# NOINLINE plainNoise2 #-}

-- One call per level: several inlined copies are no faster.
plainNoise3 :: Seed -> Level -> GridPlace3 -> Double
plainNoise3 seed l place = interpolate3 cell (cornerHashes3 (latticeHash3 seed) cell)
  where
    cell = cellAround3 l place
{-# NOINLINE plainNoise3 #-}

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
  LatticeLine3
    (pointLevel3 p)
    (sipAfter2 (latticeKey seed 3 (pointLevel3 p)) (pointX3 p) (pointY3 p))

-- | The 'latticeHash3' of the point of a line with this z, reduced around the torus.
lineHash3 :: LatticeLine3 -> Word64 -> Word64
lineHash3 (LatticeLine3 l state) z = sipThird state (pointZ3 (latticePoint3 l 0 0 z))

latticeKey :: Seed -> Word64 -> Level -> SipKey
latticeKey (Seed s) dimension l = SipKey s (256 * dimension + fromIntegral (levelNumber l))
{-# INLINE latticeKey #-}
