module BlackHole.Animation.VideoFeedSpec (spec) where

import BlackHole.Animation.FrameName
import BlackHole.Animation.Queue (Outcome (..))
import BlackHole.Animation.Video (VideoCoding (..), VideoKind (Mp4))
import BlackHole.Animation.VideoFeed
import Data.List (isInfixOf)
import System.Directory
import System.FilePath ((</>))
import System.IO.Temp (withSystemTempDirectory)
import Test.Hspec

spec :: Spec
spec = do
  it "sends frames in the animation's order, whatever the order in which they are done" . inFolder $
    \folder -> do
      feed <- started folder [2, 3, 4, 5, 6]
      mapM_ (\n -> feedFrame feed n (if even n then WasDone else Rendered 1)) [4, 3, 6, 2, 5]
      finishVideoFeed feed `shouldReturn` Nothing
      readFile (folder </> "animation.mp4") `shouldReturn` concatMap picture [2 .. 6]
  it "makes no animation that lacks a frame, and says which" . inFolder $ \folder -> do
    feed <- started folder [0, 1, 2, 3]
    mapM_
      (uncurry (feedFrame feed))
      [(0, WasDone), (1, Failed "no light"), (2, Rendered 1), (3, Elsewhere Nothing)]
    finishVideoFeed feed `shouldReturn` Just "frames 1, 3 are missing"
    filter ("mp4" `isInfixOf`) <$> listDirectory folder `shouldReturn` []
  where
    inFolder = withSystemTempDirectory "blackhole-spec"
    picture n = "frame " ++ show (n :: Int) ++ "\n"
    -- A coder of one line stands for ffmpeg.
    started folder frames = do
      let coder = folder </> "coder"
      writeFile coder "#!/bin/sh\nfor last; do :; done; cat >\"${last#file:}\"\n"
      getPermissions coder >>= setPermissions coder . setOwnerExecutable True
      mapM_ (\n -> writeFile (folder </> (show n ++ ".png")) (picture n)) frames
      case parseFrameName (folder </> "%d.png") of
        Right name ->
          startVideoFeed
            coder
            (VideoCoding Mp4 Nothing Nothing)
            24
            (folder </> "animation.mp4")
            name
            frames
        Left reason -> fail reason
