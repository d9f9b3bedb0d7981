-- | The help on animations: what the section @animation@ of a scene file can hold, from the
-- table that also reads it.
module BlackHole.Cli.AnimationHelp
  ( HelpPart (..),
    animationHelp,
  )
where

import BlackHole.Animation.AnimationKeys
import Data.List (intercalate)

-- | A part of a longer text.
data HelpPart
  = Paragraph !String
  | -- | Lines to keep as they are.
    Verbatim ![String]
  | -- | Terms with their explanations.
    Terms ![(String, String)]
  deriving (Eq, Show)

-- | The text, in order.
animationHelp :: [HelpPart]
animationHelp =
  [ Paragraph
      "An animation is a scene file with a section animation, or an orbit around the hole by \
      \--orbit. blackhole animate renders its frames, each into its own file, and with --video \
      \makes a video file of them with ffmpeg.",
    Verbatim
      [ "animation:",
        "  duration: 4              # seconds; or frames: 96",
        "  fps: 24",
        "  shutter: 0.5             # motion blur",
        "  camera-path:",
        "    kind: orbit",
        "    turns: 1",
        "  keyframes:",
        "    camera.inclination: {interpolation: smooth, 0: 82, 2: 68, 4: 82}",
        "    disk.time: {0: 0, 4: 60}"
      ],
    Paragraph "Frame n, counted from 0, shows the time n/fps. Keys of the section:",
    Terms
      ( [(keyName e, keyDoc e) | e <- animationKeys]
          ++ [ ( "camera-path",
                 "Movement of the camera, starting from where the scene and the keyframes put it"
               ),
               ("keyframes", "Settings of the scene with their values at times in seconds")
             ]
      ),
    Paragraph "Kinds of camera-path:",
    Terms
      [(kind, description ++ "; keys: " ++ commas names) | (kind, description, names) <- pathKinds],
    Paragraph "Keys of camera-path:",
    Terms [(keyName e, keyDoc e) | e <- cameraPathKeys],
    Paragraph
      "Under keyframes, every setting that is a number or a vector can have values at times, \
      \except the picture's size. A value holds before its first and after its last key. Further \
      \keys of such a setting:",
    Terms [(keyName e, keyDoc e) | e <- keyframeKeys],
    Paragraph
      "The folder of the frames gets a folder .blackhole, which records what each frame was made \
      \of and who is rendering it. A frame is rendered if it is missing, if the scene or the \
      \program has changed, or if its file is damaged; so an interrupted animation continues where \
      \it stopped, and any number of processes, on several machines too, can share a folder. \
      \--status lists what is missing. Delete .blackhole and the frames to start afresh.",
    Paragraph "With --shard slurm, every task of a Slurm array job renders its part of the frames."
  ]
  where
    commas = intercalate ", "
