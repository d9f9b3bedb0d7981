-- | Panoramas behind the hole.
module BlackHole.Render.PanoramaFilmSpec (spec) where

import BlackHole.Light.Radiance
import BlackHole.Numeric.Angle (Degrees (..))
import BlackHole.Render.Exposed
import BlackHole.Render.Film
import BlackHole.Render.PixelArray (toPixelVector)
import BlackHole.Render.Workers
import BlackHole.Scene.Camera (Camera (..), Picture (..), Pose (..), posePosition)
import BlackHole.Scene.Preset
import BlackHole.Scene.Scene
import BlackHole.Scene.Shifts (Shifts (..))
import BlackHole.Scene.Sky
import BlackHole.Spacetime.Observer (Observer (..))
import BlackHole.Spacetime.Types (Spacetime (..))
import BlackHole.Trace.EnvironmentMap
import BlackHole.Vector.XYZ (XYZ (..))
import qualified Data.Vector.Storable as Vector
import Support.Exposing
import Test.Hspec

spec :: Spec
spec = do
  it
    "one of a single colour is a uniform sky, for every observer and integrator, outside and inside"
    $ sequence_
      [ do
          flat <- exposed Nothing scene {sceneSky = SkyUniform 0.4}
          pictured <- exposed (plain 0.4) scene {sceneSky = sky}
          Vector.length (Vector.filter (> 0) flat) `shouldSatisfy` (> 500)
          Vector.maximum (Vector.zipWith (\a b -> abs (a - b) / max 1e-3 a) flat pictured)
            `shouldSatisfy` (< 2e-6)
        | scene <-
            [from 8 who | who <- [Static, Orbiting, Falling, Coordinate]]
              ++ [outwards 1.2, outwards 0.6]
              ++ [(from 8 Static) {sceneIntegrator = way} | way <- [Exact, Leapfrogging]]
              ++ [(from 8 Static) {sceneSpacetime = Flat}]
      ]
  it "a chequerboard finer than the pixels has no aliases, neither far off nor inside" $
    sequence_
      [ do
          film <- exposed checks scene
          -- In all directions the mean, where a look without a filter sees 0 or 1.
          let lit = Vector.filter (> 0) film
          Vector.length lit `shouldSatisfy` (> 500)
          abs (mean lit / level - 1) `shouldSatisfy` (< 0.01)
          deviation lit / level `shouldSatisfy` (< 0.06)
        | (scene, level) <-
            [ ((from 8 Coordinate) {sceneSky = sky, sceneSpacetime = Flat}, 0.5),
              (unshifted (from 8 Static), 0.5),
              (unshifted (outwards 0.7), 0.5)
            ]
      ]
  it "sends the same light whatever its turn, and turns as a whole" $ do
    -- A picture of four equal quarters, turned by one, is the same picture.
    let quarters =
          environmentMapFromPixels
            512
            256
            (\i j -> grey (2 + cos (pi * fromIntegral i / 64) + sin (0.1 * fromIntegral j)))
    [a, b] <-
      mapM
        ( \turn ->
            exposed
              quarters
              (from 8 Static)
                { sceneSky = SkyPanorama (panoramaOf "x") {panoramaRotation = Degrees turn}
                }
        )
        [10, 100]
    deviation a `shouldSatisfy` (> 0.3)
    -- But for the fields, of which no ring has quarters.
    mean (Vector.zipWith (\x y -> abs (x - y)) a b) `shouldSatisfy` (< 2e-3)
  it "is not traced without its picture" $ do
    film <- exposeWhole oneWorker (from 8 Static) {sceneSky = sky}
    traverse (faultyPixels oneWorker) film `shouldReturn` Nothing
  where
    sky = SkyPanorama (panoramaOf "x")
    plain v = environmentMapFromPixels 64 32 (\_ _ -> grey v)
    -- Fields of 0.18°, in pixels of 1.4° and more.
    checks = environmentMapFromPixels 2048 1024 (\i j -> if even (i + j) then white else black)
    white = grey 1
    from r who =
      defaultScene
        { scenePicture = Picture 40 30,
          sceneCamera =
            (sceneCamera defaultScene)
              { cameraPose = Around r (Degrees 77) (Degrees 30),
                cameraFieldOfView = Degrees 60
              },
          sceneObserver = who,
          sceneDisk = Nothing,
          sceneSamples = 1,
          sceneNoise = 0,
          sceneBloom = 0
        }
    -- Away from the hole, which fills half of all that is to be seen and more.
    outwards r =
      let scene = from r Falling
          XYZ x y z = posePosition (cameraPose (sceneCamera scene))
       in scene
            { sceneCamera =
                (sceneCamera scene) {cameraPose = LookAt (XYZ x y z) (XYZ (5 * x) (3 * y) (5 * z))}
            }
    unshifted scene = scene {sceneSky = sky, sceneShifts = Shifts False False}
    exposed picture scene =
      maybe Vector.empty (channel . toPixelVector . exposedLight)
        <$> exposeFilm picture oneWorker (const (pure ())) scene (allRows (scenePicture scene))
    channel light =
      Vector.generate
        (Vector.length light `quot` 3)
        (\i -> realToFrac (light Vector.! (3 * i)) :: Double)
    mean values = Vector.sum values / fromIntegral (max 1 (Vector.length values))
    deviation values = sqrt (mean (Vector.map (\v -> (v - mean values) ^ (2 :: Int)) values))
