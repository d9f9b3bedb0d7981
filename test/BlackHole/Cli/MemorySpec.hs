module BlackHole.Cli.MemorySpec (spec) where

import BlackHole.Cli.Memory
import BlackHole.Image.Coding
import BlackHole.Scene.Camera (Picture (..))
import BlackHole.Scene.Preset (defaultScene)
import BlackHole.Scene.Scene
import Control.Concurrent (threadDelay)
import Control.Monad (forM_)
import Data.List (stripPrefix)
import Data.Maybe (isJust, isNothing, mapMaybe)
import System.Directory (findExecutable)
import System.Exit (ExitCode (..))
import System.FilePath ((</>))
import System.IO.Temp (withSystemTempDirectory)
import System.Process
  ( CreateProcess (cwd, std_err),
    StdStream (NoStream),
    getPid,
    getProcessExitCode,
    proc,
    withCreateProcess,
  )
import Test.Hspec
import Text.Read (readMaybe)

spec :: Spec
spec = do
  it "refuses a picture that no machine has the memory for" $ do
    available <- availableMemory
    problem <-
      memoryProblem
        (Making (WholePicture Png) False False)
        defaultScene {scenePicture = Picture 1000000000 1}
        1000000000
    isJust problem `shouldBe` isJust available
    memoryProblem
      (Making (WholePicture Png) False False)
      defaultScene {scenePicture = Picture 16 9}
      9
      >>= (`shouldSatisfy` isNothing)
  it "estimates no less than the program takes, and at least what the light takes" $
    withSystemTempDirectory "blackhole-spec" $ \folder -> do
      writeFile
        (folder </> "film.yaml")
        ( "image: {width: " ++ show width ++ ", height: " ++ show height
            ++ "}\nphysics: {gravity: off}\ndisk: {present: off}\nsky: {kind: uniform}\n\
               \sampling: {samples: 1, noise: 0}\noutput: {bloom: 0}\nanimation: {frames: 1}\n"
        )
      found <- findExecutable "blackhole"
      case found of
        Nothing -> pendingWith "blackhole is not on the PATH"
        Just program -> do
          let taken arguments = peakOf program folder (arguments ++ ["--threads", "2"])
              render =
                [ "render",
                  "--width",
                  show width,
                  "--height",
                  show height,
                  "--samples",
                  "1",
                  "--noise",
                  "0",
                  "--no-gravity",
                  "--no-disk",
                  "--sky",
                  "uniform",
                  "--bloom",
                  "0",
                  "--quiet"
                ]
              film = ["animate", "film.yaml", "-o"]
              plainScene =
                defaultScene {scenePicture = Picture width height, sceneBloom = 0, sceneNoise = 0}
              check (name, making, scene, arguments) = do
                peak <- taken arguments
                let estimate = pictureMemory making scene height
                (name, peak) `shouldSatisfy` maybe True (<= estimate) . snd
                (name, estimate) `shouldSatisfy` (>= 12 * toInteger (width * height)) . snd
              plain product' = Making product' False False
          forM_
            [ ("PNG", plain (WholePicture Png), plainScene, render ++ ["-o", "a.png"]),
              ( "PNG with bloom",
                plain (WholePicture Png),
                plainScene {sceneBloom = 0.1},
                render ++ ["--bloom", "0.1", "-o", "a.png"]
              ),
              ( "PNG with adaptive sampling",
                plain (WholePicture Png),
                plainScene {sceneNoise = 0.02},
                render ++ ["--noise", "0.02", "-o", "a.png"]
              ),
              ("JPEG", plain (WholePicture Jpeg), plainScene, render ++ ["-o", "a.jpg"]),
              ( "OpenEXR in 32 bits",
                plain (WholePicture Exr),
                plainScene,
                render ++ ["--bits", "32", "-o", "a.exr"]
              ),
              ( "PNG that is kept when interrupted",
                Making (WholePicture Png) False True,
                plainScene,
                render ++ ["--keep-partial", "-o", "a.png"]
              ),
              ("tile", plain Tile, plainScene, render ++ ["--tile", "1/1", "-o", "a.tile"]),
              ("tiles as PNG", plain (Joined Png), plainScene, ["join", "a.tile", "-o", "b.png"]),
              ("tiles as JPEG", plain (Joined Jpeg), plainScene, ["join", "a.tile", "-o", "b.jpg"]),
              ( "tiles as OpenEXR",
                plain (Joined Exr),
                plainScene,
                ["join", "a.tile", "-o", "b.exr"]
              ),
              ("frame", plain (Frame Png), plainScene, film ++ ["a%d.png"]),
              ( "frame in OpenEXR with bloom",
                plain (Frame Exr),
                plainScene {sceneBloom = 0.1},
                film ++ ["b%d.exr", "--bloom", "0.1"]
              ),
              ( "frame with motion blur",
                Making (Frame Png) True False,
                plainScene,
                film ++ ["c%d.png", "--shutter", "0.5", "--shutter-samples", "3"]
              )
            ]
            check
  where
    (width, height) = (1500, 1000)

-- | The most memory in bytes that the program has had, as Linux tells while it runs.
peakOf :: FilePath -> FilePath -> [String] -> IO (Maybe Integer)
peakOf program folder arguments =
  withCreateProcess (proc program arguments) {cwd = Just folder, std_err = NoStream} $
    \_ _ _ process -> do
      let watch peak = do
            pid <- getPid process
            now <- maybe (pure Nothing) highWater pid
            ended <- getProcessExitCode process
            case ended of
              Just code -> ((arguments, code) `shouldBe` (arguments, ExitSuccess)) >> pure peak
              Nothing -> threadDelay 2000 >> watch (max peak now)
      watch Nothing
  where
    highWater pid = do
      text <- readFile ("/proc/" ++ show pid ++ "/status")
      pure $! case [ n * 1024
                     | n : _ <-
                         map
                           (mapMaybe readMaybe . words)
                           (mapMaybe (stripPrefix "VmHWM:") (lines text))
                   ] of
        n : _ -> Just n
        [] -> Nothing
