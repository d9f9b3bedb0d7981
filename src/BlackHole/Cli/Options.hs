-- | The command line: its commands and their parsers.
module BlackHole.Cli.Options
  ( Command (..),
    Parsed (..),
    parseArguments,
    formerOptions,
    formerOptionWarnings,
    commandHelps,
    completion,
  )
where

import BlackHole.Cli.Animate.Options (AnimateOptions, animateOptions)
import BlackHole.Cli.Explore.Options (ExploreOptions, exploreOptions)
import BlackHole.Cli.Help
import BlackHole.Cli.Join (JoinOptions, joinOptions)
import BlackHole.Cli.ManualPage (manualPage)
import BlackHole.Cli.Photon.Options (PhotonOptions, photonOptions)
import BlackHole.Cli.Rays (RaysOptions, raysOptions)
import BlackHole.Cli.Render.Options (RenderOptions, renderOptions)
import BlackHole.Cli.SceneCommand (SceneCommand, sceneCommands)
import BlackHole.Cli.SelfTest (SelfTestOptions, selfTestOptions)
import BlackHole.Cli.Topics
import Data.List (dropWhileEnd, find)
import Data.Maybe (isJust, mapMaybe)
import Options.Applicative
import Options.Applicative.Help (unChunk)
import System.Exit (ExitCode (..))

-- | A command with its options.
data Command
  = -- | Render one picture.
    Render RenderOptions
  | -- | Join the tiles of a picture.
    Join JoinOptions
  | -- | Render the frames of an animation.
    Animate AnimateOptions
  | -- | Show a live view in the browser.
    Explore ExploreOptions
  | -- | List, print or check scenes.
    Scenes SceneCommand
  | -- | Report on one light path.
    Photon PhotonOptions
  | -- | Draw parallel light rays.
    Rays RaysOptions
  | -- | Check the program's numbers.
    SelfTest SelfTestOptions
  deriving (Eq, Show)

-- | The result of parsing the command line.
data Parsed
  = -- | Run this command.
    Run Command
  | -- | Print this text on standard output: the user asked for it.
    Inform String
  | -- | The command is not named: print this help on standard error.
    Unnamed String
  | -- | One line that says what is wrong with the arguments.
    Misused String
  deriving (Eq, Show)

-- | Parse the arguments, given the program's version line.
parseArguments :: String -> [String] -> Parsed
parseArguments version given = case given of
  [] -> Unnamed (trimmed (overview commandHelps))
  [name]
    | Just c <- named' [name],
      name
        `elem` map (takeWhile (/= ' ')) innerNames ->
      Unnamed (helpText c)
  _ -> case execParserPure preferences (commandLine version) arguments of
    Success (Task task) -> Run task
    Success (HelpOn []) -> Inform (trimmed (overview commandHelps))
    Success (HelpOn ["man"]) ->
      Inform
        (trimmed (manualPage (unwords (take 2 (words version))) commandHelps))
    Success (HelpOn wanted) -> either Misused (Inform . trimmed) (helpOn commandHelps wanted)
    CompletionInvoked _ -> Misused "completion works only through the shell's completion script"
    Failure failure -> case execFailure failure "blackhole" of
      -- Only --version and --help succeed without a command.
      (text, ExitSuccess, _)
        | "--version" `elem` take 1 arguments -> Inform (oneLine text)
        | otherwise -> Inform (maybe (trimmed (overview commandHelps)) helpText chosen)
      (text, ExitFailure _, _) -> Misused (plainComplaint options commands (oneLine text))
  where
    arguments = map presentOption given
    oneLine = unwords . words . maybe "unknown arguments" show . unChunk . helpError
    helpText = trimmed . commandText commandHelps
    trimmed = dropWhileEnd (== '\n')
    named' name = find ((== unwords name) . commandName) commandHelps
    chosen = named' (take 2 arguments) <|> named' (take 1 arguments)
    innerNames = [name | name <- map commandName commandHelps, ' ' `elem` name]
    commands = case take 1 arguments of
      [outer]
        | inner@(_ : _) <-
            [second | [first, second] <- map words innerNames, first == outer] ->
          inner
      _
        | isJust chosen -> []
        | otherwise -> [name | name <- map commandName commandHelps, name `notElem` innerNames]
    options = "--help" : maybe ["--version"] (concatMap entryNames . commandEntries) chosen

-- | Former names of options with the present ones. They are still accepted.
formerOptions :: [(String, String)]
formerOptions = [("--camera", "--position"), ("--frames", "--frame-range")]

-- | An argument with the present name of an option, with or without a value after @=@.
presentOption :: String -> String
presentOption given = maybe given (++ rest) (lookup name formerOptions)
  where
    (name, rest) = break (== '=') given

-- | One line for each former name of an option among the arguments.
formerOptionWarnings :: [String] -> [String]
formerOptionWarnings = mapMaybe warning
  where
    warning given
      | presentOption given == given = Nothing
      | otherwise =
        Just
          ( "warning: " ++ takeWhile (/= '=') given ++ " is now called "
              ++ takeWhile (/= '=') (presentOption given)
          )

