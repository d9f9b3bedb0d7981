module BlackHole.Render.WorkersSpec (spec) where

import BlackHole.Render.Workers
import Control.Concurrent (getNumCapabilities, threadDelay)
import Control.Concurrent.Async (async, cancel)
import Control.Concurrent.MVar (newEmptyMVar, putMVar, takeMVar)
import Control.Exception (ArithException (Overflow), finally, throwIO)
import Control.Monad (forever)
import Data.Foldable (for_)
import Data.IORef
import Data.Maybe (mapMaybe)
import GHC.Conc (getNumProcessors)
import Test.Hspec
import Test.Hspec.QuickCheck (prop)

spec :: Spec
spec = do
  prop "are as many as asked for, from 1 to the maximum" $ \n ->
    fmap workersCount (workersFromCount n)
      `shouldBe` if n >= 1 && n <= maximumWorkers then Just n else Nothing

  it "reach the maximum and no further" $ do
    fmap workersCount (workersFromCount maximumWorkers) `shouldBe` Just maximumWorkers
    workersFromCount (maximumWorkers + 1) `shouldBe` Nothing
    workersCount oneWorker `shouldBe` 1

  it "are one for each processor by default" $ do
    processors <- getNumProcessors
    workers <- defaultWorkers
    workersCount workers `shouldBe` min maximumWorkers processors

  it "use as many processors as there are workers or processors" $ do
    processors <- getNumProcessors
    earlier <- getNumCapabilities
    for_ [1, 2, maximumWorkers] $ \n ->
      for_ (workersFromCount n) $ \workers ->
        withWorkers workers getNumCapabilities `shouldReturn` min n processors
    getNumCapabilities `shouldReturn` earlier

  it "give the processors back after an exception" $ do
    earlier <- getNumCapabilities
    workers <- defaultWorkers
    for_ [oneWorker, workers] $ \some ->
      withWorkers some (throwIO Overflow) `shouldThrow` (== Overflow)
    getNumCapabilities `shouldReturn` earlier

  it "run an action once each, but no more often than asked for" $
    for_ [(n, most) | n <- mapMaybe workersFromCount [1, 2, 7], most <- [0, 1, 3, 9]] $
      \(workers, most) -> do
        calls <- newIORef (0 :: Int)
        onWorkers workers most (atomicModifyIORef' calls (\k -> (k + 1, ())))
        readIORef calls `shouldReturn` min (workersCount workers) most

  it "all stop when one fails, or when the caller is stopped" $
    for_ (mapMaybe workersFromCount [1, 3]) $ \workers -> do
      started <- newIORef (0 :: Int)
      ended <- newIORef (0 :: Int)
      all' <- newEmptyMVar
      let count = workersCount workers
          act whenLast = do
            k <- atomicModifyIORef' started (\k -> (k + 1, k + 1))
            (if k `mod` count == 0 then whenLast >> idle else idle)
              `finally` atomicModifyIORef' ended (\n -> (n + 1, ()))
          idle = forever (threadDelay 1000000)
      onWorkers workers count (act (throwIO Overflow)) `shouldThrow` (== Overflow)
      readIORef ended `shouldReturn` count
      caller <- async (onWorkers workers count (act (putMVar all' ())))
      takeMVar all'
      cancel caller
      readIORef ended `shouldReturn` 2 * count
