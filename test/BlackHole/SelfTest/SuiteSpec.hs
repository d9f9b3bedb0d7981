module BlackHole.SelfTest.SuiteSpec (spec) where

import BlackHole.SelfTest.Check
import BlackHole.SelfTest.Physics (deflectionReferences)
import BlackHole.SelfTest.Suite
import Data.Foldable (for_)
import Data.List (isPrefixOf, nub)
import Support.Reference
import Test.Hspec

spec :: Spec
spec = beforeAll selfTestChecks $ do
  it "every check holds" $ \checks ->
    for_ checks $ \check -> (check, checkError check) `shouldSatisfy` checkHolds . fst
  it "every check could fail" $ \checks ->
    for_ checks $ \check -> do
      checkHolds check {checkReference = checkReference check + checkLimit check * 2.5 + 1e-9}
        `shouldBe` False
      checkHolds check {checkValue = 0 / 0} `shouldBe` False
  it "no limit is looser than a thirtieth of what is measured" $ \checks ->
    for_ checks $ \check ->
      (check, checkLimit check)
        `shouldSatisfy` (<= max 1e-5 (abs (checkReference check) / 30)) . snd
  it "names are different" $ \checks ->
    nub (map checkName checks) `shouldBe` map checkName checks
  it "covers what it promises" $ \checks ->
    for_
      [ "critical impact parameter",
        "deflection",
        "shadow half-angle",
        "shadow radius at r = 3",
        "shadow radius at r = 6",
        "shadow radius at r = 20",
        "leapfrog: energy",
        "leapfrog: direction",
        "leapfrog: relative change of h",
        "greatest g",
        "least g",
        "radius of the disk's greatest flux",
        "chromaticity",
        "SipHash",
        "one worker or two"
      ]
      $ \beginning -> filter (isPrefixOf beginning . checkName) checks `shouldSatisfy` not . null
  it "has the deflections of the reference table" $ \_ -> do
    rows <- readDeflections
    deflectionReferences
      `shouldBe` [(deflectionImpactParameter row, deflectionValue row) | row <- rows]