-- | The answer to a shell's completion request or its request for the completion
-- script; 'Nothing' for other arguments.
completion :: String -> [String] -> Maybe (IO String)
completion version arguments = case execParserPure preferences (commandLine version) arguments of
  CompletionInvoked asked -> Just (execCompletion asked "blackhole")
  _ -> Nothing

preferences :: ParserPrefs
preferences = prefs (columns 100)

data Request
  = Task !Command
  | -- | Help on these words, or the overview.
    HelpOn ![String]

-- | A command's help with its parser.
data Described = Described !CommandHelp !(Parser Request)

-- | The help of every command, also of those inside commands, in the order of the
-- overview.
commandHelps :: [CommandHelp]
commandHelps = concat [h : inner (commandName h) | Described h _ <- described]
  where
    inner name = [h | name == "scene", Described h _ <- describedScenes]

described :: [Described]
described =
  [ describe
      "render"
      "Render one picture."
      "It shows the default scene, a preset, a scene file, or the scene stored in a picture. \
      \Options override the settings of that scene."
      ["blackhole render --width 1280 --inclination 75 --fov 40 -o hole.png"]
      (Task . Render <$> renderOptions),
    describe
      "explore"
      "Fly around the hole in a live view in the browser."
      "Serves a page on this machine alone and prints its address, which contains a secret token. \
      \The picture there is traced by the code of render: drag it to orbit, turn the wheel to come \
      \nearer, change any setting, look at single pixels, set keyframes, and take the result home \
      \as a command line, a scene file, an animation or a picture. Files go to the folder in which \
      \the program was started."
      [ "blackhole explore",
        "blackhole explore --preset kerr",
        "blackhole explore mine.yaml --port 8000 --no-open"
      ]
      (Task . Explore <$> exploreOptions),
    describe
      "animate"
      "Render the frames of an animation."
      "The animation is a scene file with a section animation (see: blackhole help animation), or \
      \an orbit around the hole in any scene (--orbit). Renders only frames that are missing, \
      \outdated or damaged, so an interrupted animation continues where it stopped. Several \
      \processes can share the work."
      [ "blackhole animate --preset luminet --orbit 360 --duration 4 -o frames/%05d.png",
        "blackhole animate scenes/orbit.yaml -o frames/%05d.png --video orbit.mp4"
      ]
      (Task . Animate <$> animateOptions),
    describe
      "join"
      "Join the tiles of a picture."
      "Writes the file that render would have written without --tile."
      ["blackhole join big-*.tile -o big.png"]
      (Task . Join <$> joinOptions),
    describe
      "scene"
      "List, print and check scenes."
      ""
      ["blackhole scene show report > mine.yaml"]
      (hsubparser (foldMap sceneTask describedScenes)),
    describe
      "photon"
      "Report on one light path."
      "The path is that of light from infinity (--impact), or the line of sight of a camera \
      \(--psi). The report gives lengths in Schwarzschild radii (r_s) and angles in radians."
      [ "blackhole photon --psi 10",
        "blackhole photon --impact 2.65 --json",
        "blackhole photon --spin 0.9 --observer falling --distance 3 --psi 60"
      ]
      (Task . Photon <$> photonOptions),
    describe
      "rays"
      "Draw parallel light rays and their paths around the hole."
      "Writes an SVG or PNG file."
      ["blackhole rays --rays 41 -o rays.svg"]
      (Task . Rays <$> raysOptions),
    describe
      "selftest"
      "Check the program's numbers against published and independently computed values."
      "Takes a few seconds. The exit code is 1 if a check fails."
      ["blackhole selftest"]
      (Task . SelfTest <$> selfTestOptions),
    describe
      "help"
      "Explain a command or a topic."
      "Without an argument, lists the commands and topics. blackhole help man prints the manual \
      \page."
      ["blackhole help render", "blackhole help scene check", "blackhole help camera"]
      ( HelpOn
          <$> many
            ( strArgument
                ( metavar "COMMAND|TOPIC..."
                    <> completeWith
                      ("man" : concatMap (words . commandName) commandHelps ++ topicNames)
                    <> help "Words that name a command or a topic"
                )
            )
      )
  ]
  where
    sceneTask (Described about parser) =
      command (drop 6 (commandName about)) (info parser (progDesc (commandSummary about)))

describedScenes :: [Described]
describedScenes =
  [ describe ("scene " ++ name) summary details examples (Task . Scenes <$> parser)
    | (name, summary, details, examples, parser) <- sceneCommands
  ]

describe :: String -> String -> String -> [String] -> Parser Request -> Described
describe name summary details examples parser =
  Described
    (CommandHelp name summary details examples (parserEntries parser))
    parser

commandLine :: String -> ParserInfo Request
commandLine version =
  info
    (hsubparser (foldMap task described) <**> versionOption <**> helper)
    fullDesc
  where
    task (Described about parser) =
      command
        (commandName about)
        (info parser (progDesc (commandSummary about)))
    versionOption =
      infoOption version (long "version" <> help "Print the version and exit")
