-- | Counts finished rows from many threads and reports them to one listener.
module BlackHole.Render.RowCount (withRowCount) where

import Control.Concurrent.Async (concurrently)
import Control.Concurrent.MVar (newEmptyMVar, takeMVar, tryPutMVar)
import Control.Monad (void)
import Data.IORef (atomicModifyIORef', newIORef, readIORef)

-- | @withRowCount total report work@ runs @work rowFinished@, where @rowFinished@ may
-- be called from any thread and never waits for @report@.
--
-- A single thread calls @report@ with strictly increasing counts. While it is busy,
-- counts are skipped rather than queued. If the work ends normally after calling
-- @rowFinished@ @total@ times, the last reported count is @total@. An exception on
-- either side stops the other and is rethrown. No thread outlives the call.
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
