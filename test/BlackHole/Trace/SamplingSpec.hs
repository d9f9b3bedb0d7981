module BlackHole.Trace.SamplingSpec (spec) where

import BlackHole.Scene.Camera (Picture (..))
import BlackHole.Scene.Filter
import BlackHole.Scene.Preset (defaultScene)
import BlackHole.Scene.Scene
import BlackHole.Trace.Pixel (samplePoint)
import BlackHole.Trace.Sampling
import BlackHole.Vector.XY (XY (..))
import Data.List (sort)
import Support.Approx
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck

spec :: Spec
spec = do
  it "a single one is the pixel's middle, whatever the filter" $
    [sampleOf f 0 1 3 4 0 | f <- [minBound ..]] `shouldBe` replicate 3 (Sample (XY 3.5 4.5) 1)
  prop "the first 4^k lie one in each cell of a grid, in their pixel" $
    forAll ((,,,) <$> elements [2, 4, 8] <*> choose (0, 5000) <*> choose (0, 5000) <*> arbitrary) $
      \(side, column, row, seed) ->
        let cells =
              [ (cell column x, cell row y)
                | k <- [0 .. side * side - 1],
                  let Sample (XY x y) _ = sampleOf Box seed 100 column row k
              ]
            cell pixel v = floor ((v - fromIntegral pixel) * fromIntegral side) :: Int
         in sort cells === [(i, j) | i <- [0 .. side - 1], j <- [0 .. side - 1]]
  prop "are numbered from 0: those of a scene, too, lie one in each cell" $
    forAll ((,) <$> choose (0, 63) <*> choose (0, 35)) $ \(column, row) ->
      let scene =
            defaultScene
              { scenePicture = Picture 64 36,
                sceneFilter = Box,
                sceneSamples = 4,
                sceneMostSamples = 64
              }
          cells =
            [ (cell column x, cell row y) | k <- [0 .. 15], let Sample (XY x y) _ =
                                                                  samplePoint scene column row k
            ]
          cell pixel v = floor ((v - fromIntegral pixel) * 4) :: Int
       in sort cells === [(i, j) | i <- [0 .. 3], j <- [0 .. 3]]
  prop "do not depend on how many there will be" $ \seed ->
    forAll ((,) <$> choose (0, 50) <*> elements [minBound ..]) $ \(k, f) ->
      sampleOf f seed 64 7 9 k === sampleOf f seed 4096 7 9 k
  prop "depend on the seed and the pixel" $ \seed ->
    sampleOf Box seed 4 1 1 0 /= sampleOf Box (seed + 1) 4 1 1 0
      .&&. sampleOf Box seed 4 1 1 0 /= sampleOf Box seed 4 2 1 0
  describe "have the moments of their filter" $ do
    -- Mean weight, weighted mean and variance along each axis; in closed form.
    moments Box 0.5 1 (1 / 12)
    -- A Gaussian in the plane cut off at three standard deviations.
    moments Gaussian 1.5 1 (0.25 * (1 - 4.5 * exp (-4.5) / (1 - exp (-4.5))))
    -- Of a cubic of this family the second moment is B/3.
    moments Mitchell 2 mitchellMean (1 / 9)
  where
    moments f radius meanWeight variance =
      it (filterName f) $ do
        let n = 65536
            samples = [sampleOf f 5 n 10 20 k | k <- [0 .. n - 1]]
            weights = sum (map sampleWeight samples)
            mean g = sum [w * g p | Sample p w <- samples] / weights
        map (\(Sample (XY x y) _) -> max (abs (x - 10.5)) (abs (y - 20.5)) <= radius) samples
          `shouldSatisfy` and
        (weights / fromIntegral n) `shouldBeWithin` (2e-3, meanWeight)
        mean (\(XY x _) -> x - 10.5) `shouldBeWithin` (1e-3, 0)
        mean (\(XY _ y) -> y - 20.5) `shouldBeWithin` (1e-3, 0)
        mean (\(XY x _) -> (x - 10.5) ^ (2 :: Int)) `shouldBeWithin` (2e-3, variance)
        mean (\(XY _ y) -> (y - 20.5) ^ (2 :: Int)) `shouldBeWithin` (2e-3, variance)
    -- (∫f / ∫|f|)² in one dimension each.
    mitchellMean = 1 / (1 + 2 * negative) ^ (2 :: Int)
    negative =
      2 * sum [max 0 (negate (cubic (1 + (k + 0.5) / 10000))) / 10000 | k <- [0 .. 9999]] :: Double
    cubic d = (-7 / 3 * d * d * d + 12 * d * d - 20 * d + 32 / 3) / 6
