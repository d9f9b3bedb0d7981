-- | Finished frames on their way into a film file, in the film's order, whatever
-- the order in which they are finished.
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

-- | A film file in the making, or why there is none.
data VideoFeed = VideoFeed
  { feedVideoFile :: !(Either String Video),
    videoFeedName :: !FrameName,
    -- | Frames not sent yet, in the film's order.
    videoFeedLeft :: !(IORef [Int]),
    -- | Finished ones that wait for one before them.
    videoFeedReady :: !(IORef (Set.Set Int)),
    videoFeedFailed :: !(IORef [Int])
  }

-- | @startFeed coder kind rate target name frames@: 'startVideo' for these
-- frames.
startVideoFeed :: FilePath -> VideoCoding -> Double -> FilePath -> FrameName -> [Int] -> IO VideoFeed
startVideoFeed coder kind rate target name frames = do
  started <- startVideo coder kind rate target
  VideoFeed started name <$> newIORef frames <*> newIORef Set.empty <*> newIORef []

-- | Why the film file could not be begun.
videoFeedFault :: VideoFeed -> Maybe String
videoFeedFault = either Just (const Nothing) . feedVideoFile

-- | Tell what became of a frame.
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
          forM_ (feedVideoFile feed) $ \video -> feedVideo video (frameFile (videoFeedName feed) next)
          advance
        _ -> pure ()

-- | Finish the file; if there is none, why.
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

-- | Give the file up.
abandonVideoFeed :: VideoFeed -> IO ()
abandonVideoFeed feed = forM_ (feedVideoFile feed) abandonVideo
