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

-- | Compute every check, print the table on standard output, and return the
-- checks. Colours only a terminal, and not if NO_COLOR is set to anything.
runSelfTest :: SelfTestOptions -> IO [Check]
runSelfTest (SelfTestOptions quiet) = do
  terminal <- hIsTerminalDevice stdout
  noColour <- lookupEnv "NO_COLOR"
  checks <- selfTestChecks
  if quiet
    then pure ()
    else mapM_ putStrLn (tableLines (if terminal && maybe True null noColour then Painted else Plain) checks)
  putStrLn (summaryLine checks)
  pure checks
