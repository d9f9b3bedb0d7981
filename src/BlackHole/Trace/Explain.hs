{-# LANGUAGE BangPatterns #-}

-- | An explanation of a pixel: all intermediate numbers between its position in the
-- picture and its colour, from the functions that render it.
module BlackHole.Trace.Explain
  ( Explanation (..),
    Sighting (..),
    Arrival (..),
    opticalDepth,
    Shown (..),
    explainPixel,
    gatheredAlong,
    shownAs,
  )
where

import BlackHole.Light.Display
import BlackHole.Light.Radiance
import BlackHole.Matter.GasFlow (gasFlow)
import BlackHole.Matter.Redshift
import BlackHole.Scene.Camera (Picture (..), pixelMiddle)
import BlackHole.Scene.Scene
import BlackHole.Spacetime.Fate (Fate)
import BlackHole.Spacetime.Follow (planeCrossings)
import BlackHole.Spacetime.LightPath
import BlackHole.Spacetime.Observer (Constants, SightLine, sightConstants, sightFrequency)
import BlackHole.Spacetime.PlaneCrossing (PlaneCrossing)
import BlackHole.Trace.Adaptive
import BlackHole.Trace.Gas
import BlackHole.Trace.Ray
import BlackHole.Trace.Sampling (Sample (..))
import BlackHole.Trace.SkyLight (SkyPatch, sharedSky)
import BlackHole.Trace.Tracer
import BlackHole.Vector.XY (XY (..))
import BlackHole.Vector.XYZ (XYZ)
import Data.Word (Word8)

-- | Everything about one pixel.
data Explanation = Explanation
  { -- | Column and row, counted from 0 at the top left.
    explainedPixel :: !(Int, Int),
    -- | The line of sight through the middle of the pixel.
    explainedMiddle :: !Sighting,
    -- | The radiance that the first rays of the pixel and its neighbours give, if it
    -- counts: as much as 'sharedWorth' samples.
    explainedShared :: !(Maybe Radiance),
    -- | The lines of sight that the renderer traces for this pixel alone.
    explainedSamples :: ![Sighting],
    -- | The mean of both, which is the pixel's radiance on the film.
    explainedRadiance :: !Radiance,
    explainedShown :: !Shown
  }
  deriving (Eq, Show)

-- | One line of sight.
data Sighting = Sighting
  { -- | The point of the picture that it passes through, in pixels.
    sightingPoint :: !XY,
    -- | Its weight among a pixel's samples; 1 for the middle.
    sightingWeight :: !Double,
    -- | Its direction in the observer's frame, of unit length; 'Nothing' outside a
    -- fisheye's circle.
    sightingDirection :: !(Maybe XYZ),
    -- | 'Nothing' if no light arrives from outside ('BlackHole.Spacetime.Observer.sightLine').
    sightingArrival :: !(Maybe Arrival),
    -- | The radiance seen along it, 'sightRadiance'.
    sightingRadiance :: !Radiance
  }
  deriving (Eq, Show)

-- | The light that arrives along a line of sight, followed backwards.
data Arrival = Arrival
  { arrivalConstants :: !Constants,
    -- | The observer's frequency over the frequency at infinity.
    arrivalFrequency :: !Double,
    arrivalFate :: !(Fate XYZ),
    -- | With the shift of gas there, outside the horizon.
    arrivalCrossings :: ![PlaneCrossing (Maybe Redshift)],
    -- | Number of steps of the integrator.
    arrivalSteps :: !Int,
    -- | Number of path segments that contained gas.
    arrivalGasSamples :: !Int,
    -- | The fraction of the light from behind the gas that gets through.
    arrivalTransmittance :: !Double,
    -- | Radiance of the gas as it reaches the camera.
    arrivalGas :: !Radiance,
    -- | Radiance of the sky before it passes the gas.
    arrivalSky :: !Radiance
  }
  deriving (Eq, Show)

-- | The optical depth of the gas along the path: −ln of the transmittance, at least 0,
-- infinite if nothing gets through.
opticalDepth :: Arrival -> Double
opticalDepth light = negate (log (arrivalTransmittance light)) + 0

-- | The steps by which a display shows radiance.
data Shown = Shown
  { shownExposed :: !Radiance,
    -- | Linear, with each component in 0 to 1.
    shownToneMapped :: !Radiance,
    -- | 8-bit sRGB, without bloom, which needs the rest of the picture.
    shownCodes :: !(Word8, Word8, Word8)
  }
  deriving (Eq, Show)

-- | The explanation of the pixel in a column and a row, both from 0 at the top
-- left; 'Nothing' outside the picture. It costs about three times as much as
-- rendering the pixel.
explainPixel :: Tracer -> Int -> Int -> Maybe Explanation
explainPixel traced column row
  | column < 0 || row < 0 || column >= width || row >= height = Nothing
  | otherwise =
    Just
      Explanation
        { explainedPixel = (column, row),
          explainedMiddle =
            sighting scene traced Nothing (pixelMiddle column row),
          explainedShared = originShared origin,
          explainedSamples =
            [ (sighting scene traced (originSky origin) place) {sightingWeight = weight}
              | Sample place weight <- originSamples origin
            ],
          explainedRadiance = radiance,
          explainedShown = shownAs scene column row radiance
        }
  where
    scene = tracerScene traced
    Picture width height = scenePicture scene
    origin = pixelOrigin traced column row
    radiance = pixelRadiance (singlePixel traced column row)

sighting :: Scene -> Tracer -> Maybe SkyPatch -> XY -> Sighting
sighting scene traced shared point =
  Sighting
    { sightingPoint = point,
      sightingWeight = 1,
      sightingDirection = tracedDirection lensed point,
      sightingArrival = arrival scene lensed shared point <$> tracedSight lensed point,
      sightingRadiance = sharingRadiance traced shared point
    }
  where
    lensed = throughLens traced point

-- | The gathered light, and the number of segments that contributed to it.
data Counted = Counted !Int !Gathered

-- | The fate of a line of sight, the number of integrator steps, and the number of
-- segments with gas, for the ray through this point of the picture as the renderer
-- traces it.
gatheredAlong :: Tracer -> XY -> SightLine -> (Fate XYZ, Int, Int)
gatheredAlong traced point sight = case counted traced point sight of
  Followed fate (Counted samples _) steps -> (fate, steps, samples)

arrival :: Scene -> Tracer -> Maybe SkyPatch -> XY -> SightLine -> Arrival
arrival scene traced shared point sight =
  case counted traced point sight of
    Followed fate (Counted samples (Gathered light transmittance)) steps ->
      Arrival
        { arrivalConstants = sightConstants sight,
          arrivalFrequency = sightFrequency sight,
          arrivalFate = fate,
          arrivalCrossings =
            [ crossingRedshift (gasFlow (sceneSpacetime scene)) sight crossing <$ crossing
              | crossing <- planeCrossings (tracerPaths traced) sight
            ],
          arrivalSteps = steps,
          arrivalGasSamples = samples,
          arrivalTransmittance = transmittance,
          arrivalGas = light,
          arrivalSky = sharedSky traced shared point sight fate
        }

counted :: Tracer -> XY -> SightLine -> Followed Counted
counted traced point sight = followSight traced point sight count (Counted 0 nothingYet)
  where
    !shade = tracedGas traced sight
    count (Counted n before) segment = case shade before segment of
      Continue after -> Continue (Counted (n + added before after) after)
      Stop after -> Stop (Counted (n + added before after) after)
    added (Gathered light transmittance) (Gathered light' transmittance')
      | light == light' && transmittance == transmittance' = 0
      | otherwise = 1

-- | The steps from radiance to codes, including the film's single precision.
shownAs :: Scene -> Int -> Int -> Radiance -> Shown
shownAs scene column row radiance =
  Shown
    { shownExposed = exposed,
      shownToneMapped = applyToneMap (sceneToneMap scene) exposed,
      shownCodes = displayCode (developer (sceneDevelopment scene)) column row onFilm
    }
  where
    onFilm = mapRadiance single radiance
    exposed = expose (sceneExposure scene) onFilm
    single v = realToFrac (realToFrac v :: Float)
