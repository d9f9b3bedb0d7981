module BlackHole.Animation.VideoSpec (spec) where

import BlackHole.Animation.Video
import BlackHole.Scene.Problem (renderProblem)
import Data.List (isInfixOf)
import System.Directory
import System.FilePath ((</>))
import System.IO.Temp (withSystemTempDirectory)
import Test.Hspec

spec :: Spec
spec = do
  it "knows animations by their extension" $
    map videoKind ["a.mp4", "b.WebM", "c.gif", "d.avi", "mp4"]
      `shouldBe` [Just Mp4, Just WebM, Just Gif, Nothing, Nothing]
  it "reads PNG files from a pipe and never asks" $ do
    let arguments = ffmpegArguments (plain Mp4) 23.976 "-o.mp4"
    arguments `shouldContain` ["-framerate", "23.976", "-c:v", "png", "-i", "-"]
    arguments `shouldContain` ["-y"]
    -- A name that begins with a dash or holds a colon is a file's all the same.
    last' arguments `shouldBe` "file:-o.mp4"
  it "passes the codec and the rate factor on" $ do
    ffmpegArguments (VideoCoding Mp4 (Just H265) (Just 20)) 24 "a"
      `shouldContain` ["-c:v", "libx265"]
    ffmpegArguments (VideoCoding Mp4 (Just H265) (Just 20)) 24 "a" `shouldContain` ["-crf", "20"]
    ffmpegArguments (VideoCoding WebM (Just Av1) Nothing) 24 "a"
      `shouldContain` ["-c:v", "libsvtav1"]
    ffmpegArguments (plain Mp4) 24 "a"
      `shouldContain` ["-c:v", "libx264", "-preset", "slow", "-crf", "16"]
  it "refuses codecs and rate factors that the file cannot have" $ do
    let refused kind codec crf =
          map renderProblem (videoCodingProblems (VideoCoding kind codec crf))
    refused Mp4 (Just H264) (Just 51) `shouldBe` []
    refused WebM (Just Vp9) (Just 63) `shouldBe` []
    refused Mp4 Nothing (Just 52)
      `shouldBe` ["--crf: 52 is not a whole number from 0 to 51 (for h264)"]
    refused WebM Nothing (Just 64)
      `shouldBe` ["--crf: 64 is not a whole number from 0 to 63 (for vp9)"]
    refused WebM (Just H264) Nothing
      `shouldBe` ["--codec: h264 is not a codec of .webm files; the choices are: vp9, av1"]
    refused Gif (Just Av1) (Just 3)
      `shouldBe` ["--codec: has no effect on a GIF", "--crf: has no effect on a GIF"]
  -- A coder of three lines stands for ffmpeg where its fate is to be known.
  it "sends all frames, in order, and shows the animation when it is complete" . inFolder $
    \folder -> do
      coder <- script folder "for last; do :; done; cat >\"${last#file:}\""
      frames <- mapM (frame folder) [0 .. 9]
      video <- started coder (folder </> "animation.mp4")
      mapM_ (feedVideo video) frames
      doesFileExist (folder </> "animation.mp4") `shouldReturn` False
      finishVideo video `shouldReturn` Right ()
      readFile (folder </> "animation.mp4") `shouldReturn` concatMap picture [0 .. 9]
      leftOver folder `shouldReturn` []
  it
    "says what happened to a coder that dies, keeps the former animation, and leaves nothing"
    . inFolder
    $ \folder -> do
      coder <- script folder "head -c 5 >/dev/null; echo 'no such codec' >&2; exit 7"
      frames <- mapM (frame folder) [0 .. 9]
      writeFile (folder </> "animation.mp4") "former"
      video <- started coder (folder </> "animation.mp4")
      mapM_ (feedVideo video) (concat (replicate 2000 frames))
      outcome <- finishVideo video
      outcome
        `shouldSatisfy` either
          (\reason -> "code 7" `isInfixOf` reason && "no such codec" `isInfixOf` reason)
          (const False)
      readFile (folder </> "animation.mp4") `shouldReturn` "former"
      mapM readFile frames `shouldReturn` map picture [0 .. 9]
      leftOver folder `shouldReturn` []
  it "ends the coder and leaves nothing when the animation is given up" . inFolder $ \folder -> do
    coder <- script folder "exec sleep 1000"
    video <- started coder (folder </> "animation.mp4")
    abandonVideo video
    doesFileExist (folder </> "animation.mp4") `shouldReturn` False
    leftOver folder `shouldReturn` []
  it "says so when there is no such program" . inFolder $ \folder -> do
    outcome <- startVideo (folder </> "nothing") (plain Gif) 24 (folder </> "animation.gif")
    either (const True) (const False) outcome `shouldBe` True
    leftOver folder `shouldReturn` []
  where
    inFolder = withSystemTempDirectory "blackhole-spec"
    plain kind = VideoCoding kind Nothing Nothing
    picture n = "frame " ++ show (n :: Int) ++ "\n"
    frame folder n = do
      let file = folder </> (show n ++ ".png")
      writeFile file (picture n)
      pure file
    script folder text = do
      let file = folder </> "coder"
      writeFile file ("#!/bin/sh\n" ++ text ++ "\n")
      getPermissions file >>= setPermissions file . setOwnerExecutable True
      pure file
    started coder file = startVideo coder (plain Mp4) 24 file >>= either fail pure
    leftOver folder = filter (isInfixOf "blackhole-") <$> listDirectory folder
    last' = foldl (const id) ""
