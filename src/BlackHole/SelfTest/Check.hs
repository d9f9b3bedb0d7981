-- | A check: a number the program computes, the number it ought to be, and
-- how far apart the two may lie.
module BlackHole.SelfTest.Check
  ( Check (..),
    checkError,
    checkHolds,
  )
where

-- | One line of the table of checks.
data Check = Check
  { -- | What is checked, with the unit.
    checkName :: !String,
    -- | What the program computes.
    checkValue :: !Double,
    -- | What it ought to be.
    checkReference :: !Double,
    -- | The greatest absolute difference that is allowed.
    checkLimit :: !Double
  }
  deriving (Eq, Show)

-- | The absolute difference of value and reference.
checkError :: Check -> Double
checkError check = abs (checkValue check - checkReference check)

-- | Whether the difference is within the limit. What is no number never is.
checkHolds :: Check -> Bool
checkHolds check = checkError check <= checkLimit check
