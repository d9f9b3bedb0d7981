-- | The keys of the section @animation@ of a scene file. The reader, the JSON Schema and
-- the help all derive from these tables.
module BlackHole.Animation.AnimationKeys
  ( animationKey,
    AnimationKey (..),
    animationKeys,
    cameraPathKeys,
    pathKinds,
    keyframeKeys,
  )
where

import BlackHole.Animation.Animation
import BlackHole.Animation.Interpolate
import BlackHole.Scene.Field.Kind

-- | The section's name at the top of a scene file.
animationKey :: String
animationKey = "animation"

-- | A key with its kind of value and a description in one line.
data AnimationKey = AnimationKey
  { keyName :: !String,
    keyKind :: !Kind,
    keyDoc :: !String
  }

-- | The keys of the section that have a single value; it also has the groups
-- @camera-path@ and @keyframes@.
animationKeys :: [AnimationKey]
animationKeys =
  [ AnimationKey
      "frames"
      (WholeKind 1 maximumFrames "")
      "Number of frames, instead of the duration",
    AnimationKey
      "duration"
      (NumberKind (Quantity "a duration" (Above 0) (UpTo 1e6) "seconds"))
      "Duration of the animation in seconds, instead of the number of frames",
    AnimationKey
      "fps"
      (NumberKind (Quantity "a number of frames per second" (From 0.001) (UpTo 1000) ""))
      "Frames per second (default: 24)",
    AnimationKey
      "shutter"
      (NumberKind (Quantity "a fraction of the time between frames" (From 0) (UpTo 1) ""))
      "Motion blur: the fraction of the time between frames for which the shutter is open \
      \(default: 0, no motion blur)",
    AnimationKey
      "shutter-samples"
      (WholeKind 1 maximumShutterSamples "")
      "Times averaged in each frame with an open shutter; rendering takes that many times as long \
      \(default: 8)"
  ]

-- | The keys of the group @camera-path@.
cameraPathKeys :: [AnimationKey]
cameraPathKeys =
  [ AnimationKey
      "kind"
      (ChoiceKind "a camera path" [(name, doc) | (name, doc, _) <- pathKinds])
      "Kind of the camera path",
    AnimationKey
      "turns"
      (NumberKind (Quantity "a number of turns" (From (-1e4)) (UpTo 1e4) ""))
      "Number of turns around the hole during the animation, right-handed about the axis \
      \(default: 1)",
    AnimationKey "axis" VectorKind "Axis of the turns (default: [0, 1, 0], the disk's axis)",
    AnimationKey
      "to"
      VectorKind
      "Position of the camera at the end of the animation, in Schwarzschild radii",
    AnimationKey
      "look-at"
      VectorKind
      "Point that the camera looks at in the end, in Schwarzschild \
      \radii (default: the same as at the start)",
    AnimationKey
      "interpolation"
      ( ChoiceKind
          "a kind of interpolation"
          [("linear", "at constant speed"), ("eased", "from rest to rest")]
      )
      "Speed along the path: linear (constant), or eased (from rest to rest) (default: linear)",
    AnimationKey
      "end-distance"
      (NumberKind (Quantity "a distance" (Above 0) (UpTo 1e6) "Schwarzschild radii"))
      "Distance from the hole at the end of the animation, in Schwarzschild radii",
    AnimationKey
      "rate"
      ( NumberKind
          (Quantity "a proper time" (From (-1e9)) (UpTo 1e9) "r_s/c per second of animation")
      )
      "Proper time of the camera per second of animation, in r_s/c"
  ]

-- | The kinds of camera paths: name, description, and keys.
pathKinds :: [(String, String, [String])]
pathKinds =
  [ ("orbit", "turns around the hole", ["turns", "axis", "interpolation"]),
    ("dolly", "a straight line to a position", ["to", "look-at", "interpolation"]),
    ( "free-fall",
      "radial free fall from rest at infinity, with end-distance or rate",
      ["end-distance", "rate"]
    ),
    ("circular-orbit", "the circular geodesic in the disk's plane", ["rate"])
  ]

-- | The keys of a setting under @keyframes@, apart from times.
keyframeKeys :: [AnimationKey]
keyframeKeys =
  [ AnimationKey
      "interpolation"
      (ChoiceKind "a kind of interpolation" [(interpolationName kind, "") | kind <- [minBound ..]])
      "Between two keys: held (the value of the earlier key), linear, eased (from rest to rest) or \
      \smooth (Catmull-Rom spline) (default: linear)",
    AnimationKey
      "shortest-turn"
      SwitchKind
      "For angles in degrees: take the shorter way round from each key to the next (default: false)"
  ]
