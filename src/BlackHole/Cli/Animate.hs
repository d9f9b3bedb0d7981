-- | @blackhole animate@: renders the frames of an animation, together with other processes and
-- across interruptions.
module BlackHole.Cli.Animate
  ( AnimateOptions (..),
    ShardChoice (..),
    animateOptions,
    framePatternOf,
    adjustAnimation,
    Ending (..),
    runAnimation,
    showStatus,
  )
where

import BlackHole.Animation.Animation
import BlackHole.Animation.CameraPath (CameraPath (Orbit))
import BlackHole.Animation.FrameName
import BlackHole.Animation.Interpolate (Interpolation (Linear))
import BlackHole.Animation.Shoot
import BlackHole.Animation.Status
import BlackHole.Animation.Video
import BlackHole.Cli.AnimateReport
import BlackHole.Cli.AnimationScene (frameFaults, maximumFaults)
import BlackHole.Cli.Check
import BlackHole.Cli.CodingOptions (codingOptions)
import BlackHole.Cli.Progress (ProgressMode (..))
import BlackHole.Cli.Read
import BlackHole.Cli.RunOptions
import BlackHole.Image.AtomicFile (printable)
import BlackHole.Image.Coding (Coding)
import qualified BlackHole.Render.Film as Light
import BlackHole.Render.Shard
import BlackHole.Render.Workers
import BlackHole.Scene.Scene (Scene)
import BlackHole.Scene.Validate
import BlackHole.Trace.EnvironmentMap (EnvironmentMap)
import BlackHole.Vector.XYZ (XYZ (..))
import Control.Exception (IOException, try)
import Control.Monad (unless, when)
import qualified Data.ByteString.Lazy as Lazy
import Data.Char (isDigit, toLower)
import Data.Foldable (toList)
import Data.List (intercalate)
import Data.List.NonEmpty (NonEmpty)
import Data.Maybe (fromMaybe, isJust, listToMaybe)
import Options.Applicative
import System.Directory (doesDirectoryExist)
import System.Environment (getEnvironment)
import System.FilePath (takeExtension)
import Text.Read (readMaybe)

-- | The options of @blackhole animate@, with those of the scene.
data AnimateOptions scene = AnimateOptions
  { animateScene :: !scene,
    -- | The value of @--output@, if it is given; see 'framePatternOf'.
    animateOutput :: !(Maybe String),
    animateCoding :: !Coding,
    -- | Degrees around the hole.
    animateOrbit :: !(Maybe Double),
    -- | First and last frame; without a last one, all frames from the first.
    animateFrames :: !(Maybe (Int, Maybe Int)),
    animateRate :: !(Maybe Double),
    animateDuration :: !(Maybe Double),
    animateShutter :: !(Maybe Double),
    animateShutterSamples :: !(Maybe Int),
    animateShard :: !(Maybe ShardChoice),
    animateVideo :: !(Maybe FilePath),
    animateCodec :: !(Maybe VideoCodec),
    animateCrf :: !(Maybe Int),
    animateThreads :: !(Maybe Int),
    animatePatience :: !Double,
    -- | Report on the animations in this folder instead.
    animateStatus :: !(Maybe FilePath),
    animateReporting :: !Reporting
  }
  deriving (Eq, Show)

-- | The pattern of the frames' files, which 'parseFrameName' reads.
framePatternOf :: AnimateOptions scene -> String
framePatternOf = fromMaybe "frames/%05d.png" . animateOutput

-- | Which part of an animation to render.
data ShardChoice
  = TheShard !Shard
  | -- | The part of this task of a Slurm array job.
    SlurmShard
  deriving (Eq, Show)

