module BlackHole.Render.WorkersSpec (spec) where

import BlackHole.Render.Workers
import Control.Concurrent (getNumCapabilities)
import Control.Exception (ArithException (Overflow), throwIO)
import Data.Foldable (for_)
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
