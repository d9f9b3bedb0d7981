-- | The program: from its arguments to its exit code.
module BlackHole.Cli.Run
  ( run,
    ExitStatus (..),
    exitCode,
    versionLine,
    selfTestStatus,
  )
where

import BlackHole.Animation.Animation (animationScene, animationShutter, shutterOpen, stillAnimation)
import BlackHole.Animation.Exposure
import BlackHole.Animation.FrameName (frameFile, frameNumber, parseFrameName)
import BlackHole.Cli.Animate
import BlackHole.Cli.AnimateReport (animationStats)
import BlackHole.Cli.AnimationScene (loadAnimation)
import BlackHole.Cli.Check (checkThreads)
import BlackHole.Cli.Console
import BlackHole.Cli.Explain (explanationLines, pixelProblems)
import BlackHole.Cli.Explore (explore)
import qualified BlackHole.Cli.Explore as Explore (Ending (..))
import BlackHole.Cli.Help (CommandHelp (commandName))
import BlackHole.Cli.Join
import BlackHole.Cli.Json
import BlackHole.Cli.Memory
import BlackHole.Cli.Options
import BlackHole.Cli.Overwriting (overwritten)
import BlackHole.Cli.Photon
import BlackHole.Cli.Preview
import BlackHole.Cli.Progress (ProgressMode (JsonProgress), withProgress)
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
import BlackHole.Image.Destination (toHandle)
import BlackHole.Image.File (fileMetadata)
import BlackHole.Image.Metadata
import BlackHole.Image.TileFile
import BlackHole.Image.Write
import BlackHole.Render.Film
import BlackHole.Render.Optics
import BlackHole.Render.PixelArray (backendName, fromPixelVector, pixelArrayShape, toPixelVector)
import BlackHole.Render.PixelShape (pixelShape, shapeHeight)
import BlackHole.Render.Shard (shardRows)
import BlackHole.Render.Workers
import BlackHole.Scene.Camera (Picture (..))
import BlackHole.Scene.Field.Field (fieldLabel)
import BlackHole.Scene.Field.Table (findField)
import BlackHole.Scene.File.SceneFile (printScene)
import BlackHole.Scene.Scene
import BlackHole.Scene.Setting (Setting (settingPath))
import BlackHole.Scene.Validate
import BlackHole.SelfTest.Check (Check, checkHolds)
import BlackHole.Trace.EnvironmentMap (EnvironmentMap)
import BlackHole.Trace.Explain (explainPixel)
import BlackHole.Trace.Pixel (tracerWithSky)
import BlackHole.Trace.Sky (neededPicture)
import Control.Applicative ((<|>))
import Control.Exception (IOException, SomeAsyncException (..), SomeException, catch, displayException, fromException, throwIO, try)
import Control.Monad (forM_, unless, when, (>=>))
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Builder as Builder
import qualified Data.ByteString.Lazy as Lazy
import Data.IORef
import Data.List (intercalate)
import Data.List.NonEmpty (NonEmpty (..))
import Data.Maybe (fromMaybe, isJust)
import qualified Data.Vector.Storable as Vector
import Data.Version (showVersion)
import GHC.Clock (getMonotonicTime)
import Numeric (showFFloat)
import qualified Paths_blackhole as Package
import qualified System.Console.Terminal.Size as Terminal
import System.Directory (listDirectory)
import System.Environment (getEnvironment)
import System.Exit (ExitCode (..))
import System.FilePath (takeDirectory, (</>))
import System.IO (Handle, IOMode (ReadMode), hIsTerminalDevice, stdout, withBinaryFile)
import System.IO.Error (ioeGetErrorString)
import System.Info (compilerName, compilerVersion)

-- | The result of a run.
data ExitStatus
  = -- | Success.
    Done
  | -- | An internal error.
    InternalFault
  | -- | Invalid command line.
    UsageError
  | -- | An invalid scene, or an input file that cannot be read.
    BadInput
  | -- | The output cannot be written.
    CannotWrite
  | -- | Frames of an animation or its video file are missing.
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