-- | The parser, around that of the scene's options.
animateOptions :: Parser scene -> Parser (AnimateOptions scene)
animateOptions scene =
  AnimateOptions
    <$> scene
    <*> setting (strOption (long "output" <> short 'o' <> metavar "PATTERN" <> action "file" <> help "Files of the frames; %05d stands for the frame number (default: frames/%05d.png)"))
    <*> codingOptions
    <*> setting (option number (long "orbit" <> metavar "DEGREES" <> help "Move the camera this far around the hole, about the disk's axis, instead of along the scene file's camera path; needs no scene file"))
    <*> setting (option frameRange (long "frame-range" <> metavar "A-B" <> help "Render only these frames, counted from 0: A, A- or A-B"))
    <*> setting (option number (long "fps" <> metavar "F" <> help "Frames per second; does not change the duration (default: the scene file's, or 24)"))
    <*> setting (option number (long "duration" <> metavar "SECONDS" <> help "Duration of the animation (default: the scene file's, or 2)"))
    <*> setting (option number (long "shutter" <> metavar "FRACTION" <> help "Motion blur: the fraction of the time between frames for which the shutter is open, 0 to 1 (default: the scene file's, or 0)"))
    <*> setting (option wholeNumber (long "shutter-samples" <> metavar "N" <> help "Times averaged in each frame with an open shutter; rendering takes N times as long (default: the scene file's, or 8)"))
    <*> setting (option shardChoice (long "shard" <> metavar "I/N|slurm" <> help "Render only every N-th frame, beginning with the I-th; slurm takes I and N from a Slurm array job"))
    <*> setting (strOption (long "video" <> metavar "FILE" <> action "file" <> help ("Also make a video file of the frames with ffmpeg: " ++ intercalate ", " videoExtensions)))
    <*> setting (option (named "a codec" videoCodecs) (long "codec" <> metavar "NAME" <> completeWith (map fst videoCodecs) <> help "Codec of the video file: h264, h265 or av1 for .mp4, vp9 or av1 for .webm (default: h264 or vp9)"))
    <*> setting (option wholeNumber (long "crf" <> metavar "N" <> help "Constant rate factor of the video file: less is better and larger (default: 16 for h264, 18 for h265, 24 for vp9 and av1)"))
    <*> threadsOption
    <*> settingOr 120 (option number (long "stale-after" <> metavar "SECONDS" <> help "Take over a frame if the process on another machine that was rendering it has shown no sign of life for this long (default: 120)"))
    <*> setting (strOption (long "status" <> metavar "DIR" <> action "directory" <> help "List the frames in a folder that are done, running, missing, outdated or damaged, instead of rendering; the exit code is 0 if all are done"))
    <*> reporting

frameRange :: ReadM (Int, Maybe Int)
frameRange = eitherReader $ \text -> case span isDigit text of
  (first, "") | Just n <- count first -> Right (n, Just n)
  (first, "-") | Just n <- count first -> Right (n, Nothing)
  (first, '-' : final) | Just a <- count first, all isDigit final, Just b <- count final, a <= b -> Right (a, Just b)
  _ -> Left ("'" ++ text ++ "' is not a range of frames: A, A- or A-B, counted from 0")
  where
    count digits
      | length digits <= 9 = readMaybe digits
      | otherwise = Nothing

shardChoice :: ReadM ShardChoice
shardChoice = eitherReader $ \text -> case (text, parseShard text) of
  ("slurm", _) -> Right SlurmShard
  (_, Just shard) -> Right (TheShard shard)
  _ -> Left ("'" ++ text ++ "' is not I/N with I from 1 to N, or slurm")

-- | The animation as changed by the options.
adjustAnimation :: AnimateOptions scene -> Animation -> Animation
adjustAnimation options animation =
  animation
    { animationPath = maybe (animationPath animation) orbitBy (animateOrbit options),
      animationRate = rate,
      animationFrames = case (animateDuration options, animateRate options) of
        (Nothing, Nothing) -> animationFrames animation
        -- Numbers that make no sense are reported by 'paceProblems'.
        _ | rate > 0 && duration > 0 -> round (min 1e9 (duration * rate))
        _ -> animationFrames animation,
      animationShutter =
        Shutter
          (fromMaybe (shutterOpen shutter) (animateShutter options))
          (fromMaybe (shutterSamples shutter) (animateShutterSamples options))
    }
  where
    rate = fromMaybe (animationRate animation) (animateRate options)
    duration = fromMaybe (animationDuration animation) (animateDuration options)
    shutter = animationShutter animation
    orbitBy degrees = Just (Orbit (XYZ 0 1 0) (degrees / 360) Linear)

