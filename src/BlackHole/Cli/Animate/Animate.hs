-- | @blackhole animate@: renders the frames of an animation, together with other processes
-- and across interruptions.
module BlackHole.Cli.Animate.Animate (animate) where

import BlackHole.Animation.Animation
import BlackHole.Animation.FrameName
import BlackHole.Animation.Shoot
import BlackHole.Animation.Status
import BlackHole.Animation.Video
import BlackHole.Cli.Animate.Options
import BlackHole.Cli.AnimateReport
import BlackHole.Cli.AnimationScene (frameFaults, loadAnimation, maximumFaults)
import BlackHole.Cli.Console (say)
import BlackHole.Cli.ExitStatus
import BlackHole.Cli.Memory
import BlackHole.Cli.Overwriting (overwritten)
import BlackHole.Cli.PictureOutput
import BlackHole.Cli.Progress
import BlackHole.Cli.RunOptions
import BlackHole.Cli.SceneOptions
import BlackHole.Cli.Version (versionLine)
import BlackHole.Image.AtomicFile (printable)
import BlackHole.Image.Coding
import BlackHole.Image.Metadata (software)
import BlackHole.Image.SkyFile
import BlackHole.Image.Write (pictureBytes)
import BlackHole.Render.Shard
import BlackHole.Scene.Camera (Picture (..))
import BlackHole.Scene.File.SceneFile (printScene)
import BlackHole.Scene.Problem (renderProblem)
import BlackHole.Scene.Scene (Scene (..))
import Control.Exception (IOException, try)
import Control.Monad (unless, when)
import Data.Maybe (fromMaybe, listToMaybe)
import System.Directory (doesDirectoryExist, listDirectory)
import System.Environment (getEnvironment)
import System.FilePath (takeDirectory, (</>))

-- | Renders the frames that the options ask for, or reports on the frames in a folder.
animate :: AnimateOptions -> IO ExitStatus
animate options = case (animateStatus options, formatOf (framePatternOf options)) of
  (Just folder, _) -> case idleBesideStatus options of
    [] -> showStatus (animatePatience options) folder
    problems -> complainAll UsageError problems
  (_, Nothing) -> complainAll UsageError [unknownExtensionOf (framePatternOf options)]
  (_, Just format)
    | problems@(_ : _) <- codingProblem format (animateCoding options) ->
      complainAll UsageError problems
    | otherwise -> do
      loaded <- loadAnimation (animateScene options)
      case (loaded, animateOrbit options) of
        (Left problems, _) -> BadInput <$ mapM_ say problems
        (Right (Left _), Nothing) ->
          complain
            BadInput
            "animate needs a scene file with a section animation, or --orbit DEGREES (see: \
            \blackhole help animation)"
        (Right (Left scene), Just _) -> whenPossible options format (stillAnimation scene)
        (Right (Right animation), _) -> whenPossible options format animation

-- | Renders the animation, as changed by the options, if its frames fit into memory and
-- overwrite no input.
whenPossible :: AnimateOptions -> Format -> Animation -> IO ExitStatus
whenPossible options format given = do
  clashes <- animationClashes options animation
  lacking <-
    memoryProblem
      (Making (Frame format) (shutterOpen (animationShutter animation) > 0) False)
      scene
      (pictureHeight (scenePicture scene))
  case (clashes, lacking) of
    (_ : _, _) -> UsageError <$ mapM_ say clashes
    (_, Just line) -> complain BadInput line
    _ -> underSky scene (renderFrames options format animation)
  where
    animation = adjustAnimation options given
    scene = animationScene animation

-- | One line for each input that the frames, the video file or the statistics would
-- overwrite. A frame that does not exist yet cannot be an input.
animationClashes :: AnimateOptions -> Animation -> IO [String]
animationClashes options animation = case parseFrameName (framePatternOf options) of
  Left _ -> pure []
  Right name -> do
    let folder = takeDirectory (frameFile name 0)
    names <- either (const [] :: IOException -> [FilePath]) id <$> try (listDirectory folder)
    overwritten
      (sceneInputs (animateScene options) (animationScene animation))
      ( [("--video", file) | Just file <- [animateVideo options]]
          ++ [("--stats", file) | Just file <- [reportStats (animateReporting options)]]
          ++ [("--output", folder </> file) | file <- names, Just _ <- [frameNumber name file]]
      )

