-- | Help for people: overview, commands, topics and the manual page, all made
-- of the parsers and the table of the scene's fields.
module BlackHole.Cli.Help
  ( -- * Commands
    CommandHelp (..),
    Entry (..),
    parserEntries,

    -- * Texts
    overview,
    commandText,
    topicText,
    topicNames,
    helpOn,
    manualPage,

    -- * Mistakes
    withSuggestion,
  )
where

import BlackHole.Cli.Read (nearest)
import BlackHole.Scene.Field.Field
import BlackHole.Scene.Field.Kind (Value (..), showValue)
import BlackHole.Scene.Field.Table (sceneFields)
import BlackHole.Scene.Preset (defaultScene, presetNames)
import BlackHole.Scene.Problem (suggestion)
import Data.Char (toLower)
import Data.List (find, intercalate, isInfixOf, stripPrefix)
import Data.Maybe (fromMaybe, listToMaybe, mapMaybe)
import Options.Applicative.Common (mapParser)
import Options.Applicative.Help (unChunk)
import Options.Applicative.Types

-- | One option or argument.
data Entry = Entry
  { -- | Its names with dashes; none for an argument.
    entryNames :: ![String],
    -- | What stands for its value; empty if it takes none.
    entryValue :: !String,
    entryText :: !String
  }
  deriving (Eq, Show)

-- | What help says of one command.
data CommandHelp = CommandHelp
  { commandName :: !String,
    commandSummary :: !String,
    commandExamples :: ![String],
    commandEntries :: ![Entry]
  }
  deriving (Eq, Show)

-- | The options and arguments of a parser in its order, without hidden ones and
-- without commands inside it.
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

-- | The names of the topics, in lower case.
topicNames :: [String]
topicNames = map (map toLower . topicName) [minBound .. maxBound]

-- | All commands with a line for each, and the topics.
overview :: [CommandHelp] -> String
overview commands =
  unlines $
    [ "Physically exact pictures of a black hole.",
      "",
      "Usage: blackhole COMMAND [OPTION...]",
      "",
      "Commands:"
    ]
      ++ concat [row 12 (commandName c) (firstSentence (commandSummary c)) | c <- commands]
      ++ row 12 "help" "Explain a command or a topic"
      ++ ["", "Topics:"]
      ++ wrapped 2 (intercalate ", " topicNames)
      ++ [ "",
           "blackhole help COMMAND or TOPIC says more, and so does COMMAND --help.",
           "blackhole --version names the version, the compiler and the array back end.",
           "",
           "Example: blackhole render --width 1280 -o hole.png"
         ]
  where
    firstSentence = takeWhile (/= ':')

-- | A command with all its options, those of a scene grouped by topic.
commandText :: CommandHelp -> String
commandText c =
  unlines $
    wrapped 0 (commandSummary c)
      ++ ["", usage c]
      ++ concat
        [ "" : (title ++ ":") : concatMap entryRows entries
          | (title, entries) <- sections c
        ]
      ++ [line | not (null (commandExamples c)), line <- "" : heading : map ("  " ++) (commandExamples c)]
  where
    heading = if length (commandExamples c) > 1 then "Examples:" else "Example:"

usage :: CommandHelp -> String
usage c = "Usage: blackhole " ++ unwords (commandName c : "[OPTION...]" : [argument (entryValue e) | e <- commandEntries c, null (entryNames e)])
  where
    -- A scene file need not be given; every other argument must be.
    argument name = if name == "SCENE.yaml" then "[" ++ name ++ "]" else name

entryRows :: Entry -> [String]
entryRows e = row 26 (entryLabel e) (entryMeaning e)

entryLabel :: Entry -> String
entryLabel (Entry names value _)
  | null names = value
  | null value = intercalate ", " names
  | otherwise = intercalate ", " names ++ " " ++ value

-- | The text with the default, if that is a field's and not said yet.
entryMeaning :: Entry -> String
entryMeaning e = entryText e ++ fromMaybe "" (fieldOf e >>= defaultNote (entryText e))

fieldOf :: Entry -> Maybe Field
fieldOf e = find (maybe False ((`elem` entryNames e) . optionName) . fieldOption) sceneFields

