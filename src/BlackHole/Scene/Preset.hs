-- | Scenes that come with the program.
module BlackHole.Scene.Preset
  ( presets,
    presetNames,
    findPreset,
    Preset (..),
    describedPresets,
    defaultScene,
    reportScene,
  )
where

import BlackHole.Light.Display (Exposure (..), ToneMap (..))
import BlackHole.Light.Dither (Dither (..))
import BlackHole.Numeric.Angle (Degrees (..))
import BlackHole.Scene.Camera
import BlackHole.Scene.Disk
import BlackHole.Scene.Filter (Filter (..))
import BlackHole.Scene.Scene
import BlackHole.Scene.Shifts (Shifts (..))
import BlackHole.Scene.Sky
import BlackHole.Spacetime.Kerr.Landmarks (Handedness (RightHanded), iscoRadius, spin)
import BlackHole.Spacetime.Observer (Observer (..))
import BlackHole.Spacetime.Types (Spacetime (..))
import BlackHole.Vector.XYZ (XYZ (..))

-- | Every preset with its name, the default first.
presets :: [(String, Scene)]
presets = [(presetName p, presetScene p) | p <- describedPresets]

-- | A preset with what it shows, in one line.
data Preset = Preset
  { presetName :: !String,
    presetShows :: !String,
    presetScene :: !Scene
  }

-- | All of them, the default first.
describedPresets :: [Preset]
describedPresets =
  [ Preset "default" "a wide disk of glowing gas, seen by an observer at rest above its plane" defaultScene,
    Preset "report" "the picture of the design report, with its observer, gas, stars and leapfrog integration" reportScene,
    Preset "interstellar" "the look of the film Interstellar (2014): a thin bright disk without Doppler shift or redshift" interstellarScene,
    Preset "edge-on" "the disk seen from within a degree of its plane" (seenFrom 89 40 defaultScene),
    Preset "face-on" "the disk seen from near its pole" (seenFrom 12 56 defaultScene),
    Preset "luminet" "Luminet's picture of 1979: a thin opaque disk, its intensity over all wavelengths, without colour" luminetScene,
    Preset "lens-only" "no disk, only the sky distorted by the hole" defaultScene {sceneDisk = Nothing, sceneSky = SkyStars realSky {realSkyRotation = Degrees (-6), realSkyMilkyWay = 3}, sceneExposure = Exposure 2.5},
    Preset "photon-ring" "a close-up of the rings formed by light that has gone around the hole" photonRingScene,
    Preset "falling" "the view of an observer falling into the hole, at r = 2.6" fallingScene,
    Preset "kerr" "a hole that rotates almost as fast as possible, seen from close to the plane of its disk: a shadow like the letter D" kerrScene
  ]

-- | The names, the default first.
presetNames :: [String]
presetNames = map fst presets

-- | A preset by its name.
findPreset :: String -> Maybe Scene
findPreset name = lookup name presets

-- | The default's distance, from another angle to the disk's axis and with another
-- field of view, both in degrees.
seenFrom :: Double -> Double -> Scene -> Scene
seenFrom inclination fieldOfView scene =
  scene
    { sceneCamera =
        (sceneCamera scene)
          { cameraPose = Around 50 (Degrees inclination) (Degrees 90),
            cameraRoll = Degrees 0,
            cameraFieldOfView = Degrees fieldOfView
          }
    }

interstellarScene :: Scene
interstellarScene =
  defaultScene
    { sceneCamera = Camera (Around 50 (Degrees 86) (Degrees 90)) (Degrees (-4)) (Degrees 40),
      sceneDisk =
        Just
          defaultDisk
            { diskThickness = 0.1,
              diskBrightness = 1.3,
              diskArms = 0,
              diskTurbulenceFrequency = 18,
              diskColour = BlackBody 3200
            },
      sceneShifts = Shifts False False,
      sceneBloom = 0.05
    }

luminetScene :: Scene
luminetScene =
  defaultScene
    { sceneCamera = Camera (Around 60 (Degrees 80) (Degrees 90)) (Degrees 0) (Degrees 42),
      sceneDisk =
        Just
          defaultDisk
            { diskOuterRadius = 20,
              diskFade = 0.9,
              diskThickness = 0.05,
              diskOpacity = 40,
              diskBrightness = 1,
              diskArms = 0,
              diskTurbulence = 0,
              diskHaze = 0,
              diskColour = Bolometric
            },
      sceneBloom = 0,
      sceneSky = SkyNone
    }

photonRingScene :: Scene
photonRingScene =
  defaultScene
    { sceneCamera = Camera (LookAt (XYZ 0 5.2 29.5) (XYZ 0 1.3 0)) (Degrees 0) (Degrees 13)
    }

fallingScene :: Scene
fallingScene =
  defaultScene
    { sceneCamera = Camera (LookAt (XYZ 0 0.9 2.4392622) (XYZ 0 0.2 0)) (Degrees 10) (Degrees 110),
      sceneObserver = Falling,
      sceneExposure = Exposure (-3)
    }

kerrScene :: Scene
kerrScene = maybe defaultScene around (spin 0.998)
  where
    around hole =
      defaultScene
        { sceneCamera = Camera (Around 40 (Degrees 86) (Degrees 90)) (Degrees 0) (Degrees 30),
          sceneSpacetime = Kerr hole,
          -- The gas is hottest in a narrow ring; as bright as the default's it would leave
          -- the rest of the disk dark.
          sceneDisk = Just defaultDisk {diskInnerRadius = iscoRadius RightHanded hole, diskOuterRadius = 11, diskBrightness = 3.5, diskColour = BlackBody 4800}
        }

-- | A wide disk seen from above its plane by an observer at rest. All of it is in the
-- frame, also at a field of view of 40 degrees.
defaultScene :: Scene
defaultScene =
  Scene
    { scenePicture = Picture 1920 1080,
      sceneCamera =
        Camera
          { cameraPose = Around 54 (Degrees 77) (Degrees 90),
            cameraRoll = Degrees (-8),
            cameraFieldOfView = Degrees 40
          },
      sceneProjection = Perspective,
      sceneObserver = Static,
      sceneSpacetime = Schwarzschild,
      sceneIntegrator = Tabulated,
      sceneStep = 0.1,
      sceneDisk = Just defaultDisk,
      -- A Milky Way that can be seen beside the glowing gas.
      sceneSky = SkyStars realSky {realSkyMilkyWay = 1.2},
      sceneShifts = Shifts True True,
      sceneDebugTextures = False,
      sceneSamples = 4,
      sceneNoise = 0.04,
      sceneMostSamples = 64,
      sceneFilter = Gaussian,
      sceneExposure = Exposure 0,
      sceneToneMap = ToneFilm,
      sceneDither = BlueNoise,
      sceneBloom = 0.03,
      sceneSeed = 0
    }

-- | The picture of the report's author: gas, stars, observer and steps of the report,
-- framed closer. The report's own picture plane is one unit high at unit distance; a
-- field of view of 2·atan(8/9) = 83.2674° shows it.
reportScene :: Scene
reportScene =
  defaultScene
    { scenePicture = Picture 1280 720,
      sceneCamera =
        Camera
          { cameraPose = LookAt (XYZ 0 5 25) (XYZ 0 0 0),
            cameraRoll = Degrees 0,
            cameraFieldOfView = Degrees 40
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
      sceneDither = NoDither,
      sceneBloom = 0
    }
