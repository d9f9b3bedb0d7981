module BlackHole.Scene.ValidateSpec (spec) where

import BlackHole.Light.Display (Exposure (..))
import BlackHole.Numeric.Angle
import BlackHole.Scene.Camera
import BlackHole.Scene.Disk
import BlackHole.Scene.Preset
import BlackHole.Scene.Scene
import BlackHole.Scene.Validate
import BlackHole.Spacetime.Observer
import BlackHole.Vector.XYZ (XYZ (..))
import Data.List (isInfixOf)
import Test.Hspec

spec :: Spec
spec = do
  describe "presets" $
    mapM_ (\(name, scene) -> it (name ++ " is valid") (validateScene scene `shouldBe` [])) presets
  describe "problems" $ do
    complains "--width" "0" defaultScene {scenePicture = Picture 0 10}
    complains "--height" "-3" defaultScene {scenePicture = Picture 10 (-3)}
    complains "--width" "65537" defaultScene {scenePicture = Picture 65537 10}
    complains "--fov" "180" (fieldOfView 180)
    complains "--fov" "0" (fieldOfView 0)
    complains "--fov" "NaN" (fieldOfView (0 / 0))
    complains "--step" "Infinity" defaultScene {sceneStep = 1 / 0}
    complains "--exposure" "NaN" defaultScene {sceneExposure = Exposure (0 / 0)}
    complains "--samples" "0" defaultScene {sceneSamples = 0}
    complains "--distance" "1" (posed (Around 1 (Degrees 80) (Degrees 0)))
    complains "--distance" "0.5" (posed (Around 0.5 (Degrees 80) (Degrees 0)))
    complains "--inclination" "200" (posed (Around 9 (Degrees 200) (Degrees 0)))
    complains "--position" "0,0,0.9" (posed (LookAt (XYZ 0 0 0.9) (XYZ 0 0 0)))
    complains "--position" "NaN,1,2" (posed (LookAt (XYZ (0 / 0) 1 2) (XYZ 0 0 0)))
    complains "--look-at" "0,-4,0" (posed (LookAt (XYZ 0 9 0) (XYZ 0 (-4) 0)))
    complains "--look-at" "1,2,3" (posed (LookAt (XYZ 1 2 3) (XYZ 1 2 3)))
    complains "--disk-outer" "1" (gas reportDisk {diskInnerRadius = 0.5, diskOuterRadius = 1})
    complains "--disk-inner" "5" (gas reportDisk {diskInnerRadius = 5})
    complains "--disk-thickness" "0" (gas reportDisk {diskThickness = 0})
    complains "--temperature" "400" (gas reportDisk {diskColour = BlackBody 400})
  it "an orbiting observer needs to be outside the photon sphere, a falling one anywhere" $ do
    let at r observer =
          map
            problemOption
            (validateScene (posed (Around r (Degrees 80) (Degrees 0))) {sceneObserver = observer})
    at 1.5 Orbiting `shouldBe` ["--distance"]
    at 1.6 Orbiting `shouldBe` []
    at 0.5 Falling `shouldBe` []
  it "all problems are reported at once" $
    map
      problemOption
      (validateScene (fieldOfView 190) {scenePicture = Picture 0 0, sceneSamples = -1})
      `shouldBe` ["--fov", "--width", "--height", "--samples"]
  where
    gas disk = defaultScene {sceneDisk = Just disk}
    posed pose = defaultScene {sceneCamera = (sceneCamera defaultScene) {cameraPose = pose}}
    fieldOfView a =
      defaultScene {sceneCamera = (sceneCamera defaultScene) {cameraFieldOfView = Degrees a}}
    complains option value scene =
      it (option ++ " " ++ value) $ case validateScene scene of
        [problem] -> do
          problemOption problem `shouldBe` option
          problemValue problem `shouldBe` value
          renderProblem problem
            `shouldSatisfy` (\l -> option `isInfixOf` l && value `isInfixOf` l && '\n' `notElem` l)
        other -> expectationFailure (show other)
