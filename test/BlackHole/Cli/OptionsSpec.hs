module BlackHole.Cli.OptionsSpec (spec) where

import BlackHole.Cli.Options
import BlackHole.Cli.Photon.Options (PhotonOptions (..))
import BlackHole.Cli.Rays (RaysOptions (..))
import BlackHole.Cli.Render.Options
import BlackHole.Cli.SceneOptions (resolveScene)
import BlackHole.Light.Display (Exposure (..), ToneMap (..))
import BlackHole.Light.Dither (Dither (..))
import BlackHole.Numeric.Angle
import BlackHole.Scene.Camera
import BlackHole.Scene.Field.Field (Field (..), optionName)
import BlackHole.Scene.Field.Table (sceneFields)
import BlackHole.Scene.Preset
import BlackHole.Scene.Scene
import BlackHole.Spacetime.Observer
import BlackHole.Spacetime.Types
import BlackHole.Vector.XYZ (XYZ (..))
import Data.List (isInfixOf, isPrefixOf, nub)
import Test.Hspec

spec :: Spec
spec = do
  it "no options give the default scene" $ scene [] `shouldBe` Right defaultScene
  it "a preset gives that scene" $ scene ["--preset", "report"] `shouldBe` Right reportScene
  it "the height follows the width at 16:9" $
    fmap scenePicture (scene ["--width", "640", "--fov", "40"]) `shouldBe` Right (Picture 640 360)
  it "the height may be given" $
    fmap scenePicture (scene ["--width", "640", "--height", "100"])
      `shouldBe` Right (Picture 640 100)
  it "angles place the camera" $
    fmap
      (cameraPose . sceneCamera)
      (scene ["--distance", "12", "--inclination=30", "--azimuth", "-45"])
      `shouldBe` Right (Around 12 (Degrees 30) (Degrees (-45)))
  it "so does a point, with the hole as target" $
    fmap (cameraPose . sceneCamera) (scene ["--position", "-1,2.5,+3e1"])
      `shouldBe` Right (LookAt (XYZ (-1) 2.5 30) (XYZ 0 0 0))
  it "takes numbers as people write them" $
    fmap sceneExposure (scene ["--exposure", "-.5"]) `shouldBe` Right (Exposure (-0.5))
  it "the last of an option given repeatedly counts" $
    fmap scenePicture (scene ["--width", "640", "--no-disk", "--width", "320", "--no-disk"])
      `shouldBe` Right (Picture 320 180)
  it "sets the film" $
    fmap
      (\s -> (sceneToneMap s, sceneDither s, sceneBloom s))
      (scene ["--tone-map", "agx", "--dither", "off", "--bloom", ".1"])
      `shouldBe` Right (ToneAgx, NoDither, 0.1)
  it "names are taken in any case" $
    fmap sceneObserver (scene ["--observer", "Falling"]) `shouldBe` Right Falling
  it "switches gravity and gas off" $
    fmap (\s -> (sceneSpacetime s, sceneDisk s)) (scene ["--no-gravity", "--no-disk"])
      `shouldBe` Right (Flat, Nothing)
  describe "mistakes" $ do
    misused ["render", "--width", "many"] ["--width", "many", "whole number"]
    misused ["render", "--seed", "-1"] ["--seed", "-1", "18446744073709551615"]
    misused ["render", "--seed", "18446744073709551616"] ["--seed", "18446744073709551615"]
    misused ["render", "--fov", "4o"] ["--fov", "4o", "number"]
    misused ["render", "--position", "1,2"] ["--position", "1,2", "X,Y,Z"]
    misused ["render", "--observer", "statik"] ["--observer", "statik", "static"]
    misused ["render", "--widht", "3"] ["--widht"]
    misused ["rendr"] ["rendr"]
    misused ["render", "one.yaml", "stray"] ["stray"]
  it "an unknown preset is reported with the nearest name" $
    scene ["--preset", "reprot"]
      `shouldBe` Left
        [ "--preset: reprot is not a preset (did you mean report?); the presets are: \
          \default, report, interstellar, edge-on, face-on, luminet, lens-only, photon-ring, \
          \falling, m87, kerr"
        ]
  it "two ways to place the camera clash" $
    scene ["--position", "0,1,9", "--distance", "4"]
      `shouldBe` Left
        ["--position, --look-at: cannot be combined with --distance, --inclination or --azimuth"]
  describe "an option without effect is a mistake" $ do
    idle ["--step", "0.05"] "--step: 0.05 has no effect; it applies only with --integrator leapfrog"
    idle
      ["--step", "0.1", "--integrator", "exact"]
      "--step: 0.1 has no effect; it applies only with --integrator leapfrog"
    idle ["--no-disk", "--disk-inner", "4"] "--disk-inner: 4 has no effect with --no-disk"
    idle
      ["--preset", "lens-only", "--temperature", "6000"]
      "--temperature: 6000 has no effect; it applies only with disk.present on"
    idle ["--no-gravity", "--spin", "0.5"] "--spin: 0.5 has no effect with --no-gravity"
    idle ["--spin", "1"] "--spin: 1 is not a spin above -1 and below 1"
    idle
      ["--sky", "grid", "--sky-rotation", "20"]
      "--sky-rotation: 20 has no effect with --sky grid; it applies only with --sky stars or FILE"
    idle ["--debug-textures", "--sky", "grid"] "--sky: grid has no effect with --debug-textures"
    idle
      ["--noise", "0", "--most-samples", "8"]
      "--most-samples: 8 has no effect with --noise 0; it applies only with --noise above 0"
    it "but not where its condition holds" $
      mapM_
        (\arguments -> scene arguments `shouldSatisfy` either (const False) (const True))
        [ ["--step", "0.05", "--integrator", "leapfrog", "--preset", "report"],
          ["--preset", "report", "--step", "0.1"],
          ["--disk-inner", "4"],
          ["--sky", "sky.png", "--sky-rotation", "20"],
          ["--noise", "0.1", "--most-samples", "8"]
        ]
  it "accepts former names and warns" $ do
    scene ["--camera", "0,1,9"] `shouldBe` scene ["--position", "0,1,9"]
    scene ["--camera=0,1,9"] `shouldBe` scene ["--position", "0,1,9"]
    formerOptionWarnings ["render", "--camera=0,1,9", "--width", "3"]
      `shouldBe` ["warning: --camera is now called --position"]
    formerOptionWarnings ["render", "--position", "0,1,9"] `shouldBe` []
  it "an option is named like the end of its setting's path" $ do
    let agrees f o =
          fieldPath f == "sky.kind" && optionName o == "--sky"
            || any (`elem` [optionName o, "--no-" ++ drop 2 (optionName o)]) (ends (fieldPath f))
        ends path = case break (== '.') path of
          (_, _ : rest) -> ("--" ++ dashed path) : ends rest
          _ -> ["--" ++ path]
        dashed = map (\c -> if c == '.' then '-' else c)
        negated = [("physics.gravity", "--no-gravity"), ("disk.present", "--no-disk")]
    [(fieldPath f, optionName o) | f <- sceneFields, Just o <- [fieldOption f], not (agrees f o)]
      `shouldBe` negated
  it "takes every field's option, and each field has another one" $ do
    let names = [optionName o | f <- sceneFields, Just o <- [fieldOption f]]
    nub names `shouldBe` names
    case parseArguments "v1" ["render", "--help"] of
      Inform text -> mapM_ (\o -> text `shouldSatisfy` isInfixOf o) names
      other -> expectationFailure (show other)
  it "photon and rays have options of their own" $ do
    case parseArguments "v1" ["photon", "--impact", "2.65", "--json"] of
      Run (Photon options) ->
        (photonImpact options, photonJson options) `shouldBe` (Just 2.65, True)
      other -> expectationFailure (show other)
    case parseArguments "v1" ["rays", "--extent", "5", "-o", "fan.png"] of
      Run (Rays options) -> (raysExtent options, raysOutput options) `shouldBe` (5, "fan.png")
      other -> expectationFailure (show other)
  it "without a command, the help comes by itself" $ do
    parseArguments "v1" [] `shouldBe` named ["help"]
    parseArguments "v1" ["scene"] `shouldBe` named ["help", "scene"]
  it "--help and --version are not mistakes" $ do
    parseArguments "v1" ["--version"] `shouldBe` Inform "v1"
    case parseArguments "v1" ["render", "--help"] of
      Inform text ->
        mapM_ (\o -> text `shouldSatisfy` isInfixOf o) ["--width", "--fov", "--preset", "Example"]
      other -> expectationFailure (show other)
  where
    named arguments = case parseArguments "v1" arguments of
      Inform text -> Unnamed text
      other -> other
    scene arguments = case parseArguments "v1" ("render" : arguments) of
      Run (Render options) -> resolveScene (renderScene options) Nothing
      other -> Left [show other]
    idle arguments start =
      it (unwords arguments) $
        scene arguments `shouldSatisfy` either (any (start `isPrefixOf`)) (const False)
    misused arguments parts =
      it (unwords ("blackhole" : arguments)) $ case parseArguments "v1" arguments of
        Misused line -> do
          line `shouldSatisfy` notElem '\n'
          mapM_ (\part -> line `shouldSatisfy` isInfixOf part) (parts :: [String])
        other -> expectationFailure (show other)
