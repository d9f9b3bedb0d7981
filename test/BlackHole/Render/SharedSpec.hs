module BlackHole.Render.SharedSpec (spec) where

import BlackHole.Render.Shared
import BlackHole.Render.Workers
import Control.Exception (ErrorCall (..), throwIO)
import Control.Monad (when)
import Data.Maybe (mapMaybe)
import Test.Hspec

spec :: Spec
spec = do
  it "keeps the order of the pieces for any number of workers" $
    mapM_
      (\workers -> mapShared workers (pure . (* 2)) [1 .. 100 :: Int] `shouldReturn` [2, 4 .. 200])
      (mapMaybe workersFromCount [1, 2, 7])
  it "has nothing to do for no pieces" $
    mapShared oneWorker pure ([] :: [Int]) `shouldReturn` []
  it "rethrows what a piece throws" $
    mapM_
      ( \workers ->
          mapShared workers (\n -> when (n == 50) (throwIO (ErrorCall "fifty"))) [1 .. 100 :: Int]
            `shouldThrow` (== ErrorCall "fifty")
      )
      (mapMaybe workersFromCount [1, 3])
