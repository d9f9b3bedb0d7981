module BlackHole.Cli.RunSpec (spec) where

import BlackHole.Cli.Run
import BlackHole.Image.File (fileMetadata)
import BlackHole.Image.Metadata (Metadata (..))
import BlackHole.Light.Radiance (luminance)
import qualified BlackHole.Light.Radiance as Radiance
import Codec.Picture
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Char8 as Characters
import Data.List (isInfixOf, isPrefixOf, isSuffixOf)
import Data.Maybe (isJust)
import Support.Json
import Support.Program (outputOf, quietly)
import System.Directory (listDirectory)
import System.Exit (ExitCode (..))
import System.FilePath ((</>))
import System.IO (stderr, stdout)
import System.IO.Temp (withSystemTempDirectory)
import Test.Hspec

spec :: Spec
spec = do
  describe "blackhole render" $ do
    it "writes a PNG with the shadow, the disk arched over it, and stars" $
      inFolder $ \folder -> do
        let file = folder </> "hole.png"
        quietly ["render", "--width", "160", "--fov", "40", "--samples", "1", "-o", file]
          `shouldReturn` ExitSuccess
        listDirectory folder `shouldReturn` ["hole.png"]
        decoded <- readPng file
        case convertRGB8 <$> decoded of
          Left problem -> expectationFailure problem
          Right picture -> do
            (imageWidth picture, imageHeight picture) `shouldBe` (160, 90)
            -- The shadow's middle lies a little above the picture's, where the
            -- near side of the disk does not cover it.
            brightness picture 80 40 `shouldSatisfy` (< 0.02)
            -- Going up from there: the shadow, then the disk's far side.
            maximum [brightness picture 80 y | y <- [15 .. 35]] `shouldSatisfy` (> 0.3)
            -- Going down: the disk's near side.
            maximum [brightness picture 80 y | y <- [45 .. 60]] `shouldSatisfy` (> 0.3)
    it "writes equal bytes for any number of threads" $
      inFolder $ \folder -> do
        let picture n = do
              let file = folder </> (show n ++ ".png")
              code <- quietly ["render", "--width", "64", "--threads", show (n :: Int), "-o", file]
              bytes <- Bytes.readFile file
              pure (code, bytes)
        one <- picture 1
        two <- picture 2
        two `shouldBe` one
    it "renders a picture of any format again from the picture, byte for byte" $
      inFolder $ \folder -> do
        let file name = folder </> name
            again (extension, more) = do
              let first = file ("first" ++ extension)
                  second = file ("second" ++ extension)
              codes <-
                mapM
                  quietly
                  [ [ "render",
                      "--width",
                      "24",
                      "--samples",
                      "2",
                      "--seed",
                      "5",
                      "--bloom",
                      "0.1",
                      "--tone-map",
                      "agx",
                      "-o",
                      first
                    ]
                      ++ more,
                    ["render", "--from", first, "-o", second]
                  ]
              same <- (==) <$> Bytes.readFile first <*> Bytes.readFile second
              pure (codes, same)
        mapM
          again
          [ (".png", []),
            (".png", ["--bits", "16"]),
            (".jpg", ["--quality", "40"]),
            (".tif", ["--bits", "32"]),
            (".hdr", []),
            (".exr", ["--bits", "32"])
          ]
          `shouldReturn` replicate 6 ([ExitSuccess, ExitSuccess], True)
    it "takes the scene of a picture of another format, and options on top" $
      inFolder $ \folder -> do
        let png = folder </> "a.png"
            exr = folder </> "b.exr"
        codes <-
          mapM
            quietly
            [ ["render", "--width", "24", "--bits", "16", "-o", png],
              ["render", "--from", png, "--seed", "9", "-o", exr]
            ]
        codes `shouldBe` [ExitSuccess, ExitSuccess]
        text <- maybe "" (Characters.unpack . metadataScene) . fileMetadata <$> Bytes.readFile exr
        lines text `shouldContain` ["  seed: 9"]
        lines text `shouldContain` ["  width: 24"]
  describe "success" $ do
    says "hole.png: 32 × 18, " ["render", "--width", "32", "--samples", "1", "-o", "hole.png"]
    says
      "a.tile: 32 × 9, "
      ["render", "--width", "32", "--samples", "1", "--tile", "1/2", "-o", "a.tile"]
    says "rays.svg: 31 rays, " ["rays", "-o", "rays.svg"]
    says "path.csv: 334 points, " ["photon", "--psi", "10", "--path", "path.csv"]
    says "blackhole: 2 frames: 2 rendered in " (orbit ++ ["-o", "%d.png"])
    it "of join says so, and --stats has its numbers" $
      inFolder $ \folder -> do
        mapM_
          ( \i ->
              quietly
                [ "render",
                  "--width",
                  "32",
                  "--samples",
                  "1",
                  "--tile",
                  i ++ "/2",
                  "-o",
                  folder </> (i ++ ".tile")
                ]
          )
          ["1", "2"]
        let arguments =
              [ "join",
                folder </> "1.tile",
                folder </> "2.tile",
                "-o",
                folder </> "whole.png",
                "--stats",
                folder </> "stats.json"
              ]
        (code, said) <- outputOf stderr (folder </> "said") (run arguments)
        code `shouldBe` ExitSuccess
        said `shouldSatisfy` ((folder </> "whole.png: 32 × 18, ") `isPrefixOf`)
        stats <- readJson <$> readFile (folder </> "stats.json")
        map (\key -> stats >>= numberAt [key]) ["width", "height", "tiles"]
          `shouldBe` map Just [32, 18, 2]
        outputOf stderr (folder </> "said") (run (arguments ++ ["-q"]))
          `shouldReturn` (ExitSuccess, "")
    it "is an object with --progress json" $
      inFolder $ \folder -> do
        (_, said) <-
          outputOf
            stderr
            (folder </> "said")
            ( run
                [ "render",
                  "--width",
                  "32",
                  "--samples",
                  "1",
                  "--progress",
                  "json",
                  "-o",
                  folder </> "a.png"
                ]
            )
        map readJson (lines said) `shouldSatisfy` all isJust
        (lastOf (lines said) >>= readJson >>= numberAt ["height"]) `shouldBe` Just 18
  describe "animate" $ do
    it "orbits any scene without a scene file, as a camera path does" $
      inFolder $ \folder -> do
        quietly (orbit ++ ["-o", folder </> "%d.png", "--stats", folder </> "stats.json"])
          `shouldReturn` ExitSuccess
        -- The camera goes from azimuth 90 towards smaller ones, with the gas.
        quietly
          [ "render",
            "--width",
            "16",
            "--samples",
            "1",
            "--preset",
            "luminet",
            "--azimuth",
            "60",
            "-o",
            folder </> "alone.png"
          ]
          `shouldReturn` ExitSuccess
        alone <- Bytes.readFile (folder </> "alone.png")
        Bytes.readFile (folder </> "1.png") `shouldReturn` alone
        stats <- readJson <$> readFile (folder </> "stats.json")
        map (\key -> stats >>= numberAt [key]) ["frames", "rendered", "failed"]
          `shouldBe` map Just [2, 2, 0]
    it "reports progress in JSON" $
      inFolder $ \folder -> do
        (_, said) <-
          outputOf
            stderr
            (folder </> "said")
            (run (orbit ++ ["--progress", "json", "-o", folder </> "%d.png"]))
        (lastOf (lines said) >>= readJson >>= numberAt ["frames_done"]) `shouldBe` Just 2
  describe "without a command" $
    mapM_
      ( \arguments -> it
          ( unwords ("blackhole" : arguments)
              ++ " prints its help on standard error and exits with 2"
          )
          . inFolder
          $ \folder -> do
            (code, said) <- outputOf stderr (folder </> "said") (run arguments)
            code `shouldBe` ExitFailure 2
            said `shouldSatisfy` isInfixOf "Usage: blackhole"
      )
      [[], ["scene"]]
  it "warns of former names, with the same result" $
    inFolder $ \folder -> do
      writeFile (folder </> "a.yaml") "camera: {field-of-view: 30}\n"
      writeFile (folder </> "b.yaml") "camera: {fov: 30}\n"
      let rendered name =
            [ "render",
              folder </> (name ++ ".yaml"),
              "--width",
              "16",
              "--samples",
              "1",
              "-q",
              "-o",
              folder </> (name ++ ".png")
            ]
      outputOf stderr (folder </> "said") (run (rendered "a"))
        `shouldReturn` ( ExitSuccess,
                         "blackhole: " ++ folder
                           </> "a.yaml:1: warning: camera.field-of-view is now called camera.fov\n"
                       )
      outputOf stderr (folder </> "said") (run (rendered "b")) `shouldReturn` (ExitSuccess, "")
      old <- Bytes.readFile (folder </> "a.png")
      Bytes.readFile (folder </> "b.png") `shouldReturn` old
      outputOf
        stderr
        (folder </> "said")
        ( run
            [ "render",
              "--camera",
              "0,3,20",
              "--width",
              "16",
              "--samples",
              "1",
              "-q",
              "-o",
              folder </> "c.png"
            ]
        )
        `shouldReturn` (ExitSuccess, "blackhole: warning: --camera is now called --position\n")
  describe "options without effect" $ do
    idle
      "--quality: 80 has no effect; it applies only to JPEG files"
      ["render", "--quality", "80", "-o", "y.png"]
    idle "--output: has no effect with --pixel" ["render", "--pixel", "1,1", "-o", "y.png"]
    idle "--stats: has no effect with --preview" ["render", "--preview", "--stats", "s.json"]
    idle
      "--keep-partial: has no effect with --tile"
      ["render", "--tile", "1/2", "-o", "a.tile", "--keep-partial"]
    idle "--preset: has no effect with --from" ["render", "--from", "a.png", "--preset", "report"]
    idle "--codec: has no effect; it applies only with --video" (orbit ++ ["--codec", "h264"])
    idle "--crf: has no effect on a GIF" (orbit ++ ["--crf", "3", "--video", "a.gif"])
    idle
      "--shutter-samples: has no effect; it applies only with --shutter above 0"
      (orbit ++ ["--shutter-samples", "3"])
    idle "--width: has no effect with --status" ["animate", "--status", "frames", "--width", "3"]
    idle
      "--quality: 80 has no effect; it applies only to JPEG files"
      ["join", "a.tile", "-o", "y.png", "--quality", "80"]
  describe "bad input" $ do
    fails 2 ["render", "--width", "many"]
    fails 2 ["render", "--no-such-option"]
    fails 2 []
    fails 3 ["render", "--width", "0"]
    fails 3 ["render", "--height", "-1"]
    fails 3 ["render", "--fov", "180"]
    fails 3 ["render", "--fov", "NaN"]
    fails 3 ["render", "--distance", "0.5"]
    fails 3 ["render", "--position", "0,9,0", "--look-at", "0,0,0"]
    fails 3 ["render", "--preset", "nothing"]
    fails 2 ["render", "--threads", "0"]
    fails 2 ["render", "-o", "picture.bmp"]
    fails 2 ["render", "--bits", "9"]
    fails 2 ["render", "--quality", "0"]
    fails 2 ["render", "--from", "a.png", "b.yaml"]
    fails 3 ["render", "--from", "/no/such/picture.png"]
    fails 3 ["render", "--from", "/dev/null"]
    fails 3 ["render", "--bloom", "1.5"]
    fails 4 ["render", "--width", "16", "-o", "/no/such/folder/picture.png"]
  where
    inFolder = withSystemTempDirectory "blackhole-spec"
    orbit =
      [ "animate",
        "--preset",
        "luminet",
        "--orbit",
        "60",
        "--duration",
        "2",
        "--fps",
        "1",
        "--width",
        "16",
        "--samples",
        "1"
      ]
    lastOf = foldl (const Just) Nothing
    -- Files are made in a folder that is not the working directory.
    placed folder arguments =
      [ if take 1 before' `elem` [["-o"], ["--path"]] then folder </> argument else argument
        | (before', argument) <- zip ([] : map pure arguments) arguments
      ]
    says start arguments =
      it (unwords arguments ++ " says " ++ start ++ "…, and nothing with --quiet") . inFolder $
        \folder -> do
          (code, said) <-
            outputOf
              stderr
              (folder </> "said")
              (fst <$> outputOf stdout (folder </> "out") (run (placed folder arguments)))
          code `shouldBe` ExitSuccess
          length (lines said) `shouldBe` 1
          said `shouldSatisfy` isInfixOf start
          said `shouldSatisfy` \line -> " s\n" `isSuffixOf` line
          outputOf
            stderr
            (folder </> "said")
            (fst <$> outputOf stdout (folder </> "out") (run (placed folder arguments ++ ["-q"])))
            `shouldReturn` (ExitSuccess, "")
    idle line arguments =
      it (unwords arguments ++ ": " ++ line) . inFolder $ \folder -> do
        (code, said) <- outputOf stderr (folder </> "said") (run arguments)
        code `shouldBe` ExitFailure 2
        lines said `shouldBe` ["blackhole: " ++ line]
    fails code arguments =
      it
        (unwords ("blackhole" : arguments) ++ " exits with " ++ show code ++ " and writes nothing")
        $ inFolder $ \folder -> do
          let output =
                [ "--output=" ++ folder </> "picture.png" | arguments /= [], "-o"
                                                                               `notElem` arguments
                ]
          quietly (arguments ++ output) `shouldReturn` ExitFailure code
          listDirectory folder `shouldReturn` []
    brightness picture x y =
      let PixelRGB8 r g b = pixelAt picture x y
          part c = fromIntegral c / 255
       in luminance (Radiance.Radiance (part r) (part g) (part b))
