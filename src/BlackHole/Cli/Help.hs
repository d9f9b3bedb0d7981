-- | Help: the overview and the text of each command and topic, made from the parsers and
-- the table of settings.
module BlackHole.Cli.Help
  ( -- * Commands
    CommandHelp (..),
    Entry (..),
    parserEntries,

    -- * Texts
    overview,
    commandText,
    topicNames,
    helpOn,
    headedOptions,
    exitTexts,

    -- * Options and settings
    entryLabel,
    entryMeaning,
    defaultNote,
    sections,

    -- * Mistakes
    withSuggestion,
  )
where

import BlackHole.Cli.AnimationHelp
import BlackHole.Cli.Read (nearest)
import BlackHole.Scene.Field.Field
import BlackHole.Scene.Field.Kind (Value (..), showValue)
import BlackHole.Scene.Field.Table (sceneFields)
import BlackHole.Scene.Preset (defaultScene)
import BlackHole.Scene.Problem (suggestion)
import Data.Char (toLower)
import Data.List (find, intercalate, isInfixOf, isPrefixOf, stripPrefix)
import Data.Maybe (fromMaybe, listToMaybe, mapMaybe)
import Options.Applicative.Common (mapParser)
import Options.Applicative.Help (unChunk)
import Options.Applicative.Types

-- | One option or argument.
data Entry = Entry
  { -- | Its names with dashes; none for an argument.
    entryNames :: ![String],
    -- | The placeholder for its value; empty for a flag.
    entryValue :: !String,
    entryText :: !String
  }
  deriving (Eq, Show)

-- | What help says about one command.
data CommandHelp = CommandHelp
  { -- | One word, or two for a command of a command.
    commandName :: !String,
    -- | One sentence.
    commandSummary :: !String,
    -- | More sentences; may be empty.
    commandDetails :: !String,
    -- | Complete command lines.
    commandExamples :: ![String],
    commandEntries :: ![Entry]
  }
  deriving (Eq, Show)

-- | The visible options and arguments of a parser in its order, without those of
-- commands inside it.
parserEntries :: Parser a -> [Entry]
parserEntries = concat . mapParser (const entry)
  where
    entry option
      | propVisibility (optProps option) /= Visible = []
      | otherwise = case optMain option of
        OptReader names _ _ -> [described option names]
        FlagReader names _ -> [described option names]
        ArgReader _ -> [described option []]
        CmdReader {} -> []
    described option names =
      Entry
        { entryNames = map dashed (filter isLong names ++ filter (not . isLong) names),
          entryValue = propMetaVar (optProps option),
          entryText = unwords (words (maybe "" show (unChunk (propHelp (optProps option)))))
        }
    isLong (OptLong _) = True
    isLong (OptShort _) = False
    dashed (OptLong name) = "--" ++ name
    dashed (OptShort c) = ['-', c]

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
        \at -0.9. The disk is hotter and its light more strongly shifted there. A disk that \
        \reaches down to that orbit follows the spin unless --disk-inner says otherwise.",
        "The observers static, zamo, orbiting, counter-orbiting and falling are possible; static \
        \ones outside the ergosphere only. A zamo turns with space and has no angular momentum of \
        \its own."
      ]
    partLines part =
      "" : case part of
        Paragraph text -> wrapped 0 text
        Verbatim code -> map ("    " ++) code
        Terms terms -> concatMap (uncurry (row 19)) terms

-- | The commands, one line for each, and the topics.
overview :: [CommandHelp] -> String
overview commands =
  unlines $
    [ "Physically accurate pictures of a black hole.",
      "",
      "Usage: blackhole COMMAND [OPTION...]",
      "",
      "Commands:"
    ]
      ++ summaries [c | c <- commands, ' ' `notElem` commandName c]
      ++ ["", "Topics:"]
      ++ wrapped 2 (intercalate ", " topicNames)
      ++ [ "",
           "blackhole help COMMAND (or TOPIC) explains a command or a topic.",
           "blackhole --version prints the versions of the program and its compiler.",
           "",
           "Example: blackhole render --width 1280 -o hole.png"
         ]

summaries :: [CommandHelp] -> [String]
summaries = concatMap (\c -> row 17 (commandName c) (takeWhile (/= '.') (commandSummary c)))

-- | The text of a command, given all commands: its summary, its options, those of a
-- scene grouped by topic, the commands inside it, and examples.
commandText :: [CommandHelp] -> CommandHelp -> String
commandText commands c =
  unlines $
    wrapped 0 (commandSummary c ++ " " ++ commandDetails c)
      ++ ["", usage c inner]
      ++ (if null inner then [] else ["", "Commands:"] ++ summaries inner)
      ++ concat
        [ "" : (title ++ ":") : concatMap (entryRows c) entries
          | (title, entries) <- sections c
        ]
      ++ [ line
           | not (null (commandExamples c)),
             line <- "" : heading : map ("  " ++) (commandExamples c)
         ]
  where
    inner = innerCommands commands c
    heading = if length (commandExamples c) > 1 then "Examples:" else "Example:"

innerCommands :: [CommandHelp] -> CommandHelp -> [CommandHelp]
innerCommands commands c = [i | i <- commands, (commandName c ++ " ") `isPrefixOf` commandName i]

