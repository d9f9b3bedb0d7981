module BlackHole.Light.GrainSpec (spec) where

import BlackHole.Light.Display
import BlackHole.Light.Dither
import BlackHole.Light.Grain
import BlackHole.Light.Radiance
import Control.Monad (forM_)
import Support.Approx
import Test.Hspec

spec :: Spec
spec = do
  it "covers as much of the area as the picture is bright" $
    forM_
      [ (diameter, brightness) | diameter <- [1.5, 3, 6.2], brightness <-
                                                              [0.02, 0.1, 0.3, 0.5, 0.8, 0.95]
      ]
      $ \(diameter, brightness) ->
        meanOf [grainCover (Grain diameter 7) x y brightness | x <- [-100 .. 99], y <- [300 .. 499]]
          `shouldBeWithin` (0.03, brightness)
  it "covers nothing of black, and the more the brighter" $
    forM_ places $ \(x, y) -> do
      grainCover grain x y 0 `shouldBe` 0
      let covers = map (grainCover grain x y) [0, 0.05 .. 1]
      zip covers (drop 1 covers) `shouldSatisfy` all (uncurry (<=))
  it "makes dots: most pixels of a grey area are black or white" $
    let isGrey c = c > 0.05 && c < 0.95
        covers = [grainCover (Grain 8 3) x y 0.4 | (x, y) <- places]
     in meanOf [if isGrey c then 1 else 0 | c <- covers] `shouldSatisfy` (< 0.3)
  it "differs between seeds" $
    map (\(x, y) -> grainCover grain x y 0.4) places
      `shouldNotBe` map (\(x, y) -> grainCover grain {grainSeed = 8} x y 0.4) places
  it "keeps a picture's hue, and black" $ do
    let codes = [displayCode prepared x y (Radiance 0.4 0.2 0) | (x, y) <- places]
    forM_
      codes
      ( `shouldSatisfy`
          \(r, g, b) -> b == 0 && (r < 60 || fromIntegral g / fromIntegral r < (0.8 :: Double))
      )
    displayCode prepared 3 4 black `shouldBe` (0, 0, 0)
  where
    grain = Grain 3 7
    prepared = developer (Development (Exposure 0) ToneNone grain NoDither)
    places = [(x, y) | x <- [0 .. 39], y <- [0 .. 39]] :: [(Int, Int)]
    meanOf values = sum values / fromIntegral (length values) :: Double
