-- | Whole and fractional part, for the inner loops.
module BlackHole.Numeric.Floor
  ( Floor (..),
    floorOf,
    turnFraction,
  )
where

-- | A whole number and how far beyond it a number lies, 0 … 1.
data Floor = Floor {-# UNPACK #-} !Int {-# UNPACK #-} !Double

-- | The whole part of a number within ±2^51 and the rest. An odd whole number
-- itself comes out as the one below it and the rest 1.
--
-- Adding and subtracting 3·2^51 rounds to whole numbers. That is several times
-- faster than @truncate@ and @fromIntegral@: the processor's conversion from
-- integer waits for whatever used its target register last, which chains
-- together computations that have nothing to do with each other.
floorOf :: Double -> Floor
floorOf x
  -- Numbers so close below a whole one that the half swallows the difference.
  | rest < 0 = Floor (truncate whole - 1) (rest + 1)
  | otherwise = Floor (truncate whole) rest
  where
    rest = x - whole
    whole = ((x - 0.5) + 6755399441055744) - 6755399441055744
{-# INLINE floorOf #-}

-- | An angle in turns, within ±2^51, brought to −1\/2 … 1\/2.
turnFraction :: Double -> Double
turnFraction x = x - ((x + 6755399441055744) - 6755399441055744)
{-# INLINE turnFraction #-}
