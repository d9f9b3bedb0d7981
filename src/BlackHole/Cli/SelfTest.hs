-- | @blackhole selftest@.
module BlackHole.Cli.SelfTest
  ( SelfTestOptions (..),
    selfTestOptions,
    selfTest,
    selfTestStatus,
    checkTable,
    summaryLine,
  )
where

import BlackHole.Cli.ExitStatus
import BlackHole.Cli.Read (toggle)
import BlackHole.Cli.TextTable
import BlackHole.SelfTest.Check
import BlackHole.SelfTest.Suite (selfTestChecks)
import Numeric (showEFloat, showFFloat)
import Options.Applicative
import System.Environment (lookupEnv)
import System.IO (hIsTerminalDevice, stdout)

-- | The options of @blackhole selftest@: whether to print the summary only.
newtype SelfTestOptions = SelfTestOptions
  { selfTestQuiet :: Bool
  }
  deriving (Eq, Show)

-- | Their parser.
selfTestOptions :: Parser SelfTestOptions
selfTestOptions =
  SelfTestOptions
    <$> toggle (long "quiet" <> short 'q' <> help "Print the last line only")

-- | Computes every check and prints their table, in colour on a terminal unless NO_COLOR
-- is set.
selfTest :: SelfTestOptions -> IO ExitStatus
selfTest (SelfTestOptions quiet) = do
  terminal <- hIsTerminalDevice stdout
  noColour <- lookupEnv "NO_COLOR"
  checks <- selfTestChecks
  let table = checkTable (terminal && maybe True null noColour) checks
  printed (selfTestStatus checks) (unlines ((if quiet then [] else table) ++ [summaryLine checks]))

-- | A failed check is an internal error.
selfTestStatus :: [Check] -> ExitStatus
selfTestStatus checks
  | all checkHolds checks = Done
  | otherwise = InternalFault

-- | A heading and one line per check, in columns: check, value, reference, error, limit,
-- and @pass@ or @FAIL@, in colour or not.
checkTable :: Bool -> [Check] -> [String]
checkTable coloured checks =
  tableLines
    (LeftAligned : replicate 4 RightAligned ++ [LeftAligned])
    (Cells ["check", "value", "reference", "error", "limit"] : map row checks)
  where
    row check =
      Cells
        [ checkName check,
          showValue (checkValue check),
          showValue (checkReference check),
          showSize (checkError check),
          showSize (checkLimit check),
          verdict check
        ]
    verdict check
      | checkHolds check = painted "32" "pass"
      | otherwise = painted "1;31" "FAIL"
    painted colour text = if coloured then "\ESC[" ++ colour ++ "m" ++ text ++ "\ESC[0m" else text

-- | The line @N passed, N failed@.
summaryLine :: [Check] -> String
summaryLine checks = show (length checks - failed) ++ " passed, " ++ show failed ++ " failed"
  where
    failed = length (filter (not . checkHolds) checks)

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
