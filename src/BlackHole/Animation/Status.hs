-- | The status of a folder of frames, for a process that renders none of them.
module BlackHole.Animation.Status
  ( AnimationStatus (..),
    animationStatuses,
    isComplete,
    statusLines,
  )
where

import BlackHole.Animation.FrameName
import BlackHole.Animation.FrameStore
import BlackHole.Animation.Lease
import BlackHole.Animation.Progress (frameRanges)

-- | The frames of one animation, each in exactly one of the lists.
data AnimationStatus = AnimationStatus
  { statusName :: !FrameName,
    statusDone :: ![Int],
    -- | Frames in progress, with their holders.
    statusRunning :: ![(Int, Maybe Holder)],
    statusMissing :: ![Int],
    -- | Frames of a different scene than the animation's latest run asked for.
    statusStale :: ![Int],
    statusDamaged :: ![Int]
  }

-- | The status of all animations in a folder, from the lists that their runs left. Reads
-- every finished frame once. Leases of other machines count as abandoned after this
-- many seconds without a touch.
animationStatuses :: FilePath -> Double -> IO [AnimationStatus]
animationStatuses folder patience = do
  lists <- readFrameLists folder
  holder <- currentHolder
  mapM (status holder) lists
  where
    status holder (name, frames) = do
      store <- openFrameStore name holder patience
      found <- mapM (look store) frames
      pure
        AnimationStatus
          { statusName = name,
            statusDone = [n | (n, Done) <- found],
            statusRunning = [(n, who) | (n, Running who) <- found],
            statusMissing = [n | (n, Lacking Missing) <- found],
            statusStale = [n | (n, Lacking Stale) <- found],
            statusDamaged = [n | (n, Lacking Damaged) <- found]
          }
    look store (n, digest) = do
      state <- frameState store n digest
      case state of
        Finished _ -> pure (n, Done)
        _ -> do
          alive <- liveHolder (frameStoreLeases store) (frameLabel store n)
          pure (n, maybe (Lacking state) Running alive)

data FrameProgress
  = Done
  | Running !(Maybe Holder)
  | Lacking !FrameState

-- | Whether all frames are done.
isComplete :: AnimationStatus -> Bool
isComplete status =
  null (statusRunning status) && null (statusMissing status) && null (statusStale status)
    && null (statusDamaged status)

-- | The status as text: a line of counts, followed by the frames that are not done.
statusLines :: AnimationStatus -> [String]
statusLines status =
  ( framePattern (statusName status) ++ ": " ++ show total ++ " frames, "
      ++ show (length (statusDone status))
      ++ " done, "
      ++ show (length (statusRunning status))
      ++ " running, "
      ++ show (length (statusMissing status))
      ++ " missing, "
      ++ show (length (statusStale status))
      ++ " stale, "
      ++ show (length (statusDamaged status))
      ++ " damaged"
  ) :
  [ "  running: " ++ show n ++ maybe "" ((" (" ++) . (++ ")") . holderName) who
    | (n, who) <- statusRunning status
  ]
    ++ concat
      [ ["  " ++ what ++ ": " ++ frameRanges frames | not (null frames)]
        | (what, frames) <-
            [ ("missing", statusMissing status),
              ("stale", statusStale status),
              ("damaged", statusDamaged status)
            ]
      ]
  where
    total =
      sum
        ( map
            length
            [ statusDone status,
              map fst (statusRunning status),
              statusMissing status,
              statusStale status,
              statusDamaged status
            ]
        )
