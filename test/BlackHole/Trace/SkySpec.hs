module BlackHole.Trace.SkySpec (spec) where

import BlackHole.Light.Radiance
import BlackHole.Numeric.Angle (Degrees (..))
import BlackHole.Scene.Sky
import BlackHole.Trace.EnvironmentMap
import BlackHole.Trace.RayDifferential
import BlackHole.Trace.Sky
import BlackHole.Vector.XYZ (XYZ (..), (*^))
import qualified BlackHole.Vector.XYZ as XYZ
import Data.Word (Word64)
import Support.Approx
import Support.Generators
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck

spec :: Spec
spec = do
  prop "light of the sky grows as g⁴" $ \(Direction d) ->
    forAll (inRange 0.3 2) $ \g ->
      conjoin
        [ counterexample
            (show sky)
            ( abs (luminance (shader g d) - g ** 4 * luminance (shader 1 d)) < 1e-9
                + 1e-6 * luminance (shader g d)
            )
          | (sky, shader) <- shaders
        ]
  it "stars are few, and some are bright" $
    sequence_
      [ do
          length (filter (> 0) values) `shouldSatisfy` (\n -> n > 10 && n < 1000)
          maximum values `shouldSatisfy` (> 0.5)
        | stars <- [reportStars, defaultStars],
          let values = [luminance (shown 0 (SkyNoise stars) 1 d) | d <- directionsOf 20000]
      ]
  it "depends on the seed" $
    length
      [ () | d <- directionsOf 20000, shown 1 (SkyNoise reportStars) 1 d
                                        /= shown 2 (SkyNoise reportStars) 1 d
      ]
      `shouldSatisfy` (> 10)
  it "a panorama is as bright as it is said to be, and g⁴ times that" $
    case ( panoramaShader (Panorama "" (Degrees 40) 3)
             <$> environmentMapFromPixels 8 4 (\_ _ -> grey 0.5),
           wide (XYZ 0 1 0)
         ) of
      (Just (ByDifferential sky), differential) ->
        luminance (skyThrough sky 2 differential) `shouldBeWithin` (1e-4, 24)
      _ -> expectationFailure "a panorama needs the beam"
  where
    -- Made once, for all the properties' cases.
    shaders =
      [ (sky, shown 7 sky)
        | sky <-
            [ SkyNoise reportStars,
              SkyNoise defaultStars,
              SkyStars realSky,
              SkyRandomStars defaultPointStars,
              SkyGrid,
              SkyUniform 0.4,
              SkyNone
            ]
      ]
    shown :: Word64 -> Sky -> Double -> XYZ -> Radiance
    shown seed sky = case skyShader Nothing seed sky of
      Just (ByDirection shader) -> shader
      Just (ByDifferential filtered) -> \g d -> skyThrough filtered g (wide d)
      Nothing -> \_ _ -> Radiance (0 / 0) 0 0
    -- Some hundredths of a radian.
    wide d@(XYZ x y z) =
      RayDifferential d (0.02 *^ XYZ y (-x) 0) (0.02 *^ XYZ.cross d (XYZ z 0.1 x))
    -- Evenly over the sphere along a spiral of golden angles.
    directionsOf n = map (onSpiral n) [0 .. n - 1]
    onSpiral :: Int -> Int -> XYZ
    onSpiral n i = XYZ (s * cos a) y (s * sin a)
      where
        y = 1 - (2 * fromIntegral i + 1) / fromIntegral n
        a = fromIntegral i * 2.399963229728653
        s = sqrt (1 - y * y)
