-- | What the program does: from its arguments to its exit code.
module BlackHole.Cli.Run
  ( run,
    ExitStatus (..),
    exitCode,
    versionLine,
    selfTestStatus,
  )
where

import BlackHole.Cli.Animate
import BlackHole.Cli.Explain (explanationLines, pixelProblems)
import BlackHole.Cli.FilmScene (loadFilm)
import BlackHole.Cli.Join
import BlackHole.Cli.Options
import BlackHole.Cli.Photon
import BlackHole.Cli.Rays
import BlackHole.Cli.SceneCommand (SceneCommand (..), sceneText)
import BlackHole.Cli.SceneOptions (SceneOptions, loadScene)
import BlackHole.Cli.SelfTest (runSelfTest)
import BlackHole.Image.AtomicFile
import BlackHole.Image.Png (encodePicture)
import BlackHole.Image.TileFile
import BlackHole.Render.Film
import BlackHole.Render.PixelArray (backendName)
import BlackHole.Render.Shard (Shard (..), renderShard, shardRows)
import BlackHole.Render.Workers
import BlackHole.Scene.Camera (Picture (..))
import BlackHole.Scene.File.SceneFile (printScene)
import BlackHole.Scene.Scene
import BlackHole.Scene.Validate
import BlackHole.SelfTest.Check (Check, checkHolds)
import BlackHole.Trace.Explain (explainPixel)
import Control.Exception (SomeAsyncException (..), SomeException, displayException, fromException, throwIO, try)
import Control.Monad (void)
import qualified Data.ByteString.Lazy as Lazy
import Data.Char (toLower)
import Data.Version (showVersion)
import qualified Paths_blackhole as Package
import System.Exit (ExitCode (..))
import System.FilePath (takeExtension)
import System.IO (hIsTerminalDevice, hPutStr, hPutStrLn, stderr)
import System.Info (compilerName, compilerVersion)

-- | How a run ended.
data ExitStatus
  = -- | All went well.
    Done
  | -- | The program itself is at fault.
    InternalFault
  | -- | The arguments are wrong.
    UsageError
  | -- | The scene, or a file to read, is wrong.
    BadInput
  | -- | The result can't be written.
    CannotWrite
  | -- | A film lacks frames, or its film file.
    Unfinished
  deriving (Eq, Show, Enum, Bounded)

-- | The table of exit codes.
exitCode :: ExitStatus -> ExitCode
exitCode status = case status of
  Done -> ExitSuccess
  InternalFault -> ExitFailure 1
  UsageError -> ExitFailure 2
  BadInput -> ExitFailure 3
  CannotWrite -> ExitFailure 4
  Unfinished -> ExitFailure 5

-- | Name, version, compiler and array back end.
versionLine :: String
versionLine =
  programName ++ " (" ++ compilerName ++ "-" ++ showVersion compilerVersion ++ ", " ++ backendName ++ " arrays)"

-- | Name and version alone: what a picture file says of its origin.
programName :: String
programName = "blackhole " ++ showVersion Package.version

-- | Run the program on its arguments. Everything that can go wrong is one line
-- on standard error and an exit code.
run :: [String] -> IO ExitCode
run arguments = do
  outcome <- try (dispatch arguments)
  case outcome of
    Right status -> pure (exitCode status)
    Left failure
      | Just (SomeAsyncException _) <- fromException failure -> throwIO failure
      | otherwise -> exitCode <$> complain InternalFault (unwords (lines (displayException (failure :: SomeException))))

dispatch :: [String] -> IO ExitStatus
dispatch arguments = case parseArguments versionLine arguments of
  Inform text -> Done <$ putStrLn text
  Misused line -> complain UsageError (line ++ " (see: blackhole --help)")
  Run (Render options) -> render options
  Run (Join options) -> join options
  Run (Animate options) -> animate options
  Run (Scenes task) -> scenes task
  Run (Photon options) -> photon options
  Run (Rays options) -> rays options
  Run (SelfTest options) -> selfTestStatus <$> runSelfTest options

-- | A check that does not hold is a fault of the program.
selfTestStatus :: [Check] -> ExitStatus
selfTestStatus checks
  | all checkHolds checks = Done
  | otherwise = InternalFault

-- | One light path, reported on standard output.
photon :: PhotonOptions -> IO ExitStatus
photon options = case resolvePhoton options of
  Left problems -> complainAll UsageError problems
  Right task -> do
    let outcome = photonOutcome task
    written <- maybe (pure (Right ())) (`writeFileAtomically` outcomeCsv outcome) (photonPath options)
    case written of
      Left problem -> complain CannotWrite ("--path: " ++ renderWriteProblem problem)
      Right () -> Done <$ putStr (outcomeText (photonJson options) outcome)

-- | The figure of light rays, from options to file.
rays :: RaysOptions -> IO ExitStatus
rays options = case resolveRays options of
  Left problems -> complainAll UsageError problems
  Right task -> do
    written <- writeFileAtomically (raysOutput options) (raysFile programName task)
    case written of
      Left problem -> complain CannotWrite ("--output: " ++ renderWriteProblem problem)
      Right () -> pure Done

