-- | Films as one file, coded by ffmpeg, which is a program of its own. It is fed
-- with the finished frames' files as they come; nothing that happens to it can
-- harm them.
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
import System.Directory (findExecutable, removeFile, renameFile)
import System.Exit (ExitCode (..))
import System.FilePath (takeDirectory, takeExtension)
import System.IO (Handle, hClose, hSetBinaryMode)
import System.Process

-- | The kinds of film files.
data VideoKind
  = -- | H.264 in MP4.
    Mp4
  | -- | VP9 in WebM.
    WebM
  | -- | A GIF of 256 colours chosen for the film.
    Gif
  deriving (Eq, Show, Enum, Bounded)

-- | The kind that a file's name asks for.
videoKind :: FilePath -> Maybe VideoKind
videoKind path = lookup (map toLower (takeExtension path)) [(videoExtension kind, kind) | kind <- [minBound ..]]

-- | The extensions that 'videoKind' knows.
videoExtensions :: [String]
videoExtensions = map videoExtension [minBound ..]

videoExtension :: VideoKind -> String
videoExtension kind = case kind of
  Mp4 -> ".mp4"
  WebM -> ".webm"
  Gif -> ".gif"

-- | The codecs of film files.
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

-- | How to encode a film file.
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
  ([], _) -> [Mistake option "has no effect on a GIF" | (option, True) <- [("--codec", isJust codec), ("--crf", isJust crf)]]
  (codecs, Just own) | own `notElem` codecs -> [Problem "--codec" (nameOf own) ("a codec of " ++ videoExtension kind ++ " files; the choices are: " ++ intercalate ", " (map nameOf codecs))]
  (standard : _, _) ->
    [ Problem "--crf" (show n) ("a whole number from 0 to " ++ show most ++ " (for " ++ nameOf own ++ ")")
      | let own = fromMaybe standard codec,
        let most = if own `elem` [H264, H265] then 51 else 63,
        Just n <- [crf],
        n < 0 || n > most
    ]
  where
    nameOf c = concat [name | (name, named) <- videoCodecs, named == c]

-- | The arguments for ffmpeg to read PNG files one after the other from its standard
-- input and write a film of some frames per second to a file. They declare the colours
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
      (_, Gif) -> ["-filter_complex", "split[a][b];[a]palettegen[p];[b][p]paletteuse=dither=sierra2_4a", "-loop", "0", "-f", "gif"]
      (own, _) -> ["-vf", planes] ++ encoder own ++ colours ++ container
    encoder own = case own of
      H264 -> ["-c:v", "libx264", "-preset", "slow"] ++ quality 16
      H265 -> ["-c:v", "libx265", "-preset", "slow", "-x265-params", "log-level=error"] ++ quality 18 ++ ["-tag:v", "hvc1"]
      Vp9 -> ["-c:v", "libvpx-vp9"] ++ quality 24 ++ ["-b:v", "0"]
      Av1 -> ["-c:v", "libsvtav1", "-preset", "5"] ++ quality 24
    quality standard = ["-crf", show (fromMaybe standard crf)]
    container = case kind of
      WebM -> ["-f", "webm"]
      _ -> ["-movflags", "+faststart", "-f", "mp4"]
    planes = "pad=ceil(iw/2)*2:ceil(ih/2)*2,scale=out_color_matrix=bt709:out_range=tv,format=yuv420p"
    colours = ["-colorspace", "bt709", "-color_primaries", "bt709", "-color_trc", "iec61966-2-1", "-color_range", "tv"]

-- | ffmpeg, if it is installed. Without a variable PATH there is nowhere to look.
findCoder :: IO (Maybe FilePath)
findCoder = fromRight Nothing <$> reasonOf (findExecutable "ffmpeg")

-- | A film file in the making.
data Video = Video
  { videoTarget :: !FilePath,
    videoPart :: !FilePath,
    videoProcess :: !ProcessHandle,
    videoInput :: !Handle,
    videoFrames :: !(Chan (Maybe FilePath)),
    -- | Ends with what went wrong with the frames, if anything did.
    videoFeeder :: !(Async (Maybe String)),
    -- | Ends with what the coder said.
    videoComplaints :: !(Async String)
  }

-- | Start a coder (its program's path) on a film of some frames per second. The
-- film file appears only by 'finishVideo', complete. On the left, why it could
-- not be started.
startVideo :: FilePath -> VideoCoding -> Double -> FilePath -> IO (Either String Video)
startVideo coder coding rate target = mask_ $ do
  sweepPartFiles (takeDirectory target)
  opened <- reasonOf (openPartFile (takeDirectory target) (videoExtension (videoCodingKind coding)))
  case opened of
    Left reason -> pure (Left reason)
    Right (part, handle) -> do
      hClose handle
      launched <- reasonOf . createProcess $ (proc coder (ffmpegArguments coding rate part)) {std_in = CreatePipe, std_err = CreatePipe}
      case launched of
        Right (Just input, Nothing, Just complaints, process) -> do
          hSetBinaryMode input True
          frames <- newChan
          feeder <- async (feeding input frames)
          said <- async (wholly complaints)
          pure (Right (Video target part process input frames feeder said))
        Right (_, _, _, process) -> do
          terminateProcess process
          removeQuietly part
          pure (Left "its pipes could not be made")
        Left reason -> removeQuietly part $> Left reason
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

-- | Send the next frame's file, without waiting for the coder.
feedVideo :: Video -> FilePath -> IO ()
feedVideo video = writeChan (videoFrames video) . Just

-- | Wait until the coder has all frames, and put the film into its place. On
-- the left, what went wrong; then there is no new film.
finishVideo :: Video -> IO (Either String ())
finishVideo video = do
  writeChan (videoFrames video) Nothing
  fault <- wait (videoFeeder video)
  quietly (hClose (videoInput video))
  code <- waitForProcess (videoProcess video)
  said <- wait (videoComplaints video)
  case (code, fault) of
    (ExitSuccess, Nothing) -> do
      moved <- reasonOf (renameFile (videoPart video) (videoTarget video))
      either (failed . ("cannot write " ++) . ((videoTarget video ++ ": ") ++)) (pure . Right) moved
    (ExitFailure n, _)
      | n < 0 -> failed ("ffmpeg was killed by signal " ++ show (negate n) ++ remark said)
      | otherwise -> failed ("ffmpeg ended with code " ++ show n ++ remark said)
    (_, Just reason) -> failed ("ffmpeg did not take all frames: " ++ reason ++ remark said)
  where
    failed reason = removeQuietly (videoPart video) $> Left reason
    remark said = if null said then "" else " (" ++ take 400 said ++ ")"

-- | Give the film up: end the coder and remove what it has written.
abandonVideo :: Video -> IO ()
abandonVideo video = mask_ $ do
  cancel (videoFeeder video)
  terminateProcess (videoProcess video)
  quietly (hClose (videoInput video))
  _ <- waitForProcess (videoProcess video)
  removeQuietly (videoPart video)

reasonOf :: IO a -> IO (Either String a)
reasonOf action = either (Left . reason) Right <$> try action
  where
    reason :: IOException -> String
    reason = show

removeQuietly :: FilePath -> IO ()
removeQuietly = quietly . removeFile

quietly :: IO () -> IO ()
quietly action = action `catch` refused
  where
    refused :: IOException -> IO ()
    refused _ = pure ()
