module BlackHole.Animation.ProgressSpec (spec) where

import BlackHole.Animation.Progress
import Test.Hspec

spec :: Spec
spec = do
  it "says how far an animation is, how fast and how long still" $
    progressLine (Just 21) (Tally 48 12 9 1 0 0.5 19)
      `shouldBe` "21 of 48 frames, frame 21 50 %, 0.50 frames/s, 0:51 left, 1 failed"
  it "has no pace before there is anything to go by" $ do
    progressLine Nothing (startTally 48) `shouldBe` "0 of 48 frames"
    secondsLeft (startTally 48) `shouldBe` Nothing
  it "counts neither frames that were there nor those of others as its own pace" $ do
    framesPerSecond (Tally 48 40 2 0 3 0 4) `shouldBe` Just 0.5
    secondsLeft (Tally 48 40 2 0 3 0 4) `shouldBe` Just 6
  it "writes times" $
    map durationText [0, 59.4, 61, 3661, 1 / 0, -1]
      `shouldBe` ["0:00", "0:59", "1:01", "1:01:01", "277777:46:40", "0:00"]
  it "puts neighbouring frames together" $
    map frameRanges [[], [3], [0, 1, 2, 5, 7, 8]] `shouldBe` ["none", "3", "0-2, 5, 7-8"]
