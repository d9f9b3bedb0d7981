module BlackHole.Cli.SelfTestSpec (spec) where

import BlackHole.Cli.Options
import BlackHole.Cli.Run
import BlackHole.Cli.SelfTest
import BlackHole.SelfTest.Check
import Test.Hspec

spec :: Spec
spec = do
  it "is a command" $
    map (parseArguments "v1") [["selftest"], ["selftest", "--quiet"]]
      `shouldBe` [Run (SelfTest (SelfTestOptions False)), Run (SelfTest (SelfTestOptions True))]
  it "ends with 0 if every check holds, and with 1 if one does not" $ do
    exitCode (selfTestStatus [right, right]) `shouldBe` exitCode Done
    exitCode (selfTestStatus [right, right {checkValue = 1.1}]) `shouldBe` exitCode InternalFault
  where
    right = Check "right" 1 1 1e-10
