-- | The options that control how the program works and what it reports, as opposed to
-- what a picture shows.
module BlackHole.Cli.RunOptions
  ( Reporting (..),
    reporting,
    progressMode,
    threadsOption,
    RunOptions (..),
    runOptions,
  )
where

import BlackHole.Cli.Progress (ProgressMode (..))
import BlackHole.Cli.Read
import Data.Maybe (fromMaybe)
import Options.Applicative

-- | What a command reports about its work.
data Reporting = Reporting
  { -- | The value of @--progress@, if it is given.
    reportProgress :: !(Maybe ProgressMode),
    reportQuiet :: !Bool,
    -- | The file for statistics.
    reportStats :: !(Maybe FilePath)
  }
  deriving (Eq, Show)

-- | Their parser.
reporting :: Parser Reporting
reporting =
  Reporting
    <$> setting
      ( option
          (named "a way to report progress" modes)
          ( long "progress" <> metavar "HOW" <> completeWith (map fst modes)
              <> help
                "Progress on standard error: auto (a bar on a terminal, otherwise lines), bar, \
                \lines, json (one object per line) or none (default: auto)"
          )
      )
    <*> toggle (long "quiet" <> short 'q' <> help "Report neither progress nor success")
    <*> setting
      ( strOption
          ( long "stats" <> metavar "FILE.json" <> action "file"
              <> help "Write statistics to this file: seconds, memory, workers and more"
          )
      )
  where
    modes =
      [ ("auto", AutoProgress),
        ("bar", BarProgress),
        ("lines", LineProgress),
        ("json", JsonProgress),
        ("none", NoProgress)
      ]

-- | How to report progress. @--quiet@ takes precedence over @--progress@.
progressMode :: Reporting -> ProgressMode
progressMode options
  | reportQuiet options = NoProgress
  | otherwise = fromMaybe AutoProgress (reportProgress options)

-- | @--threads@; its value is not checked yet.
threadsOption :: Parser (Maybe Int)
threadsOption =
  setting
    ( option
        wholeNumber
        ( long "threads" <> metavar "N"
            <> help
              "Number of worker threads, which does not change the result (default: one per core)"
        )
    )

-- | The options of a rendering.
data RunOptions = RunOptions
  { runReporting :: !Reporting,
    -- | Fail if a pixel has no finite radiance.
    runStrict :: !Bool,
    -- | Write the finished rows when interrupted.
    runKeepPartial :: !Bool
  }
  deriving (Eq, Show)

-- | Their parser.
runOptions :: Parser RunOptions
runOptions =
  RunOptions
    <$> reporting
    <*> toggle
      ( long "strict"
          <> help "Fail with exit code 1 and write no file if a pixel has no finite radiance"
      )
    <*> toggle
      ( long "keep-partial"
          <> help "When interrupted, write the picture with the unfinished rows black"
      )
