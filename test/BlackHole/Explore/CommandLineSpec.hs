module BlackHole.Explore.CommandLineSpec (spec) where

import BlackHole.Cli.Options
import BlackHole.Cli.Render.Options (RenderOptions (renderScene))
import BlackHole.Cli.SceneOptions
import BlackHole.Explore.CommandLine
import BlackHole.Scene.Field.Kind
import BlackHole.Scene.Preset
import BlackHole.Scene.Setting
import Data.Maybe (fromMaybe)
import Support.Generators
import Test.Hspec
import Test.QuickCheck

spec :: Spec
spec = do
  it "needs no option for a preset" $
    sequence_
      [ commandLine name shown
          `shouldBe` Options (if name == "default" then [] else ["--preset", name])
        | (name, shown) <- presets
      ]
  it "names only what differs" $ do
    commandLine
      "default"
      ( applySettings
          [Setting "image.width" (WholeValue 320), Setting "camera.inclination" (NumberValue 60)]
          defaultScene
      )
      `shouldBe` Options ["--inclination", "60", "--width", "320"]
    commandLine "kerr" (applySettings [Setting "disk.present" (SwitchValue False)] (scene "kerr"))
      `shouldBe` Options ["--preset", "kerr", "--no-disk"]
  it "says which settings only a file can hold" $
    commandLine "default" (applySettings [Setting "disk.fade" (NumberValue 0.4)] defaultScene)
      `shouldBe` NeedsFile ["disk.fade"]
  it "makes exactly the scene, read as the program reads it" $
    forAll (elements presetNames) $ \preset ->
      forAll validScene $ \wanted -> case commandLine preset wanted of
        NeedsFile _ -> property True
        Options arguments -> case parseArguments "" ("render" : arguments) of
          Run (Render options) -> resolveScene (renderScene options) Nothing === Right wanted
          _ -> counterexample (unwords arguments) False
  it "makes exactly the scene of a few changed options" $
    forAll (elements presetNames) $ \preset -> forAll (vectorOf 3 (elements changes)) $ \settings ->
      let wanted = applySettings settings (scene preset)
       in case commandLine preset wanted of
            NeedsFile _ -> counterexample "an option would do" False
            Options arguments -> case parseArguments "" ("render" : arguments) of
              Run (Render options) -> resolveScene (renderScene options) Nothing === Right wanted
              _ -> counterexample (unwords arguments) False
  it "quotes words for the shell" $ do
    shellWord "--fov" `shouldBe` "--fov"
    shellWord "./it's here.png" `shouldBe` "'./it'\\''s here.png'"
    shellWord "" `shouldBe` "''"
  where
    scene name = fromMaybe defaultScene (findPreset name)
    changes =
      [ Setting "camera.fov" (NumberValue 33),
        Setting "camera.roll" (NumberValue (-12.5)),
        Setting "image.width" (WholeValue 333),
        Setting "sampling.samples" (WholeValue 3),
        Setting "output.exposure" (NumberValue 1.25),
        Setting "sky.kind" (NameValue "grid"),
        Setting "sampling.seed" (SeedValue 18446744073709551615),
        Setting "physics.doppler" (SwitchValue False)
      ]
