-- | The command line: its grammar, and the scene it asks for.
module BlackHole.Cli.Options
  ( Command (..),
    RenderOptions (..),
    Parsed (..),
    parseArguments,
  )
where

import BlackHole.Cli.Animate (AnimateOptions, animateOptions)
import BlackHole.Cli.CodingOptions (codingOptions)
import BlackHole.Cli.Join (JoinOptions, joinOptions, tilePart)
import BlackHole.Cli.Photon (PhotonOptions, photonOptions)
import BlackHole.Cli.Rays (RaysOptions, raysOptions)
import BlackHole.Cli.Read
import BlackHole.Cli.SceneCommand (SceneCommand, sceneCommand)
import BlackHole.Cli.SceneOptions (SceneOptions, sceneOptions)
import BlackHole.Cli.SelfTest (SelfTestOptions, selfTestOptions)
import BlackHole.Image.Coding (Coding)
import BlackHole.Render.Shard (Shard)
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
  case execParserPure (prefs (columns 100)) (commandLine version) arguments of
    Success request -> Run request
    CompletionInvoked _ -> Misused "completion scripts are not available"
    Failure failure -> case execFailure failure "blackhole" of
      (text, ExitSuccess, width) -> Inform (renderHelp width text)
      (text, ExitFailure _, _) -> Misused (oneLine text)
  where
    oneLine = unwords . words . maybe "unknown arguments" show . unChunk . helpError

commandLine :: String -> ParserInfo Command
commandLine version =
  info (commands <**> versionOption <**> helper) $
    fullDesc
      <> progDesc "Physically exact pictures of a black hole."
      <> footer "Example: blackhole render --width 1280 -o hole.png"
  where
    commands =
      hsubparser $
        command
          "render"
          ( info (Render <$> renderOptions) $
              progDesc "Render one picture to a file: of a scene file, if one is given, and with the options in the place of its settings."
                <> footer "Example: blackhole render --width 1280 --inclination 75 --fov 40 -o hole.png"
          )
          <> command
            "join"
            ( info (Join <$> joinOptions) $
                progDesc "Join the tiles of a picture: the file is the one that render would have made without --tile."
                  <> footer "Example: blackhole join big-*.tile -o big.png"
            )
          <> command
            "animate"
            ( info (Animate <$> animateOptions sceneOptions) $
                progDesc "Render the frames of a scene file with a section animation: those that are missing, stale or damaged, beside any number of other processes."
                  <> footer "Example: blackhole animate scenes/orbit.yaml -o frames/%05d.png --video orbit.mp4"
            )
          <> command
            "scene"
            ( info (Scenes <$> sceneCommand) $
                progDesc "Presets and scene files: list, show, check and print them, or print the schema for editors."
                  <> footer "Example: blackhole scene show report > mine.yaml"
            )
          <> command
            "photon"
            ( info (Photon <$> photonOptions) $
                progDesc "Report on one light path: where it goes and what it meets. Lengths in Schwarzschild radii, angles in radians."
                  <> footer "Examples: blackhole photon --impact 2.65 --json; blackhole photon --distance 20 --inclination 80 --psi 10 --eta -90"
            )
          <> command
            "rays"
            ( info (Rays <$> raysOptions) $
                progDesc "Draw parallel light rays on their way around the hole, as SVG or PNG."
                  <> footer "Example: blackhole rays --rays 41 -o rays.svg"
            )
          <> command
            "selftest"
            ( info (SelfTest <$> selfTestOptions) $
                progDesc "Hold the program's numbers against known ones, in a few seconds. The exit code is 0 only if all of them are right."
            )
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
    <*> settingOr "blackhole.png" (strOption (long "output" <> short 'o' <> metavar "FILE" <> help "File to write: .png, .jpg, .tif, .hdr or .exr (default: blackhole.png)"))
