-- | A table of several smooth functions of one variable.
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

-- | Values at equally spaced arguments for linear interpolation. The error is an eighth
-- of the second derivative times the square of the spacing.
data Tabulated = Tabulated
  { _tabulatedStart :: {-# UNPACK #-} !Double,
    -- | The largest argument.
    _tabulatedEnd :: {-# UNPACK #-} !Double,
    -- | Number of rows per unit of the argument.
    _tabulatedScale :: {-# UNPACK #-} !Double,
    tabulatedColumns :: {-# UNPACK #-} !Int,
    tabulatedNumbers :: !(PrimArray Double)
  }

-- | @tabulate columns count start end functions@ is a table of @columns@ functions at
-- @count@ arguments, at least 2, from @start@ to @end@.
tabulate :: Int -> Int -> Double -> Double -> (Double -> [Double]) -> Tabulated
tabulate columns count start end functions =
  Tabulated start end (1 / spacing) columns $
    -- One extra row, so that the end has a successor.
    primArrayFromList
      ( concat
          [ take columns (functions (start + spacing * fromIntegral (min (count - 1) i)))
            | i <- [0 .. count]
          ]
      )
  where
    spacing = (end - start) / fromIntegral (count - 1)

-- | A position in the table: the start of its row, and the fraction of the way to the
-- next row, 0 to 1.
data Row = Row {-# UNPACK #-} !Int {-# UNPACK #-} !Double

-- | The position of an argument. Arguments beyond the ends get the position of the end.
rowAt :: Tabulated -> Double -> Row
rowAt (Tabulated start end scale columns _) x =
  case floorOf ((max start (min end x) - start) * scale) of
    Floor i t -> Row (columns * i) t
{-# INLINE rowAt #-}

-- | The interpolated value of the function with this index, counted from 0.
valueAt :: Tabulated -> Row -> Int -> Double
valueAt table (Row i t) column = a + t * (b - a)
  where
    a = indexPrimArray (tabulatedNumbers table) (i + column)
    b = indexPrimArray (tabulatedNumbers table) (i + tabulatedColumns table + column)
{-# INLINE valueAt #-}
