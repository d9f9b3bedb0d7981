module BlackHole.Numeric.ExponentialSpec (spec) where

import BlackHole.Numeric.Exponential
import Support.Approx
import Support.Generators
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess, prop)
import Test.QuickCheck

spec :: Spec
spec = modifyMaxSuccess (const 2000) $ do
  describe "exponential" $ do
    -- The documented bound is 1.3e-12. What is left out of the series is at most
    -- 1.253e-12, at the ends of the intervals of length ln 2 / 32; rounding adds a
    -- few 1e-16.
    it "has a relative error below 1.26e-12 at both ends of each of its intervals" $
      maximum
        [ relativeError x
          | k <- [-27699 .. 27698 :: Int],
            side <- [-1e-9, 1e-9],
            let x = (fromIntegral k + 0.5) * log 2 / 32 + side
        ]
        `shouldSatisfy` (< 1.26e-12)
    prop "has a relative error below 1.26e-12 everywhere" $
      forAll (oneof [inRange (-600) 600, inRange (-2) 2, inRange (-1e-3) 1e-3]) $ \x ->
        closeTo 1.26e-12 1 (exponential x / exp x)
    it "ends at ±600" $ do
      map exponential [601, 1e9, 1 / 0] `shouldBe` replicate 3 (exponential 600)
      map exponential [-601, -1e9, -1 / 0] `shouldBe` replicate 3 (exponential (-600))
  describe "sineOfTurns" $ do
    prop "is the sine to 1e-9" $
      forAll (inRange (-3) 3) $ \t -> closeTo 1e-9 (sin (2 * pi * t)) (sineOfTurns t)
    prop "repeats with every turn" $
      forAll ((,) <$> inRange (-0.5) 0.5 <*> choose (-1000000, 1000000 :: Int)) $ \(t, n) ->
        closeTo 2e-9 (sineOfTurns t) (sineOfTurns (t + fromIntegral n))
    it "has its quarters" $
      zipWith
        (\t s -> abs (sineOfTurns t - s) < 1e-9)
        [0, 0.25, 0.5, 0.75, 1, -0.25]
        [0, 1, 0, -1, 0, -1]
        `shouldBe` replicate 6 True
  where
    relativeError x = abs (exponential x / exp x - 1)
