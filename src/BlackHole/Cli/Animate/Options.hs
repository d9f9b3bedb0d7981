-- | The options of @blackhole animate@.
module BlackHole.Cli.Animate.Options
  ( AnimateOptions (..),
    ShardChoice (..),
    animateOptions,
    framePatternOf,
    adjustAnimation,
    videoCodingOf,
    paceProblems,
    usageProblems,
    idleBesideStatus,
  )
where

import BlackHole.Animation.Animation
import BlackHole.Animation.CameraPath (CameraPath (Orbit))
import BlackHole.Animation.Interpolate (Interpolation (Linear))
import BlackHole.Animation.Video
import BlackHole.Cli.Check
import BlackHole.Cli.CodingOptions (codingOptions)
import BlackHole.Cli.Read
import BlackHole.Cli.RunOptions
import BlackHole.Cli.SceneOptions
import BlackHole.Image.Coding (Coding (..))
import BlackHole.Render.Shard
import BlackHole.Scene.Field.Field (fieldLabel)
import BlackHole.Scene.Field.Table (findField)
import BlackHole.Scene.Problem
import BlackHole.Scene.Setting (Setting (settingPath))
import BlackHole.Vector.XYZ (XYZ (..))
import Data.Char (isDigit, toLower)
import Data.Foldable (toList)
import Data.List (intercalate)
import Data.Maybe (fromMaybe, isJust)
import Options.Applicative
import System.FilePath (takeExtension)
import Text.Read (readMaybe)

