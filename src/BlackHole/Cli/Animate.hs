-- | @blackhole animate@: a film's frames, beside other processes and across
-- interruptions.
module BlackHole.Cli.Animate
  ( AnimateOptions (..),
    ShardChoice (..),
    animateOptions,
    adjustFilm,
    Ending (..),
    runFilm,
    showStatus,
  )
where

import BlackHole.Animation.Film
import BlackHole.Animation.FrameName
import BlackHole.Animation.Shoot
import BlackHole.Animation.Status
import BlackHole.Animation.Video
import BlackHole.Cli.AnimateReport
import BlackHole.Cli.CodingOptions (codingOptions)
import BlackHole.Cli.FilmScene (frameFaults, maximumFaults)
import BlackHole.Cli.Read
import BlackHole.Image.AtomicFile (printable)
import BlackHole.Image.Coding (Coding)
import qualified BlackHole.Render.Film as Light
import BlackHole.Render.Shard
import BlackHole.Render.Workers
import BlackHole.Scene.Scene (Scene)
import BlackHole.Scene.Validate
import BlackHole.Trace.SkyImage (SkyImage)
import Control.Exception (IOException, try)
import Control.Monad (when)
import qualified Data.ByteString.Lazy as Lazy
import Data.Char (isDigit, toLower)
import Data.Foldable (toList)
import Data.List (intercalate)
import Data.List.NonEmpty (NonEmpty)
import Data.Maybe (fromMaybe, listToMaybe)
import Options.Applicative
import System.Directory (doesDirectoryExist)
import System.Environment (getEnvironment)
import System.FilePath (takeExtension)
import Text.Read (readMaybe)

-- | The options of @blackhole animate@, with those of the scene.
data AnimateOptions scene = AnimateOptions
  { animateScene :: !scene,
    -- | The frames' files, as 'parseFrameName' reads them.
    animateOutput :: !String,
    animateCoding :: !Coding,
    -- | First and last frame; without a last one, all from the first on.
    animateFrames :: !(Maybe (Int, Maybe Int)),
    animateRate :: !(Maybe Double),
    animateDuration :: !(Maybe Double),
    animateShutter :: !(Maybe Double),
    animateShutterSamples :: !(Maybe Int),
    animateShard :: !(Maybe ShardChoice),
    animateVideo :: !(Maybe FilePath),
    animateThreads :: !(Maybe Int),
    animatePatience :: !Double,
    -- | Tell about this folder's films instead.
    animateStatus :: !(Maybe FilePath)
  }
  deriving (Eq, Show)

-- | Which part of a film to make.
data ShardChoice
  = TheShard !Shard
  | -- | That of a task of a Slurm array job.
    SlurmShard
  deriving (Eq, Show)

-- | The parser, around that of the scene's options.
animateOptions :: Parser scene -> Parser (AnimateOptions scene)
animateOptions scene =
  AnimateOptions
    <$> scene
    <*> settingOr "frames/%05d.png" (strOption (long "output" <> short 'o' <> metavar "PATTERN" <> help "Frames' files, with a place for their number (default: frames/%05d.png)"))
    <*> codingOptions
    <*> setting (option frameRange (long "frames" <> metavar "A-B" <> help "Only these frames, counted from 0: A, A- or A-B"))
    <*> setting (option number (long "fps" <> metavar "F" <> help "Frames per second; the film lasts as long as before"))
    <*> setting (option number (long "duration" <> metavar "SECONDS" <> help "Length of the film"))
    <*> setting (option number (long "shutter" <> metavar "PART" <> help "Motion blur: the part of a frame's time for which the shutter is open, 0 to 1"))
    <*> setting (option wholeNumber (long "shutter-samples" <> metavar "N" <> help "Moments averaged in each frame with an open shutter; the time it takes grows with them"))
    <*> setting (option shardChoice (long "shard" <> metavar "I/N|slurm" <> help "Only part I of N, every N-th frame; slurm: this array task's part"))
    <*> setting (strOption (long "video" <> metavar "FILE" <> help ("Also make a film file of the frames with ffmpeg: " ++ intercalate ", " videoExtensions)))
    <*> setting (option wholeNumber (long "threads" <> metavar "N" <> help "Workers (default: one per core); the frames are the same for any number"))
    <*> settingOr 120 (option number (long "stale-after" <> metavar "SECONDS" <> help "Take over a frame of another machine that has given no sign of life for so long (default: 120)"))
    <*> setting (strOption (long "status" <> metavar "DIR" <> help "Say which frames in a folder are done, running, missing or stale, instead of rendering; the exit code is 0 if all are done"))

