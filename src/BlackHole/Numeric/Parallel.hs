-- | Values that processors with nothing else to do may work out.
module BlackHole.Numeric.Parallel (inParallel) where

import GHC.Conc (par, pseq)

-- | The same list. When it is asked for, all of its members begin to be evaluated,
-- to their outermost constructors, by whatever processors are idle: from the end on,
-- while who asked goes through them from the beginning, lest both work on one.
inParallel :: [a] -> [a]
inParallel xs = foldr par () (reverse xs) `pseq` xs
