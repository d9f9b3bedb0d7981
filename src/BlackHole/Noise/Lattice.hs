-- | The multi-level grid that carries the noise (report, "Texture
-- Generation").
--
-- All of space is one cell whose edge is 2^64 lattice units. That cell is
-- level 0; every further level splits each cell into 2^n smaller ones (n is
-- the dimension), so the cells of level l have an edge of 2^(64 − l) lattice
-- units, and there are 2^l of them along each axis, l = 0 … 64. One unit of
-- space is 2^32 lattice units, so the cells of level 32 have the edge 1, those
-- of level 32 + k the edge 2^−k. The origin of space is the middle of the
-- grid. A lattice point is a corner of a cell.
--
-- Space is a torus: the cell after the last along an axis is the first. A
-- coordinate therefore means the same as that coordinate plus any multiple of
-- 'circumference', and every finite coordinate has its place.
--
-- The points of the lattice are integers with types of their own, so that
-- they cannot be taken for places in space.
module BlackHole.Noise.Lattice
  ( -- * Levels
    Level,
    level,
    clampedLevel,
    levelNumber,
    unitLevel,
    cellsPerUnit,
    circumference,

    -- * Lattice points
    LatticePoint2 (),
    latticePoint2,
    pointLevel2,
    pointX2,
    pointY2,
    LatticePoint3 (),
    latticePoint3,
    pointLevel3,
    pointX3,
    pointY3,
    pointZ3,

    -- * Places and their cells
    GridPlace2,
    onGrid2,
    Cell2 (..),
    cellAround2,
    GridPlace3 (..),
    onGrid3,
    Cell3 (..),
    cellAround3,
    cellOfEdge3,
    Along (..),
    alongCells,
    lastIndex,
    middleIndex,
  )
where

import BlackHole.Numeric.Floor
import BlackHole.Vector.XY (XY (..))
import BlackHole.Vector.XYZ (XYZ (..))
import Data.Bits (unsafeShiftL, unsafeShiftR, (.&.))
import Data.Word (Word64)

-- | A level of the grid, 0 (one cell, all of space) to 64 (cells of one
-- lattice unit).
newtype Level = Level Int
  deriving (Eq, Ord)

instance Show Level where
  showsPrec p (Level n) =
    showParen (p > 10) (showString "clampedLevel " . showsPrec 11 n)

instance Bounded Level where
  minBound = Level 0
  maxBound = Level 64

-- | The level of this number; 'Nothing' outside 0 … 64.
level :: Int -> Maybe Level
level n
  | n >= 0 && n <= 64 = Just (Level n)
  | otherwise = Nothing

-- | The level of this number, or the nearest one there is.
clampedLevel :: Int -> Level
clampedLevel n = Level (max 0 (min 64 n))

-- | The number of a level, 0 … 64.
levelNumber :: Level -> Int
levelNumber (Level n) = n
{-# INLINE levelNumber #-}

-- | Level 32: cells whose edge is one unit of space.
unitLevel :: Level
unitLevel = Level 32

-- | Cells of a level per unit of space along an axis, 2^(l − 32): the spatial
-- frequency of its noise. Exact, 2^−32 to 2^32.
cellsPerUnit :: Level -> Double
cellsPerUnit (Level n) = powerOfTwo half * powerOfTwo (n - half) * 2.3283064365386963e-10
  where
    -- 2^l is the product of two powers that an Int can hold; the literal is
    -- 2^-32.
    half = n `unsafeShiftR` 1
    powerOfTwo e = fromIntegral ((1 :: Int) `unsafeShiftL` e) :: Double
{-# INLINE cellsPerUnit #-}

-- | The length of space around the torus, 2^32 units. Exactly 2^l cells of
-- level l lie along it, so noise read along a whole circumference closes
-- without a seam:
--
-- > noise2 seed (clampedLevel 3) (XY (turns * circumference) y)
--
-- has period 1 in @turns@ and eight cells to the turn.
circumference :: Double
circumference = 4294967296

-- | A point of the lattice of one level in the plane. Its coordinates count
-- cells from the edge of the grid, each in 0 … 2^level − 1.
data LatticePoint2
  = LatticePoint2 {-# UNPACK #-} !Level {-# UNPACK #-} !Word64 {-# UNPACK #-} !Word64
  deriving (Eq, Ord, Show)

-- | The point with these coordinates, each taken around the torus: modulo
-- 2^level.
latticePoint2 :: Level -> Word64 -> Word64 -> LatticePoint2
latticePoint2 l x y = LatticePoint2 l (around l x) (around l y)
{-# INLINE latticePoint2 #-}

-- | The level that the point belongs to.
pointLevel2 :: LatticePoint2 -> Level
pointLevel2 (LatticePoint2 l _ _) = l
{-# INLINE pointLevel2 #-}

-- | Cells from the edge of the grid along x.
pointX2 :: LatticePoint2 -> Word64
pointX2 (LatticePoint2 _ x _) = x
{-# INLINE pointX2 #-}

-- | Cells from the edge of the grid along y.
pointY2 :: LatticePoint2 -> Word64
pointY2 (LatticePoint2 _ _ y) = y
{-# INLINE pointY2 #-}

-- | A point of the lattice of one level in space. Its coordinates count
-- cells from the edge of the grid, each in 0 … 2^level − 1.
data LatticePoint3
  = LatticePoint3
      {-# UNPACK #-} !Level
      {-# UNPACK #-} !Word64
      {-# UNPACK #-} !Word64
      {-# UNPACK #-} !Word64
  deriving (Eq, Ord, Show)

-- | The point with these coordinates, each taken around the torus: modulo
-- 2^level.
latticePoint3 :: Level -> Word64 -> Word64 -> Word64 -> LatticePoint3
latticePoint3 l x y z = LatticePoint3 l (around l x) (around l y) (around l z)
{-# INLINE latticePoint3 #-}

-- | The level that the point belongs to.
pointLevel3 :: LatticePoint3 -> Level
pointLevel3 (LatticePoint3 l _ _ _) = l
{-# INLINE pointLevel3 #-}

-- | Cells from the edge of the grid along x.
pointX3 :: LatticePoint3 -> Word64
pointX3 (LatticePoint3 _ x _ _) = x
{-# INLINE pointX3 #-}

-- | Cells from the edge of the grid along y.
pointY3 :: LatticePoint3 -> Word64
pointY3 (LatticePoint3 _ _ y _) = y
{-# INLINE pointY3 #-}

-- | Cells from the edge of the grid along z.
pointZ3 :: LatticePoint3 -> Word64
pointZ3 (LatticePoint3 _ _ _ z) = z
{-# INLINE pointZ3 #-}

-- | A place of the plane, brought into the grid: each coordinate within
-- −2^31 … 2^31.
data GridPlace2 = GridPlace2 {-# UNPACK #-} !Double {-# UNPACK #-} !Double

-- | A place of space, brought into the grid: each coordinate within
-- −2^31 … 2^31.
data GridPlace3
  = GridPlace3
      {-# UNPACK #-} !Double
      {-# UNPACK #-} !Double
      {-# UNPACK #-} !Double

-- | The same place in the grid, going around the torus without rounding;
-- 'Nothing' if a coordinate is not finite.
onGrid2 :: XY -> Maybe GridPlace2
onGrid2 (XY x y)
  | within x && within y = Just (GridPlace2 x y)
  | otherwise = GridPlace2 <$> wrapped x <*> wrapped y
{-# INLINE onGrid2 #-}

-- | The same place in the grid, going around the torus without rounding;
-- 'Nothing' if a coordinate is not finite.
onGrid3 :: XYZ -> Maybe GridPlace3
onGrid3 (XYZ x y z)
  | within x && within y && within z = Just (GridPlace3 x y z)
  | otherwise = GridPlace3 <$> wrapped x <*> wrapped y <*> wrapped z
{-# INLINE onGrid3 #-}

-- | Where a place lies among the cells of one level of the plane: the corner
-- of its cell that has the smallest coordinates, and how far along the cell's
-- edges it is from there, x then y, each 0 … 1.
data Cell2
  = Cell2
      {-# UNPACK #-} !LatticePoint2
      {-# UNPACK #-} !Double
      {-# UNPACK #-} !Double
  deriving (Eq, Show)

-- | Where a place lies among the cells of one level of space: the corner of
-- its cell that has the smallest coordinates, and how far along the cell's
-- edges it is from there, x then y then z, each 0 … 1.
data Cell3
  = Cell3
      {-# UNPACK #-} !LatticePoint3
      {-# UNPACK #-} !Double
      {-# UNPACK #-} !Double
      {-# UNPACK #-} !Double
  deriving (Eq, Show)

-- | The cell of a level around a place. The fractions are exact to rounding
-- at every level: a place just below a cell border may get the fraction 1 of
-- the cell below it.
cellAround2 :: Level -> GridPlace2 -> Cell2
cellAround2 l (GridPlace2 x y) =
  case along l cells x of
    Along i u -> case along l cells y of
      Along j v -> Cell2 (latticePoint2 l i j) u v
  where
    cells = cellsPerUnit l
{-# INLINE cellAround2 #-}

-- | The cell of a level around a place. The fractions are exact to rounding
-- at every level: a place just below a cell border may get the fraction 1 of
-- the cell below it.
cellAround3 :: Level -> GridPlace3 -> Cell3
cellAround3 l = cellOfEdge3 l (cellsPerUnit l)
{-# INLINE cellAround3 #-}

-- | The same for who has the level's 'cellsPerUnit' at hand.
cellOfEdge3 :: Level -> Double -> GridPlace3 -> Cell3
cellOfEdge3 l cells (GridPlace3 x y z) =
  case along l cells x of
    Along i u -> case along l cells y of
      Along j v -> case along l cells z of
        Along k w -> Cell3 (latticePoint3 l i j k) u v w
{-# INLINE cellOfEdge3 #-}

-- | A cell index along one axis, not yet taken around the torus, and the
-- fraction of the cell's edge beyond it.
data Along = Along {-# UNPACK #-} !Word64 {-# UNPACK #-} !Double

-- | The cell index and fraction of a coordinate within −2^31 … 2^31.
--
-- A scaling by a power of two is exact and so is the remainder of the floor,
-- so the fraction keeps whatever bits the coordinate has; a cast to fixed
-- point would cut it off 32 bits behind the binary point. The half grid
-- between the grid's edge and the origin of space is added to the integer,
-- not to the 'Double', for the same reason. Only at level 0, where it is half
-- a cell, has it to be added before.
along :: Level -> Double -> Double -> Along
along l cells x = Along (middleIndex l + i) rest
  where
    Along i rest = alongCells (x * cells + (if levelNumber l == 0 then 0.5 else 0))
{-# INLINE along #-}

-- | The cell and the fraction of a coordinate that counts cells from the
-- origin of space; below it the index is negative, modulo 2^64.
alongCells :: Double -> Along
alongCells scaled
  | abs scaled < 2251799813685248 = case floorOf scaled of
    Floor i fraction -> Along (fromIntegral i) fraction
  | rest < 0 = Along (fromIntegral (towardsZero - 1)) (rest + 1)
  | otherwise = Along (fromIntegral towardsZero) rest
  where
    towardsZero = truncate scaled :: Int
    rest = scaled - fromIntegral towardsZero
{-# INLINE alongCells #-}

-- | The index along an axis of the cell that begins at the origin of space:
-- half the number of cells; 0 at level 0.
middleIndex :: Level -> Word64
middleIndex l = lastIndex l - lastIndex l `unsafeShiftR` 1
{-# INLINE middleIndex #-}

-- | An index modulo 2^level.
around :: Level -> Word64 -> Word64
around l i = i .&. lastIndex l
{-# INLINE around #-}

-- | The largest index along an axis, 2^level − 1. Shifts in two steps because
-- a shift by 64 has no meaning.
lastIndex :: Level -> Word64
lastIndex (Level n) = ((1 `unsafeShiftL` half) `unsafeShiftL` (n - half)) - 1
  where
    half = n `unsafeShiftR` 1
{-# INLINE lastIndex #-}

within :: Double -> Bool
within x = abs x < 2147483648
{-# INLINE within #-}

-- | The same coordinate within −2^31 … 2^31 on the torus, if it is finite.
-- Exact: the result is a multiple of the last place of the argument and not
-- larger than it.
wrapped :: Double -> Maybe Double
wrapped x
  | isNaN x || isInfinite x = Nothing
  -- Here the last place is a multiple of the circumference.
  | abs x >= 1.0e30 = Just 0
  | rest >= 2147483648 = Just (rest - circumference)
  | rest < -2147483648 = Just (rest + circumference)
  | otherwise = Just rest
  where
    rest = x - circumference * fromInteger (truncate (x / circumference))
{-# NOINLINE wrapped #-}