-- | Name and version, which picture files record.
programName :: String
programName = "blackhole " ++ showVersion Package.version

-- | Run the program with its arguments. Every failure is reported in one line on
-- standard error and by the exit code.
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
  | otherwise =
    mapM_ say (formerOptionWarnings arguments) >> case parseArguments versionLine arguments of
      Inform text -> printed Done (text ++ "\n")
      Unnamed text -> UsageError <$ tell (text ++ "\n")
      Misused line -> complain UsageError (line ++ " (see: blackhole help" ++ concatMap (' ' :) (take 1 (filter (`elem` map commandName commandHelps) (take 1 arguments))) ++ ")")
      Run (Render options) -> render options
      Run (Join options) -> join options
      Run (Animate options) -> animate options
      Run (Explore options) -> exploreStatus <$> explore programName options
      Run (Scenes task) -> scenes task
      Run (Photon options) -> photon options
      Run (Rays options) -> rays options
      Run (SelfTest options) -> do
        (checks, text) <- runSelfTest options
        printed (selfTestStatus checks) text

-- | A failed check is an internal error.
selfTestStatus :: [Check] -> ExitStatus
selfTestStatus checks
  | all checkHolds checks = Done
  | otherwise = InternalFault

-- | The result of @blackhole explore@.
exploreStatus :: Explore.Ending -> ExitStatus
exploreStatus ending = case ending of
  Explore.Ended -> Done
  Explore.Misuse -> UsageError
  Explore.WrongScene -> BadInput
  Explore.CannotServe -> CannotWrite

-- | @blackhole photon@.
photon :: PhotonOptions -> IO ExitStatus
photon options = case resolvePhoton options of
  Left problems -> complainAll UsageError problems
  Right task -> do
    start <- getMonotonicTime
    let outcome = photonOutcome task
    written <- maybe (pure (Right ())) (`writeFileAtomically` outcomeCsv outcome) (photonPath options)
    case written of
      Left problem -> complain CannotWrite ("--path: " ++ renderWriteProblem problem)
      Right () -> do
        unless (photonQuiet options) $ mapM_ (\file -> succeeded start file (show (length (outcomePoints outcome)) ++ " points")) (photonPath options)
        printed Done (outcomeText (photonJson options) outcome)

-- | @blackhole rays@.
rays :: RaysOptions -> IO ExitStatus
rays options = case resolveRays options of
  Left problems -> complainAll UsageError problems
  Right task -> do
    start <- getMonotonicTime
    written <- writeFileAtomically (raysOutput options) (raysFile programName task)
    case written of
      Left problem -> complain CannotWrite ("--output: " ++ renderWriteProblem problem)
      Right () -> Done <$ unless (raysQuiet options) (succeeded start (raysOutput options) (show (raysCount options) ++ " rays"))

-- | Report success on standard error: a file, what is in it, and the seconds since the
-- start, as in @hole.png: 640 × 360, 1.3 s@.
succeeded :: Double -> FilePath -> String -> IO ()
succeeded start file content = do
  end <- getMonotonicTime
  tell (printable ((if file == "-" then "standard output" else file) ++ ": " ++ content ++ ", " ++ showFFloat (Just 1) (end - start) " s") ++ "\n")

-- | The same for a picture, unless the options ask for silence; progress in JSON gets a
-- JSON object.
pictureSucceeded :: Reporting -> Double -> FilePath -> (Int, Int) -> IO ()
pictureSucceeded reported start file (width, height) = case progressMode reported of
  _ | reportQuiet reported -> pure ()
  JsonProgress -> do
    end <- getMonotonicTime
    tell . (++ "\n") . unwords . words . renderJson $
      Object [("file", Text file), ("width", Whole width), ("height", Whole height), ("seconds", Number (end - start))]
  _ -> succeeded start file (show width ++ " × " ++ show height)

