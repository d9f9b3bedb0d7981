-- | The record of everything that determines a picture.
module BlackHole.Scene.Scene
  ( Scene (..),
    Integrator (..),
    integratorName,
    sceneLeapfrog,
    sceneDevelopment,
    scaleBarPixels,
    sceneRegion,
    mostSamples,
    isAdaptive,
  )
where

import BlackHole.Light.Display (Development (..), Exposure, ToneMap)
import BlackHole.Light.Dither (Dither)
import BlackHole.Light.Grain (Grain (..))
import BlackHole.Scene.Camera
  ( Camera (cameraPose),
    Picture (..),
    Projection,
    pixelAngle,
    posePosition,
  )
import BlackHole.Scene.Disk
import BlackHole.Scene.Filter (Filter)
import BlackHole.Scene.Shifts (Shifts)
import BlackHole.Scene.Sky (Sky)
import BlackHole.Spacetime.Observer (Observer)
import BlackHole.Spacetime.Region (Region, emptyRegion)
import BlackHole.Spacetime.Schwarzschild.StepRule
import BlackHole.Spacetime.Types (Spacetime)
import qualified BlackHole.Vector.XYZ as XYZ
import Data.Word (Word64)

-- | A scene. Equal scenes give equal bytes.
data Scene = Scene
  { scenePicture :: !Picture,
    sceneCamera :: !Camera,
    sceneProjection :: !Projection,
    -- | The diameter of the lens in Schwarzschild radii, 0 for a pinhole, and the
    -- distance from the camera at which it is in focus.
    sceneAperture :: !Double,
    sceneFocus :: !Double,
    sceneObserver :: !Observer,
    sceneSpacetime :: !Spacetime,
    sceneIntegrator :: !Integrator,
    -- | The base length @l₀@ of the leapfrog in Schwarzschild radii.
    sceneStep :: !Double,
    -- | The gas, if there is any.
    sceneDisk :: !(Maybe Disk),
    sceneSky :: !Sky,
    -- | The frequency shifts that are shown.
    sceneShifts :: !Shifts,
    -- | Checkerboards instead of gas and sky.
    sceneDebugTextures :: !Bool,
    -- | Rays per pixel.
    sceneSamples :: !Int,
    -- | The uncertainty of a pixel, as a fraction of display white, above which it gets
    -- more rays; 0 turns this off.
    sceneNoise :: !Double,
    -- | The most rays that such a pixel gets.
    sceneMostSamples :: !Int,
    sceneFilter :: !Filter,
    sceneExposure :: !Exposure,
    sceneToneMap :: !ToneMap,
    -- | Whether 8-bit codes are dithered.
    sceneDither :: !Dither,
    -- | The full width at half maximum, in degrees, of the Gaussian that blurs the
    -- picture; 0 for none.
    sceneBeam :: !Double,
    -- | The fraction of the light that the lens scatters, 0 to 1.
    sceneBloom :: !Double,
    -- | The number of straight edges of the aperture that make diffraction spikes; 0 for
    -- none.
    sceneSpikes :: !Int,
    -- | The fraction of the light in the spikes, 0 to 1.
    sceneSpikeLight :: !Double,
    -- | The diameter, in thousandths of the picture's width, of the dots of ink that the
    -- picture is made of; 0 for continuous tones.
    sceneGrain :: !Double,
    -- | The length of the scale bar in Schwarzschild radii; 0 for none.
    sceneScaleBar :: !Double,
    -- | The seed of all noise and of the sampling.
    sceneSeed :: !Word64
  }
  deriving (Eq, Show)

-- | The ways to compute light paths.
data Integrator
  = -- | Along the closed form of the orbit, tabulated for the camera's position, within
    -- 1e-5 Schwarzschild radii of it.
    Tabulated
  | -- | Along the closed form itself, with finer steps through the gas.
    Exact
  | -- | With the leapfrog of the design report (Will Yager, "Accurately Rendering a
    -- Black Hole").
    Leapfrogging
  deriving (Eq, Show, Read, Enum, Bounded)

-- | The integrator's name on the command line.
integratorName :: Integrator -> String
integratorName Tabulated = "table"
integratorName Exact = "exact"
integratorName Leapfrogging = "leapfrog"

-- | The settings of the leapfrog. Its steps follow the thickness of the disk; without a
-- disk no fine steps are needed.
sceneLeapfrog :: Scene -> Leapfrog
sceneLeapfrog scene =
  defaultLeapfrog {leapfrogSteps = ReportSteps (sceneStep scene) thickness}
  where
    thickness = maybe 1e-9 diskThickness (sceneDisk scene)

-- | The region in which there can be gas; empty without a disk.
sceneRegion :: Scene -> Region
sceneRegion scene = maybe emptyRegion (diskRegion fineness) (sceneDisk scene)
  where
    fineness = case sceneIntegrator scene of
      Tabulated -> Swift
      Exact -> Fine
      Leapfrogging -> Fine

-- | The most rays that any pixel can get. A single ray says nothing about a pixel's
-- uncertainty.
mostSamples :: Scene -> Int
mostSamples scene
  | sceneNoise scene > 0 = max (sceneSamples scene) (sceneMostSamples scene)
  | otherwise = sceneSamples scene

-- | Whether pixels get as many rays as they need, and not all the same number.
isAdaptive :: Scene -> Bool
isAdaptive scene = mostSamples scene > sceneSamples scene

-- | How the scene's light is developed for a display.
sceneDevelopment :: Scene -> Development
sceneDevelopment scene =
  Development
    { developmentExposure = sceneExposure scene,
      developmentToneMap = sceneToneMap scene,
      developmentGrain =
        Grain
          (0.001 * sceneGrain scene * fromIntegral (pictureWidth (scenePicture scene)))
          (sceneSeed scene),
      developmentDither = sceneDither scene
    }

-- | The length of the scale bar in pixels: of a rod beside the hole, seen in the middle of
-- the picture through flat space.
scaleBarPixels :: Scene -> Double
scaleBarPixels scene =
  sceneScaleBar scene
    / ( XYZ.norm (posePosition (cameraPose (sceneCamera scene)))
          * pixelAngle (sceneProjection scene) (sceneCamera scene) (scenePicture scene)
      )
