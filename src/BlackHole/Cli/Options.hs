-- | The command line: its grammar, and the scene it asks for.
module BlackHole.Cli.Options
  ( Command (..),
    RenderOptions (..),
    Parsed (..),
    parseArguments,
    completion,
  )
where

import BlackHole.Cli.Animate (AnimateOptions, animateOptions)
import BlackHole.Cli.CodingOptions (codingOptions)
import BlackHole.Cli.Help
import BlackHole.Cli.Join (JoinOptions, joinOptions, tilePart)
import BlackHole.Cli.Photon (PhotonOptions, photonOptions)
import BlackHole.Cli.Rays (RaysOptions, raysOptions)
import BlackHole.Cli.Read
import BlackHole.Cli.RunOptions (RunOptions, runOptions)
import BlackHole.Cli.SceneCommand (SceneCommand, sceneCommand)
import BlackHole.Cli.SceneOptions (SceneOptions, sceneOptions)
import BlackHole.Cli.SelfTest (SelfTestOptions, selfTestOptions)
import BlackHole.Image.Coding (Coding)
import BlackHole.Render.Shard (Shard)
import Data.List (dropWhileEnd, find)
import Data.Maybe (fromMaybe)
import Options.Applicative
import Options.Applicative.Help (renderHelp, unChunk)
import System.Exit (ExitCode (..))

-- | What the program is asked to do.
data Command
  = -- | Render one picture.
    Render RenderOptions
  | -- | Join the tiles of a picture.
    Join JoinOptions
  | -- | Render the frames of a film.
    Animate (AnimateOptions SceneOptions)
  | -- | Do something with scenes that is not rendering.
    Scenes SceneCommand
  | -- | Report on one light path.
    Photon PhotonOptions
  | -- | Draw the fan of light paths.
    Rays RaysOptions
  | -- | Hold the program's numbers against known ones.
    SelfTest SelfTestOptions
  deriving (Eq, Show)

-- | The options of @blackhole render@.
data RenderOptions = RenderOptions
  { -- | What the scene is made of.
    renderScene :: !SceneOptions,
    -- | A picture of this program that says what scene to start from.
    renderFrom :: !(Maybe FilePath),
    renderCoding :: !Coding,
    -- | Draw in the terminal instead of writing a file.
    renderPreview :: !Bool,
    renderThreads :: !(Maybe Int),
    renderPixel :: !(Maybe (Int, Int)),
    renderTile :: !(Maybe Shard),
    -- | How to go about it.
    renderRun :: !RunOptions,
    renderOutput :: !FilePath
  }
  deriving (Eq, Show)

-- | The outcome of reading the command line.
data Parsed
  = -- | Do this.
    Run Command
  | -- | Print this on standard output; nothing else was asked for.
    Inform String
  | -- | One line that says what is wrong with the arguments.
    Misused String
  deriving (Eq, Show)

-- | Read the arguments, given the program's version line.
parseArguments :: String -> [String] -> Parsed
parseArguments version arguments =
  case execParserPure preferences (commandLine version) arguments of
    Success (Task task) -> Run task
    Success (HelpOn Nothing) -> Inform (trimmed (overview commandHelps))
    Success (HelpOn (Just "man")) -> Inform (trimmed (manualPage (unwords (take 2 (words version))) commandHelps))
    Success (HelpOn (Just word)) -> either Misused (Inform . trimmed) (helpOn commandHelps word)
    CompletionInvoked _ -> Misused "completions are not asked for in this way"
    Failure failure -> case execFailure failure "blackhole" of
      (text, ExitSuccess, width) -> Inform (fromMaybe (renderHelp width text) ownHelp)
      (text, ExitFailure _, _) -> Misused (withSuggestion options (map commandName commandHelps) (oneLine text))
  where
    oneLine = unwords . words . maybe "unknown arguments" show . unChunk . helpError
    trimmed = dropWhileEnd (== '\n')
    -- A command has no other way to succeed without a result than its help.
    ownHelp = case arguments of
      "scene" : _ -> Nothing
      word : _
        | Just c <- find ((== word) . commandName) commandHelps -> Just (trimmed (commandText c))
        | word `elem` ["--help", "-h"] -> Just (trimmed (overview commandHelps))
      _ -> Nothing
    options = case arguments of
      word : _ | Just c <- find ((== word) . commandName) commandHelps -> "--help" : concatMap entryNames (commandEntries c)
      _ -> ["--help", "--version"]