-- | The options of @blackhole render@ that have no effect beside others: for each
-- option, whether it is given, and the modes in which it does nothing.
idleRenderOptions :: RenderOptions -> [Problem]
idleRenderOptions options =
  [ Mistake option ("has no effect with " ++ mode)
    | (option, True, modes) <- table,
      (mode, True) <- take 1 (filter snd modes)
  ]
  where
    table =
      [ ("--output", isJust (renderOutput options), [pixel, previewed]),
        ("--bits", isJust (codingBits coding), [pixel, previewed, tile]),
        ("--quality", isJust (codingQuality coding), [pixel, previewed, tile]),
        ("--preview", renderPreview options, [pixel]),
        ("--tile", isJust (renderTile options), [pixel, previewed]),
        ("--threads", isJust (renderThreads options), [pixel]),
        ("--progress", isJust (reportProgress reported), [pixel, previewed]),
        ("--stats", isJust (reportStats reported), [pixel, previewed]),
        ("--strict", runStrict how, [pixel, previewed]),
        ("--keep-partial", runKeepPartial how, [pixel, previewed, tile]),
        ("--preset", isJust (scenePreset (renderScene options)), [("--from", isJust (renderFrom options))])
      ]
    pixel = ("--pixel", isJust (renderPixel options))
    previewed = ("--preview", renderPreview options)
    tile = ("--tile", isJust (renderTile options))
    coding = renderCoding options
    how = renderRun options
    reported = runReporting how

