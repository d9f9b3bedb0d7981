module BlackHole.Light.ToneMapSpec (spec) where

import BlackHole.Light.BlackBody (blackBodyColour)
import BlackHole.Light.Radiance
import BlackHole.Light.Srgb (decodeSrgb)
import BlackHole.Light.ToneMap
import Support.Approx
import Support.Generators
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck

spec :: Spec
spec = do
  it "have the published values" $ do
    middle ToneFilm (log 2) `shouldBeWithin` (1e-15, 0.5)
    middle ToneReinhard 1 `shouldBeWithin` (1e-15, 0.5)
    -- x (2.51 x + 0.03) / (x (2.43 x + 0.59) + 0.14) at 1.
    middle ToneAces 1 `shouldBeWithin` (1e-12, 2.54 / 3.16)
    middle ToneAgx 0.18 `shouldBeWithin` (1e-12, 0.18)
    middle ToneAgx (0.18 * 2 ** 6.5) `shouldBeWithin` (1e-12, 1)
    middle ToneAgx (0.18 * 2 ** (-10)) `shouldBeWithin` (1e-12, 0)
  prop "leave black black and stay in range" $
    forAll arbitraryBoundedEnum $ \tone ->
      forAll light $ \l ->
        let Radiance r g b = applyToneMap tone l
         in conjoin
              [ applyToneMap tone black === black,
                conjoin [counterexample (show c) (c >= 0 && c <= 1) | c <- [r, g, b]]
              ]
  prop "never darken when the light grows" $
    forAll arbitraryBoundedEnum $ \tone ->
      forAll light $ \l ->
        luminance (applyToneMap tone (scaleRadiance 1.1 l)) >= luminance (applyToneMap tone l)
          - 1e-12
  it "radio goes from black through red and orange to white" $
    map (applyToneMap ToneRadio . grey) [0, 0.25, 0.5, 1, 7]
      `shouldBe` map
        (mapRadiance decodeSrgb)
        [ black,
          Radiance 0.5 0 0,
          Radiance 1 0.5 0,
          grey 1,
          grey 1
        ]
  prop "keep grey grey" $
    forAll (elements inColour) $ \tone ->
      forAll (inRange 0 50) $ \v ->
        let Radiance r g b =
              applyToneMap tone (grey v)
         in conjoin [closeTo 1e-12 r g, closeTo 1e-12 r b]
  prop "curves keep the middle primary's place between the others' roots" $
    forAll (elements [ToneFilm, ToneReinhard, ToneAces, ToneAgx]) $ \tone ->
      forAll ((,,) <$> inRange 0 0.3 <*> inRange 0.3 0.6 <*> inRange 0.6 8) $
        \(low, between, high) ->
          let Radiance r g b = applyToneMap tone (Radiance high between low)
           in closeTo 1e-9 (place high between low) (place r g b)
  it "film keeps the ratio of the primaries up to half of white, and gives it up near white" $ do
    let ratio (Radiance r _ b) = b / r
        shown stops =
          ratio (applyToneMap ToneFilm (scaleRadiance (2 ** stops) (Radiance 1 0.6 0.25)))
    mapM_ (\stops -> shown stops `shouldSatisfy` (\q -> q > 0.25 && q < 0.3)) [-6, -4, -2, -0.5]
    shown 2 `shouldSatisfy` (> 0.5)
    shown 4 `shouldSatisfy` (> 0.95)
  it "film lets bright light without any blue pale towards white, and dim light not" $ do
    let blue stops =
          let Radiance _ _ b =
                applyToneMap ToneFilm (scaleRadiance (2 ** stops) (Radiance 1 0.3 0))
           in b
    blue (-2) `shouldSatisfy` (< 1e-6)
    blue 3 `shouldSatisfy` (> 0.02)
  it "turn the hue of glowing gas by little" $
    -- In OKLab, of black bodies over nine stops, where colour is left to see.
    mapM_
      ( \tone -> do
          let turns = turnsBy (applyToneMap tone)
          maximum (map abs turns) `shouldSatisfy` (< 11)
          rootMeanSquare turns `shouldSatisfy` (< 4)
      )
      inColour
  it "would turn it far with a curve for each primary" $
    rootMeanSquare (turnsBy (mapRadiance (\x -> 1 - exp (negate x)))) `shouldSatisfy` (> 10)
  where
    inColour = filter (/= ToneRadio) [minBound ..]
    light = Radiance <$> inRange 0 5 <*> inRange 0 5 <*> inRange 0 5
    middle tone v = let Radiance _ g _ = applyToneMap tone (grey v) in g
    place high between low = (sqrt between - sqrt low) / (sqrt high - sqrt low)
    degreesBetween a b =
      let d = (b - a) * 180 / pi in d - 360 * fromIntegral (round (d / 360) :: Int)
    hue l = let (a, b) = okLab l in atan2 b a
    rootMeanSquare turns = sqrt (sum (map (** 2) turns) / fromIntegral (length turns))
    turnsBy shownAs =
      [ degreesBetween (hue l) (hue shown)
        | temperature <- [1000, 1250 .. 12000],
          stops <- [-5 .. 4 :: Int],
          let l = scaleRadiance (2 ^^ stops) (blackBodyColour temperature),
          let shown = shownAs l,
          chroma l > 0.02,
          chroma shown > 0.02
      ]
    chroma l = let (a, b) = okLab l in sqrt (a * a + b * b)

-- | The two colour axes of OKLab (Ottosson 2020).
okLab :: Radiance -> (Double, Double)
okLab (Radiance r g b) =
  ( 1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s,
    0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s
  )
  where
    l = cubeRoot (0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b)
    m = cubeRoot (0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b)
    s = cubeRoot (0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b)
    cubeRoot x = max 0 x ** (1 / 3)
