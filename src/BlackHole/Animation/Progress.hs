-- | The progress of an animation: its counts, and as text.
module BlackHole.Animation.Progress
  ( Tally (..),
    startTally,
    framesPerSecond,
    secondsLeft,
    progressLine,
    durationText,
    frameRanges,
  )
where

import Numeric (showFFloat)

-- | The work that a run has done so far on its frames.
data Tally = Tally
  { -- | Total number of frames of this run.
    tallyFrames :: !Int,
    -- | Number of frames that already existed.
    tallyFound :: !Int,
    tallyRendered :: !Int,
    tallyFailed :: !Int,
    -- | Number of frames that other processes are rendering.
    tallyElsewhere :: !Int,
    -- | The finished fraction of the current frame, 0 to 1.
    tallyPart :: !Double,
    -- | Seconds since rendering of the first frame began.
    tallySeconds :: !Double
  }
  deriving (Eq, Show)

-- | The tally at the start of a run of this many frames.
startTally :: Int -> Tally
startTally frames = Tally frames 0 0 0 0 0 0

-- | Rendered frames per second; 'Nothing' while there are too few to tell.
framesPerSecond :: Tally -> Maybe Double
framesPerSecond tally
  | made > 0 && tallySeconds tally > 0 = Just (made / tallySeconds tally)
  | otherwise = Nothing
  where
    made = fromIntegral (tallyRendered tally) + tallyPart tally

-- | Estimated seconds for the remaining frames at the pace so far.
secondsLeft :: Tally -> Maybe Double
secondsLeft tally = (remaining /) <$> framesPerSecond tally
  where
    settled = tallyFound tally + tallyRendered tally + tallyFailed tally + tallyElsewhere tally
    remaining = max 0 (fromIntegral (tallyFrames tally - settled) - tallyPart tally)

-- | One line with the finished and total number of frames, the current frame and its
-- finished fraction, the pace, and the time left.
progressLine :: Maybe Int -> Tally -> String
progressLine current tally =
  concat
    [ show (tallyFound tally + tallyRendered tally),
      " of ",
      show (tallyFrames tally),
      " frames",
      foldMap
        (\n -> ", frame " ++ show n ++ " " ++ show (floor (100 * tallyPart tally) :: Int) ++ " %")
        current,
      foldMap
        (\f -> ", " ++ showFFloat (Just (if f < 10 then 2 else 0)) f " frames/s")
        (framesPerSecond tally),
      foldMap (\s -> ", " ++ durationText s ++ " left") (secondsLeft tally),
      if tallyFailed tally > 0 then ", " ++ show (tallyFailed tally) ++ " failed" else ""
    ]

-- | Formats seconds as @M:SS@ or @H:MM:SS@.
durationText :: Double -> String
durationText seconds
  | hours > 0 = show hours ++ ":" ++ two minutes ++ ":" ++ two rest
  | otherwise = show minutes ++ ":" ++ two rest
  where
    total = round (max 0 (min 1e9 seconds)) :: Int
    (hours, within) = total `quotRem` 3600
    (minutes, rest) = within `quotRem` 60
    two n = (if n < 10 then "0" else "") ++ show n

-- | Formats frame numbers in ascending order, with consecutive ones joined: @0-3, 7@.
frameRanges :: [Int] -> String
frameRanges [] = "none"
frameRanges (first : rest) = go first first rest
  where
    go from to (n : more) | n == to + 1 = go from n more
    go from to more =
      (if from == to then show from else show from ++ "-" ++ show to) ++ case more of
        [] -> ""
        n : others -> ", " ++ go n n others
