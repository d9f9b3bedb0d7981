module BlackHole.Render.RingFilmSpec (spec) where

import BlackHole.Light.Radiance
import BlackHole.Numeric.Angle
import BlackHole.Render.Exposed
import BlackHole.Render.Workers
import BlackHole.Scene.Camera
import BlackHole.Scene.Disk
import BlackHole.Scene.Filter
import BlackHole.Scene.Preset
import BlackHole.Scene.Scene
import BlackHole.Scene.Sky
import qualified BlackHole.Vector.XYZ as XYZ
import Control.Monad (forM_)
import Support.Exposing
import Test.Hspec

-- The thin ring at the edge of the shadow, a third of a pixel wide, of smooth gas seen
-- from above its pole: as bright all around.
spec :: Spec
spec = beforeAll (ring (above 30)) $ do
  it "has an even photon ring with the default's samples" $ \light -> do
    -- It was 0.24, and the brightest place 4 times as bright as the darkest.
    spread light `shouldSatisfy` (< 0.06)
    maximum light / minimum light `shouldSatisfy` (< 1.5)
  it "keeps the ring's light with every filter: its mean is that of many samples everywhere" $ \_ ->
    forM_ [minBound .. maxBound] $ \kind -> do
      -- Without adaptive sampling no pixel is treated as one on the ring.
      few <- ring (above 30) {sceneFilter = kind}
      many <- ring (above 30) {sceneFilter = kind, sceneSamples = 64, sceneNoise = 0}
      (mean few / mean many) `shouldSatisfy` (\q -> abs (q - 1) < 0.05)
  it "has a photon ring that does not crawl while the camera moves" $ \light -> do
    frames <- (light :) <$> mapM (ring . above) [30.1, 30.2]
    let changes =
          [ (b - a) / mean (concat frames)
            | (f, f') <- zip frames (drop 1 frames),
              (a, b) <- zip f f'
          ]
    -- Root mean square; it was 0.37.
    sqrt (mean (map (^ (2 :: Int)) changes)) `shouldSatisfy` (< 0.1)

spread :: [Double] -> Double
spread values = sqrt (mean [(v - m) * (v - m) | v <- values]) / m
  where
    m = mean values

mean :: [Double] -> Double
mean values = sum values / fromIntegral (length values)

-- | From a distance, with pixels of 1/512 radian.
above :: Double -> Scene
above distance =
  defaultScene
    { scenePicture = Picture 100 100,
      sceneCamera =
        Camera
          (Around distance (Degrees 0) (Degrees 90))
          (Degrees 0)
          (Degrees (2 * atan (50 / 512) * 180 / pi)),
      sceneSky = SkyNone,
      sceneDisk =
        Just
          reportDisk
            { diskInnerRadius = 3,
              diskOuterRadius = 16,
              diskFade = 0.62,
              diskThickness = 0.35,
              diskProfile = ConstantOpening,
              diskOpacity = 1.2,
              diskBrightness = 1.3,
              diskColour = BlackBody 4500,
              diskArms = 0,
              diskTurbulence = 0
            },
      sceneSamples = 4,
      sceneNoise = 0.02,
      sceneMostSamples = 64,
      sceneFilter = Gaussian
    }

-- | The light across the ring, within 1.5 pixels of the edge of the shadow (Synge 1966),
-- at 720 places around it.
ring :: Scene -> IO [Double]
ring scene = do
  film <- exposeWhole oneWorker scene
  let at x y = maybe (0 / 0) luminance (film >>= \f -> filmRadiance f x y)
      -- Between the middles of four pixels.
      between x y =
        let i = floor (x - 0.5) :: Int
            j = floor (y - 0.5) :: Int
            u = x - 0.5 - fromIntegral i
            v = y - 0.5 - fromIntegral j
         in (1 - v) * ((1 - u) * at i j + u * at (i + 1) j)
              + v * ((1 - u) * at i (j + 1) + u * at (i + 1) (j + 1))
  pure
    [ 0.25
        * sum
          [ between (50 + (edge + 0.25 * d) * cos angle) (50 + (edge + 0.25 * d) * sin angle)
            | d <- [-6 .. 6]
          ]
      | k <- [0 .. 719 :: Int],
        let angle = 2 * pi * fromIntegral k / 720
    ]
  where
    distance = XYZ.norm (posePosition (cameraPose (sceneCamera scene)))
    edge = 512 * tan (asin (sqrt (6.75 * (1 - 1 / distance)) / distance))
