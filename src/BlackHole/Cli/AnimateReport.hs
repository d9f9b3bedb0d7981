-- | What @blackhole animate@ reports while it runs and at its end.
module BlackHole.Cli.AnimateReport
  ( newTeller,
    clearLine,
    summaryLine,
    faultLines,
    isWhole,
    animationStats,
  )
where

import BlackHole.Animation.Lease (holderName)
import BlackHole.Animation.Progress
import BlackHole.Animation.Queue (Outcome (..))
import BlackHole.Animation.Shoot
import BlackHole.Cli.Console (tell)
import BlackHole.Cli.Json
import BlackHole.Cli.Progress (ProgressMode (..))
import BlackHole.Render.Workers (Workers, workersCount)
import Control.Monad (when)
import Data.IORef (newIORef, readIORef, writeIORef)
import qualified Data.Map.Strict as Map
import GHC.Clock (getMonotonicTime)
import Numeric (showFFloat)
import System.IO (hIsTerminalDevice, stderr)

-- | A listener that reports progress on standard error: a bar at most ten times a
-- second, a line every five seconds, or a JSON object at most five times a second and
-- for the last frame. It passes remarks on to the first argument in any mode.
newTeller :: (String -> IO ()) -> ProgressMode -> IO (Report -> IO ())
newTeller say mode = do
  terminal <- hIsTerminalDevice stderr
  start <- getMonotonicTime
  told <- newIORef (if mode == BarProgress then start - 1 else start)
  let every seconds always text = do
        now <- getMonotonicTime
        before <- readIORef told
        when (always || now - before >= seconds) $ do
          writeIORef told now
          tell text
  pure $ \news -> case (news, mode) of
    (Remark line, _) -> clearLine mode >> say line
    (_, NoProgress) -> pure ()
    (Progressed current tally, JsonProgress) -> every 0.2 (isSettled tally) (jsonLine current tally ++ "\n")
    (Progressed current tally, _)
      | mode == BarProgress || (mode == AutoProgress && terminal) ->
        every 0.1 False ("\r\ESC[K" ++ progressBar 24 tally ++ " " ++ progressLine current tally)
      | otherwise -> every 5 False (progressLine current tally ++ "\n")
  where
    isSettled tally = settledFrames tally >= tallyFrames tally

-- | Clear the bar, if this mode draws one.
clearLine :: ProgressMode -> IO ()
clearLine mode = do
  terminal <- hIsTerminalDevice stderr
  when (mode == BarProgress || (mode == AutoProgress && terminal)) $ tell "\r\ESC[K"

-- Progress as one JSON object on one line.
jsonLine :: Maybe Int -> Tally -> String
jsonLine current tally =
  "{\"fraction\": " ++ showDouble ((fromIntegral settled + tallyPart tally) / fromIntegral (max 1 (tallyFrames tally)))
    ++ (", \"frames_done\": " ++ show settled)
    ++ (", \"frames\": " ++ show (tallyFrames tally))
    ++ (", \"frame\": " ++ maybe "null" show current)
    ++ (", \"frames_per_second\": " ++ maybe "null" showDouble (framesPerSecond tally))
    ++ (", \"seconds\": " ++ showDouble (tallySeconds tally))
    ++ (", \"seconds_left\": " ++ maybe "null" showDouble (secondsLeft tally))
    ++ "}"
  where
    settled = settledFrames tally

settledFrames :: Tally -> Int
settledFrames tally = tallyFound tally + tallyRendered tally + tallyFailed tally + tallyElsewhere tally

-- | The counts of a run in one line, such as @48 frames: 40 rendered in 12.3 s, 8 already
-- done@.
summaryLine :: Shot -> String
summaryLine shot =
  show (tallyFrames tally) ++ (if tallyFrames tally == 1 then " frame: " else " frames: ") ++ show (tallyRendered tally) ++ " rendered"
    ++ (if tallyRendered tally > 0 then " in " ++ (if tallySeconds tally < 60 then showFFloat (Just 1) (tallySeconds tally) " s" else durationText (tallySeconds tally)) else "")
    ++ (if tallyFound tally > 0 then ", " ++ show (tallyFound tally) ++ " already done" else "")
    ++ (if tallyFailed tally > 0 then ", " ++ show (tallyFailed tally) ++ " failed" else "")
  where
    tally = shotTally shot

-- | One line each for the frames that other processes are rendering, for every reason
-- for failures, and for a missing video file.
faultLines :: Shot -> [String]
faultLines shot =
  [ numbered (map fst elsewhere) ++ " being rendered by another process" ++ whose [holder | (_, Just holder) <- elsewhere]
    | not (null elsewhere)
  ]
    ++ [numbered (reverse frames) ++ " failed: " ++ reason | (reason, frames) <- Map.toList failed]
    ++ ["no video file: " ++ reason ++ "; the frames are kept, and the next run makes the video file from them" | Just reason <- [shotVideoFault shot]]
  where
    elsewhere = [(n, holder) | (n, Elsewhere holder) <- shotOutcomes shot]
    failed = Map.fromListWith (++) [(reason, [n]) | (n, Failed reason) <- shotOutcomes shot]
    numbered frames = (if length frames == 1 then "frame " else "frames ") ++ frameRanges frames
    whose holders = case holders of
      holder : others -> " (" ++ holderName holder ++ (if null others then "" else ", ...") ++ ")"
      [] -> ""

-- | Whether no frame has failed and the video file, if any, is complete.
isWhole :: Shot -> Bool
isWhole shot = null [() | (_, Failed _) <- shotOutcomes shot] && null (shotVideoFault shot)

-- | The statistics of a run for @--stats@, given the program's version and the peak of
-- its memory in bytes.
animationStats :: String -> Maybe Integer -> Workers -> Shot -> Json
animationStats version memory workers shot =
  Object
    [ ("version", Text version),
      ("frames", Whole (tallyFrames tally)),
      ("rendered", Whole (tallyRendered tally)),
      ("already_done", Whole (tallyFound tally)),
      ("failed", Whole (tallyFailed tally)),
      ("elsewhere", Whole (tallyElsewhere tally)),
      ("workers", Whole (workersCount workers)),
      ("seconds", Number (tallySeconds tally)),
      ("frames_per_second", maybe Null Number (framesPerSecond tally)),
      ("peak_memory_bytes", maybe Null (Whole . fromInteger) memory)
    ]
  where
    tally = shotTally shot
