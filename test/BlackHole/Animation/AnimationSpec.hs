module BlackHole.Animation.AnimationSpec (spec) where

import BlackHole.Animation.Animation
import BlackHole.Animation.CameraPath
import BlackHole.Animation.Interpolate
import BlackHole.Numeric.Angle
import BlackHole.Scene.Camera
import BlackHole.Scene.Preset
import BlackHole.Scene.Problem
import BlackHole.Scene.Scene
import BlackHole.Vector.XYZ (XYZ (..))
import Data.Foldable (toList)
import Test.Hspec

spec :: Spec
spec = do
  it "shows frame n at n / rate seconds" $ do
    toList (frameTimes animation 0) `shouldBe` [0]
    toList (frameTimes animation 36) `shouldBe` [1.5]
    animationDuration animation `shouldBe` 2
  it "gathers the light of an open shutter from the frame's time on" $
    toList (frameTimes animation {animationShutter = Shutter 0.5 4} 24)
      `shouldBe` [1 + part / 24 | part <- [0.0625, 0.1875, 0.3125, 0.4375]]
  it "sets keyed fields first and moves the camera from there" $ do
    let moving =
          animation
            { animationTracks = distances,
              animationPath = Just (Orbit (XYZ 0 (-1) 0) 1 Linear)
            }
    fmap (map (cameraPose . sceneCamera) . toList) (frameScenes moving 24)
      `shouldBe` Right [Around 25 (Degrees 77) (Degrees 270)]
  it "does not run into its own beginning twice" $ do
    let turning = animation {animationPath = Just (Orbit (XYZ 0 (-1) 0) 1 Linear)}
        azimuth n =
          [ a
            | Right scenes <- [frameScenes turning n],
              scene <- toList scenes,
              Around _ _ (Degrees a) <- [cameraPose (sceneCamera scene)]
          ]
    (azimuth 0, azimuth 47, azimuth 48) `shouldBe` ([90], [90 + 360 * 47 / 48], [450])
  it "names the frame's own problems" $
    case frameScenes animation {animationTracks = distances} (24 * 7) of
      Left [Problem "--distance" "-5" _] -> pure ()
      other -> expectationFailure (show other)
  it "checks its own numbers, all at once" $
    map
      problemOption
      ( animationProblems
          (stillAnimation defaultScene)
            { animationFrames = 0,
              animationRate = 0 / 0,
              animationShutter = Shutter 2 0
            }
      )
      `shouldBe` ["--duration", "--fps", "--shutter", "--shutter-samples"]
  where
    animation = stillAnimation defaultScene
    -- The distance is 30 at first, 5 less each second.
    distances =
      [ Track "camera.distance" setDistance Linear keys
        | Right keys <- [makeKeys [(0, [30]), (10, [-20])]]
      ]
    setDistance values scene = case (values, cameraPose (sceneCamera scene)) of
      ([r], Around _ i a) ->
        Right scene {sceneCamera = (sceneCamera scene) {cameraPose = Around r i a}}
      _ -> Left (Problem "camera.distance" (show values) "one number")
