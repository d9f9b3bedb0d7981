module BlackHole.SelfTest.TableSpec (spec) where

import BlackHole.SelfTest.Check
import BlackHole.SelfTest.Table
import Data.List (isInfixOf, isSuffixOf)
import Test.Hspec

spec :: Spec
spec = do
  it "lines up its columns and ends each line with the verdict" $
    tableLines Plain [right, wrong]
      `shouldBe` [ "check                     value     reference   error    limit",
                   "right              1.0000000000  1.0000000000       0  1.0e-10  pass",
                   "wrong by a tenth   1.1000000000  1.0000000000  1.0e-1  1.0e-10  FAIL"
                 ]
  it "colours the verdict alone, and only when asked" $ do
    let painted = unlines (tableLines Painted [right, wrong])
    painted `shouldSatisfy` isInfixOf "\ESC[32mpass\ESC[0m\n"
    painted `shouldSatisfy` isInfixOf "\ESC[1;31mFAIL\ESC[0m\n"
    unlines (tableLines Plain [right, wrong]) `shouldSatisfy` notElem '\ESC'
  it "shows what is no number as a failure" $
    drop 1 (tableLines Plain [right {checkValue = 0 / 0}]) `shouldSatisfy` all (isSuffixOf "FAIL")
  it "counts" $ do
    summaryLine [right, wrong, right] `shouldBe` "2 passed, 1 failed"
    summaryLine [] `shouldBe` "0 passed, 0 failed"
    failureCount [wrong, right, wrong] `shouldBe` 2
  where
    right = Check "right" 1 1 1e-10
    wrong = Check "wrong by a tenth" 1.1 1 1e-10
