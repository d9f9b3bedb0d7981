module BlackHole.Trace.GasSpec (spec) where

import BlackHole.Light.Radiance
import BlackHole.Numeric.Angle
import BlackHole.Scene.Camera
import BlackHole.Scene.Disk
import BlackHole.Scene.Preset
import BlackHole.Scene.Scene
import BlackHole.Scene.Shifts
import BlackHole.Scene.Sky
import BlackHole.Spacetime.LightPath
import BlackHole.Spacetime.Observer
import BlackHole.Spacetime.Photon
import BlackHole.Spacetime.Types
import BlackHole.Trace.Gas
import BlackHole.Trace.Ray
import BlackHole.Trace.Tracer
import BlackHole.Vector.XY (XY (..))
import BlackHole.Vector.XYZ (XYZ (..))
import Support.Approx
import Test.Hspec

spec :: Spec
spec = do
  describe "scenes of known radiance" $ do
    it "a ray straight down through smooth gas, without gravity" $
      -- ∫ exp(−(y/w)²) dy = √π w, so the optical depth is √π times the
      -- opacity times the two edges; the gas is of one radiance along the ray.
      sequence_
        [ luminanceOf transparency `shouldBeWithin` (1e-4, exp (negate (sqrt pi * opacity * edges)))
          | opacity <- [0.1, 0.5, 2],
            integrator <- [minBound ..],
            let edges = 1 / (1 + exp (-10 * (2.5 - 1.7))) / (1 + exp (-15 * (0.6 - 2.5 / 5)))
                transparency = through integrator smooth {diskOpacity = opacity, diskBrightness = 0}
        ]
    it "gas that hides everything behind it shows its own radiance" $
      -- Emission and absorption of one temperature: I = S (1 − e^{−τ}).
      let Radiance r _ _ = through Exact smooth {diskOpacity = 3, diskBrightness = 0.4}
          tau = 3 * sqrt pi * edges
          edges = 1 / (1 + exp (-10 * (2.5 - 1.7))) / (1 + exp (-15 * (0.6 - 2.5 / 5))) :: Double
       in r `shouldBeWithin` (2e-3, 0.4 * (1 - exp (negate tau)) + exp (negate tau))
  describe "the approaching side" $
    it "is brighter and bluer, and only with the Doppler shift" $ do
      -- Seen from +z the gas on the right (+x) recedes: it turns from +z
      -- towards +x on the near side, right-handed about +y.
      let left = edgeOn (Shifts True True) (-1)
          right = edgeOn (Shifts True True) 1
          left' = edgeOn (Shifts False True) (-1)
          right' = edgeOn (Shifts False True) 1
      luminance left `shouldSatisfy` (> 3 * luminance right)
      blueness left `shouldSatisfy` (> blueness right)
      luminance left' `shouldBeWithin` (1e-9 + 1e-6 * luminance right', luminance right')
  describe "opacity" $
    it "ends the path beyond 99 %" $ do
      let thick =
            gatherGas
              ( gas
                  Schwarzschild
                  0
                  (Shifts True True)
                  smooth {diskOpacity = 1e4}
                  (XYZ 0 0 20)
                  1e-3
              )
              1
      case thick nothingYet (planarSegment (Photon (XYZ 2.5 0 0) (XYZ 0 (-1) 0)) 0.1) of
        Stop gathered -> gatheredTransmittance gathered `shouldSatisfy` (< opaqueEnough)
        Continue _ -> expectationFailure "the path goes on"
  where
    luminanceOf = luminance
    blueness (Radiance r _ b) = b / r

-- | The report's gas without arms.
smooth :: Disk
smooth = reportDisk {diskArms = 0}

-- | White light from below, through the gas at 2.5 from the axis.
through :: Integrator -> Disk -> Radiance
through integrator disk =
  light
    defaultScene
      { scenePicture = Picture 2 2,
        sceneCamera = Camera (LookAt (XYZ 2.5 3 0) (XYZ 2.5 0 1e-5)) (Degrees 0) (Degrees 20),
        sceneObserver = Coordinate,
        sceneSpacetime = Flat,
        sceneIntegrator = integrator,
        sceneStep = 0.02,
        sceneDisk = Just disk,
        sceneSky = SkyUniform 1
      }
    (XY 1 1)

-- | Black-body gas seen from the disk's plane, left or right of the hole.
edgeOn :: Shifts -> Double -> Radiance
edgeOn shifts side =
  light
    defaultScene
      { scenePicture = Picture 200 2,
        sceneCamera = Camera (Around 40 (Degrees 80) (Degrees 90)) (Degrees 0) (Degrees 30),
        sceneShifts = shifts,
        -- Steps of equal phase on both sides.
        sceneIntegrator = Exact,
        sceneDisk = Just defaultDisk {diskArms = 0, diskTurbulence = 0},
        sceneSky = SkyNone
      }
    (XY (100 + side * 60) 1)

light :: Scene -> XY -> Radiance
light scene point = maybe (Radiance (0 / 0) 0 0) (`sightRadiance` point) (tracer scene)