-- | How a run ended. All messages have been written.
data Ending
  = -- | All frames of this run are done, or other processes are rendering them.
    Complete
  | -- | Some frames or the video file are missing.
    Incomplete
  | -- | Invalid options.
    WrongArguments
  | -- | Invalid scene file.
    InvalidAnimation
  | -- | The frames or the video file cannot be written.
    CannotStart
  deriving (Eq, Show)

-- | Render the animation's frames, given a function that prints a message, the environment
-- map if the scene has one, a text that is equal for equal scenes, maps and versions of
-- the program, and a function that makes a frame's file. Also returns the run's result
-- and its workers, if it got that far.
runAnimation ::
  AnimateOptions scene ->
  (String -> IO ()) ->
  Maybe EnvironmentMap ->
  (Scene -> String) ->
  (Workers -> NonEmpty Scene -> Light.Exposed -> IO (Maybe Lazy.ByteString)) ->
  Animation ->
  IO (Ending, Maybe (Workers, Shot))
runAnimation options say sky text develop animation = do
  environment <- getEnvironment
  coder <- findCoder
  when (animationFrames animation > 20000 && animationFrames animation <= maximumFrames) $ say ("an animation of " ++ show (animationFrames animation) ++ " frames, which are checked first")
  case plan options environment coder animation of
    Left (ending, problems) -> (ending, Nothing) <$ mapM_ say problems
    Right (name, frames, video) -> do
      workers <- maybe defaultWorkers pure (workersFromCount =<< animateThreads options)
      teller <- newTeller say mode
      shot <-
        try . withWorkers workers $
          shoot (Shooting animation frames name (animatePatience options) workers video sky text (develop workers)) teller
      clearLine mode
      case shot of
        Left refusal -> (CannotStart, Nothing) <$ say ("--output: the frames cannot be written: " ++ show (refusal :: IOException))
        Right done -> do
          -- In JSON, the last progress report is the summary.
          unless (reportQuiet reported || mode == JsonProgress) $ say (summaryLine done)
          mapM_ say (faultLines done)
          pure (if isWhole done then Complete else Incomplete, Just (workers, done))
  where
    reported = animateReporting options
    mode = progressMode reported

-- | The plan of a run, given the environment's variables and the path of ffmpeg: the
-- pattern of the files, the frames, and how to make the video file. 'Left' has one line
-- for each mistake.
plan ::
  AnimateOptions scene ->
  [(String, String)] ->
  Maybe FilePath ->
  Animation ->
  Either (Ending, [String]) (FrameName, [Int], Maybe (FilePath, VideoCoding, FilePath))
plan options environment coder animation = do
  refuse WrongArguments (map renderProblem (usageProblems options animation))
  shard <- either (Left . (,) WrongArguments . pure . ("--shard: " ++)) Right (shardOf (animateShard options))
  name <- either (Left . (,) WrongArguments . pure . (("--output: '" ++ output ++ "' is not ") ++)) Right (parseFrameName output)
  refuse InvalidAnimation (map renderProblem (paceProblems options animation))
  refuse InvalidAnimation (map renderProblem (animationProblems animation))
  let frames = takeShard shard selected
  refuse InvalidAnimation (take maximumFaults (frameFaults animation frames))
  video <- traverse coded [(coding, file) | Just file <- [animateVideo options], Just coding <- [videoCodingOf options]]
  Right (name, frames, listToMaybe video)
  where
    output = framePatternOf options
    refuse ending problems = if null problems then Right () else Left (ending, problems)
    shardOf choice = case choice of
      Nothing -> Right wholeShard
      Just (TheShard shard) -> Right shard
      Just SlurmShard -> slurmShard (`lookup` environment)
    selected = case animateFrames options of
      Nothing -> [0 .. animationFrames animation - 1]
      Just (from, to) -> [from .. fromMaybe (animationFrames animation - 1) to]
    coded (coding, file) = case coder of
      Just program -> Right (program, coding, file)
      Nothing -> Left (CannotStart, ["--video: needs ffmpeg, which is not installed (on Debian and Ubuntu: apt-get install ffmpeg); nothing has been rendered"])

