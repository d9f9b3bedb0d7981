-- | @blackhole selftest@.
module BlackHole.Cli.SelfTest
  ( SelfTestOptions (..),
    selfTestOptions,
    runSelfTest,
  )
where

import BlackHole.Cli.Read (toggle)
import BlackHole.SelfTest.Check (Check)
import BlackHole.SelfTest.Suite (selfTestChecks)
import BlackHole.SelfTest.Table
import Options.Applicative
import System.Environment (lookupEnv)
import System.IO (hIsTerminalDevice, stdout)

-- | The options of @blackhole selftest@: whether to leave out what passes.
newtype SelfTestOptions = SelfTestOptions
  { selfTestQuiet :: Bool
  }
  deriving (Eq, Show)

-- | Their grammar.
selfTestOptions :: Parser SelfTestOptions
selfTestOptions =
  SelfTestOptions
    <$> toggle (long "quiet" <> short 'q' <> help "Print the last line only")

-- | Compute every check, with the table to print on standard output, which is in
-- colour on a terminal unless NO_COLOR is set.
runSelfTest :: SelfTestOptions -> IO ([Check], String)
runSelfTest (SelfTestOptions quiet) = do
  terminal <- hIsTerminalDevice stdout
  noColour <- lookupEnv "NO_COLOR"
  checks <- selfTestChecks
  let table = tableLines (if terminal && maybe True null noColour then Painted else Plain) checks
  pure (checks, unlines ((if quiet then [] else table) ++ [summaryLine checks]))
