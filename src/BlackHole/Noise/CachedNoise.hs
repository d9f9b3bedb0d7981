{-# LANGUAGE BangPatterns #-}

-- | Noise in space with a table of the gradients in a box.
--
-- A picture needs the same few lattice points again and again, and SipHash accounts for
-- most of the cost of noise. The table holds the number of the gradient, one byte, of
-- every point of the levels that fit into a budget. Points outside it are hashed. The
-- values are identical to the last bit either way.
module BlackHole.Noise.CachedNoise
  ( CachedNoise,
    cacheNoise,
    cachedPoints,
    cachedPerlin3,
  )
where

import BlackHole.Noise.Gradient
import BlackHole.Noise.Lattice
import BlackHole.Noise.PerlinG
import BlackHole.Noise.Profile (Profile, layers)
import BlackHole.Numeric.Floor
import BlackHole.Numeric.Parallel
import BlackHole.Vector.XYZ (XYZ (..))
import Control.Monad (guard, when)
import Data.Bits ((.&.))
import Data.Primitive.PrimArray
import Data.Word (Word64, Word8)

-- | Noise of a seed and a profile, with a table of gradients.
data CachedNoise = CachedNoise
  { cachedSeed :: !Seed,
    -- | For each level of the profile whose amplitude is not 0: that amplitude, and the
    -- cells per unit of space.
    cachedReals :: !(PrimArray Double),
    -- | For each of these levels 'boxFields' numbers ('boxNumbers').
    cachedBoxes :: !(PrimArray Word64),
    cachedGradients :: !(PrimArray Word8)
  }

-- | @remember budget seed profile low high@ tabulates the gradients in the box between
-- the corners @low@ and @high@, for as many of the profile's levels, from coarse to
-- fine, as together need at most @budget@ points. Each point takes one byte and about
-- 25 ns, once. A box that reaches beyond the torus is tabulated all around it.
cacheNoise :: Int -> Seed -> Profile -> XYZ -> XYZ -> CachedNoise
cacheNoise budget seed profile low high =
  CachedNoise
    { cachedSeed = seed,
      cachedReals = primArrayFromList (concat [[a, cellsPerUnit l] | (l, a) <- layers profile]),
      cachedBoxes = primArrayFromList (concatMap boxNumbers boxes),
      cachedGradients = mconcat (inParallel (concatMap gradientsOf boxes))
    }
  where
    boxes = fitting 0 [(l, boxAt l low high) | (l, _) <- layers profile]
    fitting _ [] = []
    fitting used ((l, found) : rest) = case found of
      Just box
        | used + boxPoints box <= fromIntegral (max 0 budget) ->
          box {boxOffset = used} : fitting (used + boxPoints box) rest
      _ -> [CellBox l' 0 0 0 0 0 0 0 | l' <- l : map fst rest]
    gradientsOf box
      | boxCountX box == 0 = []
      | otherwise =
        [ gradientsOfLines seed box from (min (lineCount box) (from + pieceOf box))
          | from <- [0, pieceOf box .. lineCount box - 1]
        ]
    lineCount box = fromIntegral ((boxCountX box + 1) * (boxCountY box + 1)) :: Int
    -- About 50 000 points.
    pieceOf box = 1 + 50000 `quot` fromIntegral (boxCountZ box + 1)

-- | The numbers of the gradients on a range of a box's lines along z, given by the
-- first line and the line after the last.
gradientsOfLines :: Seed -> CellBox -> Int -> Int -> PrimArray Word8
gradientsOfLines seed (CellBox l x y z _ ny nz _) from to = runPrimArray $ do
  numbers <- newPrimArray ((to - from) * count)
  let along !line = when (line < to) $ do
        let (dx, dy) = fromIntegral line `quotRem` (ny + 1)
            !points = latticeLine3 seed (latticePoint3 l (x + dx) (y + dy) z)
            on !i = when (i < count) $ do
              writePrimArray
                numbers
                ((line - from) * count + i)
                (fromIntegral (gradientNumber3 (lineHash3 points (z + fromIntegral i))))
              on (i + 1)
        on 0
        along (line + 1)
  along from
  pure numbers
  where
    !count = fromIntegral (nz + 1) :: Int

-- | The number of lattice points in the table.
cachedPoints :: CachedNoise -> Int
cachedPoints = sizeofPrimArray . cachedGradients

-- | @rememberedPerlin3 noise count place@ is the sum over the first @count@ levels,
-- from coarse to fine; a fractional @count@ weights the last level by its fraction.
-- With all levels it is bit-identical to 'BlackHole.Noise.PerlinG.perlin3' with this
-- seed and profile. Allocates nothing.
cachedPerlin3 :: CachedNoise -> Double -> XYZ -> Double
cachedPerlin3 (CachedNoise seed reals boxes gradients) !count place@(XYZ px py pz) =
  case onGrid3 place of
    Nothing -> 0
    Just (GridPlace3 x y z) -> go 0 count 0
      where
        !levels = sizeofPrimArray reals `quot` realFields
        go :: Int -> Double -> Double -> Double
        go !i !left !total
          | i >= levels || left <= 0 = total
          | otherwise =
            go
              (i + 1)
              (left - 1)
              (total + (if left >= 1 then amplitude else left * amplitude) * value i)
          where
            amplitude = indexPrimArray reals (realFields * i)
        -- A call of its own for each level, so that its strict numbers are not computed
        -- beyond the last level.
        value :: Int -> Double
        value !i
          | dx < nx && dy < ny && dz < nz = interpolateGradients3 u v w at
          | otherwise = hashed seed (field 0) (XYZ px py pz)
          where
            field k = indexPrimArray boxes (boxFields * i + k)
            !cells = indexPrimArray reals (realFields * i + 1)
            !mask = field 1
            !(Floor cellX u) = floorOf (cells * x)
            !(Floor cellY v) = floorOf (cells * y)
            !(Floor cellZ w) = floorOf (cells * z)
            -- Distances from the box's first corner, around the torus.
            !dx = (fromIntegral cellX - field 2) .&. mask
            !dy = (fromIntegral cellY - field 3) .&. mask
            !dz = (fromIntegral cellZ - field 4) .&. mask
            !nx = field 5
            !ny = field 6
            !nz = field 7
            -- A line of points is one longer than a line of cells.
            !line = fromIntegral (nz + 1) :: Int
            !slice = line * fromIntegral (ny + 1)
            !first =
              fromIntegral (field 8) + fromIntegral dz + line * fromIntegral dy
                + slice * fromIntegral dx
            at a b c =
              fromIntegral
                ( indexPrimArray
                    gradients
                    (first + c + (if b == 0 then 0 else line) + (if a == 0 then 0 else slice))
                )
            {-# INLINE at #-}

-- The level is made from its number inside this function. Otherwise GHC would prepare
-- the noise of the lowest and the highest level at every position.
hashed :: Seed -> Word64 -> XYZ -> Double
hashed !seed !number = noise3 seed (clampedLevel (fromIntegral number))
{-# NOINLINE hashed #-}

-- | The cells of one level in a box of space: the first index and the number of cells
-- along each axis, and the position of its points in the table.
data CellBox = CellBox
  { _boxLevel :: !Level,
    _boxX :: !Word64,
    _boxY :: !Word64,
    _boxZ :: !Word64,
    boxCountX :: !Word64,
    boxCountY :: !Word64,
    boxCountZ :: !Word64,
    boxOffset :: !Word64
  }

boxFields, realFields :: Int
boxFields = 9
realFields = 2

-- | The box in the form that 'cachedPerlin3' reads.
boxNumbers :: CellBox -> [Word64]
boxNumbers (CellBox l x y z nx ny nz offset) =
  [ fromIntegral (levelNumber l),
    lastIndex l,
    fromMiddle x,
    fromMiddle y,
    fromMiddle z,
    nx,
    ny,
    nz,
    offset
  ]
  where
    fromMiddle i = i - middleIndex l

boxPoints :: CellBox -> Word64
boxPoints box = (boxCountX box + 1) * (boxCountY box + 1) * (boxCountZ box + 1)

-- | The box of a level between two corners. 'Nothing' if a coordinate is not finite, or
-- if the box is empty or has too many cells to tabulate.
boxAt :: Level -> XYZ -> XYZ -> Maybe CellBox
boxAt l (XYZ x0 y0 z0) (XYZ x1 y1 z1) = do
  -- The cell of level 0 does not begin at the origin, and positions beyond level 50
  -- exceed the range of 'floorOf'.
  guard (l /= minBound && l <= clampedLevel 50)
  Cell3 corner _ _ _ <- cellAround3 l <$> onGrid3 (XYZ x0 y0 z0)
  nx <- count x0 x1
  ny <- count y0 y1
  nz <- count z0 z1
  pure (CellBox l (pointX3 corner) (pointY3 corner) (pointZ3 corner) nx ny nz 0)
  where
    cellsAround = cellsPerUnit l * circumference
    -- The cells touched, plus one in case both ends lie within cells.
    count a b
      | cells >= 0 && cells < 1e6 = Just (truncate (min cellsAround (cells + 2)))
      | otherwise = Nothing
      where
        cells = (b - a) * cellsPerUnit l