-- | One picture, from options to file.
render :: RenderOptions -> IO ExitStatus
render options
  | problem : problems <- usageProblems = complainAll UsageError (problem : problems)
  | otherwise = do
    resolved <- loadScene (renderScene options)
    case resolved of
      Left problems -> BadInput <$ mapM_ (complain BadInput) problems
      Right scene | Just pixel <- renderPixel options -> case pixelProblem scene of
        [] -> explain scene pixel
        problems -> complainAll BadInput problems
      Right scene | problems@(_ : _) <- tileProblems scene -> complainAll UsageError problems
      Right scene -> do
        crew <- maybe defaultWorkers pure (workers =<< renderThreads options)
        writable <- checkWritable output
        case writable of
          Left problem -> complain CannotWrite ("--output: " ++ renderWriteProblem problem)
          Right () -> withWorkers crew (renderTo crew scene)
  where
    pixelProblem scene = foldMap (pixelProblems (scenePicture scene)) (renderPixel options)
    output = renderOutput options
    usageProblems =
      [ Problem "--output" ("'" ++ output ++ "'") ("a file name that ends in " ++ extension)
        | map toLower (takeExtension output) /= extension
      ]
        ++ [ Problem "--threads" (show n) ("a whole number from 1 to " ++ show maximumWorkers)
             | Just n <- [renderThreads options],
               Nothing <- [workers n]
           ]
    tileProblems scene =
      [ Problem "--tile" (renderShard part) ("a part of a picture of " ++ show height ++ " rows")
        | let height = pictureHeight (scenePicture scene),
          Just part <- [renderTile options],
          shardCount part > height
      ]
    extension = maybe ".png" (const tileExtension) (renderTile options)
    renderTo crew scene = do
      interactive <- hIsTerminalDevice stderr
      let (first, rows) = maybe (0, pictureHeight (scenePicture scene)) (`shardRows` pictureHeight (scenePicture scene)) (renderTile options)
      exposed <- exposeRows crew (if interactive then tellProgress rows else const (pure ())) scene (first, rows)
      case exposed of
        Nothing -> complain InternalFault "the scene passed its checks but can't be traced"
        Just film -> do
          case faultyPixels film of
            (n, Just (x, y)) ->
              hPutStrLn stderr ("blackhole: warning: " ++ show n ++ " pixels have no finite radiance, the first at " ++ show x ++ "," ++ show (first + y))
            _ -> pure ()
          file <- case renderTile options of
            Nothing -> Just <$> pictureFile crew scene film
            Just part -> pure (encodeTile (tileHeader programName part scene) film)
          case file of
            Nothing -> complain InternalFault "the tile's rows are not those of the scene"
            Just bytes -> store output bytes

-- | The file of a whole film of light.
pictureFile :: Workers -> Scene -> Film -> IO Lazy.ByteString
pictureFile crew scene light =
  encodePicture programName <$> developFilm crew (sceneExposure scene) (sceneToneMap scene) light

-- | Write the file that @--output@ names.
store :: FilePath -> Lazy.ByteString -> IO ExitStatus
store output bytes = do
  written <- writeFileAtomically output bytes
  case written of
    Left problem -> complain CannotWrite ("--output: " ++ renderWriteProblem problem)
    Right () -> pure Done

-- | The picture that tiles make together.
join :: JoinOptions -> IO ExitStatus
join options = do
  joined <- openTiles (joinTiles options)
  case joined of
    Left problems -> BadInput <$ mapM_ (complain BadInput) problems
    Right (scene, tiles) -> do
      crew <- maybe defaultWorkers pure (workers =<< joinThreads options)
      light <- readPictureRows tiles (0, pictureHeight (scenePicture scene))
      case light of
        Nothing -> complain BadInput "a tile has changed while it was read"
        Just film -> withWorkers crew (pictureFile crew scene film >>= store (joinOutput options))

-- | A film's frames, or what a folder of them lacks.
animate :: AnimateOptions SceneOptions -> IO ExitStatus
animate options = case animateStatus options of
  Just folder -> endStatus <$> showStatus say (animatePatience options) folder
  Nothing -> do
    loaded <- loadFilm (animateScene options)
    case loaded of
      Left problems -> BadInput <$ mapM_ say problems
      Right Nothing -> complain BadInput "a film needs a scene file with a section animation (see docs/animation.md)"
      Right (Just film) -> endStatus <$> runFilm options say (printScene [programName]) pictureFile (adjustFilm options film)
  where
    say line = void (complain Done line)
    endStatus ending = case ending of
      Complete -> Done
      Incomplete -> Unfinished
      WrongArguments -> UsageError
      WrongFilm -> BadInput
      CannotStart -> CannotWrite

-- | Something about scenes, on standard output.
scenes :: SceneCommand -> IO ExitStatus
scenes task = do
  outcome <- sceneText task
  case outcome of
    Right text -> Done <$ putStr text
    Left problems -> status task <$ mapM_ (complain (status task)) problems
  where
    status (ShowScene _) = UsageError
    status _ = BadInput

-- | One pixel explained instead.
explain :: Scene -> (Int, Int) -> IO ExitStatus
explain scene (x, y) = case explainPixel scene x y of
  Just explanation -> Done <$ mapM_ putStrLn (explanationLines scene explanation)
  Nothing -> complain InternalFault "the scene passed its checks but can't be traced"

-- | How much is done, on one line that is cleared at the end.
tellProgress :: Int -> Int -> IO ()
tellProgress rows done
  | done >= rows = hPutStr stderr "\r\ESC[K"
  | otherwise = hPutStr stderr ("\rrendering: " ++ show (100 * done `quot` rows) ++ " %")

complainAll :: ExitStatus -> [Problem] -> IO ExitStatus
complainAll status problems = status <$ mapM_ (complain status . renderProblem) problems

complain :: ExitStatus -> String -> IO ExitStatus
complain status line = status <$ hPutStrLn stderr ("blackhole: " ++ line)
