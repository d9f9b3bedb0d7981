-- | What @blackhole animate@ tells while it runs, and in the end.
module BlackHole.Cli.AnimateReport
  ( newTeller,
    clearLine,
    reportLines,
    isWhole,
  )
where

import BlackHole.Animation.Claim (holderName)
import BlackHole.Animation.Progress
import BlackHole.Animation.Queue (Outcome (..))
import BlackHole.Animation.Shoot
import BlackHole.Cli.Console (tell)
import Control.Monad (when)
import Data.IORef (newIORef, readIORef, writeIORef)
import qualified Data.Map.Strict as Map
import GHC.Clock (getMonotonicTime)
import System.IO (hIsTerminalDevice, stderr)

-- | A listener that draws a bar on a terminal, and elsewhere writes a line every
-- five seconds.
newTeller :: (String -> IO ()) -> IO (Told -> IO ())
newTeller say = do
  terminal <- hIsTerminalDevice stderr
  start <- getMonotonicTime
  told <- newIORef (if terminal then start - 1 else start)
  pure $ \news -> do
    now <- getMonotonicTime
    before <- readIORef told
    case news of
      Remark line -> clearLine >> say line
      Progressed current tally
        | terminal -> when (now - before >= 0.1) $ do
          writeIORef told now
          tell ("\r\ESC[K" ++ progressBar 24 tally ++ " " ++ progressLine current tally)
        | otherwise -> when (now - before >= 5) $ do
          writeIORef told now
          tell (progressLine current tally ++ "\n")

-- | Clear the bar from a terminal.
clearLine :: IO ()
clearLine = do
  terminal <- hIsTerminalDevice stderr
  when terminal $ tell "\r\ESC[K"

-- | The end of a run in lines: counts, frames that are in work elsewhere, and
-- what has failed, each reason once.
reportLines :: Shot -> [String]
reportLines shot =
  [summary (shotTally shot)]
    ++ [ numbered (map fst elsewhere) ++ " in work elsewhere" ++ whose [holder | (_, Just holder) <- elsewhere]
         | not (null elsewhere)
       ]
    ++ [numbered (reverse frames) ++ " failed: " ++ reason | (reason, frames) <- Map.toList failed]
    ++ ["no film file: " ++ reason ++ "; the frames are kept, and another run makes it of them" | Just reason <- [shotVideoFault shot]]
  where
    elsewhere = [(n, holder) | (n, Elsewhere holder) <- shotOutcomes shot]
    failed = Map.fromListWith (++) [(reason, [n]) | (n, Failed reason) <- shotOutcomes shot]
    numbered frames = (if length frames == 1 then "frame " else "frames ") ++ frameRanges frames
    whose holders = case holders of
      holder : others -> " (" ++ holderName holder ++ (if null others then "" else ", ...") ++ ")"
      [] -> ""
    summary tally =
      show (tallyFrames tally) ++ (if tallyFrames tally == 1 then " frame: " else " frames: ") ++ show (tallyRendered tally) ++ " rendered"
        ++ (if tallyRendered tally > 0 then " in " ++ durationText (tallySeconds tally) else "")
        ++ (if tallyFound tally > 0 then ", " ++ show (tallyFound tally) ++ " were done" else "")
        ++ (if tallyFailed tally > 0 then ", " ++ show (tallyFailed tally) ++ " failed" else "")

-- | Whether nothing has failed.
isWhole :: Shot -> Bool
isWhole shot = null [() | (_, Failed _) <- shotOutcomes shot] && null (shotVideoFault shot)
