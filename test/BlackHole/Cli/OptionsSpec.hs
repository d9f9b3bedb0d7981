module BlackHole.Cli.OptionsSpec (spec) where

import BlackHole.Cli.Options
import BlackHole.Cli.Photon (PhotonOptions (..))
import BlackHole.Cli.Rays (RaysOptions (..))
import BlackHole.Cli.SceneOptions (resolveScene)
import BlackHole.Light.Display (Exposure (..), ToneMap (..))
import BlackHole.Light.Dither (Dither (..))
import BlackHole.Physics.Angle
import BlackHole.Physics.Observer
import BlackHole.Physics.Spacetime
import BlackHole.Scene.Camera
import BlackHole.Scene.Field.Field (Field (..), optionName)
import BlackHole.Scene.Field.Table (sceneFields)
import BlackHole.Scene.Preset
import BlackHole.Scene.Scene
import BlackHole.Vector.XYZ (XYZ (..))
import Data.List (isInfixOf, nub)
import Test.Hspec

spec :: Spec
spec = do
  it "no options give the default scene" $ scene [] `shouldBe` Right defaultScene
  it "a preset gives that scene" $ scene ["--preset", "report"] `shouldBe` Right reportScene
  it "the height follows the width at 16:9" $
    fmap scenePicture (scene ["--width", "640", "--fov", "40"]) `shouldBe` Right (Picture 640 360)
  it "the height may be given" $
    fmap scenePicture (scene ["--width", "640", "--height", "100"]) `shouldBe` Right (Picture 640 100)
  it "angles place the camera" $
    fmap (cameraPose . sceneCamera) (scene ["--distance", "12", "--inclination=30", "--azimuth", "-45"])
      `shouldBe` Right (Around 12 (Degrees 30) (Degrees (-45)))
  it "so does a point, with the hole as target" $
    fmap (cameraPose . sceneCamera) (scene ["--camera", "-1,2.5,+3e1"])
      `shouldBe` Right (LookAt (XYZ (-1) 2.5 30) (XYZ 0 0 0))
  it "takes numbers as people write them" $
    fmap sceneExposure (scene ["--exposure", "-.5"]) `shouldBe` Right (Exposure (-0.5))
  it "the last of an option given repeatedly counts" $
    fmap scenePicture (scene ["--width", "640", "--no-disk", "--width", "320", "--no-disk"]) `shouldBe` Right (Picture 320 180)
  it "sets the film" $
    fmap (\s -> (sceneToneMap s, sceneDither s, sceneBloom s)) (scene ["--tone-map", "agx", "--dither", "off", "--bloom", ".1"])
      `shouldBe` Right (ToneAgx, NoDither, 0.1)
  it "names are taken in any case" $
    fmap sceneObserver (scene ["--observer", "Falling"]) `shouldBe` Right Falling
  it "switches gravity and gas off" $
    fmap (\s -> (sceneSpacetime s, sceneDisk s)) (scene ["--no-gravity", "--no-disk"]) `shouldBe` Right (Flat, Nothing)
  describe "mistakes" $ do
    misused ["render", "--width", "many"] ["--width", "many", "whole number"]
    misused ["render", "--seed", "-1"] ["--seed", "-1", "18446744073709551615"]
    misused ["render", "--seed", "18446744073709551616"] ["--seed", "18446744073709551615"]
    misused ["render", "--fov", "4o"] ["--fov", "4o", "number"]
    misused ["render", "--camera", "1,2"] ["--camera", "1,2", "X,Y,Z"]
    misused ["render", "--observer", "statik"] ["--observer", "statik", "static"]
    misused ["render", "--widht", "3"] ["--widht"]
    misused ["rendr"] ["rendr"]
    misused [] []
    misused ["render", "one.yaml", "stray"] ["stray"]
  it "an unknown preset is told with the nearest name" $
    scene ["--preset", "reprot"]
      `shouldBe` Left ["--preset: reprot is not a preset (did you mean report?); there are: default, report, interstellar, edge-on, face-on, luminet, lens-only, photon-ring, falling"]
  it "two ways to place the camera clash" $
    scene ["--camera", "0,1,9", "--distance", "4"]
      `shouldBe` Left ["--camera: together with --distance, --inclination or --azimuth is not one way to place the camera; choose either"]
  it "takes every field's option, and each field has another one" $ do
    let names = [optionName o | f <- sceneFields, Just o <- [fieldOption f]]
    nub names `shouldBe` names
    case parseArguments "v1" ["render", "--help"] of
      Inform text -> mapM_ (\o -> text `shouldSatisfy` isInfixOf o) names
      other -> expectationFailure (show other)
  it "photon and rays have options of their own" $ do
    case parseArguments "v1" ["photon", "--impact", "2.65", "--json"] of
      Run (Photon options) -> (photonImpact options, photonJson options) `shouldBe` (Just 2.65, True)
      other -> expectationFailure (show other)
    case parseArguments "v1" ["rays", "--extent", "5", "-o", "fan.png"] of
      Run (Rays options) -> (raysExtent options, raysOutput options) `shouldBe` (5, "fan.png")
      other -> expectationFailure (show other)
  it "--help and --version are not mistakes" $ do
    parseArguments "v1" ["--version"] `shouldBe` Inform "v1"
    case parseArguments "v1" ["render", "--help"] of
      Inform text -> mapM_ (\o -> text `shouldSatisfy` isInfixOf o) ["--width", "--fov", "--preset", "Example"]
      other -> expectationFailure (show other)
  where
    scene arguments = case parseArguments "v1" ("render" : arguments) of
      Run (Render options) -> resolveScene (renderScene options) Nothing
      other -> Left [show other]
    misused arguments parts =
      it (unwords ("blackhole" : arguments)) $ case parseArguments "v1" arguments of
        Misused line -> do
          line `shouldSatisfy` notElem '\n'
          mapM_ (\part -> line `shouldSatisfy` isInfixOf part) (parts :: [String])
        other -> expectationFailure (show other)
