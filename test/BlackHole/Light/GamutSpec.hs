module BlackHole.Light.GamutSpec (spec) where

import BlackHole.Light.BlackBody (blackBodyColour)
import BlackHole.Light.Gamut
import BlackHole.Light.Radiance
import Support.Approx
import Support.Generators
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck

spec :: Spec
spec = do
  describe "desaturateIntoGamut" $ do
    prop "leaves what a display has as it is" $
      \(NonNegative r) (NonNegative g) (NonNegative b) ->
        desaturateIntoGamut (Radiance r g b) `shouldBe` Radiance r g b
    prop "keeps the luminance and leaves nothing negative" $
      forAll outsideGamut $ \colour ->
        let mapped@(Radiance r g b) = desaturateIntoGamut colour
         in conjoin
              [ closeTo (1e-13 * luminance colour) (luminance colour) (luminance mapped),
                minimum [r, g, b] === 0
              ]
    prop "moves straight towards white, unless green is the least" $
      forAll (outsideGamut `suchThat` \(Radiance r g b) -> g > min r b) $ \colour ->
        let Radiance r g b = desaturateIntoGamut colour
            Radiance r' g' b' = colour
            y = luminance colour
            -- White, the colour and its image lie on one line.
            cross =
              [ (r - y) * (g' - y) - (g - y) * (r' - y),
                (g - y) * (b' - y) - (b - y) * (g' - y)
              ]
            along = (r - y) * (r' - y) + (g - y) * (g' - y) + (b - y) * (b' - y)
         in counterexample (show (cross, along)) (maximum (map abs cross) < 1e-10 && along > 0)
    it "shows no black body more purple than the display's red" $
      sequence_
        [ (b <= g && (t > 860 || (g == 0 && b == 0))) `shouldBe` True
          | t <- [100, 150 .. 2500],
            let Radiance _ g b = blackBodyColour t
        ]
    it "has no jump between its two rules" $
      -- Green and blue both negative, either the lesser by a hair.
      differenceOf
        (desaturateIntoGamut (Radiance 5 (-0.1) (-0.1 - 1e-9)))
        (desaturateIntoGamut (Radiance 5 (-0.1 - 1e-9) (-0.1)))
        `shouldSatisfy` (< 1e-7)
    it "makes light without luminance black" $
      desaturateIntoGamut (Radiance (-1) 0 0) `shouldBe` black
    it "lets NaN through" $
      isFiniteRadiance (desaturateIntoGamut (Radiance (0 / 0) (-1) 5))
        `shouldBe` False
  describe "fitGamut" $ do
    prop "changes nothing that fits" $
      forAll (Radiance <$> inRange 0 1 <*> inRange 0 1 <*> inRange 0 1) $ \l ->
        fitGamut l === l
    prop "keeps the luminance up to white's" $
      forAll (Radiance <$> inRange 0 5 <*> inRange 0 5 <*> inRange 0 5) $ \l ->
        closeTo 1e-12 (min 1 (luminance l)) (luminance (fitGamut l))
    it "keeps the hue of what is too bright" $
      -- Bright orange stays between red and yellow: the order of the primaries
      -- and the place of green between them.
      let Radiance r g b = fitGamut (Radiance 2 0.6 0.1)
       in do
            r `shouldBeWithin` (1e-12, 1)
            ((g - b) / (r - b)) `shouldBeWithin` (1e-12, (0.6 - 0.1) / (2 - 0.1))

-- | Colours with a negative amount and a luminance around 1.
outsideGamut :: Gen Radiance
outsideGamut =
  (Radiance <$> amount <*> amount <*> amount)
    `suchThat` \colour@(Radiance r g b) ->
      minimum [r, g, b] < -1e-3 && luminance colour > 0.1
  where
    amount = choose (-2, 5)

differenceOf :: Radiance -> Radiance -> Double
differenceOf (Radiance r g b) (Radiance r' g' b') =
  maximum (map abs [r - r', g - g', b - b'])
