module BlackHole.Light.BlackBodySpec (spec) where

import BlackHole.Light.BlackBody
import BlackHole.Light.Cie
import BlackHole.Light.Radiance
import Support.Light
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck

spec :: Spec
spec = do
  describe "spectralRadiance" $ do
    it "peaks where Wien's law says, 2.897771955e6 nm K" $ do
      let peak = 2.897771955e6 / 5000
          slopeAt l = spectralRadiance (l + 0.01) 5000 - spectralRadiance (l - 0.01) 5000
      (slopeAt (peak * 0.9999), slopeAt (peak * 1.0001))
        `shouldSatisfy` (\(rise, fall) -> rise > 0 && fall < 0)
    it "sums to the Stefan-Boltzmann law" $ do
      let step = 0.01 :: Double
          radiance =
            sum
              [ l * step * spectralRadiance l 3000
                | i <- [0 .. 1400 :: Int],
                  let l = exp (4 + step * fromIntegral i)
              ]
      -- σT⁴/π over the wavelengths that matter.
      radiance `shouldSatisfy` near 1e-6 (5.670374419e-8 * 3000 ^ (4 :: Int) / pi)

  describe "blackBodyChromaticity" $ do
    it "has the published values on the Planckian locus" $
      mapM_
        ( \(temperature, x, y, limit) -> do
            let (x', y') = blackBodyChromaticity temperature
            (temperature, max (abs (x' - x)) (abs (y' - y)))
              `shouldSatisfy` ((< limit) . snd)
        )
        locus
    it "moves from red to blue with every kelvin" $ do
      let xs = map (fst . blackBodyChromaticity) (geometric 300 1e6 400)
      filter (uncurry (<=)) (zip xs (drop 1 xs)) `shouldBe` []
    it "reaches its limits and stays there" $ do
      let (coldX, coldY) = blackBodyChromaticity 1e-3
          (hotX, hotY) = blackBodyChromaticity 1e300
      (coldX, coldY) `shouldBe` blackBodyChromaticity 0
      (hotX, hotY) `shouldBe` blackBodyChromaticity (1 / 0)
      (coldX, coldY) `shouldSatisfy` close 1e-5 (0.73469, 0.26531)
      (hotX, hotY) `shouldSatisfy` close 3e-5 (0.23990, 0.23404)

  describe "blackBodyColour" $ do
    it "has luminance 1 and no negative amount at every temperature" $
      mapM_
        ( \temperature -> do
            let colour@(Radiance r g b) = blackBodyColour temperature
            (temperature, luminance colour) `shouldSatisfy` (near 1e-13 1 . snd)
            (temperature, minimum [r, g, b]) `shouldSatisfy` ((>= 0) . snd)
        )
        ([0, -5, 0 / 0, 1 / 0] ++ geometric 0.1 1e25 500)
    it "loses red and gains blue from 1000 K on" $ do
      let colours = map blackBodyColour (geometric 1000 1e8 400)
      filter
        (\(Radiance r _ b, Radiance r' _ b') -> r' >= r || b' < b)
        (zip colours (drop 1 colours))
        `shouldBe` []
    it "is nearly white at 6500 K" $ do
      let Radiance r g b = blackBodyColour 6500
      maximum (map (abs . subtract 1) [r, g, b]) `shouldSatisfy` (< 0.05)
    it "keeps the dominant wavelength of what it desaturates" $
      mapM_
        ( \temperature -> do
            let (x, y) = blackBodyChromaticity temperature
                mapped = chromaticityXy (xyzOfRadiance (blackBodyColour temperature))
                cross (x', y') =
                  (x - 0.3127) * (y' - 0.3290) - (y - 0.3290) * (x' - 0.3127)
            fmap cross mapped `shouldSatisfy` maybe False ((< 1e-12) . abs)
        )
        (geometric 900 1900 20)

  describe "blackBodyLuminance" $ do
    it "is 6e5 cd/m² at the freezing point of platinum (the old candela)" $
      blackBodyLuminance 2041.4 `shouldSatisfy` near 0.01 6e5
    prop "is Planck's spectrum through the matching functions" $
      forAll (choose (400, 50000)) $ \temperature ->
        blackBodyLuminance temperature
          `shouldSatisfy` near
            1e-12
            (683 * xyzY (xyzOfSpectrum (`spectralRadiance` temperature)))
    it "is 0 for no positive temperature" $
      map blackBodyLuminance [0, -1, 0 / 0] `shouldBe` [0, 0, 0]

  describe "intensities" $ do
    it "are 1 at the reference" $
      (bolometricIntensity 4500 4500, visibleIntensity 4500 4500)
        `shouldBe` (1, 1)
    it "rises as the fourth power over all wavelengths" $
      bolometricIntensity 3000 6000 `shouldBe` 16
    it "rises as the first power in the Rayleigh-Jeans limit" $
      visibleIntensity 1e9 2e9 `shouldSatisfy` near 1e-4 2
    it "survives temperatures whose luminance underflows" $
      visibleIntensity 10 10.001 `shouldSatisfy` (\q -> q > 1 && q < 2)
  where
    geometric from to count =
      [ from * (to / from) ** (fromIntegral i / fromIntegral (count :: Int))
        | i <- [0 .. count]
      ]
    near limit expected value =
      abs (value - expected) <= limit * abs (expected :: Double)
    close limit (x, y) (x', y') =
      abs (x - x') < limit && abs (y - y') < (limit :: Double)
    -- Illuminant A is a black body at 2848 K × 1.438776877/1.435 (CIE S 014-2);
    -- its published place belongs to sums over 380 to 780 nm, 1e-5 away. The
    -- others were computed with c₂ = 1.4388e-2 m K, less than 1e-5 away.
    locus =
      [ (2848 * secondRadiationConstant / 1.435e7, 0.44757, 0.40745, 1.5e-5),
        (6500, 0.31352, 0.32363, 1e-5),
        (10000, 0.28063, 0.28829, 1e-5)
      ]