frameRange :: ReadM (Int, Maybe Int)
frameRange = eitherReader $ \text -> case span isDigit text of
  (first, "") | Just n <- count first -> Right (n, Just n)
  (first, "-") | Just n <- count first -> Right (n, Nothing)
  (first, '-' : final) | Just a <- count first, all isDigit final, Just b <- count final, a <= b -> Right (a, Just b)
  _ -> Left ("'" ++ text ++ "' is not A, A- or A-B, frames counted from 0 with A up to B")
  where
    count digits
      | length digits <= 9 = readMaybe digits
      | otherwise = Nothing

shardChoice :: ReadM ShardChoice
shardChoice = eitherReader $ \text -> case (text, parseShard text) of
  ("slurm", _) -> Right SlurmShard
  (_, Just shard) -> Right (TheShard shard)
  _ -> Left ("'" ++ text ++ "' is not I/N with I from 1 to N, and not slurm")

-- | The film with what the options say of its frames.
adjustFilm :: AnimateOptions scene -> Film -> Film
adjustFilm options film =
  film
    { filmRate = rate,
      filmFrames = case (animateDuration options, animateRate options) of
        (Nothing, Nothing) -> filmFrames film
        -- Numbers that make no sense are reported by 'usageProblems'.
        _ | rate > 0 && duration > 0 -> round (min 1e9 (duration * rate))
        _ -> filmFrames film,
      filmShutter =
        Shutter
          (fromMaybe (shutterOpen shutter) (animateShutter options))
          (fromMaybe (shutterSamples shutter) (animateShutterSamples options))
    }
  where
    rate = fromMaybe (filmRate film) (animateRate options)
    duration = fromMaybe (filmDuration film) (animateDuration options)
    shutter = filmShutter film

-- | How a film's run ended; what there was to say has been said.
data Ending
  = -- | All frames of this run are done, or in work elsewhere.
    Complete
  | -- | Some frames or the film file could not be made.
    Incomplete
  | -- | The arguments are wrong.
    WrongArguments
  | -- | The film is wrong.
    WrongFilm
  | -- | The frames or the film file cannot be written here.
    CannotStart
  deriving (Eq, Show)

-- | Make the film's frames. The second argument says a line to the user; the
-- third is the picture of the sky, if that is a panorama; the fourth is equal for
-- equal scenes, skies and programs; the last makes a frame's file.
runFilm ::
  AnimateOptions scene ->
  (String -> IO ()) ->
  Maybe SkyImage ->
  (Scene -> String) ->
  (Workers -> NonEmpty Scene -> Light.Exposed -> IO (Maybe Lazy.ByteString)) ->
  Film ->
  IO Ending
runFilm options say sky text develop film = do
  environment <- getEnvironment
  coder <- findCoder
  when (filmFrames film > 20000 && filmFrames film <= maximumFrames) $ say ("a film of " ++ show (filmFrames film) ++ " frames, which are checked first")
  case plan options environment coder film of
    Left (ending, problems) -> ending <$ mapM_ say problems
    Right (name, frames, video) -> do
      crew <- maybe defaultWorkers pure (workers =<< animateThreads options)
      teller <- newTeller say
      shot <-
        try . withWorkers crew $
          shoot (Shooting film frames name (animatePatience options) crew video sky text (develop crew)) teller
      clearLine
      case shot of
        Left refusal -> CannotStart <$ say ("--output: the frames cannot be written: " ++ show (refusal :: IOException))
        Right done -> do
          mapM_ say (reportLines done)
          pure (if isWhole done then Complete else Incomplete)

