-- | The table that the self-test prints.
module BlackHole.SelfTest.Table
  ( Paint (..),
    tableLines,
    summaryLine,
    failureCount,
  )
where

import BlackHole.SelfTest.Check
import Numeric (showEFloat, showFFloat)

-- | Whether escape sequences colour the verdicts.
data Paint = Plain | Painted
  deriving (Eq, Show, Enum, Bounded)

-- | A heading and one line per check, in columns: check, value, reference, error,
-- limit, and @pass@ or @fail@.
tableLines :: Paint -> [Check] -> [String]
tableLines paint checks = map line (heading : map row checks)
  where
    heading = (["check", "value", "reference", "error", "limit"], "")
    row check =
      ( [ checkName check,
          showValue (checkValue check),
          showValue (checkReference check),
          showSize (checkError check),
          showSize (checkLimit check)
        ],
        verdict check
      )
    widths = foldr (zipWith max . map length . fst) (repeat 0) (heading : map row checks)
    line (cells, end) =
      dropWhileEnd' (unwords (zipWith3 pad (True : repeat False) widths cells ++ [end]))
    pad left width text
      | left = text ++ space
      | otherwise = space ++ text
      where
        space = replicate (width - length text + 1) ' '
    verdict check = case (checkHolds check, paint) of
      (True, Plain) -> " pass"
      (False, Plain) -> " FAIL"
      (True, Painted) -> " \ESC[32mpass\ESC[0m"
      (False, Painted) -> " \ESC[1;31mFAIL\ESC[0m"
    dropWhileEnd' = reverse . dropWhile (== ' ') . reverse

-- | The line @N passed, N failed@.
summaryLine :: [Check] -> String
summaryLine checks =
  show (length checks - failed) ++ " passed, " ++ show failed ++ " failed"
  where
    failed = failureCount checks

-- | The number of failed checks.
failureCount :: [Check] -> Int
failureCount = length . filter (not . checkHolds)

-- | A number with ten decimals, which suits quantities of order one, or with three
-- digits if it is smaller.
showValue :: Double -> String
showValue v
  | v == 0 = "0"
  | abs v < 1e-4 = showEFloat (Just 2) v ""
  | otherwise = showFFloat (Just 10) v ""

-- | A number with two digits.
showSize :: Double -> String
showSize v
  | v == 0 = "0"
  | otherwise = showEFloat (Just 1) v ""
