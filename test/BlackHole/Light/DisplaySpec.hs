module BlackHole.Light.DisplaySpec (spec) where

import BlackHole.Light.Display
import BlackHole.Light.Dither (Dither (..))
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
      map quantise [0, 1, 0.5, 2, -1, 0 / 0, 1 / 0, 1 / 510 + 1e-9]
        `shouldBe` [0, 255, 128, 255, 0, 0, 255, 1]
    prop "is monotone" $
      forAll ((,) <$> inRange (-1) 2 <*> inRange (-1) 2) $ \(a, b) ->
        a <= b ==> quantise a <= quantise b
  describe "dithered codes" $ do
    prop "are one of the two nearest" $
      forAll ((,) <$> inRange 0.001 0.999 <*> inRange 0 1) $ \(threshold, s) ->
        let code = fromIntegral (ditheredCode threshold s) :: Double
         in counterexample (show code) (code > 255 * s - 1 && code < 255 * s + 1)
    prop "leave exact codes alone" $
      forAll ((,) <$> inRange 0.001 0.999 <*> choose (0, 255)) $ \(threshold, code) ->
        ditheredCode threshold (fromIntegral code / 255) === code
  it "16-bit codes reach both ends" $
    map fineCode [0, 1, 2, -1, 0.5, 0 / 0] `shouldBe` [0, 65535, 65535, 0, 32768, 0]
  describe "prepared development" $ do
    prop "is that of the exact functions" $
      forAll arbitraryBoundedEnum $ \tone ->
        forAll (inRange (-3) 3) $ \stops ->
          forAll light $ \l ->
            let Signal r g b =
                  developSignal
                    (developer (Development (Exposure stops) tone noGrain NoDither))
                    0
                    0
                    l
                Radiance r' g' b' =
                  mapRadiance encodeSrgb (applyToneMap tone (expose (Exposure stops) l))
             in conjoin [closeTo 2e-5 e v | (e, v) <- [(r', r), (g', g), (b', b)]]
    it "survives any light" $
      sequence_
        [ all (\s -> s >= 0 && s <= 1) [r, g, b] `shouldBe` True
          | tone <- [minBound ..],
            a <- strange,
            c <- strange,
            let Signal r g b =
                  developSignal
                    (developer (Development (Exposure 0) tone noGrain NoDither))
                    0
                    0
                    (Radiance a c 0.2)
        ]
    it "shows light without end as the brightest there is" $
      sequence_
        [ minimum [r, g, b] `shouldBeWithin` (1e-12, 1)
          | tone <- [minBound ..],
            let Signal r g b =
                  developSignal
                    (developer (Development (Exposure 0) tone noGrain NoDither))
                    0
                    0
                    (grey (1 / 0))
        ]
  where
    light = Radiance <$> inRange 0 5 <*> inRange 0 5 <*> inRange 0 5
    strange = [0 / 0, 1 / 0, -1 / 0, -1, 0, 1e-300, 1e300]
