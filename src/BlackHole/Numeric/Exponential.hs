{-# LANGUAGE BangPatterns #-}

-- | Exponential and sine for the inner loops.
--
-- A call of the C library's functions forces everything that is in registers into
-- memory. These functions are inlined instead.
module BlackHole.Numeric.Exponential
  ( exponential,
    sineOfTurns,
  )
where

import BlackHole.Numeric.Floor (turnFraction)
import Data.Bits (unsafeShiftR, (.&.))
import Data.Primitive.PrimArray

-- | @e^x@ with a relative error below 1.3e-12 for x within −600 … 600; beyond, the
-- value at the nearer end.
exponential :: Double -> Double
exponential x =
  indexPrimArray powers (k `unsafeShiftR` 5) * indexPrimArray parts (k .&. 31)
    * (1 + rest * (1 + rest * (1 / 2 + rest * (1 / 6 + rest * (1 / 24)))))
  where
    !clamped = max (-600) (min 600 x)
    -- Adding and subtracting 3·2^51 rounds to an integer.
    !whole = (clamped * 46.16624130844683 + 6755399441055744) - 6755399441055744
    -- ln 2 / 32 in two parts (Cody and Waite 1980, "Software manual for the
    -- elementary functions"): the first has 36 bits, so that its product is exact.
    !rest = (clamped - whole * 0.021660849392446835) - whole * 5.145609244655338e-14
    !k = truncate whole + 32 * lowestPower
{-# INLINE exponential #-}

-- | 2^e for e = −900 to 900.
powers :: PrimArray Double
powers = primArrayFromList [2 ^^ (e - lowestPower) | e <- [0 .. 2 * lowestPower]]
{-# NOINLINE powers #-}

lowestPower :: Int
lowestPower = 900

-- | 2^(i\/32).
parts :: PrimArray Double
parts = primArrayFromList [2 ** (fromIntegral i / 32) | i <- [0 .. 31 :: Int]]
{-# NOINLINE parts #-}

-- | sin 2πt with an absolute error below 1e-9 for t within ±2^51.
sineOfTurns :: Double -> Double
sineOfTurns t = if turn < 0 then negate value else value
  where
    !turn = turnFraction t
    -- The sine of the corresponding angle in the first quarter, in radians.
    !x = 6.283185307179586 * (0.25 - abs (abs turn - 0.25))
    !x2 = x * x
    !value = x * (1 + x2 * (-1 / 6 + x2 * (1 / 120 + x2 * (-1 / 5040 + x2 * higher))))
    !higher = 1 / 362880 + x2 * (-1 / 39916800 + x2 / 6227020800)
{-# INLINE sineOfTurns #-}
