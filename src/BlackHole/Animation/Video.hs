-- | Video files, which ffmpeg encodes as a separate process from the files of the
-- finished frames. A failure of ffmpeg leaves the frames untouched.
module BlackHole.Animation.Video
  ( VideoKind (..),
    videoKind,
    videoExtensions,
    VideoCodec (..),
    videoCodecs,
    VideoCoding (..),
    videoCodingProblems,
    ffmpegArguments,
    Video,
    findCoder,
    startVideo,
    feedVideo,
    finishVideo,
    abandonVideo,
  )
where

import BlackHole.Image.PartFile
import BlackHole.Scene.Problem (Problem (..))
import Control.Applicative ((<|>))
import Control.Concurrent.Async (Async, async, cancel, wait)
import Control.Concurrent.Chan (Chan, newChan, readChan, writeChan)
import Control.Exception (IOException, catch, mask_, try)
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Char8 as Char8
import Data.Char (toLower)
import Data.Either (fromRight)
import Data.Functor (($>))
import Data.List (intercalate)
import Data.Maybe (fromMaybe, isJust, listToMaybe)
import Numeric (showFFloat)
import System.Directory (findExecutable)
import System.Exit (ExitCode (..))
import System.FilePath (takeDirectory, takeExtension)
import System.IO (Handle, hClose, hSetBinaryMode)
import System.Process

-- | The kinds of video files.
data VideoKind
  = -- | H.264 in MP4.
    Mp4
  | -- | VP9 in WebM.
    WebM
  | -- | A GIF with 256 colours chosen for the video.
    Gif
  deriving (Eq, Show, Enum, Bounded)

-- | The kind of file for a name's extension; 'Nothing' for other extensions.
videoKind :: FilePath -> Maybe VideoKind
videoKind path =
  lookup
    (map toLower (takeExtension path))
    [(videoExtension kind, kind) | kind <- [minBound ..]]

-- | The extensions that 'videoKind' accepts.
videoExtensions :: [String]
videoExtensions = map videoExtension [minBound ..]

videoExtension :: VideoKind -> String
videoExtension kind = case kind of
  Mp4 -> ".mp4"
  WebM -> ".webm"
  Gif -> ".gif"

-- | The codecs of video files.
data VideoCodec = H264 | H265 | Vp9 | Av1
  deriving (Eq, Show, Enum, Bounded)

-- | The codecs with their names on the command line.
videoCodecs :: [(String, VideoCodec)]
videoCodecs = [("h264", H264), ("h265", H265), ("vp9", Vp9), ("av1", Av1)]

-- | The codecs that a kind of file can hold, the default first.
kindCodecs :: VideoKind -> [VideoCodec]
kindCodecs kind = case kind of
  Mp4 -> [H264, H265, Av1]
  WebM -> [Vp9, Av1]
  Gif -> []

-- | How to encode a video file.
data VideoCoding = VideoCoding
  { videoCodingKind :: !VideoKind,
    -- | Without a codec, the kind's default.
    videoCodingCodec :: !(Maybe VideoCodec),
    -- | The codec's constant rate factor: smaller numbers mean better quality and
    -- larger files. Without one, a default for high quality.
    videoCodingCrf :: !(Maybe Int)
  }
  deriving (Eq, Show)

-- | The problems of an encoding: a codec that the kind of file cannot hold, or a rate
-- factor out of the codec's range.
videoCodingProblems :: VideoCoding -> [Problem]
videoCodingProblems (VideoCoding kind codec crf) = case (kindCodecs kind, codec) of
  ([], _) ->
    [ Mistake option "has no effect on a GIF"
      | (option, True) <- [("--codec", isJust codec), ("--crf", isJust crf)]
    ]
  (codecs, Just own)
    | own
        `notElem` codecs ->
      [ Problem
          "--codec"
          (nameOf own)
          ( "a codec of " ++ videoExtension kind ++ " files; the choices are: "
              ++ intercalate ", " (map nameOf codecs)
          )
      ]
  (standard : _, _) ->
    [ Problem
        "--crf"
        (show n)
        ("a whole number from 0 to " ++ show most ++ " (for " ++ nameOf own ++ ")")
      | let own = fromMaybe standard codec,
        let most = if own `elem` [H264, H265] then 51 else 63,
        Just n <- [crf],
        n < 0 || n > most
    ]
  where
    nameOf c = concat [name | (name, named) <- videoCodecs, named == c]

