-- | Finished frames on their way into a film file, in the film's order, whatever
-- the order in which they are finished.
module BlackHole.Animation.Feed
  ( Feed,
    startFeed,
    feedFault,
    feedFrame,
    finishFeed,
    abandonFeed,
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
data Feed = Feed
  { feedVideoFile :: !(Either String Video),
    feedName :: !FrameName,
    -- | Frames not sent yet, in the film's order.
    feedLeft :: !(IORef [Int]),
    -- | Finished ones that wait for one before them.
    feedReady :: !(IORef (Set.Set Int)),
    feedFailed :: !(IORef [Int])
  }

-- | @startFeed coder kind rate target name frames@: 'startVideo' for these
-- frames.
startFeed :: FilePath -> VideoCoding -> Double -> FilePath -> FrameName -> [Int] -> IO Feed
startFeed coder kind rate target name frames = do
  started <- startVideo coder kind rate target
  Feed started name <$> newIORef frames <*> newIORef Set.empty <*> newIORef []

-- | Why the film file could not be begun.
feedFault :: Feed -> Maybe String
feedFault = either Just (const Nothing) . feedVideoFile

-- | Tell what became of a frame.
feedFrame :: Feed -> Int -> Outcome -> IO ()
feedFrame feed frame outcome = do
  case outcome of
    WasDone -> ready
    Rendered _ -> ready
    _ -> modifyIORef' (feedFailed feed) (frame :)
  advance
  where
    ready = modifyIORef' (feedReady feed) (Set.insert frame)
    advance = do
      left <- readIORef (feedLeft feed)
      waiting <- readIORef (feedReady feed)
      case left of
        next : later | next `Set.member` waiting -> do
          writeIORef (feedLeft feed) later
          writeIORef (feedReady feed) (Set.delete next waiting)
          forM_ (feedVideoFile feed) $ \video -> feedVideo video (frameFile (feedName feed) next)
          advance
        _ -> pure ()

-- | Finish the file; if there is none, why.
finishFeed :: Feed -> IO (Maybe String)
finishFeed feed = do
  failed <- readIORef (feedFailed feed)
  case feedVideoFile feed of
    Left reason -> pure (Just reason)
    Right video
      | null failed -> either Just (const Nothing) <$> finishVideo video
      | otherwise -> do
        abandonVideo video
        pure (Just ("frames " ++ frameRanges (sort failed) ++ " are missing"))

-- | Give the file up.
abandonFeed :: Feed -> IO ()
abandonFeed feed = forM_ (feedVideoFile feed) abandonVideo
