-- | Point stars on film, as the camera moves.
module BlackHole.Render.StarFilmSpec (spec) where

import BlackHole.Light.Radiance
import BlackHole.Noise.PerlinG (Seed)
import BlackHole.Numeric.Angle (Degrees (..))
import BlackHole.Render.Exposed
import BlackHole.Render.Workers
import BlackHole.Scene.Camera (Camera (..), Picture (..), Pose (..))
import BlackHole.Scene.Preset
import BlackHole.Scene.Scene
import BlackHole.Scene.Sky
import BlackHole.Spacetime.Fate
import BlackHole.Spacetime.LightPath
import BlackHole.Spacetime.Observer
import BlackHole.Spacetime.Schwarzschild.ExactPath
import BlackHole.Spacetime.Types (Spacetime (..))
import BlackHole.Trace.Seeds
import BlackHole.Trace.StarCatalogue
import BlackHole.Vector.XYZ (XYZ (..))
import Data.Maybe (fromMaybe)
import Support.Approx
import Support.Exposing
import Test.Hspec

spec :: Spec
spec = do
  it "sum up to the analytic magnification, frame by frame as the camera goes round" $
    -- Steps of a fifth of a pixel, then some of many.
    sequence_
      [ do
          film <- exposed 1 (Degrees beta)
          let expected = unlensed * magnification (beta * pi / 180)
          maybe 0 flux film `shouldBeWithin` (0.015 * expected, expected)
        | beta <- [2 + 0.04 * fromIntegral k | k <- [0 .. 5 :: Int]] ++ [2.7, 3.3, 4]
      ]
  it "never grow beyond that as the star passes behind the hole" $
    sequence_
      [ do
          film <- exposed 1 (Degrees beta)
          maybe 0 flux film `shouldSatisfy` (< 1.03 * unlensed * magnification (beta * pi / 180))
        | beta <- [0.05, 0.2, 0.5, 1]
      ]
  it "leave no glow on the Einstein ring where there is none" $ do
    film <- exposed 20000 (Degrees 5)
    let onRing =
          [ luminance light
            | x <- [0 .. width - 1],
              y <- [0 .. height - 1],
              abs (radiusOf x y - einstein) < 0.012,
              Just light <- [film >>= \f -> filmRadiance f x y]
          ]
    length onRing `shouldSatisfy` (> 500)
    -- Most of the sky has no star within two and a half pixels.
    length (filter (== 0) onRing) `shouldSatisfy` (> length onRing `quot` 2)
  where
    width = 200 :: Int
    height = 112 :: Int
    exposed count (Degrees beta) = exposeWhole oneWorker (scene count beta)
    scene count beta =
      defaultScene
        { sceneDisk = Nothing,
          scenePicture = Picture width height,
          sceneObserver = Static,
          sceneCamera =
            (sceneCamera defaultScene)
              { cameraPose =
                  Around
                    distance
                    (Degrees inclination)
                    (Degrees (azimuth + beta / sin (inclination * pi / 180))),
                cameraFieldOfView = Degrees 44,
                cameraRoll = Degrees 0
              },
          sceneSamples = 1,
          sceneNoise = 0,
          sceneBloom = 0,
          sceneSeed = 0,
          sceneSky = SkyRandomStars (PointStars count 80 0)
        }
    distance = 30
    catalogue = starCatalogue (purposeSeed 0 StarPlaces :: Seed) 1
    XYZ sx sy sz = starDirection catalogue 0
    -- Opposite to the brightest star.
    inclination = acos (negate sy) * 180 / pi
    azimuth = atan2 (negate sz) (negate sx) * 180 / pi
    -- Seen by an observer at rest far down, who finds all light g⁴ times as bright.
    unlensed = 80e-6 * starFlux catalogue 0 / (1 - 1 / distance) ^ (2 :: Int)
    scale = 2 * tan (22 * pi / 180) / fromIntegral width
    offset x y =
      ( scale * (fromIntegral x + 0.5 - fromIntegral width / 2),
        scale * (fromIntegral y + 0.5 - fromIntegral height / 2)
      )
    radiusOf x y = let (u, v) = offset x y in atan (sqrt (u * u + v * v))
    flux film =
      sum
        [ luminance light * scale * scale / (1 + u * u + v * v) ** 1.5
          | x <- [0 .. width - 1],
            y <- [0 .. height - 1],
            let (u, v) = offset x y,
            Just light <- [filmRadiance film x y]
        ]
    -- The angle from the axis behind the hole of what is seen at an angle from
    -- the hole, by the closed form.
    behind theta = fromMaybe (0 / 0) $ do
      photon <-
        sightLine Schwarzschild Static (XYZ distance 0 0) (XYZ (-(cos theta)) (sin theta) 0)
          >>= sightPhoton
      case followedFate (followExact Schwarzschild emptyRegion photon (\() _ -> Continue ()) ()) of
        Escaped (XYZ x y _) -> Just (atan2 y (-x))
        _ -> Nothing
    imageAt beta = bisected (\theta -> behind theta - beta)
    einstein = imageAt 0
    bisected f = go (60 :: Int) 0.15 0.6
      where
        go n low high
          | n == 0 = middle
          | f middle < 0 = go (n - 1) middle high
          | otherwise = go (n - 1) low middle
          where
            middle = 0.5 * (low + high) :: Double
    -- Of both images, the star at an angle above the axis: sin θ dθ / (sin β dβ).
    magnification beta = one beta + one (negate beta)
      where
        one b =
          let theta = imageAt b
              slope = (behind (theta + 1e-5) - behind (theta - 1e-5)) / 2e-5
           in abs (sin theta / (sin b * slope))
