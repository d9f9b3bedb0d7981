-- | Several smooth functions of one number, tabulated together.
module BlackHole.Trace.Tabulated
  ( Tabulated,
    tabulate,
    Row,
    rowAt,
    valueAt,
  )
where

import BlackHole.Numeric.Floor
import Data.Primitive.PrimArray

-- | Values at equally spaced arguments, to be interpolated linearly: the error
-- is an eighth of the second derivative times the square of the spacing.
data Tabulated = Tabulated
  { _tabulatedStart :: {-# UNPACK #-} !Double,
    -- | The largest argument.
    _tabulatedEnd :: {-# UNPACK #-} !Double,
    -- | Rows per unit of the argument.
    _tabulatedScale :: {-# UNPACK #-} !Double,
    tabulatedColumns :: {-# UNPACK #-} !Int,
    tabulatedNumbers :: !(PrimArray Double)
  }

-- | @tabulate columns count start end functions@: a table of as many functions
-- at @count@ arguments, at least 2, from start to end.
tabulate :: Int -> Int -> Double -> Double -> (Double -> [Double]) -> Tabulated
tabulate columns count start end functions =
  Tabulated start end (1 / spacing) columns $
    -- One row more, for whoever stands at the end.
    primArrayFromList (concat [take columns (functions (start + spacing * fromIntegral (min (count - 1) i))) | i <- [0 .. count]])
  where
    spacing = (end - start) / fromIntegral (count - 1)

-- | A place in the table: where its row begins, and how far it is on the way to
-- the next, 0 … 1.
data Row = Row {-# UNPACK #-} !Int {-# UNPACK #-} !Double

-- | The place of an argument; beyond the ends that of the end.
rowAt :: Tabulated -> Double -> Row
rowAt (Tabulated start end scale columns _) x =
  case floorOf ((max start (min end x) - start) * scale) of
    Floor i t -> Row (columns * i) t
{-# INLINE rowAt #-}

-- | The value of the function of this number, from 0.
valueAt :: Tabulated -> Row -> Int -> Double
valueAt table (Row i t) column = a + t * (b - a)
  where
    a = indexPrimArray (tabulatedNumbers table) (i + column)
    b = indexPrimArray (tabulatedNumbers table) (i + tabulatedColumns table + column)
{-# INLINE valueAt #-}
