module BlackHole.Cli.ProgressSpec (spec) where

import BlackHole.Cli.Progress
import Test.Hspec
import Test.QuickCheck

spec :: Spec
spec = do
  it "tells the pace and the time left of a quarter done" $
    progressText quarter `shouldBe` "25 %, 0.250 Mray/s, 0:10 elapsed, 0:30 left"
  it "knows no pace before the first row" $
    progressText (pictureProgress 100 100000 3 0) `shouldBe` "0 %, 0:03 elapsed"
  it "draws a bar from empty to full" $ do
    let bar fraction = takeWhile (/= ']') (progressBarLine False 20 (Progress fraction "text" []))
    map bar [0, 0.25, 0.5, 1, 2, 0 / 0]
      `shouldBe` map
        ('[' :)
        [ "            ",
          "===         ",
          "======      ",
          "============",
          "============",
          "            "
        ]
  it "colours the bar only if it may" $ do
    progressBarLine False 120 quarter `shouldSatisfy` notElem '\ESC'
    progressBarLine True 120 quarter `shouldSatisfy` elem '\ESC'
  it "keeps within a terminal's columns" . property $
    \(Positive rows) (NonNegative done) (NonNegative seconds) ->
      forAll (choose (60, 200)) $ \columns ->
        length (progressBarLine False columns (pictureProgress rows 1000 seconds (min rows done)))
          <= columns
  it "writes one object on one line" $
    progressJsonLine quarter
      `shouldBe` "{\"fraction\": 0.25, \"rows_done\": 25, \"rows\": 100, \"rays_per_second\": \
                 \250000, \"seconds\": 10, \"seconds_left\": 30}"
  where
    quarter = pictureProgress 100 100000 10 25
