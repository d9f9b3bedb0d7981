-- | How many threads share a rendering.
module BlackHole.Render.Workers
  ( Workers,
    workers,
    workersCount,
    maximumWorkers,
    oneWorker,
    defaultWorkers,
    withWorkers,
    onWorkers,
  )
where

import Control.Concurrent (getNumCapabilities, rtsSupportsBoundThreads, setNumCapabilities)
import Control.Concurrent.Async (Async, asyncOn, uninterruptibleCancel, waitAny)
import Control.Exception (bracket, mask, onException)
import Control.Monad (when)
import Data.List (delete)
import GHC.Conc (getNumProcessors)

-- | A number of worker threads, from 1 to 'maximumWorkers'.
newtype Workers = Workers Int
  deriving (Eq, Ord, Show)

-- | The number as 'Workers', or 'Nothing' outside 1 … 'maximumWorkers'.
workers :: Int -> Maybe Workers
workers n
  | n >= 1 && n <= maximumWorkers = Just (Workers n)
  | otherwise = Nothing

-- | How many threads these are, 1 … 'maximumWorkers'.
workersCount :: Workers -> Int
workersCount (Workers n) = n

-- | 256: GHC's run-time system from 9.8 on is built for no more processors.
maximumWorkers :: Int
maximumWorkers = 256

-- | A single worker.
oneWorker :: Workers
oneWorker = Workers 1

-- | One worker for each processor this process may run on.
defaultWorkers :: IO Workers
defaultWorkers = Workers . max 1 . min maximumWorkers <$> getNumProcessors

-- | Run an action with as many processors in use as the workers can fill, and
-- put the former number back afterwards, also after an exception.
--
-- Never more than the machine has: the collector's threads wait for each other
-- in a spin, so that surplus ones slow everything down, while surplus workers
-- merely take turns. Does nothing in a program linked without @-threaded@.
-- The number belongs to the whole process, so uses in several threads at once
-- overwrite each other (which costs speed alone).
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

-- | @onWorkers workers most act@: run an action at the same time on each of the
-- workers, but at most on so many, until all are done. An exception in one of them,
-- or to the caller, stops the others and is rethrown.
--
-- Each begins on a processor of its own. Left to the run-time system, the second
-- waits on the first one's processor until that has time to give it away, which
-- can take ten milliseconds.
onWorkers :: Workers -> Int -> IO () -> IO ()
onWorkers (Workers wanted) most act = mask $ \restore -> do
  running <- mapM (`asyncOn` restore act) [0 .. min wanted most - 1]
  restore (waitAll running) `onException` mapM_ uninterruptibleCancel running
  where
    waitAll :: [Async ()] -> IO ()
    waitAll [] = pure ()
    waitAll running = do
      (done, ()) <- waitAny running
      waitAll (delete done running)
