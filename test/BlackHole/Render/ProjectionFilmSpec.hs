module BlackHole.Render.ProjectionFilmSpec (spec) where

import BlackHole.Light.Radiance
import BlackHole.Numeric.Angle
import BlackHole.Render.Exposed
import BlackHole.Render.Workers
import BlackHole.Scene.Camera
import BlackHole.Scene.Field.Kind (Value (..))
import BlackHole.Scene.Preset
import BlackHole.Scene.Scene
import BlackHole.Scene.Setting
import BlackHole.Scene.Sky
import BlackHole.Scene.Validate
import BlackHole.Spacetime.Observer
import BlackHole.Trace.Ray
import BlackHole.Trace.Tracer
import BlackHole.Vector.XY (XY (..))
import BlackHole.Vector.XYZ (XYZ (..))
import qualified BlackHole.Vector.XYZ as XYZ
import Control.Monad (void)
import Data.Maybe (fromMaybe)
import Support.Approx
import Support.Exposing
import Support.Generators
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess, prop)
import Test.QuickCheck

spec :: Spec
spec = do
  modifyMaxSuccess (const 40)
    . prop "shows the light of a direction whatever the projection, for every observer"
    $ forAll ((,,) <$> elements (map fst projected) <*> inRange 10 118 <*> inRange 10 62) $
      \(observer, x, y) ->
        case lookup observer projected of
          Just (Just (flat : others))
            | Just direction <- tracedDirection flat (XY x y) ->
              conjoin
                [ sameLight (sightRadiance flat (XY x y)) (lightTowards other direction)
                  | other <- others
                ]
          _ -> property False
  prop "continues from the right edge to the left, and over the poles" $
    forAll ((,) <$> inRange 0 64 <*> inRange (-0.5) 0.5) $ \(y, across) ->
      case tracer sphere of
        Nothing -> property False
        Just traced ->
          conjoin
            [ sameLight
                (sightRadiance traced (XY (64 + across) y))
                (sightRadiance traced (XY (across - 64) y)),
              sameLight
                (sightRadiance traced (XY y (-abs across)))
                (sightRadiance traced (XY (y + 64) (abs across)))
            ]
  it "has no seam at the back: neighbours across it differ like neighbours elsewhere" $ do
    light <- lightOf falling
    let jump a b = sum [abs (light a r - light b r) | r <- [0 .. 63]]
        elsewhere = maximum [jump c (c + 1) | c <- [0 .. 40]]
    jump 127 0 `shouldSatisfy` (<= 1.5 * elsewhere)
  it "is even along the rows at the poles" $ do
    light <- lightOf falling
    sequence_
      [ maximum row - minimum row `shouldSatisfy` (<= 0.1 * sum row / 128)
        | r <- [0, 63],
          let row = [light c r | c <- [0 .. 127]]
      ]
  it "adds up to the whole sphere: the mean of an even sky by solid angle, less the ball" $ do
    light <-
      lightOf
        sphere
          { sceneSky = SkyUniform 1,
            sceneSamples = 16,
            sceneCamera = Camera (Around 30 (Degrees 80) (Degrees 90)) (Degrees 0) (Degrees 360)
          }
    let solidAngle r =
          2 * pi / 128 * (cos (pi * fromIntegral r / 64) - cos (pi * fromIntegral (r + 1) / 64)) ::
            Double
        whole = sum [light c r * solidAngle r | r <- [0 .. 63], c <- [0 .. 127]]
        -- The sky is brighter by (1 − 1/r)⁻² for an observer at rest, and the shadow dark.
        shadow = 2 * pi * (1 - sqrt (1 - (sqrt (6.75 * (1 - 1 / 30)) / 30) ** 2))
    (whole * (1 - 1 / 30) ** 2) `shouldBeWithin` (4e-3, 4 * pi - shadow)
  it "keeps a star's light at the pole as elsewhere" $ do
    -- All the stars' light over the sphere, seen from where the poles lie otherwise.
    let stars inclination =
          sphere
            { sceneSky =
                SkyRandomStars defaultPointStars {pointStarsCount = 60, pointStarsMilkyWay = 0},
              sceneSamples = 16,
              sceneCamera =
                Camera (Around 1e4 (Degrees inclination) (Degrees 90)) (Degrees 0) (Degrees 360)
            }
        solidAngles scene = do
          light <- lightOf scene
          pure
            ( sum
                [ light c r
                    * (cos (pi * fromIntegral r / 64) - cos (pi * fromIntegral (r + 1) / 64))
                  | r <- [0 .. 63],
                    c <- [0 .. 127]
                ]
            )
    upright <- solidAngles (stars 90)
    leaning <- mapM (solidAngles . stars) [20, 60]
    sequence_ [t `shouldBeWithin` (0.06 * upright, upright) | t <- leaning]
  it "is black outside the fisheye's circle" $ do
    light <- lightOf fisheye
    sum [light c r | r <- [0 .. 63], c <- [0 .. 63], outside c r] `shouldBe` 0
    sum [light c r | r <- [0 .. 63], c <- [0 .. 63], not (outside c r)] `shouldSatisfy` (> 0)
  it "gives each band of a picture the bytes that the whole has there" $
    mapM_
      ( \scene -> do
          let height = pictureHeight (scenePicture scene)
          whole <- exposeWhole oneWorker scene
          part <- exposeBand oneWorker scene (height - 3, 3)
          void part `shouldBe` Just ()
          [(`filmRadianceAt` (c, r)) <$> part | c <- [0, 9, 63], r <- [0, 2]]
            `shouldBe` [ (`filmRadianceAt` (c, height - 3 + r)) <$> whole
                         | c <- [0, 9, 63],
                           r <- [0, 2]
                       ]
      )
      [fisheye, sphere {scenePicture = Picture 64 32}]
  it "never sends a path that just misses the gas on an endless way" $ do
    -- Row 28 of this picture did.
    let scene =
          applySettings
            [ Setting "camera.projection" (NameValue "fisheye"),
              Setting "camera.fov" (NumberValue 100),
              Setting "image.width" (WholeValue 64)
            ]
            defaultScene {sceneSky = SkyNone}
    film <- exposeBand oneWorker scene (28, 1)
    void film `shouldBe` Just ()
  it "chooses angle of view, height and bloom with the projection" $ do
    let with name =
          applySettings
            [Setting "camera.projection" (NameValue name), Setting "image.width" (WholeValue 400)]
            defaultScene {sceneBloom = 0.1}
        seen scene = (scenePicture scene, cameraFieldOfView (sceneCamera scene), sceneBloom scene)
    seen (with "equirectangular") `shouldBe` (Picture 400 200, Degrees 360, 0)
    seen (with "fisheye") `shouldBe` (Picture 400 400, Degrees 180, 0.1)
    seen (with "perspective") `shouldBe` (Picture 400 225, Degrees 40, 0.1)
  it "refuses what does not fit on the sphere" $ do
    map problemName (validateScene sphere {scenePicture = Picture 128 65}) `shouldBe` ["--height"]
    map problemName (validateScene sphere {sceneBloom = 0.1}) `shouldBe` ["--bloom"]
    map
      problemName
      (validateScene lit {sceneCamera = (sceneCamera lit) {cameraFieldOfView = Degrees 180}})
      `shouldBe` ["--fov"]
    map
      problemName
      ( validateScene
          fisheye {sceneCamera = (sceneCamera fisheye) {cameraFieldOfView = Degrees 361}}
      )
      `shouldBe` ["--fov"]
    validateScene sphere `shouldBe` []
    validateScene fisheye `shouldBe` []
  where
    -- For each observer the scene in every projection, prepared once.
    projected =
      [ (,) observer $
          traverse
            tracer
            [ lit
                { sceneObserver = observer,
                  sceneProjection = projection,
                  sceneCamera = (sceneCamera lit) {cameraFieldOfView = Degrees fov}
                }
              | (projection, fov) <- [(Perspective, 90), (Fisheye, 180), (Equirectangular, 360)]
            ]
        | observer <- [minBound .. maxBound]
      ]
    problemName (Problem name _ _) = name
    problemName (Mistake name _) = name
    outside c r =
      let d v = abs (fromIntegral v + 0.5 - 32) - 2 :: Double in d c * d c + d r * d r > 32 * 32
    filmRadianceAt film (c, r) = filmRadiance film c r
    lightOf scene = do
      film <- exposeWhole oneWorker scene
      pure (\c r -> maybe (0 / 0) luminance (film >>= \f -> filmRadiance f c r))

