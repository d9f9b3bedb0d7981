module BlackHole.Light.CieSpec (spec) where

import BlackHole.Light.Cie
import BlackHole.Light.Radiance
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck

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

  describe "desaturateIntoGamut" $ do
    prop "leaves what a display has as it is" $
      \(NonNegative r) (NonNegative g) (NonNegative b) ->
        desaturateIntoGamut (Radiance r g b) `shouldBe` Radiance r g b
    prop "keeps the luminance and leaves nothing negative" $
      forAll outsideGamut $ \colour ->
        let mapped@(Radiance r g b) = desaturateIntoGamut colour
         in (abs (luminance mapped - luminance colour), minimum [r, g, b])
              `shouldSatisfy` \(error', least) ->
                error' < 1e-13 * luminance colour
                  && least == 0
    prop "moves straight towards white" $
      forAll outsideGamut $ \colour ->
        let Radiance r g b = desaturateIntoGamut colour
            Radiance r' g' b' = colour
            y = luminance colour
            -- White, the colour and its image lie on one line.
            cross =
              [ (r - y) * (g' - y) - (g - y) * (r' - y),
                (g - y) * (b' - y) - (b - y) * (g' - y)
              ]
            along = (r - y) * (r' - y) + (g - y) * (g' - y) + (b - y) * (b' - y)
         in (maximum (map abs cross), along) `shouldSatisfy` \(off, forwards) ->
              off < 1e-10 && forwards > 0
    it "makes light without luminance black" $
      desaturateIntoGamut (Radiance (-1) 0 0) `shouldBe` black
    it "lets NaN through" $
      isFiniteRadiance (desaturateIntoGamut (Radiance (0 / 0) (-1) 5))
        `shouldBe` False
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

-- | Colours with a negative amount and a luminance around 1.
outsideGamut :: Gen Radiance
outsideGamut =
  (Radiance <$> amount <*> amount <*> amount)
    `suchThat` \colour@(Radiance r g b) ->
      minimum [r, g, b] < -1e-3 && luminance colour > 0.1
  where
    amount = choose (-2, 5)

closeTo :: Double -> (Double, Double) -> Maybe (Double, Double) -> Bool
closeTo limit (x, y) =
  maybe False (\(x', y') -> abs (x - x') < limit && abs (y - y') < limit)

differenceOf :: Radiance -> Radiance -> Double
differenceOf (Radiance r g b) (Radiance r' g' b') =
  maximum (map abs [r - r', g - g', b - b'])
