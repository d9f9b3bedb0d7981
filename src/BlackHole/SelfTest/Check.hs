-- | A check of the self-test: a computed number, its reference value, and the greatest
-- difference allowed.
module BlackHole.SelfTest.Check
  ( Check (..),
    checkError,
    checkHolds,
  )
where

-- | One line of the table of checks.
data Check = Check
  { -- | What is checked, with its unit.
    checkName :: !String,
    -- | The value that the program computes.
    checkValue :: !Double,
    -- | The reference value.
    checkReference :: !Double,
    -- | The greatest absolute difference allowed.
    checkLimit :: !Double
  }
  deriving (Eq, Show)

-- | The absolute difference between value and reference.
checkError :: Check -> Double
checkError check = abs (checkValue check - checkReference check)

-- | Whether the difference is within the limit. Never true for NaN.
checkHolds :: Check -> Bool
checkHolds check = checkError check <= checkLimit check
