module BlackHole.Image.SceneSourceSpec (spec) where

import BlackHole.Image.SceneSource
import System.FilePath ((</>))
import System.IO.Temp (withSystemTempDirectory)
import Test.Hspec

spec :: Spec
spec = do
  it "says that a file is not there" $
    readSceneFile "no-such.yaml" `shouldReturn` Left "no-such.yaml: there is no such file"
  it "knows a preset whose name stands for a file" $
    readSceneFile "luminet"
      `shouldReturn` Left "luminet: there is no such file; for the preset, write --preset luminet"
  it "says why another file cannot be read" $
    withSystemTempDirectory "blackhole-spec" $ \folder ->
      readSceneFile (folder </> ".")
        `shouldReturn` Left (folder </> "." ++ ": cannot be read: inappropriate type")