-- | What a shell's completion asks for, or a script for it, if the arguments are
-- such a question: an action that makes the answer.
completion :: String -> [String] -> Maybe (IO String)
completion version arguments = case execParserPure preferences (commandLine version) arguments of
  CompletionInvoked asked -> Just (execCompletion asked "blackhole")
  _ -> Nothing

preferences :: ParserPrefs
preferences = prefs (columns 100)

data Request
  = Task !Command
  | -- | Help on a command or topic, or on all.
    HelpOn !(Maybe String)

-- | A command with what is said of it.
data Described = Described !CommandHelp !(Parser Command)

commandHelps :: [CommandHelp]
commandHelps = [h | Described h _ <- described]

described :: [Described]
described =
  [ describe
      "render"
      "Render one picture to a file: of a scene file, if one is given, and with the options in the place of its settings."
      ["blackhole render --width 1280 --inclination 75 --fov 40 -o hole.png"]
      (Render <$> renderOptions),
    describe
      "join"
      "Join the tiles of a picture: the file is the one that render would have made without --tile."
      ["blackhole join big-*.tile -o big.png"]
      (Join <$> joinOptions),
    describe
      "animate"
      "Render the frames of a scene file with a section animation: those that are missing, stale or damaged, beside any number of other processes."
      ["blackhole animate scenes/orbit.yaml -o frames/%05d.png --video orbit.mp4"]
      (Animate <$> animateOptions sceneOptions),
    describe
      "scene"
      "Presets and scene files: list, show, check and print them, or print the schema for editors."
      ["blackhole scene list", "blackhole scene show report > mine.yaml", "blackhole scene check mine.yaml"]
      (Scenes <$> sceneCommand),
    describe
      "photon"
      "Report on one light path: where it goes and what it meets. Lengths in Schwarzschild radii, angles in radians."
      ["blackhole photon --impact 2.65 --json", "blackhole photon --distance 20 --inclination 80 --psi 10 --eta -90"]
      (Photon <$> photonOptions),
    describe
      "rays"
      "Draw parallel light rays on their way around the hole, as SVG or PNG."
      ["blackhole rays --rays 41 -o rays.svg"]
      (Rays <$> raysOptions),
    describe
      "selftest"
      "Hold the program's numbers against known ones, in a few seconds. The exit code is 0 only if all of them are right."
      ["blackhole selftest"]
      (SelfTest <$> selfTestOptions)
  ]
  where
    describe name summary examples parser = Described (CommandHelp name summary examples (parserEntries parser)) parser

commandLine :: String -> ParserInfo Request
commandLine version = info (hsubparser (foldMap taskCommand described <> helpCommand) <**> versionOption <**> helper) fullDesc
  where
    taskCommand (Described about parser) =
      command (commandName about) (info (Task <$> parser) (progDesc (commandSummary about)))
    helpCommand =
      command "help" . flip info (progDesc "Explain a command or a topic") $
        HelpOn <$> optional (strArgument (metavar "COMMAND|TOPIC" <> completeWith ("man" : map commandName commandHelps ++ topicNames)))
    versionOption =
      infoOption version (long "version" <> help "Print the version and stop")

renderOptions :: Parser RenderOptions
renderOptions =
  RenderOptions
    <$> sceneOptions
    <*> setting (strOption (long "from" <> metavar "PICTURE" <> help "Picture of this program whose scene to start from, in the place of a scene file"))
    <*> codingOptions
    <*> toggle (long "preview" <> help "Draw the picture in the terminal, as large as that is, instead of writing a file")
    <*> setting (option wholeNumber (long "threads" <> metavar "N" <> help "Workers (default: one per core); the picture is the same for any number"))
    <*> setting (option pixelPlace (long "pixel" <> metavar "X,Y" <> help "Explain the colour of one pixel instead of rendering; 0,0 is the top left"))
    <*> setting (option tilePart (long "tile" <> metavar "I/N" <> help "Render a band of the picture, part I of N, into a tile file (-o FILE.tile) for blackhole join"))
    <*> runOptions
    <*> settingOr "blackhole.png" (strOption (long "output" <> short 'o' <> metavar "FILE" <> action "file" <> help "File to write: .png, .jpg, .tif, .hdr or .exr, or - for a PNG to standard output (default: blackhole.png)"))
