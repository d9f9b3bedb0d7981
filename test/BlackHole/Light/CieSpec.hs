module BlackHole.Light.CieSpec (spec) where

import BlackHole.Light.Cie
import BlackHole.Light.Radiance
import Support.Light
import Test.Hspec
import Test.Hspec.QuickCheck (prop)

spec :: Spec
spec = do
  describe "xyzOfSpectrum" $ do
    it "gives equal-energy light the chromaticity (1/3, 1/3)" $
      chromaticityXy equalEnergy `shouldSatisfy` closeTo 5e-5 (1 / 3, 1 / 3)
    it "gives it the area under the luminous efficiency, 106.857 nm" $
      xyzY equalEnergy `shouldSatisfy` (\y -> abs (y - 106.857) < 1e-3)
    it "passes through the spectral locus of CIE 1931" $
      mapM_
        ( \(wavelength, xy) ->
            chromaticityXy (xyzOfSpectrum (line wavelength))
              `shouldSatisfy` closeTo 2e-5 xy
        )
        spectralLocus

  describe "chromaticityXy" $
    it "knows that black has no colour" $
      chromaticityXy (Xyz 0 0 0) `shouldBe` Nothing

  describe "radianceOfXyz" $ do
    it "makes D65 white" $
      differenceOf (radianceOfXyz (Xyz (0.3127 / 0.3290) 1 (0.3583 / 0.3290))) (grey 1)
        `shouldSatisfy` (< 1e-14)
    it "has the primaries of BT.709" $
      map
        (chromaticityXy . xyzOfRadiance)
        [Radiance 1 0 0, Radiance 0 1 0, Radiance 0 0 1]
        `shouldSatisfy` and
          . zipWith
            (closeTo 1e-14)
            [(0.64, 0.33), (0.30, 0.60), (0.15, 0.06)]
    prop "is the inverse of xyzOfRadiance" $ \r g b ->
      let colour = Radiance r g b
       in differenceOf (radianceOfXyz (xyzOfRadiance colour)) colour
            `shouldSatisfy` (<= 1e-14 * (abs r + abs g + abs b))
    prop "agrees with luminance" $ \r g b ->
      abs (xyzY (xyzOfRadiance (Radiance r g b)) - luminance (Radiance r g b))
        `shouldSatisfy` (<= 1e-15 * (abs r + abs g + abs b))
  where
    equalEnergy = xyzOfSpectrum (const 1)
    line wavelength l = if abs (l - wavelength) < 1 then 1 else 0
    -- Published chromaticities of single wavelengths (CIE 015, table T.2).
    spectralLocus =
      [ (450, (0.15664, 0.01771)),
        (480, (0.09129, 0.13270)),
        (520, (0.07430, 0.83380)),
        (550, (0.30160, 0.69231)),
        (600, (0.62704, 0.37249)),
        (700, (0.73469, 0.26531)),
        (830, (0.73469, 0.26531))
      ]

closeTo :: Double -> (Double, Double) -> Maybe (Double, Double) -> Bool
closeTo limit (x, y) =
  maybe False (\(x', y') -> abs (x - x') < limit && abs (y - y') < limit)

differenceOf :: Radiance -> Radiance -> Double
differenceOf (Radiance r g b) (Radiance r' g' b') =
  maximum (map abs [r - r', g - g', b - b'])
