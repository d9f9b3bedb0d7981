module BlackHole.Explore.SteerSpec (spec) where

import BlackHole.Explore.Steer
import BlackHole.Numeric.Angle
import BlackHole.Scene.Camera
import BlackHole.Scene.Preset
import BlackHole.Scene.Scene
import BlackHole.Scene.Validate
import BlackHole.Vector.XYZ (XYZ (..), (^-^))
import qualified BlackHole.Vector.XYZ as XYZ
import Support.Generators
import Test.Hspec
import Test.QuickCheck

spec :: Spec
spec = do
  it "orbits the hole" $ do
    pose (steer (OrbitHole 15 (-7)) defaultScene) `shouldBe` Around 54 (Degrees 70) (Degrees 105)
    pose (steer (OrbitHole (-100) 0) defaultScene) `shouldBe` Around 54 (Degrees 77) (Degrees 350)
    pose (steer (OrbitHole 0 500) defaultScene) `shouldBe` Around 54 (Degrees 180) (Degrees 90)
  it "orbits in the same way with a camera that has a position" $ do
    let circling =
          defaultScene
            { sceneCamera =
                (sceneCamera defaultScene) {cameraPose = Around 20 (Degrees 60) (Degrees 30)}
            }
        placed =
          defaultScene
            { sceneCamera =
                (sceneCamera defaultScene)
                  { cameraPose =
                      LookAt (posePosition (Around 20 (Degrees 60) (Degrees 30))) (XYZ 0 0 0)
                  }
            }
        moved how scene = posePosition (pose (steer how scene))
    sequence_
      [ XYZ.norm (moved how circling ^-^ moved how placed) `shouldSatisfy` (< 2e-3)
        | how <- [OrbitHole 40 0, OrbitHole 0 20, OrbitHole (-30) (-25)]
      ]
  it "moves nearer and farther" $ do
    pose (steer (Approach 0.5) defaultScene) `shouldBe` Around 27 (Degrees 77) (Degrees 90)
    pose (steer (Approach (1 / 3)) defaultScene) `shouldBe` Around 18 (Degrees 77) (Degrees 90)
  it "does not move where the observer cannot be" $
    steer (Approach 0.01) defaultScene `shouldBe` defaultScene
  it "looks to the right and up as the picture shows them" $
    sequence_
      [ case (cameraFrame (sceneCamera rolled), cameraFrame (sceneCamera (steer how rolled))) of
          (Just start, Just end) -> do
            XYZ.dot (frameForward end) (along start)
              `shouldSatisfy` (\c -> abs (c - sin (10 * pi / 180)) < 1e-4)
            XYZ.dot (frameForward end) (across start) `shouldSatisfy` ((< 1e-4) . abs)
          _ -> expectationFailure "the camera has no frame"
        | (how, along, across) <-
            [(LookAround 10 0, frameRight, frameUp), (LookAround 0 10, frameUp, frameRight)],
          rolled <- [defaultScene, steer (RollBy 70) defaultScene]
      ]
  it "looks at the hole again" $
    pose (steer FaceHole (steer (LookAround 20 10) defaultScene)) `shouldBe` pose defaultScene
  it "leaves every scene valid" $
    forAll validScene $ \scene -> forAll steering $ \how -> validateScene (steer how scene) === []
  where
    pose = cameraPose . sceneCamera

steering :: Gen Steering
steering =
  oneof
    [ OrbitHole <$> inRange (-3600) 3600 <*> inRange (-3600) 3600,
      Approach <$> inRange 0.01 100,
      LookAround <$> inRange (-3600) 3600 <*> inRange (-3600) 3600,
      RollBy <$> inRange (-3600) 3600,
      pure FaceHole
    ]
