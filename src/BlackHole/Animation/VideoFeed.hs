-- | The feed of finished frames into a video file: in the order of the animation, in
-- whatever order they are finished.
module BlackHole.Animation.VideoFeed
  ( VideoFeed,
    startVideoFeed,
    videoFeedFault,
    feedFrame,
    finishVideoFeed,
    abandonVideoFeed,
  )
where

import BlackHole.Animation.FrameName
import BlackHole.Animation.Progress (frameRanges)
import BlackHole.Animation.Queue (Outcome (..))
import BlackHole.Animation.Video
import Control.Monad (forM_)
import Data.IORef (IORef, modifyIORef', newIORef, readIORef, writeIORef)
import Data.List (sort)
import qualified Data.Set as Set

-- | A video file that is being encoded, or the reason why there is none.
data VideoFeed = VideoFeed
  { feedVideoFile :: !(Either String Video),
    videoFeedName :: !FrameName,
    -- | Frames not sent yet, in the animation's order.
    videoFeedLeft :: !(IORef [Int]),
    -- | Finished frames that wait for an earlier one.
    videoFeedReady :: !(IORef (Set.Set Int)),
    videoFeedFailed :: !(IORef [Int])
  }

-- | @startVideoFeed ffmpeg coding rate target name frames@ starts a video of these frames
-- ('startVideo').
startVideoFeed ::
  FilePath ->
  VideoCoding ->
  Double ->
  FilePath ->
  FrameName ->
  [Int] ->
  IO VideoFeed
startVideoFeed coder kind rate target name frames = do
  started <- startVideo coder kind rate target
  VideoFeed started name <$> newIORef frames <*> newIORef Set.empty <*> newIORef []

-- | The reason why the video file could not be started.
videoFeedFault :: VideoFeed -> Maybe String
videoFeedFault = either Just (const Nothing) . feedVideoFile

-- | Takes note of a frame's outcome, and passes on the frames whose turn has come.
feedFrame :: VideoFeed -> Int -> Outcome -> IO ()
feedFrame feed frame outcome = do
  case outcome of
    WasDone -> ready
    Rendered _ -> ready
    _ -> modifyIORef' (videoFeedFailed feed) (frame :)
  advance
  where
    ready = modifyIORef' (videoFeedReady feed) (Set.insert frame)
    advance = do
      left <- readIORef (videoFeedLeft feed)
      waiting <- readIORef (videoFeedReady feed)
      case left of
        next : later | next `Set.member` waiting -> do
          writeIORef (videoFeedLeft feed) later
          writeIORef (videoFeedReady feed) (Set.delete next waiting)
          forM_ (feedVideoFile feed) $
            \video -> feedVideo video (frameFile (videoFeedName feed) next)
          advance
        _ -> pure ()

-- | Finishes the video file; 'Just' the reason if there is none.
finishVideoFeed :: VideoFeed -> IO (Maybe String)
finishVideoFeed feed = do
  failed <- readIORef (videoFeedFailed feed)
  case feedVideoFile feed of
    Left reason -> pure (Just reason)
    Right video
      | null failed -> either Just (const Nothing) <$> finishVideo video
      | otherwise -> do
        abandonVideo video
        pure (Just ("frames " ++ frameRanges (sort failed) ++ " are missing"))

-- | Stops the video and removes its unfinished file.
abandonVideoFeed :: VideoFeed -> IO ()
abandonVideoFeed feed = forM_ (feedVideoFile feed) abandonVideo
