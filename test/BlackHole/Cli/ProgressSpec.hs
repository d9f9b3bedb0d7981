module BlackHole.Cli.ProgressSpec (spec) where

import BlackHole.Cli.Progress
import Data.List (isInfixOf)
import Test.Hspec
import Test.QuickCheck

spec :: Spec
spec = do
  it "tells the pace and the time left of a quarter done" $ do
    raysPerSecond quarter `shouldBe` Just 250000
    secondsLeft quarter `shouldBe` Just 30
    progressTextLine quarter `shouldBe` "25 %, 0.250 Mray/s, 0:10 elapsed, 0:30 left"
  it "knows no pace before the first row" $
    progressTextLine (Progress 100 0 100000 3) `shouldBe` "0 %, 0:03 elapsed"
  it "fills a quarter of the bar" $
    progressBarLine False 120 quarter `shouldSatisfy` isInfixOf ("[" ++ replicate 10 '=' ++ replicate 30 ' ' ++ "]")
  it "colours the bar only if it may" $ do
    progressBarLine False 120 quarter `shouldSatisfy` notElem '\ESC'
    progressBarLine True 120 quarter `shouldSatisfy` elem '\ESC'
  it "keeps within a terminal's columns" . property $ \(Positive rows) (NonNegative done) (NonNegative seconds) ->
    forAll (choose (60, 200)) $ \columns ->
      length (progressBarLine False columns (Progress rows (min rows done) 1000 seconds)) <= columns
  it "writes one object on one line" $ do
    progressJsonLine quarter `shouldSatisfy` notElem '\n'
    mapM_
      (\part -> progressJsonLine quarter `shouldSatisfy` isInfixOf part)
      ["\"fraction\": 0.25,", "\"rows_done\": 25,", "\"rows\": 100,", "\"rays_per_second\": 250000,", "\"seconds_left\": 30}"]
  where
    quarter = Progress 100 25 100000 10