videoCodingOf :: AnimateOptions scene -> Maybe VideoCoding
videoCodingOf options = do
  kind <- videoKind =<< animateVideo options
  Just (VideoCoding kind (animateCodec options) (animateCrf options))

-- | Values of options that would be as wrong in the scene file's section on the animation.
paceProblems :: AnimateOptions scene -> Animation -> [Problem]
paceProblems options animation =
  [ Problem "--fps" (show rate) "a number of frames per second from 0.001 to 1000"
    | Just rate <- [animateRate options],
      not (rate >= 0.001 && rate <= 1000)
  ]
    ++ [ Problem "--duration" (show seconds) ("a duration of 1 to " ++ show maximumFrames ++ " frames at " ++ show (animationRate animation) ++ " frames per second")
         | Just seconds <- [animateDuration options],
           not (seconds > 0 && animationFrames animation >= 1 && animationFrames animation <= maximumFrames)
       ]

usageProblems :: AnimateOptions scene -> Animation -> [Problem]
usageProblems options animation =
  [ Problem "--video" ("'" ++ file ++ "'") ("a file name that ends in one of " ++ intercalate ", " videoExtensions)
    | Just file <- [animateVideo options],
      Nothing <- [videoKind file]
  ]
    ++ concat
      [ [Mistake "--video" "cannot be combined with --shard; make the video file in a run of all frames, which renders only those that are missing" | Just _ <- [animateShard options]]
          ++ [Mistake "--video" ("needs frames in PNG files, not '" ++ pattern' ++ "'") | map toLower (takeExtension pattern') /= ".png"]
        | Just _ <- [animateVideo options]
      ]
    ++ foldMap videoCodingProblems (videoCodingOf options)
    ++ [ Mistake name "has no effect; it applies only with --video"
         | Nothing <- [animateVideo options],
           (name, True) <- [("--codec", isJust (animateCodec options)), ("--crf", isJust (animateCrf options))]
       ]
    ++ [ Mistake "--shutter-samples" "has no effect; it applies only with --shutter above 0"
         | shutterOpen (animationShutter animation) == 0,
           Just _ <- [animateShutterSamples options]
       ]
    ++ foldMap (checkNumber "--orbit" ((<= 3.6e6) . abs) "an angle from -3600000 to 3600000 (degrees)") (animateOrbit options)
    ++ checkThreads (animateThreads options)
    ++ [ Problem "--frame-range" (show from ++ maybe "" (\end -> if end == from then "" else '-' : show end) to) ("a range of frames of this animation, which are 0 to " ++ show (animationFrames animation - 1))
         | Just (from, to) <- [animateFrames options],
           maximum (from : toList to) >= animationFrames animation
       ]
    ++ [ Problem "--stale-after" (show patience) "a number of seconds of at least 1"
         | isNaN patience || patience < 1
       ]
  where
    patience = animatePatience options
    pattern' = framePatternOf options

-- | The state of the animations in a folder as text; 'Complete' if all their frames are done.
-- On the left, why there is nothing to report.
showStatus :: Double -> FilePath -> IO (Either String (Ending, String))
showStatus patience folder = do
  exists <- doesDirectoryExist folder
  statuses <- if exists then animationStatuses folder patience else pure []
  pure $ case statuses of
    [] -> Left ("--status: " ++ (if exists then "there is no animation in the folder " else "there is no folder ") ++ folder)
    _ -> Right (if all isComplete statuses then Complete else Incomplete, unlines (map printable (concatMap statusLines statuses)))
