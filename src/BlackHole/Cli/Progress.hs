-- | Reports on the progress of a rendering, on standard error.
module BlackHole.Cli.Progress
  ( ProgressMode (..),

    -- * As text
    Progress (..),
    raysPerSecond,
    secondsLeft,
    progressBarLine,
    progressTextLine,
    progressJsonLine,

    -- * On standard error
    withProgress,
  )
where

import BlackHole.Animation.Progress (durationText)
import BlackHole.Cli.Console (tell)
import BlackHole.Cli.Json (showDouble)
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

-- | The progress of a rendering.
data Progress = Progress
  { progressRows :: !Int,
    progressRowsDone :: !Int,
    -- | Rays in one row: pixels times samples.
    progressRowRays :: !Int,
    -- | Since the start.
    progressSeconds :: !Double
  }
  deriving (Eq, Show)

-- | Rays per second so far; 'Nothing' before the first row.
raysPerSecond :: Progress -> Maybe Double
raysPerSecond p
  | progressRowsDone p > 0 && progressSeconds p > 0 =
    Just (fromIntegral (progressRowsDone p) * fromIntegral (progressRowRays p) / progressSeconds p)
  | otherwise = Nothing

-- | Estimated seconds for the remaining rows; 'Nothing' before the first row.
secondsLeft :: Progress -> Maybe Double
secondsLeft p
  | progressRowsDone p > 0 =
    Just (progressSeconds p * fromIntegral (max 0 (progressRows p - progressRowsDone p)) / fromIntegral (progressRowsDone p))
  | otherwise = Nothing

fraction :: Progress -> Double
fraction p = min 1 (max 0 (fromIntegral (progressRowsDone p) / fromIntegral (max 1 (progressRows p))))

-- | A bar, in colour or not, followed by the text of 'progressTextLine'. It fits into
-- the given number of columns, unless the text alone is longer.
progressBarLine :: Bool -> Int -> Progress -> String
progressBarLine coloured columns p
  | room >= 5 = "[" ++ paint (replicate full '=') ++ replicate (bar - full) ' ' ++ "] " ++ text
  | otherwise = text
  where
    text = progressTextLine p
    room = columns - length text - 4
    bar = min 40 room
    full = floor (fraction p * fromIntegral bar) :: Int
    paint s = if coloured then "\ESC[33m" ++ s ++ "\ESC[0m" else s

-- | Percentage, rays per second, elapsed time and remaining time.
progressTextLine :: Progress -> String
progressTextLine p =
  concat
    [ show (floor (100 * fraction p) :: Int),
      " %",
      foldMap (\r -> ", " ++ showFFloat (Just 3) (r / 1e6) " Mray/s") (raysPerSecond p),
      ", " ++ durationText (progressSeconds p) ++ " elapsed",
      foldMap (\s -> ", " ++ durationText s ++ " left") (secondsLeft p)
    ]

-- | One JSON object on one line: fraction done, rows, rays per second, seconds elapsed
-- and left; @null@ for numbers that are not known yet.
progressJsonLine :: Progress -> String
progressJsonLine p =
  "{\"fraction\": " ++ showDouble (fraction p)
    ++ (", \"rows_done\": " ++ show (progressRowsDone p))
    ++ (", \"rows\": " ++ show (progressRows p))
    ++ (", \"rays_per_second\": " ++ maybe "null" showDouble (raysPerSecond p))
    ++ (", \"seconds\": " ++ showDouble (progressSeconds p))
    ++ (", \"seconds_left\": " ++ maybe "null" showDouble (secondsLeft p))
    ++ "}"

-- | @withProgress mode rows rowRays action@: run an action with a function to call with
-- the number of rows done. Draws a bar at most ten times a second and clears it at the
-- end, or writes a line every five seconds, or a JSON object at most five times a
-- second and for the last row.
withProgress :: ProgressMode -> Int -> Int -> ((Int -> IO ()) -> IO a) -> IO a
withProgress mode rows rowRays action = do
  terminal <- hIsTerminalDevice stderr
  start <- getMonotonicTime
  told <- newIORef start
  noColour <- lookupEnv "NO_COLOR"
  let coloured = terminal && maybe True null noColour
      every seconds draw done = do
        now <- getMonotonicTime
        before <- readIORef told
        when (now - before >= seconds || (mode == JsonProgress && done >= rows)) $ do
          writeIORef told now
          draw (Progress rows done rowRays (now - start))
      bar p = do
        window <- if terminal then Terminal.hSize stderr else pure Nothing
        tell ("\r\ESC[K" ++ progressBarLine coloured (maybe 80 columnsOf window - 1) p)
      -- A terminal that does not know its size says 0.
      columnsOf window = if Terminal.width window > 0 then Terminal.width window else 80
      asBar = action (every 0.1 bar) `finally` tell "\r\ESC[K"
      asText = action (every 5 (tell . (++ "\n") . progressTextLine))
  case mode of
    AutoProgress
      | terminal -> asBar
      | otherwise -> asText
    BarProgress -> asBar
    LineProgress -> asText
    JsonProgress -> action (every 0.2 (tell . (++ "\n") . progressJsonLine))
    NoProgress -> action (const (pure ()))
