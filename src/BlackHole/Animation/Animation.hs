-- | A film: from the number of a frame to its scene, and nothing but that.
--
-- Frame @n@ (from 0) shows the time @n \/ rate@ in seconds, so that a film of one
-- whole turn runs on into its own beginning. With a shutter, a frame is the mean
-- light of several moments from that time on.
module BlackHole.Animation.Animation
  ( Film (..),
    stillFilm,
    Track (..),
    Shutter (..),
    closedShutter,
    filmDuration,
    filmProblems,
    momentScene,
    frameMoments,
    frameScenes,
    maximumFrames,
    maximumShutterSamples,
  )
where

import BlackHole.Animation.CameraPath
import BlackHole.Animation.Interpolate
import BlackHole.Image.MotionBlur (maximumMoments)
import BlackHole.Scene.Scene
import BlackHole.Scene.Validate
import Data.List.NonEmpty (NonEmpty (..))

-- | A film.
data Film = Film
  { -- | What every frame starts from.
    filmScene :: !Scene,
    -- | Number of frames, from 1 to 'maximumFrames'.
    filmFrames :: !Int,
    -- | Frames per second, above 0.
    filmRate :: !Double,
    -- | Fields that change by keys.
    filmTracks :: ![Track],
    -- | How the camera moves, from wherever the keys have put it.
    filmPath :: !(Maybe CameraPath),
    filmShutter :: !Shutter
  }

-- | A field of the scene that follows keys; times are in seconds.
data Track = Track
  { -- | Its path in the scene file.
    trackField :: !String,
    -- | Put values into the field, or say what is wrong with them.
    trackSet :: !([Double] -> Scene -> Either Problem Scene),
    trackInterpolation :: !Interpolation,
    trackKeys :: !Keys
  }

-- | How long each frame gathers light.
data Shutter = Shutter
  { -- | Open for this part of the time from a frame to the next, 0 to 1.
    shutterOpen :: !Double,
    -- | Moments whose light is averaged, from 1 to 'maximumShutterSamples'.
    shutterSamples :: !Int
  }
  deriving (Eq, Show)

-- | A single moment for each frame: no motion blur.
closedShutter :: Shutter
closedShutter = Shutter 0 1

-- | The most frames of a film.
maximumFrames :: Int
maximumFrames = 1000000

-- | The most moments in a frame.
maximumShutterSamples :: Int
maximumShutterSamples = maximumMoments

-- | A film in which nothing moves: 48 frames at 24 a second.
stillFilm :: Scene -> Film
stillFilm scene = Film scene 48 24 [] Nothing closedShutter

-- | Seconds from the first frame to the moment after the last one's turn.
filmDuration :: Film -> Double
filmDuration film = fromIntegral (filmFrames film) / filmRate film

-- | What is wrong with the film's own numbers; its scenes are another matter
-- ('frameScenes').
filmProblems :: Film -> [Problem]
filmProblems film =
  [ Problem "--duration" (show frames ++ " frames") ("a duration of 1 to " ++ show maximumFrames ++ " frames")
    | frames < 1 || frames > maximumFrames
  ]
    ++ [ Problem "--fps" (show rate) "a number of frames per second from 0.001 to 1000"
         | not (rate >= 0.001 && rate <= 1000)
       ]
    ++ [ Problem "--shutter" (show open) "a fraction of the time between frames from 0 to 1"
         | not (open >= 0 && open <= 1)
       ]
    ++ [ Problem "--shutter-samples" (show samples) ("a whole number from 1 to " ++ show maximumShutterSamples)
         | samples < 1 || samples > maximumShutterSamples
       ]
  where
    frames = filmFrames film
    rate = filmRate film
    Shutter open samples = filmShutter film

-- | The scene at a moment (seconds), or everything that is wrong with it.
momentScene :: Film -> Double -> Either [Problem] Scene
momentScene film seconds = do
  keyed <- foldl track (Right (filmScene film)) (filmTracks film)
  moved <- maybe (Right keyed) (along keyed) (filmPath film)
  case validateScene moved of
    [] -> Right moved
    problems -> Left problems
  where
    track scene (Track _ set kind keys) =
      scene >>= either (Left . pure) Right . set (valueAt kind keys seconds)
    along scene path = either (Left . pure . impossible path) Right (alongPath path (filmDuration film) seconds scene)
    impossible path reason =
      Mistake "animation.camera-path" (cameraPathName path ++ ": " ++ reason)

-- | The moments (seconds) whose light frame @n@ gathers: the middles of equal
-- parts of the time for which the shutter is open.
frameMoments :: Film -> Int -> NonEmpty Double
frameMoments film n
  | open > 0 && samples > 0 = moment 0 :| map moment [1 .. samples - 1]
  | otherwise = time 0 :| []
  where
    Shutter open samples = filmShutter film
    time part = (fromIntegral n + part) / filmRate film
    moment :: Int -> Double
    moment k = time (open * (fromIntegral k + 0.5) / fromIntegral samples)

-- | The scenes whose mean light is frame @n@, or what is wrong with them.
frameScenes :: Film -> Int -> Either [Problem] (NonEmpty Scene)
frameScenes film n = traverse (momentScene film) (frameMoments film n)