-- | Renders the frames and reports on them, given the sky.
renderFrames :: AnimateOptions -> Format -> Animation -> Maybe SkyFile -> IO ExitStatus
renderFrames options format animation sky = do
  environment <- getEnvironment
  coder <- findCoder
  when (animationFrames animation > 20000 && animationFrames animation <= maximumFrames) $
    say
      ("an animation of " ++ show (animationFrames animation) ++ " frames, which are checked first")
  case plan options environment coder animation of
    Left (status, problems) -> status <$ mapM_ say problems
    Right (name, frames, video) -> inWorkers (animateThreads options) $ \workers -> do
      reporter <- newReporter mode
      let develop = pictureBytes workers software format (animateCoding options)
      shot <-
        try
          ( shoot
              ( Shooting
                  animation
                  frames
                  name
                  (animatePatience options)
                  workers
                  video
                  (skyFileImage <$> sky)
                  text
                  develop
              )
              (reportTo say reporter)
          )
      clearProgress reporter
      case shot of
        Left refusal ->
          complain
            CannotWrite
            ("--output: the frames cannot be written: " ++ show (refusal :: IOException))
        Right done -> do
          -- In JSON, the last progress report is the summary.
          unless (reportQuiet reported || mode == JsonProgress) $ say (summaryLine done)
          mapM_ say (faultLines done)
          memory <- peakMemory
          written <- storeStats reported (animationStats versionLine memory workers done)
          pure (if isWhole done then written else Unfinished)
  where
    reported = animateReporting options
    mode = progressMode reported
    -- Equal for equal scenes, skies, encodings and versions of the program.
    text = printScene ((software ++ ", " ++ show (animateCoding options)) : skyLines sky)

-- | The plan of a run, given the environment's variables and the path of ffmpeg: the
-- pattern of the files, the frames, and how to make the video file. 'Left' has one line
-- for each mistake.
plan ::
  AnimateOptions ->
  [(String, String)] ->
  Maybe FilePath ->
  Animation ->
  Either (ExitStatus, [String]) (FrameName, [Int], Maybe (FilePath, VideoCoding, FilePath))
plan options environment coder animation = do
  refuse UsageError (map renderProblem (usageProblems options animation))
  shard <-
    either
      (Left . (,) UsageError . pure . ("--shard: " ++))
      Right
      (shardOf (animateShard options))
  name <-
    either
      (Left . (,) UsageError . pure . (("--output: '" ++ output ++ "' is not ") ++))
      Right
      (parseFrameName output)
  refuse BadInput (map renderProblem (paceProblems options animation))
  refuse BadInput (map renderProblem (animationProblems animation))
  let frames = takeShard shard selected
  refuse BadInput (take maximumFaults (frameFaults animation frames))
  video <-
    traverse
      coded
      [(coding, file) | Just file <- [animateVideo options], Just coding <- [videoCodingOf options]]
  Right (name, frames, listToMaybe video)
  where
    output = framePatternOf options
    refuse status problems = if null problems then Right () else Left (status, problems)
    shardOf choice = case choice of
      Nothing -> Right wholeShard
      Just (TheShard shard) -> Right shard
      Just SlurmShard -> slurmShard (`lookup` environment)
    selected = case animateFrames options of
      Nothing -> [0 .. animationFrames animation - 1]
      Just (from, to) -> [from .. fromMaybe (animationFrames animation - 1) to]
    coded (coding, file) = case coder of
      Just program -> Right (program, coding, file)
      Nothing ->
        Left
          ( CannotWrite,
            [ "--video: needs ffmpeg, which is not installed (on Debian and Ubuntu: apt-get \
              \install ffmpeg); nothing has been rendered"
            ]
          )

-- | Prints the state of the animations in a folder; 'Done' if all their frames are.
showStatus :: Double -> FilePath -> IO ExitStatus
showStatus patience folder = do
  exists <- doesDirectoryExist folder
  statuses <- if exists then animationStatuses folder patience else pure []
  if null statuses
    then
      complain
        BadInput
        ( "--status: "
            ++ (if exists then "there is no animation in the folder " else "there is no folder ")
            ++ folder
        )
    else
      printed
        (if all isComplete statuses then Done else Unfinished)
        (unlines (map printable (concatMap statusLines statuses)))
