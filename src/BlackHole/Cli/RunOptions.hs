-- | The options that say how a picture is rendered and what is told about it,
-- not what is in it.
module BlackHole.Cli.RunOptions
  ( RunOptions (..),
    runOptions,
  )
where

import BlackHole.Cli.Progress (ProgressMode (..))
import BlackHole.Cli.Read
import Options.Applicative

-- | How to go about a rendering.
data RunOptions = RunOptions
  { runProgress :: !ProgressMode,
    -- | A file for what the rendering took.
    runStats :: !(Maybe FilePath),
    -- | Fail over pixels without finite radiance.
    runStrict :: !Bool,
    -- | Write what is done when interrupted.
    runKeepPartial :: !Bool
  }
  deriving (Eq, Show)

-- | Their grammar; @--quiet@ counts more than @--progress@.
runOptions :: Parser RunOptions
runOptions =
  RunOptions
    <$> progress
    <*> setting (strOption (long "stats" <> metavar "FILE.json" <> action "file" <> help "Write what the rendering took: rays, seconds per stage, memory, workers"))
    <*> toggle (long "strict" <> help "Fail, with exit code 1 and no file, if a pixel has no finite radiance")
    <*> toggle (long "keep-partial" <> help "When interrupted, write the rows that are done, the others black")
  where
    progress =
      (\mode quiet -> if quiet then NoProgress else mode)
        <$> settingOr AutoProgress (option (named "a way to tell about progress" modes) (long "progress" <> metavar "HOW" <> completeWith (map fst modes) <> help "On standard error: auto (a bar on a terminal, lines elsewhere), bar, lines, json (an object a line) or none (default: auto)"))
        <*> toggle (long "quiet" <> short 'q' <> help "Tell nothing about progress")
    modes = [("auto", AutoProgress), ("bar", BarProgress), ("lines", LineProgress), ("json", JsonProgress), ("none", NoProgress)]