usage :: CommandHelp -> [CommandHelp] -> String
usage c inner =
  "Usage: blackhole "
    ++ unwords
      ( commandName c :
        ["COMMAND" | not (null inner)] ++ ["[OPTION...]" | hasOptions] ++ map argument arguments
      )
  where
    hasOptions = not (null inner && all (null . entryNames) (commandEntries c))
    arguments = [entryValue e | e <- commandEntries c, null (entryNames e)]
    optional name = name == "COMMAND|TOPIC..." || (name == "SCENE.yaml" && isSceneCommand c)
    argument name = if optional name then "[" ++ name ++ "]" else name

-- | Whether a command takes the options of a scene.
isSceneCommand :: CommandHelp -> Bool
isSceneCommand = any (("--preset" `elem`) . entryNames) . commandEntries

entryRows :: CommandHelp -> Entry -> [String]
entryRows c e = row 26 (entryLabel e) (entryMeaning c e)

-- | The names and the placeholder.
entryLabel :: Entry -> String
entryLabel (Entry names value _)
  | null names = value
  | null value = intercalate ", " names
  | otherwise = intercalate ", " names ++ " " ++ value

-- | The description, with the default if the option belongs to a setting.
entryMeaning :: CommandHelp -> Entry -> String
entryMeaning c e =
  entryText e
    ++ fromMaybe "" (if isSceneCommand c then fieldOf e >>= defaultNote (entryText e) else Nothing)

fieldOf :: Entry -> Maybe Field
fieldOf e = find (maybe False ((`elem` entryNames e) . optionName) . fieldOption) sceneFields

-- | The default of a setting in brackets, unless its description names one.
defaultNote :: String -> Field -> Maybe String
defaultNote text f
  | "default" `isInfixOf` text = Nothing
  | Just (Sets {}) <- fieldOption f = Nothing
  | otherwise = case fieldGet f defaultScene of
    Just (VectorValue _) -> Nothing
    value -> (\v -> " (default: " ++ showValue v ++ ")") <$> value

-- | The options under their headings; a single heading for commands without a scene.
sections :: CommandHelp -> [(String, [Entry])]
sections c
  | isSceneCommand c =
    filter (not . null . snd) [(title, filter ((== title) . titleOf) entries) | title <- titles]
  | null entries = []
  | otherwise =
    [(if any (null . entryNames) entries then "Arguments and options" else "Options", entries)]
  where
    entries = commandEntries c
    titles = "Scene" : map topicName [minBound .. maxBound] ++ ["This command"]

titleOf :: Entry -> String
titleOf e
  | null (entryNames e) || any (`elem` ["--preset", "--from"]) (entryNames e) = "Scene"
  | Just f <- fieldOf e = topicName (fieldTopic f)
  | otherwise = maybe "This command" fst (find (any (`elem` entryNames e) . snd) headedOptions)

-- | The headings of options that do not belong to a setting.
headedOptions :: [(String, [String])]
headedOptions =
  [ ( topicName Output,
      [ "--output",
        "--bits",
        "--quality",
        "--preview",
        "--tile",
        "--keep-partial",
        "--video",
        "--codec",
        "--crf"
      ]
    ),
    ( topicName Diagnostics,
      ["--pixel", "--threads", "--progress", "--quiet", "--stats", "--strict"]
    )
  ]

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

-- | The text for the words after @help@, or what is wrong with them.
helpOn :: [CommandHelp] -> [String] -> Either String String
helpOn commands wanted
  | Just c <- find ((== name) . commandName) commands = Right (commandText commands c)
  | Just topic <- find ((== name) . map toLower . topicName) [minBound ..] = Right (topicText topic)
  | Just text <- lookup name guides = Right (unlines text)
  | otherwise =
    Left ("help: '" ++ unwords wanted ++ "' is not a command or a topic" ++ suggestion name known)
  where
    name = map toLower (unwords wanted)
    known = map commandName commands ++ topicNames

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

-- | A parser's message, with a suggestion if it is about an unknown option or command,
-- given the options and commands that exist. A short option gets no suggestion: any
-- letter is as near to it as any other.
withSuggestion :: [String] -> [String] -> String -> String
withSuggestion options commands complaint = complaint ++ fromMaybe "" hint
  where
    hint =
      listToMaybe
        ( mapMaybe
            meant
            [("Invalid option `", filter isLong options), ("Invalid argument `", commands)]
        )
    meant (start, names) = do
      rest <- stripPrefix start complaint
      let word = takeWhile (\c -> c /= '\'' && c /= '=') rest
      best <-
        if isLong word
          then ("--" ++) <$> nearest (drop 2 word) (map (drop 2) names)
          else if "-" `isPrefixOf` word then Nothing else nearest word names
      pure (" (did you mean " ++ best ++ "?)")
    isLong = isPrefixOf "--"

row :: Int -> String -> String -> [String]
row column name text
  | length name + 4 > column = ("  " ++ name) : map (replicate column ' ' ++) texts
  | otherwise =
    zipWith
      (++)
      (("  " ++ name ++ replicate (column - 2 - length name) ' ') : repeat (replicate column ' '))
      texts
  where
    texts = wrap (80 - column) text

wrapped :: Int -> String -> [String]
wrapped indent = map (replicate indent ' ' ++) . wrap (80 - indent)

-- | Lines of at most that many characters, except for longer words; at least one line.
wrap :: Int -> String -> [String]
wrap width = go [] . words
  where
    go line [] = [unwords (reverse line)]
    go line (w : rest)
      | null line || length (unwords (w : line)) <= width = go (w : line) rest
      | otherwise = unwords (reverse line) : go [w] rest