-- | The arguments for ffmpeg to read PNG files one after the other from its standard
-- input and write a video of some frames per second to a file. They declare the colours
-- as they are: the primaries and the transfer curve of sRGB with the matrix of BT.709.
-- All codecs halve the resolution of colour, which takes even sides: odd ones get a row
-- or column of black.
ffmpegArguments :: VideoCoding -> Double -> FilePath -> [String]
ffmpegArguments (VideoCoding kind codec crf) rate output =
  ["-hide_banner", "-loglevel", "error", "-nostats", "-y"]
    ++ ["-f", "image2pipe", "-framerate", showFFloat Nothing rate "", "-c:v", "png", "-i", "-"]
    ++ coding
    ++ ["file:" ++ output]
  where
    coding = case (fromMaybe H264 (codec <|> listToMaybe (kindCodecs kind)), kind) of
      (_, Gif) ->
        [ "-filter_complex",
          "split[a][b];[a]palettegen[p];[b][p]paletteuse=dither=sierra2_4a",
          "-loop",
          "0",
          "-f",
          "gif"
        ]
      (own, _) -> ["-vf", planes] ++ encoder own ++ colours ++ container
    encoder own = case own of
      H264 -> ["-c:v", "libx264", "-preset", "slow"] ++ quality 16
      H265 ->
        ["-c:v", "libx265", "-preset", "slow", "-x265-params", "log-level=error"]
          ++ quality 18
          ++ ["-tag:v", "hvc1"]
      Vp9 -> ["-c:v", "libvpx-vp9"] ++ quality 24 ++ ["-b:v", "0"]
      Av1 -> ["-c:v", "libsvtav1", "-preset", "5"] ++ quality 24
    quality standard = ["-crf", show (fromMaybe standard crf)]
    container = case kind of
      WebM -> ["-f", "webm"]
      _ -> ["-movflags", "+faststart", "-f", "mp4"]
    planes =
      "pad=ceil(iw/2)*2:ceil(ih/2)*2,scale=out_color_matrix=bt709:out_range=tv,format=yuv420p"
    colours =
      [ "-colorspace",
        "bt709",
        "-color_primaries",
        "bt709",
        "-color_trc",
        "iec61966-2-1",
        "-color_range",
        "tv"
      ]

-- | The path of ffmpeg, if it is installed; 'Nothing' without a variable @PATH@.
findCoder :: IO (Maybe FilePath)
findCoder = fromRight Nothing <$> reasonOf (findExecutable "ffmpeg")

-- | A video file that is being encoded.
data Video = Video
  { videoTarget :: !FilePath,
    videoPart :: !FilePath,
    videoProcess :: !ProcessHandle,
    videoInput :: !Handle,
    videoFrames :: !(Chan (Maybe FilePath)),
    -- | Ends with the reason if a frame could not be passed on.
    videoFeeder :: !(Async (Maybe String)),
    -- | Ends with the messages of ffmpeg.
    videoComplaints :: !(Async String)
  }

-- | @startVideo ffmpeg coding rate target@ starts ffmpeg, given its path, for a video of
-- some frames per second. The file appears, complete, with 'finishVideo'. 'Left' holds
-- the reason if ffmpeg cannot be started.
startVideo :: FilePath -> VideoCoding -> Double -> FilePath -> IO (Either String Video)
startVideo coder coding rate target = mask_ $ do
  sweepPartFiles (takeDirectory target)
  opened <- reasonOf (openPartFile (takeDirectory target) (videoExtension (videoCodingKind coding)))
  case opened of
    Left reason -> pure (Left reason)
    Right (part, handle) -> do
      hClose handle
      launched <-
        reasonOf . createProcess $
          (proc coder (ffmpegArguments coding rate part))
            { std_in = CreatePipe,
              std_err = CreatePipe
            }
      case launched of
        Right (Just input, Nothing, Just complaints, process) -> do
          hSetBinaryMode input True
          frames <- newChan
          feeder <- async (feeding input frames)
          said <- async (wholly complaints)
          pure (Right (Video target part process input frames feeder said))
        Right (_, _, _, process) -> do
          terminateProcess process
          removePartFile part
          pure (Left "its pipes could not be made")
        Left reason -> removePartFile part $> Left reason
  where
    feeding input frames = do
      next <- readChan frames
      case next of
        Nothing -> pure Nothing
        Just file -> do
          fed <- reasonOf (Bytes.readFile file >>= Bytes.hPut input)
          either (pure . Just) (const (feeding input frames)) fed
    wholly complaints = do
      bytes <- Bytes.hGetContents complaints
      pure (unwords (words (Char8.unpack bytes)))

-- | Passes on the file of the next frame, without waiting for ffmpeg.
feedVideo :: Video -> FilePath -> IO ()
feedVideo video = writeChan (videoFrames video) . Just

-- | Waits until ffmpeg has encoded all frames, and moves the video file to its place.
-- 'Left' holds the reason for a failure, after which there is no new file.
finishVideo :: Video -> IO (Either String ())
finishVideo video = do
  writeChan (videoFrames video) Nothing
  fault <- wait (videoFeeder video)
  quietly (hClose (videoInput video))
  code <- waitForProcess (videoProcess video)
  said <- wait (videoComplaints video)
  case (code, fault) of
    (ExitSuccess, Nothing) -> do
      moved <- reasonOf (placePartFile (videoPart video) (videoTarget video))
      either (failed . ("cannot write " ++) . ((videoTarget video ++ ": ") ++)) (pure . Right) moved
    (ExitFailure n, _)
      | n < 0 -> failed ("ffmpeg was killed by signal " ++ show (negate n) ++ remark said)
      | otherwise -> failed ("ffmpeg ended with code " ++ show n ++ remark said)
    (_, Just reason) -> failed ("ffmpeg did not take all frames: " ++ reason ++ remark said)
  where
    failed reason = removePartFile (videoPart video) $> Left reason
    remark said = if null said then "" else " (" ++ take 400 said ++ ")"

-- | Stops ffmpeg and removes its unfinished file.
abandonVideo :: Video -> IO ()
abandonVideo video = mask_ $ do
  cancel (videoFeeder video)
  terminateProcess (videoProcess video)
  quietly (hClose (videoInput video))
  _ <- waitForProcess (videoProcess video)
  removePartFile (videoPart video)

reasonOf :: IO a -> IO (Either String a)
reasonOf action = either (Left . reason) Right <$> try action
  where
    reason :: IOException -> String
    reason = show

quietly :: IO () -> IO ()
quietly action = action `catch` refused
  where
    refused :: IOException -> IO ()
    refused _ = pure ()
