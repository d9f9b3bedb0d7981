{-# LANGUAGE BangPatterns #-}

-- | From a scene and a pixel to its radiance: one pure function.
module BlackHole.Trace.Pixel
  ( Tracer,
    tracer,
    pixelRadiance,
    sightRadiance,
    samplePoint,

    -- * Its parts
    tracedDirection,
    tracedSight,
    tracedGas,
    tracedSky,
    followSight,
  )
where

import BlackHole.Light.Radiance
import BlackHole.Noise.SipHash
import BlackHole.Physics.ExactPath
import BlackHole.Physics.Fate
import BlackHole.Physics.Leapfrog
import BlackHole.Physics.LightPath
import BlackHole.Physics.Observer
import BlackHole.Physics.Spacetime (Spacetime (..))
import BlackHole.Scene.Camera
import BlackHole.Scene.Scene
import BlackHole.Scene.Shifts (skyShift)
import BlackHole.Trace.Gas
import BlackHole.Trace.Sky
import BlackHole.Vector.XY (XY (..))
import BlackHole.Vector.XYZ (XYZ)
import qualified BlackHole.Vector.XYZ as XYZ
import Data.Bits (shiftR, (.&.))

-- | A scene made ready: what all pixels share, worked out once.
data Tracer = Tracer
  { tracerSight :: !(XY -> XYZ),
    tracerScene :: !Scene,
    tracerGas :: !(Double -> GasShader),
    tracerFollow :: !(SightLine -> Followed Gathered),
    tracerSky :: !(Double -> XYZ -> Radiance)
  }

-- | Make a scene ready. 'Nothing' if its camera looks nowhere
-- ('cameraFrame'); a validated scene has none of that.
tracer :: Scene -> Maybe Tracer
tracer scene = do
  frame <- cameraFrame (sceneCamera scene)
  pure
    Tracer
      { tracerSight = sightDirection (sceneCamera scene) (scenePicture scene) frame,
        tracerScene = scene,
        tracerGas = gas,
        tracerFollow = \sight -> followSight scene sight (gas (sightFrequency sight)) nothingYet,
        tracerSky = sky
      }
  where
    seed = sceneSeed scene
    sky
      | sceneDebugTextures scene = const gridRadiance
      | otherwise = skyShader seed (sceneSky scene)
    gas = case sceneDisk scene of
      Nothing -> \_ gathered _ -> Onward gathered
      Just disk
        | sceneDebugTextures scene -> const (parityShader disk)
        | otherwise -> gasShader seed (sceneShifts scene) disk

-- | Follow a line of sight through a scene by the scene's own integrator and
-- hand the stretches that lie where there can be gas to the gatherer.
followSight :: Scene -> SightLine -> (a -> Stretch -> Onward a) -> a -> Followed a
followSight scene = case sceneIntegrator scene of
  Exact -> followExact space region . sightPhoton
  Leapfrogging -> followLeapfrog (sceneLeapfrog scene) space region . sightPhoton
  where
    space = sceneSpacetime scene
    region = sceneRegion scene
{-# INLINE followSight #-}

-- | Mean radiance of a pixel (column and row from the top left, from 0) over
-- its samples. Depends on the scene and the pixel alone.
pixelRadiance :: Tracer -> Int -> Int -> Radiance
pixelRadiance traced column row = go 0 black
  where
    !count = sceneSamples (tracerScene traced)
    go !index !total
      | index < count =
        go (index + 1) (total <+> sightRadiance traced (samplePoint (tracerScene traced) column row index))
      | otherwise = scaleRadiance (1 / fromIntegral count) total

-- | Radiance that arrives at one point of the picture (pixels from the top
-- left corner).
sightRadiance :: Tracer -> XY -> Radiance
sightRadiance traced point = case tracedSight traced point of
  Nothing -> black
  Just sight -> case tracerFollow traced sight of
    Followed fate (Gathered light transmittance) _ ->
      light <+> scaleRadiance transmittance (tracedSky traced sight fate)

-- | The direction of sight through a point of the picture.
tracedDirection :: Tracer -> XY -> XYZ
tracedDirection = tracerSight

-- | The light path that arrives at a point of the picture; 'Nothing' where it
-- is dark because none does ('sightLine').
tracedSight :: Tracer -> XY -> Maybe SightLine
tracedSight traced =
  sightLine (sceneSpacetime scene) (sceneObserver scene) (tracedPlace traced) . tracerSight traced
  where
    scene = tracerScene traced

-- | The shader of the scene's gas, by the observer's frequency.
tracedGas :: Tracer -> Double -> GasShader
tracedGas = tracerGas

-- | What the sky sends to the end of a line of sight, with no gas in between.
tracedSky :: Tracer -> SightLine -> Fate -> Radiance
tracedSky traced sight fate = case fate of
  Escaped direction -> tracerSky traced (g (sightFrequency sight)) direction
  Captured -> black
  Opaque -> black
  StepLimit -> black
  where
    scene = tracerScene traced
    g = case sceneSpacetime scene of
      Flat -> const 1
      Schwarzschild -> skyShift (sceneShifts scene) (XYZ.norm (tracedPlace traced))

-- | Where the camera stands.
tracedPlace :: Tracer -> XYZ
tracedPlace = posePosition . cameraPose . sceneCamera . tracerScene

-- | Where in its pixel a sample is taken. A single one sits in the middle;
-- several are jittered within the cells of a grid, hashed from the seed, the
-- pixel and the sample's index alone.
samplePoint :: Scene -> Int -> Int -> Int -> XY
samplePoint scene column row index
  | count == 1 = XY (fromIntegral column + 0.5) (fromIntegral row + 0.5)
  | otherwise = XY (along column i columns jitterX) (along row j rows jitterY)
  where
    count = sceneSamples scene
    -- The grid closest to square whose cells are as many as the samples.
    columns = last [n | n <- [1 .. count], n * n <= count, count `rem` n == 0]
    rows = count `quot` columns
    (j, i) = index `quotRem` columns
    along pixel cell cells jitter =
      fromIntegral pixel + (fromIntegral cell + jitter) / fromIntegral cells
    hash =
      sipHash3
        (SipKey (sceneSeed scene) 0x73616d706c65)
        (fromIntegral column)
        (fromIntegral row)
        (fromIntegral index)
    jitterX = fromIntegral (hash `shiftR` 32) / 4294967296
    jitterY = fromIntegral (hash .&. 0xffffffff) / 4294967296 :: Double
