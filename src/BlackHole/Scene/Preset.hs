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
import BlackHole.Spacetime.Kerr.Landmarks (spin)
import BlackHole.Spacetime.Observer (Observer (..))
import BlackHole.Spacetime.Types (Spacetime (..), spacetimeIsco)
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
  [ Preset
      "default"
      "a wide disk of glowing gas, seen by an observer at rest above its plane"
      defaultScene,
    Preset
      "report"
      "the picture of the design report, with its observer, gas, stars and leapfrog integration"
      reportScene,
    Preset
      "interstellar"
      "the look of the film Interstellar (2014): a thin bright disk around a \
      \rotating hole, without Doppler shift or redshift"
      interstellarScene,
    Preset
      "edge-on"
      "the disk seen from within a degree of its plane"
      (seenFrom 89 40 defaultScene),
    Preset "face-on" "the disk seen from near its pole" faceOnScene,
    Preset
      "luminet"
      "Luminet's picture of 1979: a thin opaque disk, its intensity over all \
      \wavelengths, without colour"
      luminetScene,
    Preset "lens-only" "no disk, only the sky distorted by the hole" lensOnlyScene,
    Preset
      "photon-ring"
      "a close-up of the rings formed by light that has gone around the hole"
      photonRingScene,
    Preset "falling" "the view of an observer falling into the hole, at r = 2.6" fallingScene,
    Preset
      "m87"
      "the shadow of the hole in the galaxy M87 as the Event Horizon Telescope sees it \
      \at a wavelength of 1.3 mm"
      m87Scene,
    Preset
      "kerr"
      "a hole that rotates almost as fast as possible, seen from close to the plane of \
      \its disk: a shadow like the letter D"
      kerrScene
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

faceOnScene :: Scene
faceOnScene =
  (seenFrom 12 60 defaultScene)
    { sceneDisk = Just defaultDisk {diskBrightness = 1.3, diskColour = BlackBody 2500}
    }

-- | The centre of the galaxy a little beside the hole, whose gravity draws the Milky Way
-- out into a ring.
lensOnlyScene :: Scene
lensOnlyScene =
  defaultScene
    { sceneCamera = Camera (Around 54 (Degrees 77) (Degrees 90)) (Degrees 30) (Degrees 44),
      sceneDisk = Nothing,
      sceneSky = SkyStars realSky {realSkyRotation = Degrees (-6), realSkyMilkyWay = 3},
      sceneExposure = Exposure 1.6,
      sceneToneMap = ToneAces,
      sceneBloom = 0.15
    }

-- | Spin, disk and camera of James, von Tunzelmann, Franklin and Thorne 2015,
-- "Gravitational lensing by spinning black holes in astrophysics, and in the movie
-- Interstellar", section 4: a\/M = 0.6, gas from 9.26 M to 18.7 M, seen from 74.1 M at
-- 86.56 degrees.
interstellarScene :: Scene
interstellarScene =
  maybe id (\hole scene -> scene {sceneSpacetime = Kerr hole}) (spin 0.6) $
    defaultScene
      { -- Rays that graze the opaque disk find its surface only to within a step.
        sceneSamples = 2,
        sceneNoise = 0.03,
        sceneCamera =
          Camera (Around 37.05 (Degrees 86.56) (Degrees 90)) (Degrees (-4)) (Degrees 40),
        sceneDisk =
          Just
            defaultDisk
              { diskInnerRadius = 4.63,
                diskOuterRadius = 11,
                diskFade = 0.85,
                diskThickness = 0.05,
                diskOpacity = 4,
                diskBrightness = 2.6,
                diskArms = 0,
                diskTurbulenceFrequency = 18,
                diskHaze = 0.006,
                diskHazeHeight = 4,
                diskColour = BlackBody 4500
              },
        sceneShifts = Shifts False False,
        sceneBloom = 0.15
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
      sceneGrain = 1.3,
      sceneSky = SkyNone
    }

photonRingScene :: Scene
photonRingScene =
  defaultScene
    { sceneCamera = Camera (LookAt (XYZ 0 5.2 29.5) (XYZ (-1.9) 2.2 0)) (Degrees 0) (Degrees 7)
    }

fallingScene :: Scene
fallingScene =
  defaultScene
    { sceneCamera = Camera (LookAt (XYZ 0 0.9 2.4392622) (XYZ 0 0.2 0)) (Degrees 10) (Degrees 110),
      sceneObserver = Falling,
      sceneExposure = Exposure (-3)
    }

-- | The hole in the galaxy M87 at 230 GHz. Its Schwarzschild radius is 7.6 µas wide on the
-- sky (a mass of 6.5e9 suns at 16.8 Mpc: Event Horizon Telescope Collaboration 2019,
-- ApJL 875, L1), so that the picture is 164 µas wide and 92 high, the shadow 40, the beam
-- 20, and the scale bar 50 µas long. The gas turns clockwise on the sky, and its axis is 17
-- degrees from the line of sight, at right angles to the bright side in the south.
m87Scene :: Scene
m87Scene =
  defaultScene
    { sceneCamera =
        Camera
          (Around distance (Degrees 163) (Degrees 90))
          (Degrees 90)
          (Degrees (2 * atan (0.5 * 164 * width / distance) * 180 / pi)),
      sceneDisk =
        Just
          defaultDisk
            { diskInnerRadius = 2,
              diskOuterRadius = 6,
              diskFade = 0.5,
              diskThickness = 1.2,
              diskOpacity = 0.15,
              diskBrightness = 2900,
              diskArms = 0,
              diskTurbulence = 1.5,
              diskTurbulenceFrequency = 3,
              diskTurbulenceHeat = 0,
              diskHaze = 0,
              diskColour = Synchrotron
            },
      sceneSky = SkyNone,
      sceneSamples = 1,
      sceneNoise = 0,
      sceneToneMap = ToneRadio,
      sceneBloom = 0,
      sceneBeam = 20 * width / distance * 180 / pi,
      sceneScaleBar = 50 * width
    }
  where
    -- In Schwarzschild radii, the size at the hole of one microarcsecond.
    width = 1 / 7.6
    distance = 1000

kerrScene :: Scene
kerrScene = maybe defaultScene around (spin 0.998)
  where
    around hole =
      defaultScene
        { sceneCamera = Camera (Around 40 (Degrees 86) (Degrees 90)) (Degrees 0) (Degrees 35),
          sceneSpacetime = Kerr hole,
          -- The gas is hottest in a narrow ring; as bright as the default's it would leave
          -- the rest of the disk dark.
          sceneDisk =
            Just
              defaultDisk
                { diskInnerRadius = spacetimeIsco (Kerr hole),
                  diskOuterRadius = 11,
                  diskBrightness = 3.5,
                  diskColour = BlackBody 4800
                }
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
      sceneAperture = 0,
      sceneFocus = 54,
      sceneObserver = Static,
      sceneSpacetime = Schwarzschild,
      sceneIntegrator = Tabulated,
      sceneStep = 0.1,
      sceneDisk = Just defaultDisk,
      -- A Milky Way that can be seen beside the glowing gas.
      sceneSky = SkyStars realSky {realSkyMilkyWay = 1.2},
      sceneShifts = Shifts True True,
      sceneDebugTextures = False,
      sceneSamples = 1,
      sceneNoise = 0.06,
      sceneMostSamples = 64,
      sceneFilter = Gaussian,
      sceneExposure = Exposure 0,
      sceneToneMap = ToneFilm,
      sceneDither = BlueNoise,
      sceneBeam = 0,
      sceneBloom = 0.08,
      sceneSpikes = 0,
      sceneSpikeLight = 0.1,
      sceneGrain = 0,
      sceneScaleBar = 0,
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
            cameraFieldOfView = Degrees 31
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
