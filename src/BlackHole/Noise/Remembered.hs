{-# LANGUAGE BangPatterns #-}

-- | Noise whose lattice hashes are remembered for a box of space.
--
-- A picture asks for the same few lattice points again and again, and SipHash
-- is most of the cost of noise. The table holds the hashes of all points of the
-- levels that fit into a budget; elsewhere the hash is computed as ever. The
-- values are the same to the last bit either way.
module BlackHole.Noise.Remembered
  ( Remembered,
    remember,
    rememberedPoints,
    rememberedPerlin3,
  )
where

import BlackHole.Noise.Lattice
import BlackHole.Noise.PerlinG (Seed, latticeHash3, perlin3With)
import BlackHole.Noise.Profile (Profile, layers)
import BlackHole.Vector.XYZ (XYZ (..))
import Data.Functor.Identity (Identity (..))
import qualified Data.Vector.Unboxed as Unboxed
import Data.Word (Word64)

-- | Noise of a seed and a profile, with a table.
data Remembered = Remembered
  { rememberedSeed :: !Seed,
    rememberedProfile :: !Profile,
    -- | Seven numbers for each of the levels 0…64: first index along x, y, z,
    -- counts along x, y, z, and the place of the level's first hash in the
    -- table.
    rememberedBoxes :: !(Unboxed.Vector Word64),
    rememberedHashes :: !(Unboxed.Vector Word64)
  }

-- | @remember budget seed profile low high@: remember the box between two
-- corners, for as many of the profile's levels, coarse to fine, as need no more
-- than the budget of points together. Each takes 8 bytes and some 40 ns once.
-- A box that reaches beyond the torus is remembered all around it.
remember :: Int -> Seed -> Profile -> XYZ -> XYZ -> Remembered
remember budget seed profile low high =
  Remembered
    { rememberedSeed = seed,
      rememberedProfile = profile,
      rememberedBoxes = Unboxed.fromList (concatMap boxNumbers [0 .. 64]),
      rememberedHashes = Unboxed.concat (map hashesOf boxes)
    }
  where
    boxes = takeFitting 0 [box | (l, _) <- layers profile, Just box <- [boxAt l low high]]
    takeFitting _ [] = []
    takeFitting used (box : rest)
      | used + boxPoints box > fromIntegral (max 0 budget) = []
      | otherwise = box {boxOffset = used} : takeFitting (used + boxPoints box) rest
    boxNumbers n = case [box | box <- boxes, levelNumber (boxLevel box) == n] of
      Box _ x y z nx ny nz offset : _ -> [x, y, z, nx, ny, nz, offset]
      [] -> replicate boxFields 0
    hashesOf (Box l x y z nx ny nz _) =
      Unboxed.generate (fromIntegral (nx * ny * nz)) $ \i ->
        let (rest, dx) = fromIntegral i `quotRem` nx
            (dz, dy) = rest `quotRem` ny
         in latticeHash3 seed (latticePoint3 l (x + dx) (y + dy) (z + dz))

-- | How many lattice points the table holds.
rememberedPoints :: Remembered -> Int
rememberedPoints = Unboxed.length . rememberedHashes

-- | The same as 'BlackHole.Noise.PerlinG.perlin3' with the seed and profile,
-- bit for bit.
rememberedPerlin3 :: Remembered -> XYZ -> Double
rememberedPerlin3 (Remembered seed profile boxes hashes) =
  runIdentity . perlin3With (Identity . hash) profile
  where
    hash point
      | dx < field 3 && dy < field 4 && dz < field 5 =
        Unboxed.unsafeIndex hashes (fromIntegral (field 6 + dx + field 3 * (dy + field 4 * dz)))
      | otherwise = latticeHash3 seed point
      where
        !first = boxFields * levelNumber level'
        level' = pointLevel3 point
        field k = Unboxed.unsafeIndex boxes (first + k)
        -- Distances from the box's first corner, around the torus.
        !distances = latticePoint3 level' (pointX3 point - field 0) (pointY3 point - field 1) (pointZ3 point - field 2)
        !dx = pointX3 distances
        !dy = pointY3 distances
        !dz = pointZ3 distances
{-# INLINE rememberedPerlin3 #-}

boxFields :: Int
boxFields = 7

-- | The lattice points of one level that cells in a box of space have as
-- corners.
data Box = Box
  { boxLevel :: !Level,
    _boxX :: !Word64,
    _boxY :: !Word64,
    _boxZ :: !Word64,
    boxCountX :: !Word64,
    boxCountY :: !Word64,
    boxCountZ :: !Word64,
    boxOffset :: !Word64
  }

boxPoints :: Box -> Word64
boxPoints box = boxCountX box * boxCountY box * boxCountZ box

-- | 'Nothing' where a coordinate is not finite, or the box is empty or has too
-- many points to be worth a thought.
boxAt :: Level -> XYZ -> XYZ -> Maybe Box
boxAt l (XYZ x0 y0 z0) (XYZ x1 y1 z1) = do
  Cell3 corner _ _ _ <- cellAround3 l <$> onGrid3 (XYZ x0 y0 z0)
  nx <- count x0 x1
  ny <- count y0 y1
  nz <- count z0 z1
  pure (Box l (pointX3 corner) (pointY3 corner) (pointZ3 corner) nx ny nz 0)
  where
    cellsAround = cellsPerUnit l * circumference
    -- The cells touched, one more in case both ends lie within cells, and the
    -- last one's far corner.
    count a b
      | cells >= 0 && cells < 1e6 = Just (truncate (min cellsAround (cells + 3)))
      | otherwise = Nothing
      where
        cells = (b - a) * cellsPerUnit l
