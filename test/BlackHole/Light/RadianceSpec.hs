module BlackHole.Light.RadianceSpec (spec) where

import BlackHole.Light.Radiance
import Test.Hspec
import Test.Hspec.QuickCheck (prop)

spec :: Spec
spec = do
  describe "addition" $ do
    it "adds each primary" $
      Radiance 1 2 3 <+> Radiance 10 20 30 `shouldBe` Radiance 11 22 33
    prop "is the Semigroup, with black as unit" $ \r g b ->
      let x = Radiance r g b
       in (mconcat [x], black <+> x, x <> x) `shouldBe` (x, x, scaleRadiance 2 x)

  describe "luminance" $ do
    it "is 1 for white" $ abs (luminance (grey 1) - 1) `shouldSatisfy` (< 4e-16)
    it "has the weights of BT.709" $
      map
        luminance
        [Radiance 1 0 0, Radiance 0 1 0, Radiance 0 0 1]
        `shouldSatisfy` (and . zipWith near [0.2126, 0.7152, 0.0722])
    prop "is linear" $ \k r g b ->
      let x = Radiance r g b
          size = abs k * (abs r + abs g + abs b)
       in abs (luminance (scaleRadiance k x) - k * luminance x)
            `shouldSatisfy` (<= 1e-15 * size)

  describe "mapRadiance" $
    it "keeps the order of the primaries" $
      mapRadiance (+ 1) (Radiance 1 2 3) `shouldBe` Radiance 2 3 4

  describe "isFiniteRadiance" $ do
    it "accepts numbers" $ isFiniteRadiance (Radiance 0 (-1) 1e300) `shouldBe` True
    it "rejects NaN and infinity in any place" $
      map
        isFiniteRadiance
        [ Radiance (0 / 0) 0 0,
          Radiance 0 (1 / 0) 0,
          Radiance 0 0 (-1 / 0)
        ]
        `shouldBe` [False, False, False]
  where
    near a b = abs (a - b) < 5e-5