-- | The options of @blackhole animate@.
data AnimateOptions = AnimateOptions
  { animateScene :: !SceneOptions,
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
framePatternOf :: AnimateOptions -> String
framePatternOf = fromMaybe "frames/%05d.png" . animateOutput

-- | The part of an animation to render.
data ShardChoice
  = TheShard !Shard
  | -- | The part of this task of a Slurm array job.
    SlurmShard
  deriving (Eq, Show)

-- | Their parser.
animateOptions :: Parser AnimateOptions
animateOptions =
  AnimateOptions
    <$> sceneOptions
    <*> setting
      ( strOption
          ( long "output" <> short 'o' <> metavar "PATTERN" <> action "file"
              <> help
                "Files of the frames; %05d stands for the frame number (default: frames/%05d.png)"
          )
      )
    <*> codingOptions
    <*> setting
      ( option
          number
          ( long "orbit" <> metavar "DEGREES"
              <> help
                "Move the camera this far around the hole, about the disk's axis, instead of along \
                \the scene file's camera path; needs no scene file"
          )
      )
    <*> setting
      ( option
          frameRange
          ( long "frame-range" <> metavar "A-B"
              <> help "Render only these frames, counted from 0: A, A- or A-B"
          )
      )
    <*> setting
      ( option
          number
          ( long "fps" <> metavar "F"
              <> help
                "Frames per second; does not change the duration (default: the scene file's, or 24)"
          )
      )
    <*> setting
      ( option
          number
          ( long "duration" <> metavar "SECONDS"
              <> help "Duration of the animation (default: the scene file's, or 2)"
          )
      )
    <*> setting
      ( option
          number
          ( long "shutter" <> metavar "FRACTION"
              <> help
                "Motion blur: the fraction of the time between frames for which the shutter is \
                \open, 0 to 1 (default: the scene file's, or 0)"
          )
      )
    <*> setting
      ( option
          wholeNumber
          ( long "shutter-samples" <> metavar "N"
              <> help
                "Times averaged in each frame with an open shutter; rendering takes N times as \
                \long (default: the scene file's, or 8)"
          )
      )
    <*> setting
      ( option
          shardChoice
          ( long "shard" <> metavar "I/N|slurm"
              <> help
                "Render only every N-th frame, beginning with the I-th; slurm takes I and N from a \
                \Slurm array job"
          )
      )
    <*> setting
      ( strOption
          ( long "video" <> metavar "FILE" <> action "file"
              <> help
                ( "Also make a video file of the frames with ffmpeg: "
                    ++ intercalate ", " videoExtensions
                )
          )
      )
    <*> setting
      ( option
          (named "a codec" videoCodecs)
          ( long "codec" <> metavar "NAME" <> completeWith (map fst videoCodecs)
              <> help
                "Codec of the video file: h264, h265 or av1 for .mp4, vp9 or av1 for .webm \
                \(default: h264 or vp9)"
          )
      )
    <*> setting
      ( option
          wholeNumber
          ( long "crf" <> metavar "N"
              <> help
                "Constant rate factor of the video file: less is better and larger (default: 16 \
                \for h264, 18 for h265, 24 for vp9 and av1)"
          )
      )
    <*> threadsOption
    <*> settingOr
      120
      ( option
          number
          ( long "stale-after" <> metavar "SECONDS"
              <> help
                "Take over a frame if the process on another machine that was rendering it has \
                \shown no sign of life for this long (default: 120)"
          )
      )
    <*> setting
      ( strOption
          ( long "status" <> metavar "DIR" <> action "directory"
              <> help
                "List the frames in a folder that are done, running, missing, outdated or damaged, \
                \instead of rendering; the exit code is 0 if all are done"
          )
      )
    <*> reporting

frameRange :: ReadM (Int, Maybe Int)
frameRange = eitherReader $ \text -> case span isDigit text of
  (first, "") | Just n <- count first -> Right (n, Just n)
  (first, "-") | Just n <- count first -> Right (n, Nothing)
  (first, '-' : final)
    | Just a <- count first,
      all isDigit final,
      Just b <-
        count final,
      a <= b ->
      Right (a, Just b)
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
adjustAnimation :: AnimateOptions -> Animation -> Animation
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

-- | The encoding of the video file, if one is asked for.
videoCodingOf :: AnimateOptions -> Maybe VideoCoding
videoCodingOf options = do
  kind <- videoKind =<< animateVideo options
  Just (VideoCoding kind (animateCodec options) (animateCrf options))

-- | The problems of options whose values would be as wrong in a scene file.
paceProblems :: AnimateOptions -> Animation -> [Problem]
paceProblems options animation =
  [ Problem "--fps" (show rate) "a number of frames per second from 0.001 to 1000"
    | Just rate <- [animateRate options],
      not (rate >= 0.001 && rate <= 1000)
  ]
    ++ [ Problem
           "--duration"
           (show seconds)
           ( "a duration of 1 to " ++ show maximumFrames ++ " frames at "
               ++ show (animationRate animation)
               ++ " frames per second"
           )
         | Just seconds <- [animateDuration options],
           not
             ( seconds > 0 && animationFrames animation >= 1
                 && animationFrames animation <= maximumFrames
             )
       ]

-- | The other problems of the options, given the animation.
usageProblems :: AnimateOptions -> Animation -> [Problem]
usageProblems options animation =
  [ Problem
      "--video"
      ("'" ++ file ++ "'")
      ("a file name that ends in one of " ++ intercalate ", " videoExtensions)
    | Just file <- [animateVideo options],
      Nothing <- [videoKind file]
  ]
    ++ concat
      [ [ Mistake
            "--video"
            "cannot be combined with --shard; make the video file in a run of all frames, which \
            \renders only those that are missing"
          | Just _ <- [animateShard options]
        ]
          ++ [ Mistake "--video" ("needs frames in PNG files, not '" ++ pattern' ++ "'")
               | map toLower (takeExtension pattern') /= ".png"
             ]
        | Just _ <- [animateVideo options]
      ]
    ++ foldMap videoCodingProblems (videoCodingOf options)
    ++ [ Mistake name "has no effect; it applies only with --video"
         | Nothing <- [animateVideo options],
           (name, True) <-
             [("--codec", isJust (animateCodec options)), ("--crf", isJust (animateCrf options))]
       ]
    ++ [ Mistake "--shutter-samples" "has no effect; it applies only with --shutter above 0"
         | shutterOpen (animationShutter animation) == 0,
           Just _ <- [animateShutterSamples options]
       ]
    ++ foldMap
      (checkNumber "--orbit" ((<= 3.6e6) . abs) "an angle from -3600000 to 3600000 (degrees)")
      (animateOrbit options)
    ++ checkThreads (animateThreads options)
    ++ [ Problem
           "--frame-range"
           (show from ++ maybe "" (\end -> if end == from then "" else '-' : show end) to)
           ( "a range of frames of this animation, which are 0 to "
               ++ show (animationFrames animation - 1)
           )
         | Just (from, to) <- [animateFrames options],
           maximum (from : toList to) >= animationFrames animation
       ]
    ++ [ Problem "--stale-after" (show patience) "a number of seconds of at least 1"
         | isNaN patience || patience < 1
       ]
  where
    patience = animatePatience options
    pattern' = framePatternOf options

-- | The options of @blackhole animate@ that have no effect with @--status@: all except
-- @--stale-after@ and @--quiet@.
idleBesideStatus :: AnimateOptions -> [Problem]
idleBesideStatus options =
  [ Mistake name "has no effect with --status"
    | (name, True) <-
        [ ("SCENE.yaml", isJust (sceneFile scene)),
          ("--preset", isJust (scenePreset scene)),
          ("--output", isJust (animateOutput options)),
          ("--bits", isJust (codingBits (animateCoding options))),
          ("--quality", isJust (codingQuality (animateCoding options))),
          ("--orbit", isJust (animateOrbit options)),
          ("--frame-range", isJust (animateFrames options)),
          ("--fps", isJust (animateRate options)),
          ("--duration", isJust (animateDuration options)),
          ("--shutter", isJust (animateShutter options)),
          ("--shutter-samples", isJust (animateShutterSamples options)),
          ("--shard", isJust (animateShard options)),
          ("--video", isJust (animateVideo options)),
          ("--codec", isJust (animateCodec options)),
          ("--crf", isJust (animateCrf options)),
          ("--threads", isJust (animateThreads options)),
          ("--progress", isJust (reportProgress (animateReporting options))),
          ("--stats", isJust (reportStats (animateReporting options)))
        ]
          ++ [ (maybe (settingPath s) fieldLabel (findField (settingPath s)), True)
               | s <- sceneGiven scene
             ]
  ]
  where
    scene = animateScene options
