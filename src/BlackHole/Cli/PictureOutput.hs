-- | The files that @render@, @join@ and @animate@ write: checks before any work, writing,
-- and the report of success.
module BlackHole.Cli.PictureOutput
  ( outputFormat,
    unknownExtensionOf,
    noRoom,
    whenWritable,
    Writing (..),
    store,
    storeBy,
    storeStats,
    pictureSucceeded,
    inWorkers,
    timed,
  )
where

import BlackHole.Cli.Console
import BlackHole.Cli.ExitStatus
import BlackHole.Cli.Json
import BlackHole.Cli.Memory (Making, memoryProblem)
import BlackHole.Cli.Overwriting (overwritten)
import BlackHole.Cli.Progress (ProgressMode (JsonProgress))
import BlackHole.Cli.RunOptions
import BlackHole.Image.AtomicFile
import BlackHole.Image.Coding
import BlackHole.Render.Workers
import BlackHole.Scene.Problem (Problem (..))
import BlackHole.Scene.Scene (Scene)
import qualified Data.ByteString.Builder as Builder
import qualified Data.ByteString.Lazy as Lazy
import Data.List (intercalate)
import GHC.Clock (getMonotonicTime)
import System.IO (Handle, hIsTerminalDevice, stdout)

-- | The format for a file's name; PNG for standard output.
outputFormat :: FilePath -> Maybe Format
outputFormat "-" = Just Png
outputFormat name = formatOf name

-- | The problem of a file name whose extension is of no format.
unknownExtensionOf :: FilePath -> Problem
unknownExtensionOf output =
  Problem
    "--output"
    ("'" ++ output ++ "'")
    ("a file name that ends in " ++ intercalate ", " (map fst formatExtensions))

-- | The message for a picture that its format cannot hold.
noRoom :: FilePath -> String
noRoom output = "--output: " ++ output ++ ": the picture is too large for this format"

-- | A picture that is to be written.
data Writing = Writing
  { writingMaking :: !Making,
    writingScene :: !Scene,
    -- | The number of rows in memory.
    writingRows :: !Int,
    -- | The files that are read, with the names that messages use for them.
    writingInputs :: ![(String, FilePath)],
    writingOutput :: !FilePath,
    writingReporting :: !Reporting
  }

-- | Runs an action if the picture fits into memory, and if its file and the statistics
-- can be written, as far as that is known in advance, without overwriting an input.
whenWritable :: Writing -> IO ExitStatus -> IO ExitStatus
whenWritable (Writing making scene rows inputs output reported) action = do
  clashes <-
    overwritten
      inputs
      (("--output", output) : [("--stats", file) | Just file <- [reportStats reported]])
  lacking <- memoryProblem making scene rows
  outputProblem <- outputFault output
  statsProblem <- maybe (pure (Right ())) checkWritable (reportStats reported)
  case (lacking, outputProblem, statsProblem) of
    _ | _ : _ <- clashes -> UsageError <$ mapM_ say clashes
    (Just line, _, _) -> complain BadInput line
    (_, Just line, _) -> complain CannotWrite ("--output: " ++ line)
    (_, _, Left problem) -> complain CannotWrite ("--stats: " ++ renderWriteProblem problem)
    _ -> action

-- | The reason why a picture cannot be written to a file, as far as that is known in
-- advance.
outputFault :: FilePath -> IO (Maybe String)
outputFault "-" = do
  closed <- outputIsClosed
  terminal <- hIsTerminalDevice stdout
  pure $
    if closed
      then Just "standard output is closed"
      else
        if terminal
          then Just "standard output is a terminal; redirect it to a file or a program"
          else Nothing
outputFault name = either (Just . renderWriteProblem) (const Nothing) <$> checkWritable name

-- | Writes a file or, for @-@, to standard output.
store :: FilePath -> Lazy.ByteString -> IO ExitStatus
store output bytes = storeBy output (`Lazy.hPut` bytes)

-- | 'store' for an action that writes to a handle.
storeBy :: FilePath -> (Handle -> IO ()) -> IO ExitStatus
storeBy "-" write =
  printWith write
    >>= either (complain CannotWrite . ("--output: " ++) . outputProblemText) (const (pure Done))
storeBy output write = writeAtomically output write >>= stored "--output"

-- | Writes the statistics, if the options ask for them.
storeStats :: Reporting -> Json -> IO ExitStatus
storeStats reported stats = case reportStats reported of
  Just file ->
    writeFileAtomically file (Builder.toLazyByteString (Builder.stringUtf8 (renderJson stats)))
      >>= stored "--stats"
  Nothing -> pure Done

stored :: String -> Either WriteProblem () -> IO ExitStatus
stored option =
  either
    (complain CannotWrite . ((option ++ ": ") ++) . renderWriteProblem)
    (const (pure Done))

-- | Reports that a picture of a width and height is written, given the time of the start,
-- unless the options ask for silence. Progress in JSON gets a JSON object.
pictureSucceeded :: Reporting -> Double -> FilePath -> (Int, Int) -> IO ()
pictureSucceeded reported start file (width, height) = case progressMode reported of
  _ | reportQuiet reported -> pure ()
  JsonProgress -> do
    end <- getMonotonicTime
    message . (++ "\n") . jsonLine $
      Object
        [ ("file", Text file),
          ("width", Whole width),
          ("height", Whole height),
          ("seconds", Number (end - start))
        ]
  _ -> succeeded start file (show width ++ " × " ++ show height)

-- | Runs an action with the given number of workers, or one per core.
inWorkers :: Maybe Int -> (Workers -> IO a) -> IO a
inWorkers threads action = do
  workers <- maybe defaultWorkers pure (workersFromCount =<< threads)
  withWorkers workers (action workers)

-- | An action's result and the seconds it took.
timed :: IO a -> IO (a, Double)
timed work = do
  start <- getMonotonicTime
  result <- work
  end <- getMonotonicTime
  pure (result, end - start)
