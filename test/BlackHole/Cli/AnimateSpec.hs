module BlackHole.Cli.AnimateSpec (spec) where

import BlackHole.Animation.Animation
import BlackHole.Cli.Animate.Options
import BlackHole.Cli.AnimationScene
import BlackHole.Cli.SceneOptions
import BlackHole.Scene.Preset
import Control.Monad (forM_)
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Char8 as Char8
import Data.List (isPrefixOf)
import Options.Applicative
import Support.Program (quietly)
import System.Directory
import System.Exit (ExitCode (..))
import System.FilePath ((</>))
import System.IO.Temp (withSystemTempDirectory)
import Test.Hspec

spec :: Spec
spec = do
  it "makes each frame as render would make its scene" . inFolder $ \folder -> do
    writeFilm
      folder
      ["animation: {frames: 3, fps: 1, keyframes: {camera.azimuth: {0: 90, 2: 100}}}"]
    quietly ["animate", folder </> "animation.yaml", "-o", folder </> "%d.png"]
      `shouldReturn` ExitSuccess
    quietly ["render", folder </> "animation.yaml", "--azimuth", "95", "-o", folder </> "alone.png"]
      `shouldReturn` ExitSuccess
    alone <- Bytes.readFile (folder </> "alone.png")
    Bytes.readFile (folder </> "1.png") `shouldReturn` alone
    first <- Bytes.readFile (folder </> "0.png")
    (first == alone) `shouldBe` False
  it "makes frames with an open shutter that can be rendered from themselves" . inFolder $
    \folder -> do
      writeFilm
        folder
        [ "animation: {frames: 2, fps: 1, shutter: 0.5, shutter-samples: 3, \
          \keyframes: {camera.azimuth: {0: 90, 2: 100}, camera.roll: {0: 0, 2: 9}}}"
        ]
      forM_ [".png", ".exr"] $ \extension -> do
        quietly ["animate", folder </> "animation.yaml", "-o", folder </> ("%d" ++ extension)]
          `shouldReturn` ExitSuccess
        quietly
          [ "render",
            "--from",
            folder </> ("1" ++ extension),
            "-o",
            folder </> ("again" ++ extension)
          ]
          `shouldReturn` ExitSuccess
        frame <- Bytes.readFile (folder </> ("1" ++ extension))
        Bytes.readFile (folder </> ("again" ++ extension)) `shouldReturn` frame
      quietly ["render", "--from", folder </> "1.png", "--tile", "1/2", "-o", folder </> "a.tile"]
        `shouldReturn` ExitFailure 3
  it "renders a shard, a range, and then the rest" . inFolder $ \folder -> do
    writeFilm folder ["animation: {frames: 5, camera-path: {kind: orbit}}"]
    let frames arguments =
          quietly
            ( ["animate", folder </> "animation.yaml", "-o", folder </> "f" </> "%d.png"]
                ++ arguments
            )
        there = filter ((/= '.') . headOr '.') <$> listDirectory (folder </> "f")
    frames ["--shard", "2/3"] `shouldReturn` ExitSuccess
    there >>= (`shouldMatchList` ["1.png", "4.png"])
    quietly ["animate", "--status", folder </> "f"] `shouldReturn` ExitFailure 5
    frames ["--frame-range", "2-3"] `shouldReturn` ExitSuccess
    there >>= (`shouldMatchList` ["1.png", "2.png", "3.png", "4.png"])
    time <- getModificationTime (folder </> "f" </> "1.png")
    frames [] `shouldReturn` ExitSuccess
    getModificationTime (folder </> "f" </> "1.png") `shouldReturn` time
    quietly ["animate", "--status", folder </> "f"] `shouldReturn` ExitSuccess
  it "goes on after a frame that cannot be written, and says so by its exit code" . inFolder $
    \folder -> do
      writeFilm folder ["animation: {frames: 3}"]
      createDirectoryIfMissing True (folder </> "f" </> "1.png")
      quietly ["animate", folder </> "animation.yaml", "-o", folder </> "f" </> "%d.png"]
        `shouldReturn` ExitFailure 5
      mapM (\n -> doesFileExist (folder </> "f" </> (show n ++ ".png"))) [0 :: Int, 1, 2]
        `shouldReturn` [True, False, True]
  describe "mistakes" $ do
    fails 3 [] ["animation: {frames: 3, fsp: 3}"]
    fails 3 [] ["camera: {azimut: 3}", "animation: {frames: 3}"]
    fails 3 [] ["animation: {frames: 3, keyframes: {camera.distance: {0: 3, 0.05: 0.5}}}"]
    fails 3 [] []
    fails 3 ["--fps", "0"] ["animation: {frames: 3}"]
    fails 3 ["--shutter", "1.5"] ["animation: {frames: 3}"]
    fails 2 ["--frame-range", "3"] ["animation: {frames: 3}"]
    fails 2 ["--frame-range", "2-1"] ["animation: {frames: 3}"]
    fails 2 ["--shard", "4/3"] ["animation: {frames: 3}"]
    fails 2 ["--video", "animation.avi"] ["animation: {frames: 3}"]
    fails 2 ["--video", "animation.mp4", "--shard", "1/3"] ["animation: {frames: 3}"]
    fails 2 ["--threads", "0"] ["animation: {frames: 3}"]
    fails 2 ["--stale-after", "0"] ["animation: {frames: 3}"]
    it "says what is wrong with many frames once" $
      case resolveAnimation
        (SceneOptions (Just "f.yaml") Nothing [])
        ( Just (Char8.pack "animation: {frames: 48, keyframes: {camera.distance: {0: 10, 1: 0.5}}}")
        ) of
        Right (Just animation) ->
          map (takeWhile (/= ':')) (frameFaults animation [0 .. 47])
            `shouldBe` ["frame 23", "frames 24-47"]
        other -> expectationFailure (either unlines (const "no animation") other)
    it "puts the scene's mistakes beside the animation's" $
      case resolveAnimation
        (SceneOptions (Just "f.yaml") Nothing [])
        (Just (Char8.pack "camera: {roll: left}\nanimation: {frames: 0}")) of
        Left problems -> map (takeWhile (/= ' ')) problems `shouldBe` ["f.yaml:1:", "f.yaml:2:"]
        Right _ -> expectationFailure "taken"
  describe "adjustAnimation" $ do
    it "keeps an animation's length at another rate" $
      adjusted ["--fps", "48"] `shouldBe` Just (96, 48)
    it "takes another length" $ adjusted ["--duration", "0.5"] `shouldBe` Just (12, 24)
    it "takes both" $ adjusted ["--duration", "3", "--fps", "10"] `shouldBe` Just (30, 10)
    it "leaves the animation alone otherwise" $ adjusted [] `shouldBe` Just (48, 24)
  where
    inFolder = withSystemTempDirectory "blackhole-spec"
    writeFilm folder text =
      writeFile
        (folder </> "animation.yaml")
        ( unlines
            ( [ "image: {width: 16}",
                "sampling: {samples: 1}",
                "physics: {gravity: false}",
                "disk: {present: false}",
                "sky: {kind: grid}"
              ]
                ++ text
            )
        )
    headOr = foldr const
    fails code arguments text =
      it
        ( unwords ("animate" : arguments ++ text) ++ " exits with " ++ show code
            ++ " and writes nothing"
        )
        . inFolder
        $ \folder -> do
          writeFilm folder text
          quietly (["animate", folder </> "animation.yaml", "-o", folder </> "%d.png"] ++ arguments)
            `shouldReturn` ExitFailure code
          filter (not . ("animation" `isPrefixOf`)) <$> listDirectory folder `shouldReturn` []
    adjusted arguments =
      ( \options ->
          let animation =
                adjustAnimation options (stillAnimation defaultScene)
           in (animationFrames animation, animationRate animation)
      )
        <$> getParseResult (execParserPure defaultPrefs (info animateOptions mempty) arguments)
