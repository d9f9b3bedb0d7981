-- | Panoramas from the command line and scene files to the picture.
module BlackHole.Image.SkyFileSpec (spec) where

import BlackHole.Cli.SceneOptions
import BlackHole.Image.SkyFile
import BlackHole.Scene.Field.Kind (Value (..))
import BlackHole.Scene.Preset (defaultScene)
import BlackHole.Scene.Scene
import BlackHole.Scene.Setting
import BlackHole.Trace.EnvironmentMap (environmentMapMean)
import BlackHole.Trace.Sky (neededPicture)
import Codec.Picture
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Char8 as Characters
import Data.List (isInfixOf)
import Data.List.NonEmpty (NonEmpty (..))
import Support.Program (quietly)
import System.Directory (doesFileExist, getModificationTime, removeFile, setModificationTime)
import System.Exit (ExitCode (..))
import System.FilePath ((</>))
import System.IO.Temp (withSystemTempDirectory)
import Test.Hspec

spec :: Spec
spec = do
  it "sees a scene file's panorama from the file's folder, an option's from the working directory" $
    do
      fmap neededPicture (resolveScene (SceneOptions (Just "a/b.yaml") Nothing []) (Just yaml))
        `shouldBe` Right (Just "a/it's.png")
      fmap neededPicture (resolveScene (SceneOptions (Just "b.yaml") Nothing []) (Just yaml))
        `shouldBe` Right (Just "it's.png")
      fmap
        neededPicture
        ( resolveScene
            (SceneOptions (Just "a/b.yaml") Nothing [])
            (Just (Characters.pack "sky: {kind: /x/y.png}"))
        )
        `shouldBe` Right (Just "/x/y.png")
      fmap
        neededPicture
        ( resolveScene
            (SceneOptions (Just "a/b.yaml") Nothing [Setting "sky.kind" (FileValue "z.png")])
            (Just yaml)
        )
        `shouldBe` Right (Just "z.png")
      fmap (fmap neededPicture) (resolveMetadata (SceneOptions Nothing Nothing []) "a/b.png" yaml)
        `shouldBe` Right (Just "it's.png" :| [])
  it "keeps the turn when another file takes the place, and needs no file for checks" $ do
    let made file =
          applySettings
            [Setting "sky.kind" (FileValue file), Setting "sky.rotation" (NumberValue 30)]
    sceneSky (applySettings [Setting "sky.kind" (FileValue "b.png")] (made "a.png" defaultScene))
      `shouldBe` sceneSky (made "b.png" defaultScene)
    neededPicture (made "a.png" defaultScene) {sceneDebugTextures = True} `shouldBe` Nothing
  it "takes a word for a slip, and what has a folder or an extension for a file" $ do
    scene ["kind: satrs"]
      `shouldSatisfy` either (any ("did you mean stars?" `isInfixOf`)) (const False)
    scene ["kind: \"a\\nb.png\""] `shouldSatisfy` either (const True) (const False)
    fmap neededPicture (scene ["kind: ./stars"]) `shouldBe` Right (Just "./stars")
    fmap sceneSky (scene ["kind: STARS"]) `shouldBe` Right (sceneSky defaultScene)
  it "renders it, again from its own picture, in tiles, and explains it" . inFolder $ \folder -> do
    quietly (picture folder "whole.png") `shouldReturn` ExitSuccess
    quietly ["render", "--from", folder </> "whole.png", "-o", folder </> "again.png"]
      `shouldReturn` ExitSuccess
    same folder "whole.png" "again.png"
    quietly (picture folder "one.png" ++ ["--threads", "1"]) `shouldReturn` ExitSuccess
    same folder "whole.png" "one.png"
    quietly (picture folder "1.tile" ++ ["--tile", "1/2"]) `shouldReturn` ExitSuccess
    quietly (picture folder "2.tile" ++ ["--tile", "2/2"]) `shouldReturn` ExitSuccess
    quietly ["join", folder </> "1.tile", folder </> "2.tile", "-o", folder </> "joined.png"]
      `shouldReturn` ExitSuccess
    same folder "whole.png" "joined.png"
    -- A turn moves what is seen.
    quietly (picture folder "turned.png" ++ ["--sky-rotation", "90"]) `shouldReturn` ExitSuccess
    whole <- Bytes.readFile (folder </> "whole.png")
    Bytes.readFile (folder </> "turned.png") >>= (`shouldSatisfy` (/= whole))
    -- Tiles under another sky do not belong to it.
    writePng (folder </> "sky.png") (chart 9)
    quietly (picture folder "2.tile" ++ ["--tile", "2/2"]) `shouldReturn` ExitSuccess
    quietly ["join", folder </> "1.tile", folder </> "2.tile", "-o", folder </> "other.png"]
      `shouldReturn` ExitFailure 3
  it "reports bad input and writes nothing where the file is none" . inFolder $ \folder -> do
    let refused = do
          quietly (picture folder "x.png") `shouldReturn` ExitFailure 3
          quietly (takeWhile (/= "-o") (picture folder "x.png") ++ ["--pixel", "1,1"])
            `shouldReturn` ExitFailure 3
          quietly ["scene", "check", folder </> "film.yaml"] `shouldReturn` ExitFailure 3
          doesFileExist (folder </> "x.png") `shouldReturn` False
    quietly ["scene", "check", folder </> "film.yaml"] `shouldReturn` ExitSuccess
    writePng (folder </> "sky.png") (generateImage (\_ _ -> PixelRGB8 1 2 3) 9 9)
    refused
    Characters.writeFile (folder </> "sky.png") (Characters.pack "no picture")
    refused
    removeFile (folder </> "sky.png")
    refused
    quietly ["render", "--sky", "/dev/zero", "-o", folder </> "x.png"] `shouldReturn` ExitFailure 3
    quietly ["render", "--sky", folder ++ "/", "-o", folder </> "x.png"]
      `shouldReturn` ExitFailure 3
  it "makes frames stale by the file's contents, not by its date" . inFolder $ \folder -> do
    let film =
          quietly ["animate", folder </> "film.yaml", "-o", folder </> "%d.png"]
            `shouldReturn` ExitSuccess
        frame = Bytes.readFile (folder </> "1.png")
    film
    former <- frame
    date <- getModificationTime (folder </> "1.png")
    writePng (folder </> "sky.png") (chart 8)
    film
    getModificationTime (folder </> "1.png") `shouldReturn` date
    written <- getModificationTime (folder </> "sky.png")
    writePng (folder </> "sky.png") (chart 9)
    setModificationTime (folder </> "sky.png") written
    film
    frame >>= (`shouldSatisfy` (/= former))
  it "fingerprints the file" . inFolder $ \folder -> do
    loaded <-
      loadSky (applySettings [Setting "sky.kind" (FileValue (folder </> "sky.png"))] defaultScene)
    fmap (length . skyLines) loaded `shouldBe` Right 1
    fmap (fmap (environmentMapMean . skyFileImage)) loaded
      `shouldSatisfy` either (const False) (/= Nothing)
    fmap skyLines <$> loadSky defaultScene `shouldReturn` Right []
  where
    yaml = Characters.pack "sky: {kind: 'it''s.png'}"
    scene members =
      resolveScene
        (SceneOptions (Just "s.yaml") Nothing [])
        (Just (Characters.pack (unlines ("sky:" : map ("  " ++) members))))
    picture folder name =
      [ "render",
        "--sky",
        folder </> "sky.png",
        "--no-disk",
        "--width",
        "24",
        "--samples",
        "1",
        "-o",
        folder </> name
      ]
    same folder a b = do
      first <- Bytes.readFile (folder </> a)
      second <- Bytes.readFile (folder </> b)
      second `shouldBe` first
    chart n =
      generateImage (\i j -> PixelRGB8 (fromIntegral (n * i)) (fromIntegral (7 * j)) 90) 32 16
    inFolder action = withSystemTempDirectory "blackhole-sky" $ \folder -> do
      writePng (folder </> "sky.png") (chart 8)
      Characters.writeFile (folder </> "film.yaml") . Characters.pack . unlines $
        [ "sky: {kind: sky.png}",
          "disk: {present: false}",
          "image: {width: 16}",
          "sampling: {samples: 1}",
          "animation: {fps: 2, duration: 1, keyframes: {sky.panorama.rotation: {0: 0, 1: 90}}}"
        ]
      action folder
