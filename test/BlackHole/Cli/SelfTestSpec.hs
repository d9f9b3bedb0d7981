module BlackHole.Cli.SelfTestSpec (spec) where

import BlackHole.Cli.ExitStatus
import BlackHole.Cli.Options
import BlackHole.Cli.SelfTest
import BlackHole.SelfTest.Check
import Data.List (isInfixOf, isSuffixOf)
import Test.Hspec

spec :: Spec
spec = do
  it "is a command" $
    map (parseArguments "v1") [["selftest"], ["selftest", "--quiet"]]
      `shouldBe` [Run (SelfTest (SelfTestOptions False)), Run (SelfTest (SelfTestOptions True))]
  it "ends with 0 if every check holds, and with 1 if one does not" $ do
    exitCode (selfTestStatus [right, right]) `shouldBe` exitCode Done
    exitCode (selfTestStatus [right, right {checkValue = 1.1}]) `shouldBe` exitCode InternalFault
  it "lines up its columns and ends each line with the verdict" $
    checkTable False [right, wrong]
      `shouldBe` [ "check                    value     reference   error    limit",
                   "right             1.0000000000  1.0000000000       0  1.0e-10  pass",
                   "wrong by a tenth  1.1000000000  1.0000000000  1.0e-1  1.0e-10  FAIL"
                 ]
  it "colours the verdict alone, and only when asked" $ do
    let painted = unlines (checkTable True [right, wrong])
    painted `shouldSatisfy` isInfixOf "\ESC[32mpass\ESC[0m\n"
    painted `shouldSatisfy` isInfixOf "\ESC[1;31mFAIL\ESC[0m\n"
    unlines (checkTable False [right, wrong]) `shouldSatisfy` notElem '\ESC'
  it "shows what is no number as a failure" $
    drop 1 (checkTable False [right {checkValue = 0 / 0}]) `shouldSatisfy` all (isSuffixOf "FAIL")
  it "counts" $ do
    summaryLine [right, wrong, right] `shouldBe` "2 passed, 1 failed"
    summaryLine [] `shouldBe` "0 passed, 0 failed"
  where
    right = Check "right" 1 1 1e-10
    wrong = Check "wrong by a tenth" 1.1 1 1e-10
