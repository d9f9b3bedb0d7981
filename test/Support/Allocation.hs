-- | Measuring what a computation allocates.
module Support.Allocation
  ( allocatedBytes,
    whenOptimised,
  )
where

import Control.Exception (evaluate)
import Data.Int (Int64)
import System.Mem (getAllocationCounter, setAllocationCounter)
import Test.Hspec (Expectation, pendingWith)

-- | Bytes allocated by this thread while a value is brought to weak head
-- normal form.
allocatedBytes :: a -> IO Int64
allocatedBytes a = do
  setAllocationCounter maxBound
  before <- getAllocationCounter
  _ <- evaluate a
  after <- getAllocationCounter
  pure (before - after)

-- | Run an expectation about allocation, which only an optimised build can
-- meet.
whenOptimised :: Expectation -> Expectation
whenOptimised expectation
  | optimised = expectation
  | otherwise = pendingWith "this build is not optimised"

-- | Rewrite rules fire only where the optimiser runs.
optimised :: Bool
optimised = False
{-# NOINLINE optimised #-}

{-# RULES "optimised" optimised = True #-}
