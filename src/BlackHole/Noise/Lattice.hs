-- | The multi-level grid that carries the noise (Will Yager, "Accurately Rendering a
-- Black Hole", section "Texture Generation").
--
-- All of space is one cell with an edge of 2^64 lattice units. That cell is level 0.
-- Each further level splits every cell into 2^n smaller ones, where n is the dimension,
-- so the cells of level l have an edge of 2^(64 − l) lattice units, and there are 2^l
-- of them along each axis, for l = 0 to 64. One unit of space is 2^32 lattice units, so
-- the cells of level 32 have the edge 1 and those of level 32 + k the edge 2^−k. The
-- origin of space is the middle of the grid. A lattice point is a corner of a cell.
--
-- Space is a torus: the cell after the last one along an axis is the first. A
-- coordinate is therefore equivalent to that coordinate plus any multiple of
-- 'circumference', and every finite coordinate has its place in the grid.
--
-- Lattice points have integer coordinates and types of their own, so they cannot be
-- confused with points in space.
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

-- | A level of the grid, from 0 (one cell, all of space) to 64 (cells of one lattice
-- unit).
newtype Level = Level Int
  deriving (Eq, Ord)

instance Show Level where
  showsPrec p (Level n) =
    showParen (p > 10) (showString "clampedLevel " . showsPrec 11 n)

instance Bounded Level where
  minBound = Level 0
  maxBound = Level 64

-- | The level with this number; 'Nothing' outside 0 to 64.
level :: Int -> Maybe Level
level n
  | n >= 0 && n <= 64 = Just (Level n)
  | otherwise = Nothing

-- | The level with this number, or the nearest existing one.
clampedLevel :: Int -> Level
clampedLevel n = Level (max 0 (min 64 n))

-- | The number of a level, 0 to 64.
levelNumber :: Level -> Int
levelNumber (Level n) = n
{-# INLINE levelNumber #-}

-- | Level 32, whose cells have an edge of one unit of space.
unitLevel :: Level
unitLevel = Level 32

-- | The number of cells of a level per unit of space along an axis, 2^(l − 32), which
-- is the spatial frequency of its noise. Exact, from 2^−32 to 2^32.
cellsPerUnit :: Level -> Double
cellsPerUnit (Level n) = powerOfTwo half * powerOfTwo (n - half) * 2.3283064365386963e-10
  where
    -- 2^l is the product of two powers that fit into an Int; the literal is 2^-32.
    half = n `unsafeShiftR` 1
    powerOfTwo e = fromIntegral ((1 :: Int) `unsafeShiftL` e) :: Double
{-# INLINE cellsPerUnit #-}

-- | The length of space around the torus, 2^32 units. Exactly 2^l cells of level l fit
-- along it, so noise along a whole circumference closes without a seam:
--
-- > noise2 seed (clampedLevel 3) (XY (turns * circumference) y)
--
-- has period 1 in @turns@ and eight cells per turn.
circumference :: Double
circumference = 4294967296

-- | A lattice point of one level in the plane. Its coordinates count cells from the
-- edge of the grid, from 0 to 2^level − 1.
data LatticePoint2
  = LatticePoint2 {-# UNPACK #-} !Level {-# UNPACK #-} !Word64 {-# UNPACK #-} !Word64
  deriving (Eq, Ord, Show)

-- | The point with these coordinates, reduced modulo 2^level.
latticePoint2 :: Level -> Word64 -> Word64 -> LatticePoint2
latticePoint2 l x y = LatticePoint2 l (around l x) (around l y)
{-# INLINE latticePoint2 #-}

-- | The level that the point belongs to.
pointLevel2 :: LatticePoint2 -> Level
pointLevel2 (LatticePoint2 l _ _) = l
{-# INLINE pointLevel2 #-}

-- | The number of cells from the edge of the grid along x.
pointX2 :: LatticePoint2 -> Word64
pointX2 (LatticePoint2 _ x _) = x
{-# INLINE pointX2 #-}

-- | The number of cells from the edge of the grid along y.
pointY2 :: LatticePoint2 -> Word64
pointY2 (LatticePoint2 _ _ y) = y
{-# INLINE pointY2 #-}

-- | A lattice point of one level in space. Its coordinates count cells from the edge of
-- the grid, from 0 to 2^level − 1.
data LatticePoint3
  = LatticePoint3
      {-# UNPACK #-} !Level
      {-# UNPACK #-} !Word64
      {-# UNPACK #-} !Word64
      {-# UNPACK #-} !Word64
  deriving (Eq, Ord, Show)

-- | The point with these coordinates, reduced modulo 2^level.
latticePoint3 :: Level -> Word64 -> Word64 -> Word64 -> LatticePoint3
latticePoint3 l x y z = LatticePoint3 l (around l x) (around l y) (around l z)
{-# INLINE latticePoint3 #-}

-- | The level that the point belongs to.
pointLevel3 :: LatticePoint3 -> Level
pointLevel3 (LatticePoint3 l _ _ _) = l
{-# INLINE pointLevel3 #-}

-- | The number of cells from the edge of the grid along x.
pointX3 :: LatticePoint3 -> Word64
pointX3 (LatticePoint3 _ x _ _) = x
{-# INLINE pointX3 #-}

-- | The number of cells from the edge of the grid along y.
pointY3 :: LatticePoint3 -> Word64
pointY3 (LatticePoint3 _ _ y _) = y
{-# INLINE pointY3 #-}

-- | The number of cells from the edge of the grid along z.
pointZ3 :: LatticePoint3 -> Word64
pointZ3 (LatticePoint3 _ _ _ z) = z
{-# INLINE pointZ3 #-}

-- | A point in the plane, reduced to the grid: each coordinate lies in −2^31 to 2^31.
data GridPlace2 = GridPlace2 {-# UNPACK #-} !Double {-# UNPACK #-} !Double

-- | A point in space, reduced to the grid: each coordinate lies in −2^31 to 2^31.
data GridPlace3
  = GridPlace3
      {-# UNPACK #-} !Double
      {-# UNPACK #-} !Double
      {-# UNPACK #-} !Double

-- | The point reduced around the torus, without rounding; 'Nothing' if a coordinate is
-- not finite.
onGrid2 :: XY -> Maybe GridPlace2
onGrid2 (XY x y)
  | within x && within y = Just (GridPlace2 x y)
  | otherwise = GridPlace2 <$> wrapped x <*> wrapped y
{-# INLINE onGrid2 #-}

-- | The point reduced around the torus, without rounding; 'Nothing' if a coordinate is
-- not finite.
onGrid3 :: XYZ -> Maybe GridPlace3
onGrid3 (XYZ x y z)
  | within x && within y && within z = Just (GridPlace3 x y z)
  | otherwise = GridPlace3 <$> wrapped x <*> wrapped y <*> wrapped z
{-# INLINE onGrid3 #-}

-- | The position of a point among the cells of one level in the plane: the corner of
-- its cell with the smallest coordinates, and the position along the cell's edges from
-- there, x then y, each 0 to 1.
data Cell2
  = Cell2
      {-# UNPACK #-} !LatticePoint2
      {-# UNPACK #-} !Double
      {-# UNPACK #-} !Double
  deriving (Eq, Show)

-- | The position of a point among the cells of one level in space: the corner of its
-- cell with the smallest coordinates, and the position along the cell's edges from
-- there, x then y then z, each 0 to 1.
data Cell3
  = Cell3
      {-# UNPACK #-} !LatticePoint3
      {-# UNPACK #-} !Double
      {-# UNPACK #-} !Double
      {-# UNPACK #-} !Double
  deriving (Eq, Show)

-- | The cell of a level that contains a point. The fractions are exact up to rounding
-- at every level: a point just below a cell border may get the fraction 1 of the cell
-- below it.
cellAround2 :: Level -> GridPlace2 -> Cell2
cellAround2 l (GridPlace2 x y) =
  case along l cells x of
    Along i u -> case along l cells y of
      Along j v -> Cell2 (latticePoint2 l i j) u v
  where
    cells = cellsPerUnit l
{-# INLINE cellAround2 #-}

-- | The cell of a level that contains a point. The fractions are exact up to rounding
-- at every level: a point just below a cell border may get the fraction 1 of the cell
-- below it.
cellAround3 :: Level -> GridPlace3 -> Cell3
cellAround3 l = cellOfEdge3 l (cellsPerUnit l)
{-# INLINE cellAround3 #-}

-- | 'cellAround3' for callers that already have the level's 'cellsPerUnit'.
cellOfEdge3 :: Level -> Double -> GridPlace3 -> Cell3
cellOfEdge3 l cells (GridPlace3 x y z) =
  case along l cells x of
    Along i u -> case along l cells y of
      Along j v -> case along l cells z of
        Along k w -> Cell3 (latticePoint3 l i j k) u v w
{-# INLINE cellOfEdge3 #-}

-- | A cell index along one axis, not yet reduced around the torus, and the fraction of
-- the cell's edge beyond it.
data Along = Along {-# UNPACK #-} !Word64 {-# UNPACK #-} !Double

-- | The cell index and fraction of a coordinate in −2^31 to 2^31.
--
-- Scaling by a power of two is exact, and so is the remainder of the floor, so the
-- fraction keeps all bits of the coordinate; a cast to fixed point would cut it off 32
-- bits after the binary point. For the same reason the half grid between the grid's
-- edge and the origin of space is added to the integer, not to the 'Double'. Only at
-- level 0, where that half grid is half a cell, must it be added before.
along :: Level -> Double -> Double -> Along
along l cells x = Along (middleIndex l + i) rest
  where
    Along i rest = alongCells (x * cells + (if levelNumber l == 0 then 0.5 else 0))
{-# INLINE along #-}

-- | The cell index and fraction of a coordinate that counts cells from the origin of
-- space. Below the origin the index is negative, modulo 2^64.
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

-- | The index along an axis of the cell that begins at the origin of space: half the
-- number of cells, and 0 at level 0.
middleIndex :: Level -> Word64
middleIndex l = lastIndex l - lastIndex l `unsafeShiftR` 1
{-# INLINE middleIndex #-}

-- | An index modulo 2^level.
around :: Level -> Word64 -> Word64
around l i = i .&. lastIndex l
{-# INLINE around #-}

-- | The largest index along an axis, 2^level − 1. Shifts in two steps because a shift
-- by 64 is undefined.
lastIndex :: Level -> Word64
lastIndex (Level n) = ((1 `unsafeShiftL` half) `unsafeShiftL` (n - half)) - 1
  where
    half = n `unsafeShiftR` 1
{-# INLINE lastIndex #-}

within :: Double -> Bool
within x = abs x < 2147483648
{-# INLINE within #-}

-- | The equivalent coordinate in −2^31 to 2^31 on the torus; 'Nothing' if it is not
-- finite. Exact: the result is a multiple of the argument's last place and no larger
-- than the argument.
wrapped :: Double -> Maybe Double
wrapped x
  | isNaN x || isInfinite x = Nothing
  -- From here on the last place is a multiple of the circumference.
  | abs x >= 1.0e30 = Just 0
  | rest >= 2147483648 = Just (rest - circumference)
  | rest < -2147483648 = Just (rest + circumference)
  | otherwise = Just rest
  where
    rest = x - circumference * fromInteger (truncate (x / circumference))
{-# NOINLINE wrapped #-}
