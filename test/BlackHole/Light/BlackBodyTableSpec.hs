module BlackHole.Light.BlackBodyTableSpec (spec) where

import BlackHole.Light.BlackBody
import BlackHole.Light.BlackBodyTable
import BlackHole.Light.Radiance
import Support.Light
import Test.Hspec

spec :: Spec
spec = do
  describe "tabulatedColour" $ do
    it "is within 1e-4 of the exact colour from 1 K to 1e25 K" $
      maximum (map colourError temperatures) `shouldSatisfy` (< 1e-4)
    it "has luminance 1 and no negative amount at any argument" $
      mapM_
        ( \temperature -> do
            let colour@(Radiance r g b) = tabulatedColour temperature
            (temperature, luminance colour)
              `shouldSatisfy` ((< 1e-12) . abs . subtract 1 . snd)
            (temperature, minimum [r, g, b]) `shouldSatisfy` ((>= 0) . snd)
        )
        ([0, -5, 0 / 0, 1 / 0] ++ temperatures)
    it "is as monotone as the exact one" $ do
      let colours = map tabulatedColour (filter (> 1000) temperatures)
      filter
        (\(Radiance r _ b, Radiance r' _ b') -> r' > r || b' < b)
        (zip colours (drop 1 colours))
        `shouldBe` []

  describe "tabulatedLuminance" $ do
    it "is within 1e-4 of the exact luminance, relatively" $
      maximum (map luminanceError (filter (>= coldestTabulated) temperatures))
        `shouldSatisfy` (< 1e-4)
    it "rises with the temperature" $ do
      let values = map tabulatedLuminance (filter (>= coldestTabulated) temperatures)
      filter (uncurry (>=)) (zip values (drop 1 values)) `shouldBe` []
    it "is dark below its range" $
      map tabulatedLuminance [99, 0, -1, 0 / 0] `shouldBe` [0, 0, 0, 0]

  describe "blackBodyRadiance" $ do
    it "has luminance 1 at the reference" $
      map
        (\brightness -> luminance (blackBodyRadiance brightness 4500 4500))
        [minBound .. maxBound]
        `shouldSatisfy` all ((< 1e-12) . abs . subtract 1)
    it "follows the chosen brightness" $ do
      let at brightness = luminance (blackBodyRadiance brightness 3000 6000)
      at Bolometric `shouldSatisfy` near 1e-12 16
      at Visible `shouldSatisfy` near 1e-4 (visibleIntensity 3000 6000)
    it "is black for gas without a temperature" $
      map
        (\brightness -> blackBodyRadiance brightness 4500 0)
        [minBound .. maxBound]
        `shouldBe` [black, black]
  where
    temperatures = [1.0037 ^^ i | i <- [0 .. 15580 :: Int]]
    colourError temperature =
      let Radiance r g b = tabulatedColour temperature
          Radiance r' g' b' = blackBodyColour temperature
       in maximum (map abs [r - r', g - g', b - b'])
    luminanceError temperature =
      abs (tabulatedLuminance temperature / blackBodyLuminance temperature - 1)
    near limit expected value =
      abs (value - expected) <= limit * abs (expected :: Double)
