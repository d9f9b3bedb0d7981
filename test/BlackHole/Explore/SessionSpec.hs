{-# LANGUAGE OverloadedStrings #-}

-- | A page without a browser and without a web server: messages go in and out through
-- queues.
module BlackHole.Explore.SessionSpec (spec) where

import BlackHole.Cli.ExploreJson
import BlackHole.Cli.Json
import BlackHole.Explore.Picture
import BlackHole.Explore.ServerState
import BlackHole.Explore.Service
import BlackHole.Explore.Session
import BlackHole.Image.Coding (Format (..), defaultCoding)
import BlackHole.Image.Metadata (software)
import BlackHole.Image.Write
import BlackHole.Render.Film
import BlackHole.Render.Workers
import BlackHole.Scene.Camera
import BlackHole.Scene.Preset
import BlackHole.Scene.Scene
import Control.Concurrent (threadDelay)
import Control.Concurrent.Async
import Control.Concurrent.STM
import Control.Monad (forM_)
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Builder as Builder
import qualified Data.ByteString.Char8 as Char8
import qualified Data.ByteString.Lazy as Lazy
import Data.List (isInfixOf)
import Data.List.NonEmpty (NonEmpty (..))
import System.Directory
import System.IO.Temp (withSystemTempDirectory)
import System.Timeout (timeout)
import Test.Hspec
import Test.QuickCheck (generate, vectorOf)
import Test.QuickCheck.Arbitrary (arbitrary)

spec :: Spec
spec = do
  it "shows a coarse picture first and in the end the bytes of render" $
    withPage $ \page -> do
      say page "window 48 27"
      frames <- framesUntilFinished page
      (frameStage (head frames), Bytes.take 2 (framePicture (head frames)))
        `shouldBe` (0, "\xff\xd8")
      let scene = defaultScene {scenePicture = Picture 48 27}
      exposed <- exposeFilm Nothing oneWorker (const (pure ())) scene (0, 27)
      expected <-
        maybe
          (pure Nothing)
          (pictureBytes oneWorker software Png defaultCoding (scene :| []))
          exposed
      Just (Lazy.fromStrict (framePicture (last frames))) `shouldBe` expected
  it "refines to the same bytes whatever came before" $
    withPage $ \page -> do
      say page "window 48 27"
      _ <- framesUntilFinished page
      -- Interrupted, developed anew, and undone.
      forM_ [1 .. 8 :: Int] $ \n -> say page (Char8.pack ("orbit " ++ show n ++ " 3 1"))
      say page "change 9\noutput.exposure 1"
      say page "preset 10 default"
      frames <- framesUntil page (\f -> frameStage f == 2 && frameInput f == 10)
      withPage $ \fresh -> do
        say fresh "window 48 27"
        others <- framesUntilFinished fresh
        framePicture (last frames) `shouldBe` framePicture (last others)
  it "sends no third frame to a page that draws none" $
    withPage $ \page -> do
      say page "window 48 27"
      forM_ [1 .. 20 :: Int] $ \n ->
        say page (Char8.pack ("orbit " ++ show n ++ " 3 1")) >> threadDelay 50000
      frames <- atomically (flushTQueue (pageFrames page))
      length frames `shouldSatisfy` (<= 2)
      forM_ frames (drawn page)
      more <- framesUntil page (\f -> frameInput f == 20)
      length more `shouldSatisfy` (>= 1)
  it "answers a thousand random messages and goes on" $
    withPage $ \page -> do
      texts <- generate (vectorOf 1000 (vectorOf 20 arbitrary))
      mapM_ (say page . Bytes.pack) texts
      say page "window 48 27"
      say page "preset 1 luminet"
      frames <- framesUntil page (\f -> frameStage f == 2 && frameInput f == 1)
      null frames `shouldBe` False
  it "refuses what is out of range, without effect, or elsewhere" $
    withPage $ \page -> do
      say page "change 1\ncamera.fov 400"
      reply page "camera.fov: '400' is not an angle"
      say page "change 2\nhole.spin 0.5\nphysics.gravity off"
      reply page "hole.spin: 0.5 has no effect"
      say page "change 3\nsky.kind /etc/hostname"
      reply page "'/etc/hostname' is not in the folder"
      say page "restore 4 default\nsky.kind ../sky.png"
      reply page "is not a scene"
      say page "render keep ../hole.png"
      reply page "is not a plain name"
      say page "scrub 5 1"
      reply page "there is no animation"
  it "saves and renders, with the bytes of the command line" $
    withPage $ \page -> do
      say page "change 1\nimage.width 32"
      reply page "\"input\": 1"
      say page "save-scene keep mine.yaml"
      reply page "\"type\": \"saved\""
      say page "save-scene keep mine.yaml"
      reply page "\"type\": \"exists\""
      say page "render keep hole.png"
      reply page "\"state\": \"done\""
      written <- Lazy.readFile "hole.png"
      let scene = defaultScene {scenePicture = Picture 32 18}
      exposed <- exposeFilm Nothing oneWorker (const (pure ())) scene (0, 18)
      expected <-
        maybe
          (pure Nothing)
          (pictureBytes oneWorker software Png defaultCoding (scene :| []))
          exposed
      Just written `shouldBe` expected
  it "keeps the scenes of two pages apart" $
    withPage $ \one -> do
      other <- another (pageState one)
      withAsync (serveSession (pageState one) (pageTalk other)) $ \_ -> do
        say one "preset 1 luminet"
        say other "preset 1 kerr"
        reply one "\"preset\": \"luminet\""
        reply other "\"preset\": \"kerr\""
        atomically (busy (pageState one)) `shouldReturn` True

-- | A frame as it arrives.
data Frame' = Frame'
  { frameStage :: !Int,
    frameNumber :: !Int,
    frameInput :: !Int,
    framePicture :: !Bytes.ByteString
  }

data Page = Page
  { pageState :: !ServerState,
    pageIn :: !(TQueue Bytes.ByteString),
    pageFrames :: !(TQueue Frame'),
    pageTexts :: !(TQueue String),
    pageTalk :: !Connection
  }

-- | A page of a new state, in a folder of its own.
withPage :: (Page -> IO ()) -> IO ()
withPage action = withSystemTempDirectory "blackhole" $ \folder -> withCurrentDirectory folder $ do
  state <-
    newServerState
      (Renderer oneWorker (const (pure (Right Nothing))) (\_ _ -> pure Nothing))
      ("default", defaultScene)
      (Builder.toLazyByteString . Builder.stringUtf8 . renderJson . replyJson)
  page <- another state
  outcome <-
    timeout
      120000000
      (withAsync (serveSession state (pageTalk page)) (\running -> link running >> action page))
  outcome `shouldBe` Just ()

another :: ServerState -> IO Page
another state = do
  incoming <- newTQueueIO
  frames <- newTQueueIO
  texts <- newTQueueIO
  let receive message = atomically $ case message of
        TextMessage text -> writeTQueue texts (Char8.unpack (Lazy.toStrict text))
        BinaryMessage bytes -> writeTQueue frames (frameOf (Lazy.toStrict bytes))
  pure
    ( Page
        state
        incoming
        frames
        texts
        (Connection (Just <$> atomically (readTQueue incoming)) receive)
    )

frameOf :: Bytes.ByteString -> Frame'
frameOf bytes = Frame' (number 0 1) (number 6 4) (number 10 4) (Bytes.drop 16 bytes)
  where
    number at count =
      Bytes.foldl' (\n b -> 256 * n + fromIntegral b) 0 (Bytes.take count (Bytes.drop at bytes))

say :: Page -> Bytes.ByteString -> IO ()
say page = atomically . writeTQueue (pageIn page)

drawn :: Page -> Frame' -> IO ()
drawn page frame = say page (Char8.pack ("drawn " ++ show (frameNumber frame)))

-- | The frames up to one, each of which is drawn.
framesUntil :: Page -> (Frame' -> Bool) -> IO [Frame']
framesUntil page good = do
  frame <- atomically (readTQueue (pageFrames page))
  drawn page frame
  if good frame then pure [frame] else (frame :) <$> framesUntil page good

framesUntilFinished :: Page -> IO [Frame']
framesUntilFinished page = framesUntil page ((== 2) . frameStage)

-- | Wait for a reply that contains a text.
reply :: Page -> String -> IO ()
reply page part = do
  text <- atomically (readTQueue (pageTexts page))
  if part `isInfixOf` text then pure () else reply page part
