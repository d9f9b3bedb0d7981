-- | Giving memory back.
module BlackHole.Render.Release (release) where

import Control.Monad (when)
import System.Mem (performMajorGC)

-- | Collects garbage after so many bytes in large objects have become free. These are few,
-- so the collector by itself would not notice them in time. Up to 1 MiB is not worth the
-- milliseconds that a collection takes.
release :: Int -> IO ()
release bytes = when (bytes > 1048576) performMajorGC
