module BlackHole.Trace.EstimateSpec (spec) where

import BlackHole.Light.Radiance
import BlackHole.Trace.Estimate
import Support.Approx
import Support.Generators
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck

spec :: Spec
spec = do
  it "of no samples is black and certain" $ do
    estimatedRadiance noSamples `shouldBe` black
    estimatedError noSamples `shouldBe` 0
  prop "of equal weights is the mean" $
    forAll (listOf1 (inRange 0 10)) $ \vs ->
      let Radiance r _ _ = estimatedRadiance (of' [(1, v) | v <- vs])
       in closeTo 1e-12 (sum vs / fromIntegral (length vs)) r
  prop "of one radiance is that radiance, whatever the weights" $
    forAll ((,) <$> inRange 0 10 <*> listOf1 (elements [1, -1])) $ \(v, ws) ->
      let Radiance r _ _ = estimatedRadiance (of' [(w, v) | w <- ws]) in closeTo 1e-12 v r
  prop "the error is the standard error of what is seen" $
    forAll (vectorOf 8 (inRange 0 4)) $ \vs ->
      let seen = map sqrt vs
          mean = sum seen / 8
          variance = sum [(s - mean) ^ (2 :: Int) | s <- seen] / 7
       in abs (estimatedError (of' [(1, v) | v <- vs]) - sqrt (variance / 8)) < 1e-7
  it "the error of one radiance is none" $
    estimatedError (of' (replicate 5 (1, 0.37))) `shouldBeWithin` (1e-7, 0)
  where
    of' = foldr (\(w, v) -> addSample 1 w (grey v)) noSamples
