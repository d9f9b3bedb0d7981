-- | How many threads share a rendering.
module BlackHole.Render.Workers
  ( Workers,
    workers,
    workersCount,
    maximumWorkers,
    oneWorker,
    defaultWorkers,
    withWorkers,
  )
where

import Control.Concurrent (getNumCapabilities, rtsSupportsBoundThreads, setNumCapabilities)
import Control.Exception (bracket)
import Control.Monad (when)
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
