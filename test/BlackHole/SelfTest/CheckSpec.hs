module BlackHole.SelfTest.CheckSpec (spec) where

import BlackHole.SelfTest.Check
import Test.Hspec

spec :: Spec
spec = do
  it "holds up to the limit, on either side" $
    map (\v -> checkHolds (Check "" v 4 0.5)) [3.25, 3.5, 4, 4.5, 4.75]
      `shouldBe` [False, True, True, True, False]
  it "a limit of 0 asks for equality" $
    map (\v -> checkHolds (Check "" v 1 0)) [1, 1 + 1e-15] `shouldBe` [True, False]
  it "what is no number never holds" $
    map
      checkHolds
      [Check "" (0 / 0) 1 1, Check "" 1 (0 / 0) 1, Check "" 1 1 (0 / 0), Check "" (0 / 0) 0 (1 / 0)]
      `shouldBe` replicate 4 False
