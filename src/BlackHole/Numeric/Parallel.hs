-- | Values that idle processors may evaluate ahead of time.
module BlackHole.Numeric.Parallel (inParallel) where

import GHC.Conc (par, pseq)

-- | Returns the list unchanged. When the caller first demands it, idle processors start
-- to evaluate its elements to weak head normal form, beginning at the end of the list.
-- The caller meanwhile proceeds from the beginning, so the two rarely work on one
-- element.
inParallel :: [a] -> [a]
inParallel xs = foldr par () (reverse xs) `pseq` xs
