-- | Scenes that come with the program.
module BlackHole.Scene.Preset
  ( presets,
    presetNames,
    findPreset,
    describePreset,
    defaultScene,
    reportScene,
  )
where

import BlackHole.Light.Display (Exposure (..), ToneMap (..))
import BlackHole.Light.Dither (Dither (..))
import BlackHole.Physics.Angle (Degrees (..))
import BlackHole.Physics.Observer (Observer (..))
import BlackHole.Physics.Spacetime (Spacetime (..))
import BlackHole.Scene.Camera
import BlackHole.Scene.Disk
import BlackHole.Scene.Filter (Filter (..))
import BlackHole.Scene.Scene
import BlackHole.Scene.Shifts (Shifts (..))
import BlackHole.Scene.Sky
import BlackHole.Vector.XYZ (XYZ (..))

-- | Every preset with its name, the default first.
presets :: [(String, Scene)]
presets = [("default", defaultScene), ("report", reportScene)]

-- | The names, the default first.
presetNames :: [String]
presetNames = map fst presets

-- | A preset by its name.
findPreset :: String -> Maybe Scene
findPreset name = lookup name presets

-- | What a preset is, in one line; empty for a name that there is not.
describePreset :: String -> String
describePreset name = case name of
  "default" -> "a wide disk of glowing gas, seen from a little above its plane by somebody at rest"
  "report" -> "the picture of the design report: its camera, gas, stars and steps"
  _ -> ""

-- | A wide disk seen from a little above its plane by somebody at rest.
defaultScene :: Scene
defaultScene =
  Scene
    { scenePicture = Picture 1920 1080,
      sceneCamera =
        Camera
          { cameraPose = Around 30 (Degrees 82) (Degrees 90),
            cameraRoll = Degrees (-12),
            cameraFieldOfView = Degrees 50
          },
      sceneObserver = Static,
      sceneSpacetime = Schwarzschild,
      sceneIntegrator = Tabulated,
      sceneStep = 0.1,
      sceneDisk = Just defaultDisk,
      sceneSky = SkyNoise defaultStars,
      sceneShifts = Shifts True True,
      sceneDebugTextures = False,
      sceneSamples = 4,
      sceneNoise = 0.02,
      sceneMostSamples = 64,
      sceneFilter = Gaussian,
      sceneExposure = Exposure 0,
      sceneToneMap = ToneFilm,
      sceneDither = BlueNoise,
      sceneBloom = 0,
      sceneSeed = 0
    }

-- | The picture of the report's author: its camera, gas, stars and steps.
-- Its picture plane is one unit high at unit distance, so at 16:9 the field of
-- view is 2·atan(8/9) across the width.
reportScene :: Scene
reportScene =
  defaultScene
    { scenePicture = Picture 1280 720,
      sceneCamera =
        Camera
          { cameraPose = LookAt (XYZ 0 5 25) (XYZ 0 0 0),
            cameraRoll = Degrees 0,
            cameraFieldOfView = Degrees 83.2674
          },
      sceneObserver = Coordinate,
      sceneIntegrator = Leapfrogging,
      sceneDisk = Just reportDisk,
      sceneSky = SkyNoise reportStars,
      sceneSamples = 1,
      sceneNoise = 0,
      sceneFilter = Box,
      sceneExposure = Exposure (-1.2),
      sceneToneMap = ToneNone,
      sceneDither = NoDither
    }
