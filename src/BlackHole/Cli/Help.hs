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
    helpOn,
    headedOptions,

    -- * Options and settings
    entryLabel,
    entryMeaning,
    sections,

    -- * Mistakes
    plainComplaint,
  )
where

import BlackHole.Cli.HelpLines
import BlackHole.Cli.Read (nearest)
import BlackHole.Cli.Topics
import BlackHole.Scene.Field.Field
import BlackHole.Scene.Field.Table (sceneFields)
import BlackHole.Scene.Problem (suggestion)
import Data.Char (toLower)
import Data.List (find, intercalate, isPrefixOf, stripPrefix)
import Data.Maybe (fromMaybe, listToMaybe)
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

-- | The text for the words after @help@, or what is wrong with them.
helpOn :: [CommandHelp] -> [String] -> Either String String
helpOn commands wanted
  | Just c <- find ((== name) . commandName) commands = Right (commandText commands c)
  | Just topic <- find ((== name) . map toLower . topicName) [minBound ..] = Right (topicText topic)
  | Just text <- lookup name guides = Right (unlines text)
  | otherwise =
    Left
      ( "help: '" ++ unwords wanted ++ "' is not a command or a topic"
          ++ fromMaybe (suggestion name known) (listToMaybe explanations)
      )
  where
    name = map toLower (unwords wanted)
    known = map commandName commands ++ topicNames
    -- For the name of an option.
    explanations =
      [ "; blackhole help " ++ (if title `elem` topicNames then title else commandName c)
          ++ " explains --"
          ++ name
        | c <- commands,
          e <- commandEntries c,
          ("--" ++ name) `elem` entryNames e,
          let title = map toLower (titleOf e)
      ]

-- | A parser's message in the words of the program's other messages, with a suggestion for
-- an unknown option or command, given the options and commands that are possible there. A
-- short option gets no suggestion: any letter is as near to it as any other.
plainComplaint :: [String] -> [String] -> String -> String
plainComplaint options commands complaint
  | Just word <- quoted "Invalid option `" = "'" ++ word ++ "' is not an option" ++ longHint word
  | Just word <- quoted "Invalid argument `" =
    if null commands
      then "unexpected argument '" ++ word ++ "'"
      else "'" ++ word ++ "' is not a command" ++ suggestion word commands
  | Just word <- quoted "The option `" = "option " ++ word ++ ": its value is missing"
  | otherwise = complaint
  where
    quoted start = takeWhile (`notElem` "'`=") <$> stripPrefix start complaint
    longHint word
      | "--" `isPrefixOf` word =
        foldMap
          (\best -> " (did you mean --" ++ best ++ "?)")
          (nearest (drop 2 word) [drop 2 o | o <- options, "--" `isPrefixOf` o])
      | otherwise = ""