-- | The radiance that arrives from a direction, by the point of the picture where it
-- is seen.
lightTowards :: Tracer -> XYZ -> Radiance
lightTowards traced direction = fromMaybe black $ do
  Frame forward right up <- cameraFrame (sceneCamera scene)
  let Picture width height = scenePicture scene
      Degrees fov = cameraFieldOfView (sceneCamera scene)
      pixels = fromIntegral width / (fov * pi / 180)
      f = XYZ.dot direction forward
      x = XYZ.dot direction right
      y = XYZ.dot direction up
      (px, py) = case sceneProjection scene of
        Fisheye ->
          let rho = sqrt (x * x + y * y); theta = atan2 rho f in (theta * x / rho, theta * y / rho)
        _ -> (atan2 x f, asin y)
  let point =
        XY (0.5 * fromIntegral width + pixels * px) (0.5 * fromIntegral height - pixels * py)
  pure (sightRadiance traced point)
  where
    scene = tracerScene traced

sameLight :: Radiance -> Radiance -> Property
sameLight (Radiance r g b) (Radiance r' g' b') =
  conjoin [closeTo 1e-6 (a + 1e-3) (a' + 1e-3) | (a, a') <- [(r, r'), (g, g'), (b, b')]]

-- | A sky that shows errors of direction.
lit :: Scene
lit =
  defaultScene
    { scenePicture = Picture 128 72,
      sceneBloom = 0,
      sceneDisk = Nothing,
      sceneSky = SkyGrid,
      sceneCamera = Camera (Around 12 (Degrees 80) (Degrees 90)) (Degrees 7) (Degrees 90),
      sceneSamples = 1,
      sceneNoise = 0
    }

-- | Smooth light without symmetry: an even sky is brighter ahead of an observer who
-- moves, here towards the upper left.
falling :: Scene
falling =
  sphere
    { sceneObserver = Falling,
      sceneSky = SkyUniform 1,
      sceneSamples = 4,
      sceneCamera = Camera (LookAt (XYZ 0 5 15) (XYZ 9 4 3)) (Degrees 7) (Degrees 360)
    }

sphere, fisheye :: Scene
sphere =
  lit
    { scenePicture = Picture 128 64,
      sceneProjection = Equirectangular,
      sceneCamera = (sceneCamera lit) {cameraFieldOfView = Degrees 360}
    }
fisheye =
  defaultScene
    { scenePicture = Picture 64 64,
      sceneProjection = Fisheye,
      sceneCamera = (sceneCamera defaultScene) {cameraFieldOfView = Degrees 180},
      sceneSky = SkyUniform 1
    }
