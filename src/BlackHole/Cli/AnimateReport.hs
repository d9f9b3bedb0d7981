-- | What @blackhole animate@ reports while it runs and at its end.
module BlackHole.Cli.AnimateReport
  ( reportTo,
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
import BlackHole.Cli.Json
import BlackHole.Cli.Progress
import BlackHole.Render.Workers (Workers, workersCount)
import qualified Data.Map.Strict as Map
import Numeric (showFFloat)

-- | A listener that shows progress by a reporter and passes remarks on to the first
-- argument.
reportTo :: (String -> IO ()) -> Reporter -> Report -> IO ()
reportTo say reporter news = case news of
  Remark line -> clearProgress reporter >> say line
  Progressed current tally -> showProgress reporter (framesProgress current tally)

framesProgress :: Maybe Int -> Tally -> Progress
framesProgress current tally =
  Progress
    { progressFraction =
        (fromIntegral settled + tallyPart tally)
          / fromIntegral
            (max 1 (tallyFrames tally)),
      progressText = progressLine current tally,
      progressMembers =
        [ ("frames_done", Whole settled),
          ("frames", Whole (tallyFrames tally)),
          ("frame", maybe Null Whole current),
          ("frames_per_second", maybe Null Number (framesPerSecond tally)),
          ("seconds", Number (tallySeconds tally)),
          ("seconds_left", maybe Null Number (secondsLeft tally))
        ]
    }
  where
    settled = tallyFound tally + tallyRendered tally + tallyFailed tally + tallyElsewhere tally

-- | The counts of a run in one line, such as @48 frames: 40 rendered in 12.3 s, 8 already
-- done@.
summaryLine :: Shot -> String
summaryLine shot =
  show (tallyFrames tally) ++ (if tallyFrames tally == 1 then " frame: " else " frames: ")
    ++ show (tallyRendered tally)
    ++ " rendered"
    ++ ( if tallyRendered tally > 0
           then
             " in "
               ++ ( if tallySeconds tally < 60
                      then showFFloat (Just 1) (tallySeconds tally) " s"
                      else durationText (tallySeconds tally)
                  )
           else ""
       )
    ++ (if tallyFound tally > 0 then ", " ++ show (tallyFound tally) ++ " already done" else "")
    ++ (if tallyFailed tally > 0 then ", " ++ show (tallyFailed tally) ++ " failed" else "")
  where
    tally = shotTally shot

-- | One line each for the frames that other processes are rendering, for every reason
-- for failures, and for a missing video file.
faultLines :: Shot -> [String]
faultLines shot =
  [ numbered (map fst elsewhere) ++ " being rendered by another process"
      ++ whose [holder | (_, Just holder) <- elsewhere]
    | not (null elsewhere)
  ]
    ++ [numbered (reverse frames) ++ " failed: " ++ reason | (reason, frames) <- Map.toList failed]
    ++ [ "no video file: " ++ reason
           ++ "; the frames are kept, and the next run makes the video file from them"
         | Just reason <- [shotVideoFault shot]
       ]
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
