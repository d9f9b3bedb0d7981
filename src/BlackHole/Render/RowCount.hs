-- | Counting finished rows from many threads, and telling one listener.
module BlackHole.Render.RowCount (withRowCount) where

import Control.Concurrent.Async (concurrently)
import Control.Concurrent.MVar (newEmptyMVar, takeMVar, tryPutMVar)
import Control.Monad (void)
import Data.IORef (atomicModifyIORef', newIORef, readIORef)

-- | @withRowCount total report work@ runs @work rowFinished@, where
-- @rowFinished@ may be called from any thread and never waits for @report@.
--
-- @report@ is called by a single thread with strictly growing counts; while it
-- is busy, counts are skipped rather than queued. When the work ends normally,
-- having called @rowFinished@ @total@ times, the last count reported is
-- @total@. An exception of either side stops the other and is rethrown. No
-- thread is left behind in any case.
withRowCount :: Int -> (Int -> IO ()) -> (IO () -> IO a) -> IO a
withRowCount total report work = do
  finished <- newIORef 0
  news <- newEmptyMVar
  let rowFinished = do
        atomicModifyIORef' finished $ \n -> (n + 1, ())
        void $ tryPutMVar news ()
      listen reported
        | reported >= total = pure ()
        | otherwise = do
          takeMVar news
          count <- readIORef finished
          if count > reported then report count >> listen count else listen reported
  fst <$> concurrently (work rowFinished) (listen 0)
