-- | What @blackhole explore@ tells a page.
module BlackHole.Explore.Reply
  ( Reply (..),
    JobState (..),
    Frame (..),
    Stage (..),
    frameBytes,
  )
where

import BlackHole.Explore.CommandLine
import BlackHole.Explore.Message (Input)
import BlackHole.Scene.Scene (Scene)
import BlackHole.Trace.Explain (Explanation)
import BlackHole.Vector.XYZ (XYZ)
import qualified Data.ByteString.Builder as Builder
import qualified Data.ByteString.Lazy as Lazy

-- | An answer, or news.
data Reply
  = -- | The scene after an input, and the name of the preset it comes from.
    SceneIs !Input !String !Scene
  | -- | Why an input, or another message, has no effect: at least one line.
    Refused !(Maybe Input) ![String]
  | -- | A pixel of the present scene's own picture, and points of the light path
    -- through its middle.
    PixelIs !Scene !Explanation ![XYZ]
  | -- | The command line, given the preset's name.
    CommandIs !CommandLine
  | -- | A file has been written.
    Saved !FilePath
  | -- | There is a file of that name already.
    Exists !FilePath
  | -- | What is wrong with the animation, or the settings that cannot change in it.
    AnimationIs !(Either [String] [String])
  | -- | The state of the picture that is being rendered to a file.
    JobIs !JobState

-- | A rendering at full size.
data JobState
  = NoJob
  | -- | The file, and the finished fraction.
    JobRuns !FilePath !Double
  | -- | The file, and the seconds it took.
    JobDone !FilePath !Double
  | JobStopped !FilePath
  | -- | The file, and what went wrong.
    JobFailed !FilePath !String
  deriving (Eq, Show)

-- | How far a picture is from the final one.
data Stage = Moving | Refining | Finished
  deriving (Eq, Show, Enum)

-- | A picture for the page.
data Frame = Frame
  { frameStage :: !Stage,
    -- | Finished part of the refinement, 0 to 1.
    frameDone :: !Double,
    frameNumber :: !Int,
    -- | The newest input that the picture shows.
    frameInput :: !Input,
    frameSize :: !(Int, Int),
    -- | A JPEG, or a PNG if it is finished.
    framePicture :: !Lazy.ByteString
  }

-- | A frame as a binary message: stage (one byte), finished part in 255ths (one byte),
-- width and height (two bytes each), number and input (four bytes each), all with the
-- most significant byte first; two zero bytes; then the picture.
frameBytes :: Frame -> Lazy.ByteString
frameBytes frame =
  Builder.toLazyByteString $
    Builder.word8 (fromIntegral (fromEnum (frameStage frame)))
      <> Builder.word8 (round (255 * max 0 (min 1 (frameDone frame))))
      <> Builder.word16BE (fromIntegral width)
      <> Builder.word16BE (fromIntegral height)
      <> Builder.word32BE (fromIntegral (frameNumber frame))
      <> Builder.word32BE (fromIntegral (frameInput frame))
      <> Builder.word16BE 0
      <> Builder.lazyByteString (framePicture frame)
  where
    (width, height) = frameSize frame
