-- | The topics of help: the settings of a scene by topic, and guides.
module BlackHole.Cli.Topics
  ( topicNames,
    guides,
    topicText,
    defaultNote,
    exitTexts,
  )
where

import BlackHole.Cli.AnimationHelp
import BlackHole.Cli.HelpLines
import BlackHole.Scene.Field.Field
import BlackHole.Scene.Field.Kind (Value (..), showValue)
import BlackHole.Scene.Field.Table (sceneFields)
import BlackHole.Scene.Preset (defaultScene)
import Data.Char (toLower)
import Data.List (isInfixOf)
import Data.Maybe (fromMaybe)

-- | The names of all topics in lower case.
topicNames :: [String]
topicNames = map (map toLower . topicName) [minBound ..] ++ map fst guides

-- | Topics that are not about settings.
guides :: [(String, [String])]
guides =
  [ ( "hole",
      "The hole and its spin." :
      "" :
      concatMap (\text -> wrapped 0 text ++ [""]) holeHelp
        ++ ["Example: blackhole render --spin 0.9 --inclination 85 -o kerr.png"]
    ),
    ( "animation",
      "Animations: keyframes, camera paths and motion blur." :
      concatMap partLines animationHelp
        ++ [ "",
             "Example: blackhole animate --preset luminet --orbit 360 --duration 4 -o \
             \frames/%05d.png"
           ]
    ),
    ( "exit-status",
      "Exit codes, the same for all commands." :
      "" : concatMap (uncurry (row 12)) exitTexts ++ ["", "Example: blackhole selftest --quiet"]
    )
  ]
  where
    holeHelp =
      [ "A hole is its mass and its spin. The mass sets the scale: every length is in \
        \Schwarzschild radii, and nothing else depends on it. The spin (--spin, or hole.spin in \
        \scene files) is the angular momentum as a fraction of the greatest that a hole can have, \
        \from -1 to 1; 0 is a hole that does not rotate.",
        "A rotating hole drags space along. Light that passes on the side that turns towards you \
        \gets closer without falling in, so the shadow shifts and is flattened on that side: like \
        \the letter D for a fast hole in the plane of its disk. Inside the ergosphere (1 in the \
        \disk's plane) nothing can stay at rest.",
        "A positive spin turns with the disk, a negative one against it. With the disk, the gas \
        \can circle closer in: down to 3 without spin, 1.16 at 0.9, 0.62 at 0.998, but only 4.36 \
        \at -0.9. Gas there is faster, and its light more strongly shifted. A disk that reaches \
        \down to that orbit follows the spin unless --disk-inner says otherwise.",
        "The observers static, zamo, orbiting, counter-orbiting and falling are possible; static \
        \ones outside the ergosphere only. A zamo turns with space and has no angular momentum of \
        \its own."
      ]
    partLines part =
      "" : case part of
        Paragraph text -> wrapped 0 text
        Verbatim code -> map ("    " ++) code
        Terms terms -> concatMap (uncurry (row 19)) terms

-- | A topic: all its settings, with their options and their paths in scene files.
topicText :: Topic -> String
topicText topic =
  unlines $
    [topicName topic ++ ": settings of a scene, as options and (in brackets) in scene files.", ""]
      ++ concat [row 28 (label f) (settingMeaning f) | f <- sceneFields, fieldTopic f == topic]
      ++ (if topic == Sky then "" : concatMap (wrapped 0) skySources else [])
      ++ ["", "Example: blackhole render " ++ example topic]
  where
    label f = case fieldOption f of
      Just (Takes name value) -> "--" ++ name ++ " " ++ value
      Just (Sets name _ _) -> "--" ++ name
      Nothing -> fieldPath f

settingMeaning :: Field -> String
settingMeaning f =
  text ++ fromMaybe "" (defaultNote text f)
    ++ maybe " [scene file only]" (const (" [" ++ fieldPath f ++ "]")) (fieldOption f)
  where
    text = case fieldOption f of
      Just (Sets _ _ flagText) -> flagText
      _ -> fieldDoc f

-- | The sources of the real sky.
skySources :: [String]
skySources =
  [ "The real sky has 118 235 stars with their measured positions, magnitudes and colours: ESA, \
    \1997, The Hipparcos and Tycho Catalogues, ESA SP-1200, and for bright stars the Bright Star \
    \Catalogue, 5th edition (Hoffleit and Warren 1991).",
    "The Milky Way is the light of all stars that are not among them, from star counts of the \
    \Tycho-2 and NOMAD catalogues and a model of the Galaxy behind the dust measured by Schlegel, \
    \Finkbeiner and Davis 1998."
  ]

-- | Options of render that demonstrate a topic.
example :: Topic -> String
example topic = case topic of
  Image -> "--width 1280 --height 720"
  Camera -> "--inclination 75 --distance 20 --fov 40"
  Observer -> "--observer falling"
  Disk -> "--disk-outer 12 --temperature 6000"
  Sky -> "--sky grid"
  Sampling -> "--samples 16 --seed 7"
  Output -> "--tone-map agx --exposure 1 -o hole.png"
  Diagnostics -> "--debug-textures"

-- | The default of a setting in brackets, unless its description names one.
defaultNote :: String -> Field -> Maybe String
defaultNote text f
  | "default" `isInfixOf` text = Nothing
  | Just (Sets {}) <- fieldOption f = Nothing
  | otherwise = case fieldGet f defaultScene of
    Just (VectorValue _) -> Nothing
    value -> (\v -> " (default: " ++ showValue v ++ ")") <$> value

-- | The exit codes and their meanings.
exitTexts :: [(String, String)]
exitTexts =
  [ ("0", "Success."),
    ( "1",
      "An internal error, a failed self-test, or with --strict a pixel without finite radiance."
    ),
    ("2", "Invalid command line."),
    ( "3",
      "Invalid input: a value of the scene out of its range, a file that cannot be read, or a \
      \picture that does not fit into memory."
    ),
    ("4", "The output cannot be written."),
    ("5", "Frames of an animation or its video file are missing."),
    ( "129, 130, 143, 152",
      "Stopped by a signal: SIGHUP, Ctrl-C (SIGINT), SIGTERM, or the limit on processor time."
    )
  ]