-- | @blackhole render@.
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
        | renderPreview options -> underSky scene (\sky -> onAll (preview (skyFileImage <$> sky) scene))
        | Just _ <- renderTile options,
          not (null others) ->
          complain BadInput "--tile: a picture with motion blur cannot be rendered in tiles"
        | Just part <- renderTile options -> case tileProblems part (scenePicture scene) of
          [] -> ready (Making Tile False False) scene (snd (shardRows part (pictureHeight (scenePicture scene)))) (\sky workers -> tileTo sky workers part scene)
          problems -> complainAll UsageError problems
        | otherwise -> case outputFormat output of
          Just format -> case codingProblem format coding of
            [] -> ready (Making (WholePicture format) (not (null others)) (runKeepPartial how)) scene (pictureHeight (scenePicture scene)) (\sky workers -> renderTo sky workers format coding scenes')
            problems -> complainAll UsageError problems
          Nothing -> complainAll UsageError [unknownExtension]
  where
    output = renderTarget options
    reported = runReporting how
    onAll = inWorkers (renderThreads options)
    ready making scene rows action = do
      clashes <- overwritten (sceneInputs (renderScene options) scene ++ [("--from", from) | Just from <- [renderFrom options]]) (("--output", output) : [("--stats", file) | Just file <- [reportStats reported]])
      lacking <- memoryProblem making scene rows
      outputProblem <- outputFault output
      statsProblem <- maybe (pure (Right ())) checkWritable (reportStats reported)
      case (lacking, outputProblem, statsProblem) of
        _ | _ : _ <- clashes -> UsageError <$ mapM_ say clashes
        (Just line, _, _) -> complain BadInput line
        (_, Just line, _) -> complain CannotWrite ("--output: " ++ line)
        (_, _, Left problem) -> complain CannotWrite ("--stats: " ++ renderWriteProblem problem)
        _ -> underSky scene (onAll . action)
    how = renderRun options
    unknownExtension = unknownExtensionOf output
    usageProblems =
      (if null (renderTile options) then [unknownExtension | Nothing <- [outputFormat output]] else tileNameProblems output)
        ++ checkThreads (renderThreads options)
        ++ idleRenderOptions options
        ++ [ Mistake "--from" "cannot be combined with a scene file"
             | Just _ <- [renderFrom options],
               Just _ <- [sceneFile (renderScene options)]
           ]
    renderTo sky workers format coding scenes'@(scene :| _) = do
      let rows = pictureHeight (scenePicture scene)
      exposing how (skyFileImage <$> sky) workers scenes' (0, rows) output $ \exposed done seconds ->
        finishing (skyFileImage <$> sky) workers scene (0, done) (exposedLight exposed) seconds $
          maybe (complain CannotWrite (noRoom output)) (\write -> storeBy output (toHandle >=> write (pure . filmRows (exposedLight exposed)))) (pictureEncoder workers programName format coding scenes' (pure . countsRow scene exposed))
    tileTo sky workers part scene = do
      let band = shardRows part (pictureHeight (scenePicture scene))
      exposing how {runKeepPartial = False} (skyFileImage <$> sky) workers (scene :| []) band output $ \exposed _ seconds ->
        finishing (skyFileImage <$> sky) workers scene band (exposedLight exposed) seconds $
          maybe (complain CannotWrite "the tile cannot be encoded") (store output) (encodeTile (tileHeader (programName : skyLines sky) part scene) (exposedCounts exposed) (exposedLight exposed))
    finishing picture workers scene band film traced write = do
      start <- subtract traced <$> getMonotonicTime
      faults <- warnOfFaults workers (fst band) film
      if runStrict how && fst faults > 0
        then complain InternalFault "--strict: no file is written because of these pixels"
        else do
          (status, writing) <- timed write
          memory <- peakMemory
          let stats = Stats versionLine scene picture workers band traced writing memory faults
          if status == Done
            then do
              pictureSucceeded reported start output (pictureWidth (scenePicture scene), snd band)
              storeStats reported (statsText stats)
            else pure status

-- | Write the statistics, if the options ask for them.
storeStats :: Reporting -> Lazy.ByteString -> IO ExitStatus
storeStats reported text = case reportStats reported of
  Just file -> either (complain CannotWrite . ("--stats: " ++) . renderWriteProblem) (const (pure Done)) =<< writeFileAtomically file text
  Nothing -> pure Done

-- | Trace rows of a scene and report the progress, then continue with the film, the
-- number of finished rows and the seconds it took. With @--keep-partial@, trace bands one
-- after the other; after a signal, continue with a film of the finished bands that is
-- black below them.
exposing :: RunOptions -> Maybe EnvironmentMap -> Workers -> NonEmpty Scene -> (Int, Int) -> FilePath -> (Exposed -> Int -> Double -> IO ExitStatus) -> IO ExitStatus
exposing how sky workers scenes'@(scene :| others) (first, rows) output finish
  | runKeepPartial how = do
    kept <- newIORef []
    start <- getMonotonicTime
    let bands = [(from, min bandRows (rows - from)) | from <- [0, bandRows .. rows - 1]]
    outcome <- try . timed . tracking $ \report -> forM_ bands $ \(from, count) -> do
      band <- exposeMotionBlur sky workers (report . (from +) . rowsOf count) scenes' (first + from, count)
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
          say (output ++ ": " ++ show rowsDone ++ " of " ++ show rows ++ " rows are finished, the others are black")
          end <- getMonotonicTime
          _ <- finish exposed rowsDone (end - start)
          throwIO (stop :: Stopped)
        | otherwise -> throwIO stop
  | otherwise = do
    (exposed, seconds) <- timed (tracking (\report -> exposeMotionBlur sky workers (report . rowsOf rows) scenes' (first, rows)))
    maybe untraceable (\light -> finish light rows seconds) exposed
  where
    width = pictureWidth (scenePicture scene)
    tracking = withProgress (progressMode (runReporting how)) rows (width * sceneSamples scene * (1 + length others))
    rowsOf count part = floor (part * fromIntegral count + 1e-6 :: Double)
    -- Enough to keep all workers busy, and at most some thirty bands.
    bandRows = max (4 * workersCount workers) ((rows + 31) `quot` 32)

-- | An action's result and the seconds it took.
timed :: IO a -> IO (a, Double)
timed work = do
  start <- getMonotonicTime
  result <- work
  end <- getMonotonicTime
  pure (result, end - start)

-- | The format for a file's name; PNG for standard output.
outputFormat :: FilePath -> Maybe Format
outputFormat "-" = Just Png
outputFormat name = formatOf name

-- | Why a picture cannot be written to a file, as far as that is known in advance.
outputFault :: FilePath -> IO (Maybe String)
outputFault "-" = do
  closed <- outputIsClosed
  terminal <- hIsTerminalDevice stdout
  pure $
    if closed
      then Just "standard output is closed"
      else if terminal then Just "standard output is a terminal; redirect it to a file or a program" else Nothing
outputFault name = either (Just . renderWriteProblem) (const Nothing) <$> checkWritable name

-- | Run an action with the given number of workers, or one per core.
inWorkers :: Maybe Int -> (Workers -> IO a) -> IO a
inWorkers threads action = do
  workers <- maybe defaultWorkers pure (workersFromCount =<< threads)
  withWorkers workers (action workers)

-- | Write a file or, for @-@, to standard output.
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

noRoom :: FilePath -> String
noRoom output = "--output: " ++ output ++ ": the picture is too large for this format"

-- | @blackhole join@.
join :: JoinOptions -> IO ExitStatus
join options = case (formatOf output, joinCoding options) of
  (Nothing, _) -> complainAll UsageError [unknownExtensionOf output]
  (Just format, coding)
    | problems@(_ : _) <- codingProblem format coding ++ checkThreads (joinThreads options) -> complainAll UsageError problems
    | otherwise -> do
      start <- getMonotonicTime
      joined <- openTiles (joinTiles options)
      case joined of
        Left problems -> BadInput <$ mapM_ (complain BadInput) problems
        Right (scene, tiles) -> writing format scene tiles . inWorkers (joinThreads options) $ \workers -> do
          let Picture width height = scenePicture scene
          status <- withProgress (progressMode reported) height (width * sceneSamples scene) $ \report ->
            let rowsOf (first, count) = report first >> readPictureRows tiles (first, count)
             in maybe (complain CannotWrite (noRoom output)) (\write -> storeBy output (toHandle >=> write rowsOf)) $
                  pictureEncoder workers programName format coding (scene :| []) (countsOf scene tiles)
          if status == Done
            then do
              pictureSucceeded reported start output (width, height)
              end <- getMonotonicTime
              memory <- peakMemory
              storeStats reported (joinStatsText versionLine scene (length tiles) workers (end - start) memory)
            else pure status
  where
    output = joinOutput options
    reported = joinReporting options
    writing format scene tiles action = do
      lacking <- memoryProblem (Making (Joined format) False False) scene (pictureHeight (scenePicture scene))
      clashes <- overwritten [("a tile", tileFilePath tile) | tile <- tiles] (("--output", output) : [("--stats", file) | Just file <- [reportStats reported]])
      outputProblem <- outputFault output
      statsProblem <- maybe (pure (Right ())) checkWritable (reportStats reported)
      case (clashes, lacking, outputProblem, statsProblem) of
        (_ : _, _, _, _) -> UsageError <$ mapM_ say clashes
        (_, Just line, _, _) -> complain BadInput line
        (_, _, Just line, _) -> complain CannotWrite ("--output: " ++ line)
        (_, _, _, Left problem) -> complain CannotWrite ("--stats: " ++ renderWriteProblem problem)
        _ -> action
    countsOf scene tiles row = do
      counts <- readCountsRow tiles row
      pure (fromMaybe (Vector.replicate (pictureWidth (scenePicture scene)) (fromIntegral (sceneSamples scene))) counts)

-- | @blackhole animate@.
animate :: AnimateOptions SceneOptions -> IO ExitStatus
animate options = case (animateStatus options, formatOf pattern') of
  (Just _, _) | problems@(_ : _) <- idleBesideStatus options -> complainAll UsageError problems
  (Just folder, _) -> showStatus (animatePatience options) folder >>= either (complain BadInput) (\(ending, text) -> printed (endStatus ending) text)
  (_, Nothing) -> complainAll UsageError [unknownExtensionOf pattern']
  (_, Just format)
    | problems@(_ : _) <- codingProblem format coding -> complainAll UsageError problems
    | otherwise -> do
      loaded <- loadAnimation (animateScene options)
      case (loaded, animateOrbit options) of
        (Left problems, _) -> BadInput <$ mapM_ say problems
        (Right (Left _), Nothing) -> complain BadInput "animate needs a scene file with a section animation, or --orbit DEGREES (see: blackhole help animation)"
        (Right (Left scene), Just _) -> checked format (adjustAnimation options (stillAnimation scene))
        (Right (Right found), _) -> checked format (adjustAnimation options found)
  where
    pattern' = framePatternOf options
    reported = animateReporting options
    checked format animation = do
      clashes <- animationClashes animation
      lacking <- memoryProblem (Making (Frame format) (shutterOpen (animationShutter animation) > 0) False) (animationScene animation) (pictureHeight (scenePicture (animationScene animation)))
      case (clashes, lacking) of
        (_ : _, _) -> UsageError <$ mapM_ say clashes
        (_, Just line) -> complain BadInput line
        _ -> shootAnimation format animation
    -- Frames that exist are compared, the others cannot be a file that is read.
    animationClashes animation = case parseFrameName pattern' of
      Left _ -> pure []
      Right name -> do
        let folder = takeDirectory (frameFile name 0)
        names <- either (const [] :: IOException -> [FilePath]) id <$> try (listDirectory folder)
        overwritten
          (sceneInputs (animateScene options) (animationScene animation))
          ([("--video", file) | Just file <- [animateVideo options]] ++ [("--stats", file) | Just file <- [reportStats reported]] ++ [("--output", folder </> file) | file <- names, Just _ <- [frameNumber name file]])
    coding = animateCoding options
    describe sky = printScene ((programName ++ ", " ++ show coding) : skyLines sky)
    develop format workers = pictureBytes workers programName format coding
    shootAnimation format animation = underSky (animationScene animation) $ \sky -> do
      (ending, shot) <- runAnimation options say (skyFileImage <$> sky) (describe sky) (develop format) (adjustAnimation options animation)
      memory <- peakMemory
      written <- maybe (pure Done) (\(workers, done) -> storeStats reported (renderedJson (animationStats versionLine memory workers done))) shot
      pure (if ending == Complete then written else endStatus ending)
    renderedJson = Builder.toLazyByteString . Builder.stringUtf8 . renderJson
    endStatus ending = case ending of
      Complete -> Done
      Incomplete -> Unfinished
      WrongArguments -> UsageError
      InvalidAnimation -> BadInput
      CannotStart -> CannotWrite

-- | The options of @blackhole animate@ that have no effect with @--status@: all except
-- @--stale-after@ and @--quiet@.
idleBesideStatus :: AnimateOptions SceneOptions -> [Problem]
idleBesideStatus options =
  [ Mistake option "has no effect with --status"
    | (option, True) <-
        [ ("SCENE.yaml", isJust (sceneFile scene)),
          ("--preset", isJust (scenePreset scene)),
          ("--output", isJust (animateOutput options)),
          ("--bits", isJust (codingBits (animateCoding options))),
          ("--quality", isJust (codingQuality (animateCoding options))),
          ("--orbit", isJust (animateOrbit options)),
          ("--frame-range", isJust (animateFrames options)),
          ("--fps", isJust (animateRate options)),
          ("--duration", isJust (animateDuration options)),
          ("--shutter", isJust (animateShutter options)),
          ("--shutter-samples", isJust (animateShutterSamples options)),
          ("--shard", isJust (animateShard options)),
          ("--video", isJust (animateVideo options)),
          ("--codec", isJust (animateCodec options)),
          ("--crf", isJust (animateCrf options)),
          ("--threads", isJust (animateThreads options)),
          ("--progress", isJust (reportProgress (animateReporting options))),
          ("--stats", isJust (reportStats (animateReporting options)))
        ]
          ++ [(maybe (settingPath s) fieldLabel (findField (settingPath s)), True) | s <- sceneGiven scene]
  ]
  where
    scene = animateScene options

-- | The files that a scene is read from, with what messages call them.
sceneInputs :: SceneOptions -> Scene -> [(String, FilePath)]
sceneInputs options scene = [("the scene", file) | Just file <- [sceneFile options]] ++ [("the sky", file) | Just file <- [neededPicture scene]]

-- | Continue with the environment map of a scene, if it has one.
underSky :: Scene -> (Maybe SkyFile -> IO ExitStatus) -> IO ExitStatus
underSky scene action = loadSky scene >>= either (complain BadInput) action

-- | The scene that the options ask for, or all scenes of a picture with
-- motion blur; and the encoding of the file: that of the options, or else that of the
-- picture that the scene comes from.
renderedScene :: RenderOptions -> IO (Either [String] (NonEmpty Scene, Coding))
renderedScene options = case renderFrom options of
  Nothing -> fmap (coded asked . (:| [])) <$> loadScene (renderScene options)
  Just path -> do
    -- The metadata stands before the pixels.
    outcome <- try (withBinaryFile path ReadMode (`Bytes.hGet` 0x400000))
    case outcome of
      Left failure -> pure (Left [path ++ ": cannot be read: " ++ ioeGetErrorString (failure :: IOException)])
      Right bytes -> case fileMetadata bytes of
        Nothing -> pure (Left [path ++ ": this picture has no scene; only pictures that blackhole wrote do"])
        Just metadata -> do
          when (metadataSoftware metadata /= programName) $
            say ("note: " ++ path ++ " was made by " ++ metadataSoftware metadata ++ "; " ++ programName ++ " may render it differently")
          pure (fromMetadata path metadata)
  where
    asked = renderCoding options
    coded coding scene = (scene, coding)
    fromMetadata path metadata = do
      scenes' <- resolveMetadata (renderScene options) path (metadataScene metadata)
      -- Bits and quality are specific to the format.
      let before
            | formatOf path == formatOf (renderTarget options) = metadataCoding metadata
            | otherwise = defaultCoding
      pure (coded (Coding (codingBits asked <|> codingBits before) (codingQuality asked <|> codingQuality before)) scenes')

-- | Draw the picture as text on standard output.
preview :: Maybe EnvironmentMap -> Scene -> Workers -> IO ExitStatus
preview sky scene workers = do
  isTerminal <- hIsTerminalDevice stdout
  environment <- getEnvironment
  window <- Terminal.size
  let (columns, textLines) = maybe (80, 24) (\(Terminal.Window h w) -> (w, h)) window
      Picture width height = scenePicture scene
      (across, down) = previewSize columns textLines (width, height)
  let small = scene {scenePicture = Picture across down}
  exposed <- exposeFilm sky workers (const (pure ())) small (0, down)
  case exposed of
    Nothing -> untraceable
    Just (Exposed film _) -> do
      _ <- warnOfFaults workers 0 film
      recorded <- opticsFilm workers small film
      codes <- developFilm workers (sceneDevelopment small) recorded
      printed Done (previewText (palette isTerminal environment) codes)

untraceable :: IO ExitStatus
untraceable = complain InternalFault "the scene is valid but cannot be traced"

-- | Warn of pixels without finite radiance in a film whose first row is this row of the
-- picture. Returns their number, and the column and row of the first one in the picture.
warnOfFaults :: Workers -> Int -> Film -> IO (Int, Maybe (Int, Int))
warnOfFaults workers first film = faultyPixels workers film >>= warn
  where
    warn (n, Just (x, y)) = do
      say ("warning: " ++ show n ++ " pixels have no finite radiance, the first at " ++ show x ++ "," ++ show (first + y))
      pure (n, Just (x, first + y))
    warn _ = pure (0, Nothing)

-- | @blackhole scene@.
scenes :: SceneCommand -> IO ExitStatus
scenes task = do
  outcome <- sceneText task
  case outcome of
    Right text -> printed Done text
    Left problems -> status task <$ mapM_ (complain (status task)) problems
  where
    status (ShowScene _) = UsageError
    status _ = BadInput

-- | Explain one pixel on standard output.
explain :: Scene -> (Int, Int) -> Maybe EnvironmentMap -> IO ExitStatus
explain scene (x, y) sky = case tracerWithSky sky scene >>= \traced -> explainPixel traced x y of
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
