module BlackHole.Trace.SkySpec (spec) where

import BlackHole.Light.Radiance
import BlackHole.Scene.Sky
import BlackHole.Trace.Sky
import BlackHole.Vector.XYZ (XYZ (..))
import Support.Generators
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck

spec :: Spec
spec = do
  prop "light of the sky grows as g⁴" $ \(Direction d) ->
    forAll (inRange 0.3 2) $ \g ->
      conjoin
        [ counterexample (skyName sky) (abs (luminance (skyShader 7 sky g d) - g ** 4 * luminance (skyShader 7 sky 1 d)) < 1e-9 + 1e-6 * luminance (skyShader 7 sky g d))
          | sky <- [SkyNoise reportStars, SkyNoise defaultStars, SkyGrid, SkyUniform 0.4, SkyNone]
        ]
  it "stars are few, and some are bright" $
    sequence_
      [ do
          length (filter (> 0) values) `shouldSatisfy` (\n -> n > 10 && n < 1000)
          maximum values `shouldSatisfy` (> 0.5)
        | stars <- [reportStars, defaultStars],
          let values = [luminance (skyShader 0 (SkyNoise stars) 1 d) | d <- directionsOf 20000]
      ]
  it "depends on the seed" $
    length [() | d <- directionsOf 20000, skyShader 1 (SkyNoise reportStars) 1 d /= skyShader 2 (SkyNoise reportStars) 1 d]
      `shouldSatisfy` (> 10)
  where
    -- Evenly over the sphere along a spiral of golden angles.
    directionsOf n = map (onSpiral n) [0 .. n - 1]
    onSpiral :: Int -> Int -> XYZ
    onSpiral n i = XYZ (s * cos a) y (s * sin a)
      where
        y = 1 - (2 * fromIntegral i + 1) / fromIntegral n
        a = fromIntegral i * 2.399963229728653
        s = sqrt (1 - y * y)