defaultNote :: String -> Field -> Maybe String
defaultNote text f
  | "default" `isInfixOf` text = Nothing
  | Just (Sets {}) <- fieldOption f = Nothing
  | otherwise = case fieldGet f defaultScene of
    Just (VectorValue _) -> Nothing
    value -> (\v -> " (default: " ++ showValue v ++ ")") <$> value

-- | The entries under their headings. Commands without a scene have one heading.
sections :: CommandHelp -> [(String, [Entry])]
sections c
  | any (("--preset" `elem`) . entryNames) entries =
    filter (not . null . snd) [(title, filter ((== title) . titleOf) entries) | title <- titles]
  | null entries = []
  | otherwise = [("Options", entries)]
  where
    entries = commandEntries c
    titles = "Scene" : map topicName [minBound .. maxBound] ++ ["This command"]

titleOf :: Entry -> String
titleOf e
  | null (entryNames e) || any (`elem` ["--preset", "--from"]) (entryNames e) = "Scene"
  | Just f <- fieldOf e = topicName (fieldTopic f)
  | any (`elem` outputs) (entryNames e) = topicName Output
  | any (`elem` diagnostics) (entryNames e) = topicName Diagnostics
  | otherwise = "This command"
  where
    outputs = ["--output", "--bits", "--quality", "--preview", "--tile", "--keep-partial", "--layers", "--video"]
    diagnostics = ["--pixel", "--threads", "--progress", "--quiet", "--stats", "--strict"]

-- | A topic: every setting that belongs to it, with its option and its place in
-- scene files.
topicText :: Topic -> String
topicText topic =
  unlines $
    [topicName topic ++ ": settings of a scene, as options of render and in scene files.", ""]
      ++ concat [row 30 (label f) (meaning f) | f <- sceneFields, fieldTopic f == topic]
      ++ (if topic == Diagnostics then concatMap (uncurry (row 30)) others else [])
      ++ (if topic == Sky then "" : concatMap (wrapped 0) skySources else [])
      ++ ["", "Example: blackhole render " ++ example topic]
  where
    label f = case fieldOption f of
      Just (Takes name value) -> "--" ++ name ++ " " ++ value
      Just (Sets name _ _) -> "--" ++ name
      Nothing -> fieldPath f
    meaning f = fieldDoc f ++ fromMaybe "" (defaultNote (fieldDoc f) f) ++ maybe " [scene file only]" (const (" [" ++ fieldPath f ++ "]")) (fieldOption f)
    others =
      [ ("--pixel X,Y", "Explain one pixel instead of rendering"),
        ("--stats FILE.json", "Write what the rendering took"),
        ("--progress HOW", "How to tell about progress"),
        ("--strict", "Fail if a pixel has no finite radiance")
      ]

-- | Where the real sky comes from.
skySources :: [String]
skySources =
  [ "The real sky has 118 235 stars with their measured positions, magnitudes and colours: ESA, 1997, The Hipparcos and Tycho Catalogues, ESA SP-1200, and for bright stars the Bright Star Catalogue, 5th edition (Hoffleit and Warren 1991).",
    "The Milky Way is the light of all stars that are not among them, from star counts of the Tycho-2 and NOMAD catalogues and a model of the Galaxy behind the dust measured by Schlegel, Finkbeiner and Davis 1998.",
    "data/sky/README.md and docs/sky.md say more."
  ]

-- | Options of render that show what a topic is about.
example :: Topic -> String
example topic = case topic of
  Image -> "--width 1280 --height 720"
  Camera -> "--inclination 75 --distance 20 --fov 40"
  Observer -> "--observer falling"
  Disk -> "--disk-outer 12 --temperature 6000"
  Sky -> "--sky grid"
  Sampling -> "--samples 16 --seed 7"
  Output -> "--tone-map agx --exposure 1 -o hole.png"
  Diagnostics -> "--pixel 640,300"

-- | The text for a word after @help@, or what is wrong with the word.
helpOn :: [CommandHelp] -> String -> Either String String
helpOn commands word
  | Just c <- find ((== lower) . commandName) commands = Right (commandText c)
  | Just topic <- find ((== lower) . map toLower . topicName) [minBound ..] = Right (topicText topic)
  | otherwise =
    Left ("help: '" ++ word ++ "' is not a command or topic" ++ suggestion word known ++ "; there are: " ++ intercalate ", " known)
  where
    lower = map toLower word
    known = map commandName commands ++ topicNames

