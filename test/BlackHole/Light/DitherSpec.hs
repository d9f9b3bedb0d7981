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
        [ closeTo
            (1 / 128 + 1e-9)
            (255 * s)
            (mean [fromIntegral (ditheredCode t s) | t <- tile channel])
          | channel <- [0, 1, 2]
        ]
  it "has less than a hundredth of white noise's power in coarse patterns" $
    -- Independent thresholds have 1/12 at every frequency.
    mean
      [ power kx ky * 12
        | kx <- [-3 .. 3],
          ky <- [0 .. 3],
          (ky, kx) > (0, 0)
      ]
      `shouldSatisfy` (< 0.01)
  it "has nothing in common between the channels" $
    mean (zipWith (\a b -> (a - 0.5) * (b - 0.5) * 12) (tile 0) (tile 1)) `shouldBeWithin` (0.05, 0)
  where
    side = [0 .. ditherTileSide - 1]
    tile channel = [ditherThreshold channel x y | y <- side, x <- side]
    power :: Double -> Double -> Double
    power kx ky =
      let waves =
            [ (t - 0.5, 2 * pi * (kx * fromIntegral x + ky * fromIntegral y) / 64)
              | (t, (y, x)) <- zip (tile 0) [(y, x) | y <- side, x <- side]
            ]
          along f = sum [t * f angle | (t, angle) <- waves] ** 2
       in (along cos + along sin) / 4096
    mean :: [Double] -> Double
    mean values = sum values / fromIntegral (length values)
