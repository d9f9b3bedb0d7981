module BlackHole.Light.DitherSpec (spec) where

import BlackHole.Light.Display (ditheredCode)
import BlackHole.Light.Dither
import Data.List (group, sort)
import Support.Approx
import Support.Generators
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck

spec :: Spec
spec = do
  it "has each of 64 thresholds equally often, and repeats" $ do
    map length (group (sort (tile 0))) `shouldBe` replicate 64 64
    [ditherThreshold 0 (x + 64) (y + 128) | y <- side, x <- side] `shouldBe` tile 0
  prop "keeps the mean of any shade over a tile" $
    forAll (inRange 0 1) $ \s ->
      conjoin
        [ closeTo (1 / 128 + 1e-9) (255 * s) (mean [fromIntegral (ditheredCode t s) | t <- tile channel])
          | channel <- [0, 1, 2]
        ]
  it "keeps it over small areas too, ten times better than white noise" $
    -- The variance of the mean over 8 by 8 pixels; independent thresholds have
    -- 1/12 of a step squared each.
    mean [(mean block - 0.5) ^ (2 :: Int) | block <- blocks] `shouldSatisfy` (< 1 / 12 / 64 / 10)
  it "has nothing in common between the channels" $
    mean (zipWith (\a b -> (a - 0.5) * (b - 0.5) * 12) (tile 0) (tile 1)) `shouldBeWithin` (0.05, 0)
  where
    side = [0 .. ditherTileSide - 1]
    tile channel = [ditherThreshold channel x y | y <- side, x <- side]
    blocks =
      [ [ditherThreshold 0 (8 * bx + x) (8 * by + y) | y <- [0 .. 7], x <- [0 .. 7]]
        | by <- [0 .. 7],
          bx <- [0 .. 7 :: Int]
      ]
    mean :: [Double] -> Double
    mean values = sum values / fromIntegral (length values)