-- | The manual page in the macros of @man@, given the program's version.
manualPage :: String -> [CommandHelp] -> String
manualPage version commands =
  unlines $
    [ ".TH BLACKHOLE 1 \"\" \"" ++ version ++ "\" \"User Commands\"",
      ".SH NAME",
      "blackhole \\- physically exact pictures of a black hole",
      ".SH SYNOPSIS",
      ".B blackhole",
      "\\fICOMMAND\\fR [\\fIOPTION\\fR...]",
      ".SH DESCRIPTION",
      "Traces light backwards from a camera through the curved space around a black hole: a disk of gas, a sky of stars, and the shadow between them.",
      "Equal scenes give equal bytes, for any number of threads.",
      "Lengths are in Schwarzschild radii.",
      ".SH COMMANDS"
    ]
      ++ concatMap commandPart commands
      ++ [".SH EXIT STATUS"]
      ++ concat [[".TP", ".B " ++ code, roff text] | (code, text) <- exitTexts]
      ++ [ ".SH ENVIRONMENT",
           ".TP",
           ".B NO_COLOR",
           "If set to anything, no colours are written.",
           ".SH PRESETS",
           roff (intercalate ", " presetNames)
         ]
  where
    commandPart c =
      [".SS blackhole " ++ roff (commandName c), roff (commandSummary c)]
        ++ concat [(".PP" : [".B " ++ roff title]) ++ concatMap item entries | (title, entries) <- sections c]
        ++ concat [[".PP", "Example:", ".PP", ".EX", roff line, ".EE"] | line <- commandExamples c]
    item e = [".TP", ".B " ++ roff (entryLabel e), roff (entryMeaning e)]

-- | The table of exit codes, in words.
exitTexts :: [(String, String)]
exitTexts =
  [ ("0", "All went well."),
    ("1", "A fault of the program, a self-test that does not hold, or with --strict a pixel without finite radiance."),
    ("2", "The arguments are wrong."),
    ("3", "The scene is wrong: a value out of its range, a file that can't be read, or a picture too large for the memory."),
    ("4", "The file can't be written."),
    ("5", "A film lacks frames or its film file."),
    ("129, 130, 143, 152", "Stopped by a signal: SIGHUP, Ctrl-C, SIGTERM, or the limit on processor time.")
  ]

roff :: String -> String
roff text = case concatMap escaped text of
  line@(c : _) | c `elem` ".'" -> "\\&" ++ line
  line -> line
  where
    escaped c = case c of
      '\\' -> "\\e"
      '-' -> "\\-"
      _ -> [c]

-- | A parser's complaint with the option or command that may have been meant,
-- given the names there are.
withSuggestion :: [String] -> [String] -> String -> String
withSuggestion options commands complaint = complaint ++ fromMaybe "" hint
  where
    hint = listToMaybe (mapMaybe meant [("Invalid option `", options), ("Invalid argument `", commands)])
    meant (start, names) = do
      rest <- stripPrefix start complaint
      let word = takeWhile (\c -> c /= '\'' && c /= '=') rest
      best <- nearest word names
      pure (" (did you mean " ++ best ++ "?)")

row :: Int -> String -> String -> [String]
row column name text
  | length name + 4 > column = ("  " ++ name) : map (replicate column ' ' ++) texts
  | otherwise = zipWith (++) (("  " ++ name ++ replicate (column - 2 - length name) ' ') : repeat (replicate column ' ')) texts
  where
    texts = wrap (84 - column) text

wrapped :: Int -> String -> [String]
wrapped indent = map (replicate indent ' ' ++) . wrap (84 - indent)

-- | Lines of at most that many characters, words longer than that excepted; at
-- least one line.
wrap :: Int -> String -> [String]
wrap width = go [] . words
  where
    go line [] = [unwords (reverse line)]
    go line (w : rest)
      | null line || length (unwords (w : line)) <= width = go (w : line) rest
      | otherwise = unwords (reverse line) : go [w] rest
