-- | Keyframes that a page sets, and the animation that they make.
module BlackHole.Explore.Timeline
  ( Timeline (..),
    Key (..),
    interpolations,
    Sequence (..),
    sequenceOf,
  )
where

import BlackHole.Animation.Animation
import BlackHole.Animation.AnimationFile
import BlackHole.Animation.AnimationKeys
import BlackHole.Animation.Interpolate
import BlackHole.Scene.Field.Field
import BlackHole.Scene.Field.Kind
import BlackHole.Scene.Field.Number
import BlackHole.Scene.Field.Table
import BlackHole.Scene.File.SceneFile
import BlackHole.Scene.File.Yaml (parseYaml)
import BlackHole.Scene.Preset
import BlackHole.Scene.Problem
import BlackHole.Scene.Scene
import BlackHole.Scene.Setting
import BlackHole.Vector.XYZ (XYZ (..))
import qualified Data.ByteString.Builder as Builder
import qualified Data.ByteString.Lazy as Lazy
import Data.List (intercalate, nub, sortOn)
import Data.Maybe (isJust, mapMaybe)

-- | An animation in the making: its length in seconds, its frames per second, how values go
-- from key to key, and the keys.
data Timeline = Timeline
  { timelineDuration :: !Double,
    timelineRate :: !Double,
    timelineInterpolation :: !Interpolation,
    timelineKeys :: ![Key]
  }
  deriving (Eq, Show)

-- | A time in seconds with all settings of the scene at that time.
data Key = Key
  { keySeconds :: !Double,
    keySettings :: ![Setting]
  }
  deriving (Eq, Show)

-- | The kinds of interpolation by name.
interpolations :: [(String, Interpolation)]
interpolations = [(interpolationName kind, kind) | kind <- [minBound ..]]

-- | The animation of a timeline.
data Sequence = Sequence
  { sequenceAnimation :: !Animation,
    -- | The animation scene file.
    sequenceText :: !String,
    -- | Paths of settings that differ between keys but cannot change in an animation. They
    -- keep the value of the first key.
    sequenceFixed :: ![String]
  }

-- | The animation of a timeline, read back from the text of its scene file, so that a saved
-- animation is the one that was seen; or what is wrong with it.
sequenceOf :: Timeline -> Either [String] Sequence
sequenceOf timeline = case sortOn keySeconds (timelineKeys timeline) of
  [] -> Left ["an animation needs a keyframe"]
  keys@(first : _)
    | map keySeconds keys /= nub (map keySeconds keys) -> Left ["two keyframes have the same time"]
    | otherwise -> do
      let scene = applySettings (keySettings first) defaultScene
          text = sequenceLines timeline scene keys
      animation <- readBack text scene
      Right
        ( Sequence
            animation
            text
            [ fieldPath f | f <- sceneFields, varies
                                                keys
                                                f, not (isTrackable f && all (hasValue f) keys)
            ]
        )
  where
    readBack text scene =
      case parseYaml (Lazy.toStrict (Builder.toLazyByteString (Builder.stringUtf8 text))) of
        Right (Just root) | Just (animation, faults) <- readAnimation root -> case faults of
          [] -> Right (animation scene)
          _ -> Left (map (renderProblem . snd) faults)
        _ -> Left ["the animation has no scene file"]

valueIn :: Field -> Key -> Maybe Value
valueIn field key =
  lookup (fieldPath field) [(settingPath s, settingValue s) | s <- keySettings key]

hasValue :: Field -> Key -> Bool
hasValue field key = isJust (valueIn field key)

varies :: [Key] -> Field -> Bool
varies keys field = length (nub (map (valueIn field) keys)) > 1

-- | The scene file: the scene of the first key, and a section @animation@.
sequenceLines :: Timeline -> Scene -> [Key] -> String
sequenceLines timeline scene keys =
  printScene
    ["An animation made with blackhole explore: blackhole animate FILE -o frames/%05d.png"]
    scene
    ++ unlines
      ( [ "",
          animationKey ++ ":",
          "  duration: " ++ exactNumber (timelineDuration timeline),
          "  fps: " ++ exactNumber (timelineRate timeline)
        ]
          ++ (if null tracks then [] else "  keyframes:" : concat tracks)
      )
  where
    tracks = mapMaybe track sceneFields
    track field
      | isTrackable field,
        varies keys field,
        Just values <- traverse (\key -> (,) (keySeconds key) <$> valueIn field key) keys =
        Just $
          [ "    " ++ fieldPath field ++ ":",
            "      interpolation: " ++ interpolationName (timelineInterpolation timeline)
          ]
            ++ ["      shortest-turn: true" | turns field]
            ++ ["      " ++ exactNumber seconds ++ ": " ++ text value | (seconds, value) <- values]
      | otherwise = Nothing
    -- Angles of which a whole turn makes no difference.
    turns field = fieldPath field `elem` ["camera.azimuth", "camera.roll", "sky.rotation"]
    text value = case value of
      VectorValue (XYZ x y z) -> "[" ++ intercalate ", " (map exactNumber [x, y, z]) ++ "]"
      NumberValue v -> exactNumber v
      _ -> showValue value
