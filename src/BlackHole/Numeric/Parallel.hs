-- | Values that processors with nothing else to do may work out.
module BlackHole.Numeric.Parallel (inParallel) where

import GHC.Conc (par, pseq)

-- | The same list. When it is asked for, all of its members begin to be evaluated,
-- to their outermost constructors, by whatever processors are idle.
inParallel :: [a] -> [a]
inParallel xs = foldr par () xs `pseq` xs
