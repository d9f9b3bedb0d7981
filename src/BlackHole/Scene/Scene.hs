-- | The record of everything that determines a picture.
module BlackHole.Scene.Scene
  ( Scene (..),
    Integrator (..),
    integratorName,
    sceneLeapfrog,
    sceneRegion,
    mostSamples,
  )
where

import BlackHole.Light.Display (Exposure, ToneMap)
import BlackHole.Light.Dither (Dither)
import BlackHole.Scene.Camera (Camera, Picture, Projection)
import BlackHole.Scene.Disk
import BlackHole.Scene.Filter (Filter)
import BlackHole.Scene.Shifts (Shifts)
import BlackHole.Scene.Sky (Sky)
import BlackHole.Spacetime.LightPath (Region, emptyRegion)
import BlackHole.Spacetime.Observer (Observer)
import BlackHole.Spacetime.Schwarzschild.Leapfrog
import BlackHole.Spacetime.Types (Spacetime)
import Data.Word (Word64)

-- | A scene. Equal scenes give equal bytes.
data Scene = Scene
  { scenePicture :: !Picture,
    sceneCamera :: !Camera,
    sceneProjection :: !Projection,
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
    -- | The fraction of the light that the lens scatters, 0 to 1.
    sceneBloom :: !Double,
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
  | sceneNoise scene > 0 && sceneSamples scene > 1 = max (sceneSamples scene) (sceneMostSamples scene)
  | otherwise = sceneSamples scene