-- | What a run is to do, given the environment's variables and the coder of
-- films: the files' names, the frames, the film file. Or why not, in lines.
plan ::
  AnimateOptions scene ->
  [(String, String)] ->
  Maybe FilePath ->
  Film ->
  Either (Ending, [String]) (FrameName, [Int], Maybe (FilePath, VideoKind, FilePath))
plan options environment coder film = do
  refuse WrongArguments (map renderProblem (usageProblems options film))
  shard <- either (Left . (,) WrongArguments . pure . ("--shard: " ++)) Right (shardOf (animateShard options))
  name <- either (Left . (,) WrongArguments . pure . (("--output: '" ++ output ++ "' is not ") ++)) Right (parseFrameName output)
  refuse WrongFilm (map renderProblem (filmProblems film))
  let frames = takeShard shard selected
  refuse WrongFilm (take maximumFaults (frameFaults film frames))
  video <- traverse coded [(kind, file) | Just file <- [animateVideo options], Just kind <- [videoKind file]]
  Right (name, frames, listToMaybe video)
  where
    output = animateOutput options
    refuse ending problems = if null problems then Right () else Left (ending, problems)
    shardOf choice = case choice of
      Nothing -> Right wholeShard
      Just (TheShard shard) -> Right shard
      Just SlurmShard -> slurmShard (`lookup` environment)
    selected = case animateFrames options of
      Nothing -> [0 .. filmFrames film - 1]
      Just (from, to) -> [from .. fromMaybe (filmFrames film - 1) to]
    coded (kind, file) = case coder of
      Just program -> Right (program, kind, file)
      Nothing -> Left (CannotStart, ["--video: ffmpeg is not installed (on Debian and Ubuntu: apt-get install ffmpeg); nothing has been rendered"])

usageProblems :: AnimateOptions scene -> Film -> [Problem]
usageProblems options film =
  [ Problem "--video" ("'" ++ file ++ "'") ("a file name that ends in one of " ++ intercalate ", " videoExtensions)
    | Just file <- [animateVideo options],
      Nothing <- [videoKind file]
  ]
    ++ [ Problem "--video" "a part of a film" "possible: make the film file with a run of all its frames, those that are done are not rendered again"
         | Just _ <- [animateVideo options],
           Just _ <- [animateShard options]
       ]
    ++ [ Problem "--video" ("with frames in files like '" ++ animateOutput options ++ "'") "possible; name them .png"
         | map toLower (takeExtension (animateOutput options)) /= ".png",
           Just _ <- [animateVideo options]
       ]
    ++ [ Problem "--threads" (show n) ("a whole number from 1 to " ++ show maximumWorkers)
         | Just n <- [animateThreads options],
           Nothing <- [workers n]
       ]
    ++ [ Problem "--fps" (show rate) "a number of frames per second from 0.001 to 1000"
         | Just rate <- [animateRate options],
           not (rate >= 0.001 && rate <= 1000)
       ]
    ++ [ Problem "--duration" (show seconds) ("a length of 1 to " ++ show maximumFrames ++ " frames at " ++ show (filmRate film) ++ " frames per second")
         | Just seconds <- [animateDuration options],
           not (seconds > 0 && filmFrames film >= 1 && filmFrames film <= maximumFrames)
       ]
    ++ [ Problem "--frames" (show from ++ maybe "" (\end -> if end == from then "" else '-' : show end) to) ("a range of frames of this film, which are 0 to " ++ show (filmFrames film - 1))
         | Just (from, to) <- [animateFrames options],
           maximum (from : toList to) >= filmFrames film
       ]
    ++ [ Problem "--stale-after" (show patience) "a number of seconds from 1 on"
         | isNaN patience || patience < 1
       ]
  where
    patience = animatePatience options

-- | What a folder's films lack, as text, and whether all are complete. On the left,
-- why there is nothing to say.
showStatus :: Double -> FilePath -> IO (Either String (Ending, String))
showStatus patience folder = do
  exists <- doesDirectoryExist folder
  statuses <- if exists then filmStatuses folder patience else pure []
  pure $ case statuses of
    [] -> Left ("--status: there is no film in " ++ folder ++ (if exists then "" else ", which does not exist"))
    _ -> Right (if all isComplete statuses then Complete else Incomplete, unlines (map printable (concatMap statusLines statuses)))
