-- | Independent pieces of work, distributed over the workers.
module BlackHole.Render.Shared (mapShared) where

import BlackHole.Render.Workers (Workers, onWorkers)
import Control.Exception (evaluate)
import Control.Monad (when)
import Data.IORef (atomicModifyIORef', newIORef)
import qualified Data.Vector as Boxed
import qualified Data.Vector.Mutable as Mutable

-- | @mapShared workers work pieces@ returns the results of @work@, evaluated to weak
-- head normal form, in the order of the pieces for any number of workers. Each worker
-- takes the next piece as soon as it is free. An exception stops all of them and is
-- rethrown.
mapShared :: Workers -> (a -> IO b) -> [a] -> IO [b]
mapShared workers work pieces = do
  results <- Mutable.new count
  next <- newIORef 0
  let worker = do
        i <- atomicModifyIORef' next (\n -> (n + 1, n))
        when (i < count) $ do
          result <- work (Boxed.unsafeIndex queue i) >>= evaluate
          Mutable.unsafeWrite results i result
          worker
  onWorkers workers count worker
  Boxed.toList <$> Boxed.unsafeFreeze results
  where
    queue = Boxed.fromList pieces
    count = Boxed.length queue
