-- | Integer and fractional parts for the inner loops.
module BlackHole.Numeric.Floor
  ( Floor (..),
    floorOf,
    turnFraction,
  )
where

-- | An integer, and the distance from it to a number above it, 0 to 1.
data Floor = Floor {-# UNPACK #-} !Int {-# UNPACK #-} !Double

-- | The integer part of a number within ±2^51, and the rest. An odd integer itself
-- yields the integer below it and the rest 1.
--
-- Adding and subtracting 3·2^51 rounds to an integer. This is several times as fast as
-- @truncate@ and @fromIntegral@: the processor's conversion from integers waits for the
-- last instruction that used its target register, which chains together unrelated
-- computations.
floorOf :: Double -> Floor
floorOf x
  -- Numbers so close below an integer that adding the half loses the difference.
  | rest < 0 = Floor (truncate whole - 1) (rest + 1)
  | otherwise = Floor (truncate whole) rest
  where
    rest = x - whole
    whole = ((x - 0.5) + 6755399441055744) - 6755399441055744
{-# INLINE floorOf #-}

-- | An angle in turns, within ±2^51, reduced to the range −1\/2 to 1\/2.
turnFraction :: Double -> Double
turnFraction x = x - ((x + 6755399441055744) - 6755399441055744)
{-# INLINE turnFraction #-}
