-- | Checks of rendered pictures: the size of the shadow, the uniformity of a uniform
-- sky, and independence of the number of workers.
module BlackHole.SelfTest.Picture
  ( pictureChecks,
  )
where

import BlackHole.Light.Radiance
import BlackHole.Numeric.Angle
import BlackHole.Numeric.Bisection (bisect)
import BlackHole.Render.Exposed
import BlackHole.Render.Film
import BlackHole.Render.PixelArray (toPixelVector)
import BlackHole.Render.Workers
import BlackHole.Scene.Camera
import BlackHole.Scene.Preset
import BlackHole.Scene.Scene
import BlackHole.Scene.Sky
import BlackHole.SelfTest.Check
import BlackHole.Spacetime.Observer (Observer (Static))
import BlackHole.Trace.Ray
import BlackHole.Trace.Tracer
import BlackHole.Vector.XY (XY (..))
import Data.Maybe (mapMaybe)
import qualified Data.Vector.Storable as Vector

-- | Renders five small pictures, in a tenth of a second on one core.
pictureChecks :: IO [Check]
pictureChecks = do
  shadows <- mapM shadowChecks [("3", 3, 120), ("6", 6, 60), ("20", 20, 20)]
  same <- workersCheck
  pure (concat shadows ++ [same])

-- | The shadow that an observer at rest sees against a uniform sky, compared with
-- Synge's formula sin²ψ = (27/4)(1−1/r)/r²: its edge along the middle row of the
-- picture to double precision, and the radius of a circle whose area is that of the
-- dark pixels. Also the sky's radiance, which no lens can change (Liouville's theorem):
-- everywhere outside the shadow it is (1−1/r)⁻² times that at infinity, in the film's
-- single precision.
--
-- A pixel is dark if its middle is. The squares of the dark pixels cover a disk smaller
-- by half a pixel's diagonal in radius and fit into one larger by half a diagonal,
-- which gives the limit.
shadowChecks :: (String, Double, Double) -> IO [Check]
shadowChecks (place, r, fieldOfView) = do
  exposed <- exposeFilm Nothing oneWorker (const (pure ())) scene (allRows (scenePicture scene))
  let pixels = maybe [] (allPixels . exposedLight) exposed
      dark = length (filter (== black) pixels)
      circle = sqrt (fromIntegral dark / pi) :: Double
      unevenness
        | null pixels = 0 / 0
        | otherwise =
          maximum
            (0 : [abs (v / uniform - 1) | Radiance v _ _ <- filter (/= black) pixels])
  pure
    [ Check
        ("shadow radius at r = " ++ place ++ ", edge in the picture's row (rad)")
        edge
        synge
        1e-9,
      Check
        ("shadow radius at r = " ++ place ++ ", dark area of the picture (rad)")
        (angleOf circle)
        synge
        (angleOf (reach + sqrt 0.5) - synge),
      Check ("uniform sky at r = " ++ place ++ ", greatest relative deviation") unevenness 0 1e-6
    ]
  where
    scene = shadowScene r fieldOfView
    synge = asin (sqrt (6.75 * (1 - 1 / r)) / r)
    uniform = (1 - 1 / r) ** (-2)
    scale = tan (0.5 * fieldOfView * pi / 180) / middle
    angleOf distance = atan (scale * distance)
    reach = tan synge / scale
    edge = case tracer scene of
      Nothing -> 0 / 0
      Just traced ->
        angleOf
          (bisect (\d -> sightRadiance traced (XY (middle + d) middle) == black) 0 middle)
    middle = 0.5 * fromIntegral side
    allPixels film =
      mapMaybe
        (uncurry (filmRadiance film))
        [(x, y) | y <- [0 .. side - 1], x <- [0 .. side - 1]]

-- | The width and height of the shadow's pictures in pixels.
side :: Int
side = 96

-- | A uniform sky with a hole in the middle and no gas.
shadowScene :: Double -> Double -> Scene
shadowScene r fieldOfView =
  defaultScene
    { scenePicture = Picture side side,
      sceneCamera =
        Camera
          { cameraPose = Around r (Degrees 60) (Degrees 90),
            cameraRoll = Degrees 0,
            cameraFieldOfView = Degrees fieldOfView
          },
      sceneObserver = Static,
      sceneDisk = Nothing,
      sceneSky = SkyUniform 1,
      sceneSamples = 1,
      sceneNoise = 0
    }

-- | The codes of the default scene's pixels do not depend on the number of workers.
workersCheck :: IO Check
workersCheck = do
  one <- codes oneWorker
  two <- maybe (pure []) codes (workersFromCount 2)
  let differing = length (filter id (zipWith (/=) one two)) + abs (length one - length two)
      value
        | null one = 0 / 0
        | otherwise = fromIntegral differing
  pure (Check "one worker or two, differing bytes" value 0 0)
  where
    scene = defaultScene {scenePicture = Picture 16 9, sceneSamples = 1, sceneNoise = 0}
    codes workers = withWorkers workers $ do
      exposed <- exposeFilm Nothing workers (const (pure ())) scene (allRows (scenePicture scene))
      case exposed of
        Nothing -> pure []
        Just (Exposed film _) ->
          Vector.toList . toPixelVector
            <$> developFilm workers (sceneDevelopment scene) film
