module BlackHole.Light.DisplaySpec (spec) where

import BlackHole.Light.Display
import BlackHole.Light.Radiance
import Support.Approx
import Support.Generators
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck

spec :: Spec
spec = do
  it "exposure is in stops" $ expose (Exposure 3) (Radiance 1 2 3) `shouldBe` Radiance 8 16 24
  describe "sRGB" $ do
    it "meets the standard's fixed points" $ do
      encodeSrgb 0.0031308 `shouldBeWithin` (1e-7, 0.04045)
      encodeSrgb 0.18 `shouldBeWithin` (1e-5, 0.461356)
      encodeSrgb 1 `shouldBeWithin` (1e-12, 1)
    prop "decoding undoes encoding" $
      forAll (inRange 0 1) $ \x -> closeTo 1e-7 x (decodeSrgb (encodeSrgb x))
  describe "quantisation" $ do
    it "rounds to the nearest code and survives everything" $
      map quantise [0, 1, 0.5, 2, -1, 0 / 0, 1 / 0, 1 / 510 + 1e-9] `shouldBe` [0, 255, 128, 255, 0, 0, 255, 1]
    prop "is monotone" $
      forAll ((,) <$> inRange (-1) 2 <*> inRange (-1) 2) $ \(a, b) ->
        a <= b ==> quantise a <= quantise b
  describe "tone maps" $ do
    prop "stay in range" $
      forAll arbitraryBoundedEnum $ \tone ->
        forAll light $ \l ->
          let Radiance r g b = applyToneMap tone l
           in conjoin [counterexample (show c) (c >= 0 && c <= 1) | c <- [r, g, b]]
    prop "never darken when the light grows" $
      forAll arbitraryBoundedEnum $ \tone ->
        forAll light $ \l ->
          luminance (applyToneMap tone (scaleRadiance 1.1 l)) >= luminance (applyToneMap tone l) - 1e-12
    prop "none changes nothing that fits" $
      forAll (Radiance <$> inRange 0 1 <*> inRange 0 1 <*> inRange 0 1) $ \l ->
        applyToneMap ToneNone l === l
    it "none keeps the hue of what is too bright" $
      -- Bright orange stays between red and yellow: the order of the primaries
      -- and the place of green between them.
      let Radiance r g b = applyToneMap ToneNone (Radiance 2 0.6 0.1)
       in do
            r `shouldBeWithin` (1e-12, 1)
            ((g - b) / (r - b)) `shouldBeWithin` (1e-12, (0.6 - 0.1) / (2 - 0.1))
  where
    light = Radiance <$> inRange 0 5 <*> inRange 0 5 <*> inRange 0 5
