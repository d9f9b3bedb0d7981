-- | Animations: a pure function from the number of a frame to its scenes.
--
-- Frame @n@, counted from 0, shows the time @n \/ rate@ in seconds, so that an animation
-- of one whole turn loops seamlessly. With an open shutter, a frame is the mean light of
-- the scenes at several times from then on.
module BlackHole.Animation.Animation
  ( Animation (..),
    stillAnimation,
    Track (..),
    Shutter (..),
    closedShutter,
    animationDuration,
    animationProblems,
    sceneAt,
    frameTimes,
    frameScenes,
    maximumFrames,
    maximumShutterSamples,
  )
where

import BlackHole.Animation.CameraPath
import BlackHole.Animation.Interpolate
import BlackHole.Image.MotionBlur (maximumBlurredScenes)
import BlackHole.Scene.Scene
import BlackHole.Scene.Validate
import Data.List.NonEmpty (NonEmpty (..))

-- | A scene that changes with time.
data Animation = Animation
  { -- | The scene that every frame starts from.
    animationScene :: !Scene,
    -- | Number of frames, from 1 to 'maximumFrames'.
    animationFrames :: !Int,
    -- | Frames per second, above 0.
    animationRate :: !Double,
    -- | The settings that follow keyframes.
    animationTracks :: ![Track],
    -- | The movement of the camera, from the position that the keyframes give it.
    animationPath :: !(Maybe CameraPath),
    animationShutter :: !Shutter
  }

-- | A setting of the scene that follows keyframes; times are in seconds.
data Track = Track
  { -- | Its path in the scene file.
    trackField :: !String,
    -- | Sets the values, or returns the problem with them.
    trackSet :: !([Double] -> Scene -> Either Problem Scene),
    trackInterpolation :: !Interpolation,
    trackKeys :: !Keys
  }

-- | The exposure time of each frame.
data Shutter = Shutter
  { -- | Open for this part of the time from a frame to the next, 0 to 1.
    shutterOpen :: !Double,
    -- | The number of times whose light is averaged, from 1 to 'maximumShutterSamples'.
    shutterSamples :: !Int
  }
  deriving (Eq, Show)

-- | A single time for each frame: no motion blur.
closedShutter :: Shutter
closedShutter = Shutter 0 1

-- | The greatest number of frames of an animation.
maximumFrames :: Int
maximumFrames = 1000000

-- | The greatest number of shutter samples of a frame.
maximumShutterSamples :: Int
maximumShutterSamples = maximumBlurredScenes

-- | An animation in which nothing moves: 48 frames at 24 a second.
stillAnimation :: Scene -> Animation
stillAnimation scene = Animation scene 48 24 [] Nothing closedShutter

-- | The duration in seconds, from the start of the first frame to the end of the last.
animationDuration :: Animation -> Double
animationDuration animation = fromIntegral (animationFrames animation) / animationRate animation

-- | The problems of the numbers of an animation. For the problems of its scenes, see
-- 'frameScenes'.
animationProblems :: Animation -> [Problem]
animationProblems animation =
  [ Problem
      "--duration"
      (show frames ++ " frames")
      ("a duration of 1 to " ++ show maximumFrames ++ " frames")
    | frames < 1 || frames > maximumFrames
  ]
    ++ [ Problem "--fps" (show rate) "a number of frames per second from 0.001 to 1000"
         | not (rate >= 0.001 && rate <= 1000)
       ]
    ++ [ Problem "--shutter" (show open) "a fraction of the time between frames from 0 to 1"
         | not (open >= 0 && open <= 1)
       ]
    ++ [ Problem
           "--shutter-samples"
           (show samples)
           ("a whole number from 1 to " ++ show maximumShutterSamples)
         | samples < 1 || samples > maximumShutterSamples
       ]
  where
    frames = animationFrames animation
    rate = animationRate animation
    Shutter open samples = animationShutter animation

-- | The scene at a time in seconds, or all its problems.
sceneAt :: Animation -> Double -> Either [Problem] Scene
sceneAt animation seconds = do
  keyed <- foldl track (Right (animationScene animation)) (animationTracks animation)
  moved <- maybe (Right keyed) (along keyed) (animationPath animation)
  case validateScene moved of
    [] -> Right moved
    problems -> Left problems
  where
    track scene (Track _ set kind keys) =
      scene >>= either (Left . pure) Right . set (valueAt kind keys seconds)
    along scene path =
      either
        (Left . pure . impossible path)
        Right
        (alongPath path (animationDuration animation) seconds scene)
    impossible path reason =
      Mistake "animation.camera-path" (cameraPathName path ++ ": " ++ reason)

-- | The times in seconds whose light frame @n@ gathers: the middles of equal parts of
-- the time for which the shutter is open.
frameTimes :: Animation -> Int -> NonEmpty Double
frameTimes animation n
  | open > 0 && samples > 0 = sample 0 :| map sample [1 .. samples - 1]
  | otherwise = time 0 :| []
  where
    Shutter open samples = animationShutter animation
    time part = (fromIntegral n + part) / animationRate animation
    sample :: Int -> Double
    sample k = time (open * (fromIntegral k + 0.5) / fromIntegral samples)

-- | The scenes whose mean light is frame @n@, or their problems.
frameScenes :: Animation -> Int -> Either [Problem] (NonEmpty Scene)
frameScenes animation n = traverse (sceneAt animation) (frameTimes animation n)
