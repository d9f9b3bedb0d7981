module BlackHole.Cli.SchemaSpec (spec) where

import BlackHole.Cli.Json
import BlackHole.Cli.Schema
import BlackHole.Scene.Field.Field (Field (..))
import BlackHole.Scene.Field.Table (sceneFields)
import BlackHole.Scene.File.SceneFile (printScene)
import BlackHole.Scene.Preset
import Control.Monad (filterM, forM_)
import qualified Data.ByteString.Char8 as Characters
import Data.List (intercalate)
import Support.Generators
import Support.Tool
import System.Directory (doesDirectoryExist, listDirectory)
import System.FilePath (takeExtension, (</>))
import System.IO.Temp (withSystemTempDirectory)
import Test.Hspec
import Test.QuickCheck (generate, vectorOf)

spec :: Spec
spec = do
  it "has every setting at its path, and refuses others" $
    forM_ sceneFields $ \field ->
      below (splitPath (fieldPath field)) sceneSchema `shouldBe` True
  describe "to an independent reader of schemas (python3-jsonschema, python3-yaml)" $ do
    it "allows all scenes of the checkout, all presets and random scenes" $ do
      folders <- filterM doesDirectoryExist ["scenes"]
      files <-
        concat
          <$> mapM
            (\d -> map (d </>) . filter ((== ".yaml") . takeExtension) <$> listDirectory d)
            folders
      scenes <- mapM readFile files
      random <- generate (vectorOf 40 validScene)
      judged
        (scenes ++ map (printScene [] . snd) presets ++ map (printScene []) random)
        (all (== "valid"))
    it "refuses what the program refuses" $
      judged mistakes (all (== "invalid"))
  where
    splitPath text = case break (== '.') text of
      (key, _ : rest) -> key : splitPath rest
      (key, []) -> [key]
    below [] _ = True
    below (key : rest) (Object members) =
      lookup "additionalProperties" members == Just (Truth False)
        && case lookup "properties" members of
          Just (Object properties) -> maybe False (below rest) (lookup key properties)
          _ -> False
    below _ _ = False
    judged texts expected = withSystemTempDirectory "blackhole-spec" $ \folder -> do
      writeFile (folder </> "schema.json") (renderJson sceneSchema)
      forM_ (zip [1000 :: Int ..] texts) $ \(n, text) ->
        writeFile (folder </> (show n ++ ".yaml")) text
      withTool "python3" $ \tool -> do
        output <- lines . Characters.unpack <$> toolOutput tool ["-c", judge, folder]
        case output of
          ["missing"] -> pendingWith "python3-jsonschema or python3-yaml is not installed"
          verdicts -> do
            length verdicts `shouldBe` length texts
            verdicts `shouldSatisfy` expected
    -- YAML's keys need not be texts, JSON's are.
    judge =
      intercalate
        "\n"
        [ "import glob, json, sys",
          "try:",
          "    import jsonschema, yaml",
          "except ImportError:",
          "    print('missing')",
          "    sys.exit()",
          "def plain(v):",
          "    if isinstance(v, dict): return {str(k): plain(x) for k, x in v.items()}",
          "    return [plain(x) for x in v] if isinstance(v, list) else v",
          "schema = json.load(open(sys.argv[1] + '/schema.json'))",
          "jsonschema.Draft7Validator.check_schema(schema)",
          "judge = jsonschema.Draft7Validator(schema)",
          "for path in sorted(glob.glob(sys.argv[1] + '/*.yaml')):",
          "    print('valid' if judge.is_valid(plain(yaml.safe_load(open(path)))) else 'invalid')"
        ]
    mistakes =
      [ "foo: 1",
        "camera: {azimut: 3}",
        "disk: {thickness: 1000}",
        "disk: 3",
        "image: {width: many}",
        "image: {width: 3.5}",
        "preset: reprot",
        "sky: {kind: starss}",
        "camera: {position: [0, 1]}",
        "sampling: {seed: 18446744073709551616}",
        "animation: {fsp: 3}",
        "animation: {frames: 0}",
        "animation: {camera-path: {kind: loop}}",
        "animation: {camera-path: {kind: orbit, rate: 3}}",
        "animation: {keyframes: {camera.foo: {0: 1}}}",
        "animation: {keyframes: {camera.roll: {x: 1}}}",
        "animation: {keyframes: {image.width: {0: 100}}}",
        "animation: {keyframes: {camera.roll: {interpolation: smoth, 0: 1}}}"
      ]
