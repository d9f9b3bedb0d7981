-- | Telling how far a rendering is, on standard error.
module BlackHole.Cli.Progress
  ( ProgressMode (..),

    -- * In words
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

-- | How to tell.
data ProgressMode
  = -- | A bar on a terminal; lines elsewhere.
    AutoProgress
  | BarProgress
  | LineProgress
  | -- | One JSON object a line.
    JsonProgress
  | NoProgress
  deriving (Eq, Show)

-- | How far a rendering is.
data Progress = Progress
  { progressRows :: !Int,
    progressRowsDone :: !Int,
    -- | Rays in one row: pixels times samples.
    progressRowRays :: !Int,
    -- | Since the beginning.
    progressSeconds :: !Double
  }
  deriving (Eq, Show)

-- | Rays over time; 'Nothing' before there is anything to go by.
raysPerSecond :: Progress -> Maybe Double
raysPerSecond p
  | progressRowsDone p > 0 && progressSeconds p > 0 =
    Just (fromIntegral (progressRowsDone p) * fromIntegral (progressRowRays p) / progressSeconds p)
  | otherwise = Nothing

-- | What the rest will take at the pace so far.
secondsLeft :: Progress -> Maybe Double
secondsLeft p
  | progressRowsDone p > 0 =
    Just (progressSeconds p * fromIntegral (max 0 (progressRows p - progressRowsDone p)) / fromIntegral (progressRowsDone p))
  | otherwise = Nothing

fraction :: Progress -> Double
fraction p = min 1 (max 0 (fromIntegral (progressRowsDone p) / fromIntegral (max 1 (progressRows p))))

-- | A bar for a line of that many columns, coloured or plain: bar, percent, pace,
-- elapsed time, time left. No longer than the columns, unless these are fewer
-- than the numbers need without any bar.
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

-- | The same without a bar.
progressTextLine :: Progress -> String
progressTextLine p =
  concat
    [ show (floor (100 * fraction p) :: Int),
      " %",
      foldMap (\r -> ", " ++ showFFloat (Just 3) (r / 1e6) " Mray/s") (raysPerSecond p),
      ", " ++ durationText (progressSeconds p) ++ " elapsed",
      foldMap (\s -> ", " ++ durationText s ++ " left") (secondsLeft p)
    ]

-- | One JSON object on one line: fraction done, rows, rays a second, seconds
-- elapsed and left; @null@ for what is not known yet.
progressJsonLine :: Progress -> String
progressJsonLine p =
  "{\"fraction\": " ++ showDouble (fraction p)
    ++ (", \"rows_done\": " ++ show (progressRowsDone p))
    ++ (", \"rows\": " ++ show (progressRows p))
    ++ (", \"rays_per_second\": " ++ maybe "null" showDouble (raysPerSecond p))
    ++ (", \"seconds\": " ++ showDouble (progressSeconds p))
    ++ (", \"seconds_left\": " ++ maybe "null" showDouble (secondsLeft p))
    ++ "}"

-- | @withProgress mode rows rowRays action@: the action gets a function that
-- takes the number of rows done. A bar is drawn at most ten times a second and
-- cleared at the end; text comes every five seconds, so that short renderings
-- stay silent; objects come at most five a second, the last for the last row.
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
