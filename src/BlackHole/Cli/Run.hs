-- | What the program does: from its arguments to its exit code.
module BlackHole.Cli.Run
  ( run,
    ExitStatus (..),
    exitCode,
    versionLine,
    selfTestStatus,
  )
where

import BlackHole.Animation.Exposure
import BlackHole.Animation.Film (filmScene, filmShutter, shutterOpen)
import BlackHole.Animation.FrameName (frameFile, frameNumber, parseFrameName)
import BlackHole.Cli.Animate
import BlackHole.Cli.Console hiding (tell)
import BlackHole.Cli.Explain (explanationLines, pixelProblems)
import BlackHole.Cli.FilmScene (loadFilm)
import BlackHole.Cli.Join
import BlackHole.Cli.Memory
import BlackHole.Cli.Options
import BlackHole.Cli.Overwriting (overwritten)
import BlackHole.Cli.Photon
import BlackHole.Cli.Preview
import BlackHole.Cli.Progress (withProgress)
import BlackHole.Cli.Rays hiding (Png)
import BlackHole.Cli.RunOptions
import BlackHole.Cli.SceneCommand (SceneCommand (..), sceneText)
import BlackHole.Cli.SceneOptions
import BlackHole.Cli.SelfTest (runSelfTest)
import BlackHole.Cli.Signals (Stopped)
import BlackHole.Cli.SkyFile
import BlackHole.Cli.Stats
import BlackHole.Image.AtomicFile
import BlackHole.Image.Coding
import BlackHole.Image.File (fileLabel)
import BlackHole.Image.Finish
import BlackHole.Image.Label
import BlackHole.Image.TileFile
import BlackHole.Render.Bloom
import BlackHole.Render.Film
import BlackHole.Render.PixelArray (backendName, fromPixelVector, pixelArrayShape, toPixelVector)
import BlackHole.Render.PixelShape (pixelShape, shapeHeight)
import BlackHole.Render.Shard (shardRows)
import BlackHole.Render.Workers
import BlackHole.Scene.Camera (Picture (..))
import BlackHole.Scene.File.SceneFile (printScene)
import BlackHole.Scene.Scene
import BlackHole.Scene.Validate
import BlackHole.SelfTest.Check (Check, checkHolds)
import BlackHole.Trace.Explain (explainPixel)
import BlackHole.Trace.Pixel (tracerUnder)
import BlackHole.Trace.Sky (neededPicture)
import BlackHole.Trace.SkyImage (SkyImage)
import Control.Applicative ((<|>))
import Control.Exception (IOException, SomeAsyncException (..), SomeException, catch, displayException, fromException, throwIO, try)
import Control.Monad (forM_, when)
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Lazy as Lazy
import Data.IORef
import Data.List (intercalate)
import Data.List.NonEmpty (NonEmpty (..))
import Data.Maybe (fromMaybe)
import qualified Data.Vector.Storable as Vector
import Data.Version (showVersion)
import GHC.Clock (getMonotonicTime)
import qualified Paths_blackhole as Package
import qualified System.Console.Terminal.Size as Terminal
import System.Directory (listDirectory)
import System.Environment (getEnvironment)
import System.Exit (ExitCode (..))
import System.FilePath (takeDirectory, (</>))
import System.IO (Handle, IOMode (ReadMode), hIsTerminalDevice, stdout, withBinaryFile)
import System.IO.Error (ioeGetErrorString)
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
dispatch arguments
  | Just answer <- completion versionLine arguments = answer >>= printed Done
  | otherwise = case parseArguments versionLine arguments of
    Inform text -> printed Done (text ++ "\n")
    Misused line -> complain UsageError (line ++ " (see: blackhole --help)")
    Run (Render options) -> render options
    Run (Join options) -> join options
    Run (Animate options) -> animate options
    Run (Scenes task) -> scenes task
    Run (Photon options) -> photon options
    Run (Rays options) -> rays options
    Run (SelfTest options) -> do
      (checks, text) <- runSelfTest options
      printed (selfTestStatus checks) text

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
      Right () -> printed Done (outcomeText (photonJson options) outcome)

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
    resolved <- renderedScene options
    case resolved of
      Left problems -> BadInput <$ mapM_ (complain BadInput) problems
      Right (scenes'@(scene :| others), coding)
        | Just pixel <- renderPixel options -> case pixelProblems (scenePicture scene) pixel of
          [] -> underSky scene (explain scene pixel . fmap skyFileImage)
          problems -> complainAll BadInput problems
        | renderPreview options -> underSky scene (\sky -> withCrew (preview (skyFileImage <$> sky) scene))
        | Just _ <- renderTile options,
          not (null others) ->
          complain BadInput "--tile: a frame of a film with an open shutter is rendered as a whole"
        | Just part <- renderTile options -> case tileProblems part (scenePicture scene) of
          [] -> ready (Making Tile False False) scene (snd (shardRows part (pictureHeight (scenePicture scene)))) (\sky crew -> tileTo sky crew part scene)
          problems -> complainAll UsageError problems
        | otherwise -> case outputFormat output of
          Just format -> case codingProblems format coding of
            [] -> ready (Making (WholePicture format) (not (null others)) (runKeepPartial how)) scene (pictureHeight (scenePicture scene)) (\sky crew -> renderTo sky crew format coding scenes')
            problems -> complainAll UsageError problems
          Nothing -> complainAll UsageError [unknownExtension]
  where
    output = renderOutput options
    withCrew = inCrew (renderThreads options)
    ready making scene rows action = do
      clashes <- overwritten (sceneInputs (renderScene options) scene ++ [("--from", from) | Just from <- [renderFrom options]]) (("--output", output) : [("--stats", file) | Just file <- [runStats how]])
      lacking <- memoryProblem making scene rows
      outputProblem <- outputFault output
      statsProblem <- maybe (pure (Right ())) checkWritable (runStats how)
      case (lacking, outputProblem, statsProblem) of
        _ | _ : _ <- clashes -> UsageError <$ mapM_ say clashes
        (Just line, _, _) -> complain BadInput line
        (_, Just line, _) -> complain CannotWrite ("--output: " ++ line)
        (_, _, Left problem) -> complain CannotWrite ("--stats: " ++ renderWriteProblem problem)
        _ -> underSky scene (withCrew . action)
    how = renderRun options
    unknownExtension = unknownExtensionOf output
    usageProblems =
      (if null (renderTile options) then [unknownExtension | Nothing <- [outputFormat output]] else tileNameProblems output)
        ++ [ Problem "--threads" (show n) ("a whole number from 1 to " ++ show maximumWorkers)
             | Just n <- [renderThreads options],
               Nothing <- [workers n]
           ]
        ++ [ Problem "--from" (show from) "possible beside a scene file; choose either"
             | Just from <- [renderFrom options],
               Just _ <- [sceneFile (renderScene options)]
           ]
    renderTo sky crew format coding scenes'@(scene :| _) = do
      let rows = pictureHeight (scenePicture scene)
      exposing how (skyFileImage <$> sky) crew scenes' (0, rows) output $ \exposed done seconds ->
        finishing (skyFileImage <$> sky) crew scene (0, done) (exposedLight exposed) seconds $
          maybe (complain CannotWrite (noRoom output)) (storeBy output) (finishBands crew programName format coding scenes' (pure . filmRows (exposedLight exposed)) (pure . countsRow scene exposed))
    tileTo sky crew part scene = do
      let band = shardRows part (pictureHeight (scenePicture scene))
      exposing how {runKeepPartial = False} (skyFileImage <$> sky) crew (scene :| []) band output $ \exposed _ seconds ->
        finishing (skyFileImage <$> sky) crew scene band (exposedLight exposed) seconds $
          maybe (complain CannotWrite "the tile can't be coded") (store output) (encodeTile (tileHeader (programName : skyLines sky) part scene) (exposedCounts exposed) (exposedLight exposed))
    finishing picture crew scene band film traced write = do
      faults <- warnOfFaults crew (fst band) film
      if runStrict how && fst faults > 0
        then complain InternalFault "--strict: no file is written because of them"
        else do
          (status, writing) <- timed write
          memory <- peakMemory
          let stats = Stats versionLine scene picture crew band traced writing memory faults
          case runStats how of
            Just file | status == Done -> do
              written <- writeFileAtomically file (statsText stats)
              either (complain CannotWrite . ("--stats: " ++) . renderWriteProblem) (const (pure Done)) written
            _ -> pure status

-- | Trace rows of a scene, tell how far that is, and go on with the film, the
-- number of rows done and the seconds it took. If some is to be kept when a signal comes, bands are traced
-- one after the other, and those that are done make a film that is black below.
exposing :: RunOptions -> Maybe SkyImage -> Workers -> NonEmpty Scene -> (Int, Int) -> FilePath -> (Exposed -> Int -> Double -> IO ExitStatus) -> IO ExitStatus
exposing how sky crew scenes'@(scene :| others) (first, rows) output finish
  | runKeepPartial how = do
    kept <- newIORef []
    start <- getMonotonicTime
    let bands = [(from, min bandRows (rows - from)) | from <- [0, bandRows .. rows - 1]]
    outcome <- try . timed . tracking $ \tell -> forM_ bands $ \(from, count) -> do
      band <- exposeMomentRows sky crew (tell . (from +) . rowsOf count) scenes' (first + from, count)
      modifyIORef' kept (maybe id (:) band)
    done <- reverse <$> readIORef kept
    let light = map exposedLight done
        rowsDone = sum (map (shapeHeight . pixelArrayShape) light)
        padded channels arrays = pixelShape width rows channels >>= (`fromPixelVector` Vector.concat (arrays ++ [Vector.replicate (channels * width * (rows - rowsDone)) 0]))
        -- Rows that are not done got no samples.
        counts
          | rowsDone == rows && all (null . exposedCounts) done = Just Nothing
          | otherwise = Just <$> padded 1 [countsRow scene band y | band <- done, y <- [0 .. shapeHeight (pixelArrayShape (exposedLight band)) - 1]]
    case (Exposed <$> padded 3 (map toPixelVector light) <*> counts, outcome) of
      (Nothing, _) -> untraceable
      (Just exposed, Right ((), seconds)) ->
        finish exposed rows seconds `catch` \stop -> finish exposed rows seconds >> throwIO (stop :: Stopped)
      (Just exposed, Left stop)
        | rowsDone > 0 -> do
          say (output ++ ": " ++ show rowsDone ++ " of " ++ show rows ++ " rows are done, the others stay black")
          end <- getMonotonicTime
          _ <- finish exposed rowsDone (end - start)
          throwIO (stop :: Stopped)
        | otherwise -> throwIO stop
  | otherwise = do
    (exposed, seconds) <- timed (tracking (\tell -> exposeMomentRows sky crew (tell . rowsOf rows) scenes' (first, rows)))
    maybe untraceable (\light -> finish light rows seconds) exposed
  where
    width = pictureWidth (scenePicture scene)
    tracking = withProgress (runProgress how) rows (width * sceneSamples scene * (1 + length others))
    rowsOf count part = floor (part * fromIntegral count + 1e-6 :: Double)
    -- Enough to keep all workers busy, and at most some thirty bands.
    bandRows = max (4 * workersCount crew) ((rows + 31) `quot` 32)

-- | An action's result and the seconds it took.
timed :: IO a -> IO (a, Double)
timed work = do
  start <- getMonotonicTime
  result <- work
  end <- getMonotonicTime
  pure (result, end - start)

-- | The format that a file's name asks for; standard output gets a PNG.
outputFormat :: FilePath -> Maybe Format
outputFormat "-" = Just Png
outputFormat name = formatOf name

-- | Why a picture can't be written there, as far as that is known beforehand.
outputFault :: FilePath -> IO (Maybe String)
outputFault "-" = do
  closed <- outputIsClosed
  terminal <- hIsTerminalDevice stdout
  pure $
    if closed
      then Just "standard output is closed"
      else if terminal then Just "standard output is a terminal; send it to a file or a program" else Nothing
outputFault name = either (Just . renderWriteProblem) (const Nothing) <$> checkWritable name

-- | Run an action with as many workers as were asked for.
inCrew :: Maybe Int -> (Workers -> IO a) -> IO a
inCrew threads action = do
  crew <- maybe defaultWorkers pure (workers =<< threads)
  withWorkers crew (action crew)

-- | Write the file that @--output@ names.
store :: FilePath -> Lazy.ByteString -> IO ExitStatus
store output bytes = storeBy output (`Lazy.hPut` bytes)

-- | The same by an action that writes to a handle.
storeBy :: FilePath -> (Handle -> IO ()) -> IO ExitStatus
storeBy "-" write = printWith write >>= either (complain CannotWrite . ("--output: " ++) . outputProblemText) (const (pure Done))
storeBy output write = writeAtomically output write >>= stored

stored :: Either WriteProblem () -> IO ExitStatus
stored written = case written of
  Left problem -> complain CannotWrite ("--output: " ++ renderWriteProblem problem)
  Right () -> pure Done

unknownExtensionOf :: FilePath -> Problem
unknownExtensionOf output =
  Problem "--output" ("'" ++ output ++ "'") ("a file name that ends in " ++ intercalate ", " (map fst formatExtensions))

codingProblems :: Format -> Coding -> [Problem]
codingProblems format coding = [Problem option value range | (option, value, range) <- codingProblem format coding]

noRoom :: FilePath -> String
noRoom output = "--output: " ++ output ++ ": this format has no room for so large a picture"

-- | The picture that tiles make together.
join :: JoinOptions -> IO ExitStatus
join options = case (formatOf output, joinCoding options) of
  (Nothing, _) -> complainAll UsageError [unknownExtensionOf output]
  (Just format, coding)
    | problems@(_ : _) <- codingProblems format coding -> complainAll UsageError problems
    | otherwise -> do
      joined <- openTiles (joinTiles options)
      case joined of
        Left problems -> BadInput <$ mapM_ (complain BadInput) problems
        Right (scene, tiles) -> writing format scene tiles . inCrew (joinThreads options) $ \crew ->
          maybe (complain CannotWrite (noRoom output)) (storeBy output) $
            finishBands crew programName format coding (scene :| []) (readPictureRows tiles) (countsOf scene tiles)
  where
    output = joinOutput options
    writing format scene tiles action = do
      lacking <- memoryProblem (Making (Joined format) False False) scene (pictureHeight (scenePicture scene))
      clashes <- overwritten [("a tile", tileFilePath tile) | tile <- tiles] [("--output", output)]
      outputProblem <- outputFault output
      case (clashes, lacking, outputProblem) of
        (_ : _, _, _) -> UsageError <$ mapM_ say clashes
        (_, Just line, _) -> complain BadInput line
        (_, _, Just line) -> complain CannotWrite ("--output: " ++ line)
        _ -> action
    countsOf scene tiles row = do
      counts <- readCountsRow tiles row
      pure (fromMaybe (Vector.replicate (pictureWidth (scenePicture scene)) (fromIntegral (sceneSamples scene))) counts)

-- | A film's frames, or what a folder of them lacks.
animate :: AnimateOptions SceneOptions -> IO ExitStatus
animate options = case (animateStatus options, formatOf (animateOutput options)) of
  (Just folder, _) -> showStatus (animatePatience options) folder >>= either (complain BadInput) (\(ending, text) -> printed (endStatus ending) text)
  (_, Nothing) -> complainAll UsageError [unknownExtensionOf (animateOutput options)]
  (_, Just format)
    | problems@(_ : _) <- codingProblems format coding -> complainAll UsageError problems
    | otherwise -> do
      loaded <- loadFilm (animateScene options)
      case loaded of
        Left problems -> BadInput <$ mapM_ say problems
        Right Nothing -> complain BadInput "a film needs a scene file with a section animation (see docs/animation.md)"
        Right (Just found) -> do
          let film = adjustFilm options found
          clashes <- filmClashes film
          lacking <- memoryProblem (Making (Frame format) (shutterOpen (filmShutter film) > 0) False) (filmScene film) (pictureHeight (scenePicture (filmScene film)))
          case (clashes, lacking) of
            (_ : _, _) -> UsageError <$ mapM_ say clashes
            (_, Just line) -> complain BadInput line
            _ -> shootFilm format film
  where
    shootFilm format film =
      underSky (filmScene film) $ \sky ->
        endStatus <$> runFilm options say (skyFileImage <$> sky) (describe sky) (develop format) film
    -- Frames that exist are compared, the others cannot be a file that is read.
    filmClashes film = case parseFrameName (animateOutput options) of
      Left _ -> pure []
      Right name -> do
        let folder = takeDirectory (frameFile name 0)
        names <- either (const [] :: IOException -> [FilePath]) id <$> try (listDirectory folder)
        overwritten
          (sceneInputs (animateScene options) (filmScene film))
          ([("--video", file) | Just file <- [animateVideo options]] ++ [("--output", folder </> file) | file <- names, Just _ <- [frameNumber name file]])
    coding = animateCoding options
    describe sky = printScene ((programName ++ ", " ++ show coding) : skyLines sky)
    develop format crew = finishFilm crew programName format coding
    endStatus ending = case ending of
      Complete -> Done
      Incomplete -> Unfinished
      WrongArguments -> UsageError
      WrongFilm -> BadInput
      CannotStart -> CannotWrite

-- | The files that a scene is made of, with the words for them in a message.
sceneInputs :: SceneOptions -> Scene -> [(String, FilePath)]
sceneInputs options scene = [("the scene", file) | Just file <- [sceneFile options]] ++ [("the sky", file) | Just file <- [neededPicture scene]]

-- | Go on with the picture of a scene's sky, if it has one.
underSky :: Scene -> (Maybe SkyFile -> IO ExitStatus) -> IO ExitStatus
underSky scene action = loadSky scene >>= either (complain BadInput) action

-- | The scene that is asked for, or several whose mean light it is, and how its file
-- is to be coded: as the options
-- say, or else as the picture was that the scene is taken from.
renderedScene :: RenderOptions -> IO (Either [String] (NonEmpty Scene, Coding))
renderedScene options = case renderFrom options of
  Nothing -> fmap (coded asked . (:| [])) <$> loadScene (renderScene options)
  Just path -> do
    -- The label comes before the pixels.
    outcome <- try (withBinaryFile path ReadMode (`Bytes.hGet` 0x400000))
    case outcome of
      Left failure -> pure (Left [path ++ ": can't be read: " ++ ioeGetErrorString (failure :: IOException)])
      Right bytes -> case fileLabel bytes of
        Nothing -> pure (Left [path ++ ": this is no picture that blackhole made: it does not say of which scene"])
        Just label -> do
          when (labelSoftware label /= programName) $
            say ("note: " ++ path ++ " was made by " ++ labelSoftware label ++ "; " ++ programName ++ " may make other bytes")
          pure (fromLabel path label)
  where
    asked = renderCoding options
    coded coding scene = (scene, coding)
    fromLabel path label = do
      scenes' <- resolveLabel (renderScene options) path (labelScene label)
      -- Another format has other bits.
      let before
            | formatOf path == formatOf (renderOutput options) = labelCoding label
            | otherwise = defaultCoding
      pure (coded (Coding (codingBits asked <|> codingBits before) (codingQuality asked <|> codingQuality before)) scenes')

-- | The picture as text on standard output.
preview :: Maybe SkyImage -> Scene -> Workers -> IO ExitStatus
preview sky scene crew = do
  isTerminal <- hIsTerminalDevice stdout
  environment <- getEnvironment
  window <- Terminal.size
  let (columns, textLines) = maybe (80, 24) (\(Terminal.Window h w) -> (w, h)) window
      Picture width height = scenePicture scene
      (across, down) = previewSize columns textLines (width, height)
  exposed <- exposeFilmUnder sky crew (const (pure ())) scene {scenePicture = Picture across down}
  case exposed of
    Nothing -> untraceable
    Just film -> do
      _ <- warnOfFaults crew 0 film
      bloomed <- bloomFilm crew (sceneBloom scene) film
      codes <- developFilm crew (sceneExposure scene) (sceneToneMap scene) (sceneDither scene) bloomed
      printed Done (previewText (palette isTerminal environment) codes)

untraceable :: IO ExitStatus
untraceable = complain InternalFault "the scene passed its checks but can't be traced"

-- | Warn of pixels without light that could be shown, in a film whose first row is
-- this one of the picture.
-- Their number and the first one's column and row in the picture.
warnOfFaults :: Workers -> Int -> Film -> IO (Int, Maybe (Int, Int))
warnOfFaults crew first film = faultyPixels crew film >>= warn
  where
    warn (n, Just (x, y)) = do
      say ("warning: " ++ show n ++ " pixels have no finite radiance, the first at " ++ show x ++ "," ++ show (first + y))
      pure (n, Just (x, first + y))
    warn _ = pure (0, Nothing)

-- | Something about scenes, on standard output.
scenes :: SceneCommand -> IO ExitStatus
scenes task = do
  outcome <- sceneText task
  case outcome of
    Right text -> printed Done text
    Left problems -> status task <$ mapM_ (complain (status task)) problems
  where
    status (ShowScene _) = UsageError
    status _ = BadInput

-- | One pixel explained instead.
explain :: Scene -> (Int, Int) -> Maybe SkyImage -> IO ExitStatus
explain scene (x, y) sky = case tracerUnder sky scene >>= \traced -> explainPixel traced x y of
  Just explanation -> printed Done (unlines (explanationLines scene explanation))
  Nothing -> untraceable

-- | Print a result, and end so if that succeeds. A reader that has seen enough
-- needs no message.
printed :: ExitStatus -> String -> IO ExitStatus
printed status text = printText text >>= either failed (const (pure status))
  where
    failed ReaderGone = pure CannotWrite
    failed problem = complain CannotWrite (outputProblemText problem)

outputProblemText :: OutputProblem -> String
outputProblemText problem =
  "cannot write to standard output: " ++ case problem of
    ReaderGone -> "its reader has ended"
    OutputRefused reason -> reason

complainAll :: ExitStatus -> [Problem] -> IO ExitStatus
complainAll status problems = status <$ mapM_ (complain status . renderProblem) problems

complain :: ExitStatus -> String -> IO ExitStatus
complain status line = status <$ say line
