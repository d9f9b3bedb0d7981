-- | Reports on the progress of a command, on standard error.
module BlackHole.Cli.Progress
  ( ProgressMode (..),

    -- * Progress
    Progress (..),
    pictureProgress,
    progressBarLine,
    progressJsonLine,

    -- * On standard error
    Reporter (..),
    newReporter,
    withProgress,
  )
where

import BlackHole.Animation.Progress (durationText)
import BlackHole.Cli.Console (tell)
import BlackHole.Cli.Json
import Control.Exception (finally)
import Control.Monad (when)
import Data.IORef
import GHC.Clock (getMonotonicTime)
import Numeric (showFFloat)
import qualified System.Console.Terminal.Size as Terminal
import System.Environment (lookupEnv)
import System.IO (hIsTerminalDevice, stderr)

-- | How to report progress.
data ProgressMode
  = -- | A bar on a terminal, otherwise lines.
    AutoProgress
  | BarProgress
  | LineProgress
  | -- | One JSON object a line.
    JsonProgress
  | NoProgress
  deriving (Eq, Show)

-- | The progress of a command.
data Progress = Progress
  { -- | The finished fraction of the work, 0 to 1.
    progressFraction :: !Double,
    -- | One line for people.
    progressText :: !String,
    -- | The members of the JSON object besides the fraction.
    progressMembers :: ![(String, Json)]
  }
  deriving (Eq, Show)

-- | @pictureProgress rows rowRays seconds done@ is the progress of a picture of so many
-- rows and rays in each row, some of which are done after some seconds. As text it has
-- the percentage, rays per second, elapsed time and remaining time; the pace and the
-- remaining time are unknown before the first row.
pictureProgress :: Int -> Int -> Double -> Int -> Progress
pictureProgress rows rowRays seconds done =
  Progress
    { progressFraction = fraction,
      progressText =
        concat
          [ show (floor (100 * fraction) :: Int),
            " %",
            foldMap (\r -> ", " ++ showFFloat (Just 3) (r / 1e6) " Mray/s") pace,
            ", " ++ durationText seconds ++ " elapsed",
            foldMap (\s -> ", " ++ durationText s ++ " left") left
          ],
      progressMembers =
        [ ("rows_done", Whole done),
          ("rows", Whole rows),
          ("rays_per_second", maybe Null Number pace),
          ("seconds", Number seconds),
          ("seconds_left", maybe Null Number left)
        ]
    }
  where
    fraction = min 1 (max 0 (fromIntegral done / fromIntegral (max 1 rows)))
    pace
      | done > 0 && seconds > 0 = Just (fromIntegral done * fromIntegral rowRays / seconds)
      | otherwise = Nothing
    left
      | done > 0 = Just (seconds * fromIntegral (max 0 (rows - done)) / fromIntegral done)
      | otherwise = Nothing

-- | A bar, in colour or not, followed by the text. It fits into the given number of
-- columns, unless the text alone is longer.
progressBarLine :: Bool -> Int -> Progress -> String
progressBarLine coloured columns (Progress fraction text _)
  | room >= 5 = "[" ++ paint (replicate full '=') ++ replicate (bar - full) ' ' ++ "] " ++ text
  | otherwise = text
  where
    room = columns - length text - 4
    bar = min 40 room
    full = max 0 (min bar (floor (fraction * fromIntegral bar)))
    paint s = if coloured then "\ESC[33m" ++ s ++ "\ESC[0m" else s

-- | One JSON object on one line; @null@ for numbers that are not known yet.
progressJsonLine :: Progress -> String
progressJsonLine (Progress fraction _ members) =
  jsonLine
    (Object (("fraction", Number fraction) : members))

-- | Shows progress on standard error.
data Reporter = Reporter
  { showProgress :: !(Progress -> IO ()),
    -- | Clears the bar, if there is one.
    clearProgress :: !(IO ())
  }

-- | A reporter for a mode: it draws a bar at most ten times a second, or writes a line
-- every five seconds, or a JSON object at most five times a second and whenever all work
-- is done.
newReporter :: ProgressMode -> IO Reporter
newReporter mode = do
  terminal <- hIsTerminalDevice stderr
  noColour <- lookupEnv "NO_COLOR"
  start <- getMonotonicTime
  told <- newIORef start
  let every seconds line progress = do
        now <- getMonotonicTime
        before <- readIORef told
        when (now - before >= seconds || (mode == JsonProgress && progressFraction progress >= 1)) $
          do
            writeIORef told now
            tell =<< line progress
      bar progress = do
        window <- if terminal then Terminal.hSize stderr else pure Nothing
        pure
          ( cleared
              ++ progressBarLine
                (terminal && maybe True null noColour)
                (maybe 80 columnsOf window - 1)
                progress
          )
      -- A terminal that does not know its size says 0.
      columnsOf window = if Terminal.width window > 0 then Terminal.width window else 80
      lineOf text = pure . (++ "\n") . text
      cleared = "\r\ESC[K"
      drawing = Reporter (every 0.1 bar) (tell cleared)
      writing seconds text = Reporter (every seconds (lineOf text)) (pure ())
  pure $ case mode of
    AutoProgress
      | terminal -> drawing
      | otherwise -> writing 5 progressText
    BarProgress -> drawing
    LineProgress -> writing 5 progressText
    JsonProgress -> writing 0.2 progressJsonLine
    NoProgress -> Reporter (const (pure ())) (pure ())

-- | @withProgress mode rows rowRays action@ runs an action with a function to call with
-- the number of finished rows, and clears the bar at the end.
withProgress :: ProgressMode -> Int -> Int -> ((Int -> IO ()) -> IO a) -> IO a
withProgress mode rows rowRays action = do
  reporter <- newReporter mode
  start <- getMonotonicTime
  let report done = do
        now <- getMonotonicTime
        showProgress reporter (pictureProgress rows rowRays (now - start) done)
  action report `finally` clearProgress reporter
