-- | Everything that determines a picture, in one record.
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
import BlackHole.Physics.Leapfrog
import BlackHole.Physics.LightPath (Region, emptyRegion)
import BlackHole.Physics.Observer (Observer)
import BlackHole.Physics.Spacetime (Spacetime)
import BlackHole.Scene.Camera (Camera, Picture)
import BlackHole.Scene.Disk
import BlackHole.Scene.Filter (Filter)
import BlackHole.Scene.Shifts (Shifts)
import BlackHole.Scene.Sky (Sky)
import Data.Word (Word64)

-- | A scene: equal scenes give equal bytes.
data Scene = Scene
  { scenePicture :: !Picture,
    sceneCamera :: !Camera,
    sceneObserver :: !Observer,
    sceneSpacetime :: !Spacetime,
    sceneIntegrator :: !Integrator,
    -- | The leapfrog's base length @l₀@ in Schwarzschild radii.
    sceneStep :: !Double,
    -- | The gas, if there is any.
    sceneDisk :: !(Maybe Disk),
    sceneSky :: !Sky,
    -- | The shifts of frequency that are shown.
    sceneShifts :: !Shifts,
    -- | Parity checks instead of gas and sky.
    sceneDebugTextures :: !Bool,
    -- | Rays per pixel.
    sceneSamples :: !Int,
    -- | The uncertainty of a pixel, as a part of white, beyond which it gets more
    -- rays than that; 0 for never.
    sceneNoise :: !Double,
    -- | The most rays that a pixel gets then.
    sceneMostSamples :: !Int,
    sceneFilter :: !Filter,
    sceneExposure :: !Exposure,
    sceneToneMap :: !ToneMap,
    -- | Whether codes of 8 bits are dithered.
    sceneDither :: !Dither,
    -- | The part of the light that the lens scatters, 0…1.
    sceneBloom :: !Double,
    -- | Seed of all noise and of the sampling.
    sceneSeed :: !Word64
  }
  deriving (Eq, Show)

-- | The ways to follow light.
data Integrator
  = -- | Along the closed form of the orbit, tabulated for the camera's place:
    -- the same to 1e-5 Schwarzschild radii.
    Tabulated
  | -- | Along the closed form itself, with finer steps through the gas.
    Exact
  | -- | The report's leapfrog.
    Leapfrogging
  deriving (Eq, Show, Read, Enum, Bounded)

-- | The name on the command line.
integratorName :: Integrator -> String
integratorName Tabulated = "table"
integratorName Exact = "exact"
integratorName Leapfrogging = "leapfrog"

-- | The leapfrog's settings. Its steps follow the thickness of the disk; with
-- no disk there is nothing to be fine for.
sceneLeapfrog :: Scene -> Leapfrog
sceneLeapfrog scene =
  defaultLeapfrog {leapfrogSteps = ReportSteps (sceneStep scene) thickness}
  where
    thickness = maybe 1e-9 diskThickness (sceneDisk scene)

-- | Where there can be gas; empty without a disk.
sceneRegion :: Scene -> Region
sceneRegion scene = maybe emptyRegion (diskRegion fineness) (sceneDisk scene)
  where
    fineness = case sceneIntegrator scene of
      Tabulated -> Swift
      Exact -> Fine
      Leapfrogging -> Fine

-- | The most rays that any pixel can get. A single one tells nothing about its
-- uncertainty.
mostSamples :: Scene -> Int
mostSamples scene
  | sceneNoise scene > 0 && sceneSamples scene > 1 = max (sceneSamples scene) (sceneMostSamples scene)
  | otherwise = sceneSamples scene
