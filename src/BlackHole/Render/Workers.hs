-- | The number of threads that share a rendering.
module BlackHole.Render.Workers
  ( Workers,
    workersFromCount,
    workersCount,
    maximumWorkers,
    oneWorker,
    defaultWorkers,
    withWorkers,
    onWorkers,
  )
where

import Control.Concurrent
  ( forkOn,
    getNumCapabilities,
    killThread,
    rtsSupportsBoundThreads,
    setNumCapabilities,
  )
import Control.Concurrent.Chan (newChan, readChan, writeChan)
import Control.Concurrent.MVar (newEmptyMVar, putMVar, takeMVar)
import Control.Exception
  ( SomeException,
    bracket,
    finally,
    mask,
    onException,
    throwIO,
    try,
    uninterruptibleMask_,
  )
import Control.Monad (forM, replicateM_, when)
import GHC.Conc (getNumProcessors)

-- | A number of worker threads, from 1 to 'maximumWorkers'.
newtype Workers = Workers Int
  deriving (Eq, Ord, Show)

-- | The number as 'Workers'; 'Nothing' outside 1 to 'maximumWorkers'.
workersFromCount :: Int -> Maybe Workers
workersFromCount n
  | n >= 1 && n <= maximumWorkers = Just (Workers n)
  | otherwise = Nothing

-- | The number of threads, 1 to 'maximumWorkers'.
workersCount :: Workers -> Int
workersCount (Workers n) = n

-- | 256, because GHC's run-time system supports no more processors from version 9.8 on.
maximumWorkers :: Int
maximumWorkers = 256

-- | A single worker.
oneWorker :: Workers
oneWorker = Workers 1

-- | One worker for each processor that this process may use.
defaultWorkers :: IO Workers
defaultWorkers = Workers . max 1 . min maximumWorkers <$> getNumProcessors

-- | Runs an action with as many processors in use as the workers can fill, and restores
-- the former number afterwards, even after an exception.
--
-- The number never exceeds that of the machine: the collector's threads wait for each
-- other in a spin lock, so surplus ones slow everything down, whereas surplus workers
-- merely take turns. Does nothing in a program linked without @-threaded@. The number
-- belongs to the whole process, so concurrent uses overwrite each other, which affects
-- only speed.
withWorkers :: Workers -> IO a -> IO a
withWorkers (Workers wanted) action
  | rtsSupportsBoundThreads = do
    processors <- getNumProcessors
    bracket
      (getNumCapabilities <* switchTo (max 1 (min wanted processors)))
      switchTo
      (const action)
  | otherwise = action
  where
    switchTo n = do
      current <- getNumCapabilities
      when (current /= n) $ setNumCapabilities n

-- | @onWorkers workers most act@ runs an action concurrently on each of the workers,
-- but on at most @most@ of them, until all are done. An exception in one of them, or
-- thrown to the caller, stops the others and is rethrown.
--
-- Each worker starts on a processor of its own. Left to the run-time system, the second
-- one waits on the first one's processor until that has time to hand it over, which can
-- take ten milliseconds.
--
-- The workers report through a channel. Waiting for them with STM would have the caller
-- spin while a worker that the system has stopped holds a transactional variable.
onWorkers :: Workers -> Int -> IO () -> IO ()
onWorkers (Workers wanted) most act = mask $ \restore -> do
  outcomes <- newChan
  workers <- forM [0 .. count - 1] $ \processor -> do
    ended <- newEmptyMVar
    thread <-
      forkOn processor $
        (try (restore act) >>= writeChan outcomes) `finally` putMVar ended ()
    pure (thread, ended)
  let next = readChan outcomes >>= either (throwIO :: SomeException -> IO ()) pure
      stop = uninterruptibleMask_ $ do
        mapM_ (killThread . fst) workers
        mapM_ (takeMVar . snd) workers
  restore (replicateM_ count next) `onException` stop
  where
    count = min wanted most
