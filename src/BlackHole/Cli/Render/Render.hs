-- | @blackhole render@: a picture, a tile of one, a preview, or the explanation of a
-- pixel.
module BlackHole.Cli.Render.Render (render) where

import BlackHole.Cli.Console (say)
import BlackHole.Cli.ExitStatus
import BlackHole.Cli.Explain (explanationLines, pixelProblems)
import BlackHole.Cli.Memory
import BlackHole.Cli.PictureOutput
import BlackHole.Cli.Preview
import BlackHole.Cli.Render.Options
import BlackHole.Cli.Render.Scenes
import BlackHole.Cli.Render.Trace
import BlackHole.Cli.RunOptions
import BlackHole.Cli.SceneOptions
import BlackHole.Cli.Stats
import BlackHole.Cli.Tile
import BlackHole.Cli.Version (versionLine)
import BlackHole.Image.Coding
import BlackHole.Image.Destination (toHandle)
import BlackHole.Image.Metadata (software)
import BlackHole.Image.SkyFile
import BlackHole.Image.TileFile (encodeTile)
import BlackHole.Image.Write
import BlackHole.Render.Exposed
import BlackHole.Render.Film
import BlackHole.Render.Optics
import BlackHole.Render.Shard (Shard, shardRows)
import BlackHole.Render.Workers
import BlackHole.Scene.Camera (Picture (..))
import BlackHole.Scene.Scene
import BlackHole.Trace.EnvironmentMap (EnvironmentMap)
import BlackHole.Trace.Explain (explainPixel)
import BlackHole.Trace.Tracer (tracerWithSky)
import Control.Monad ((>=>))
import Data.List.NonEmpty (NonEmpty (..))
import GHC.Clock (getMonotonicTime)
import qualified System.Console.Terminal.Size as Terminal
import System.Environment (getEnvironment)
import System.IO (hIsTerminalDevice, stdout)

-- | Renders what the options ask for.
render :: RenderOptions -> IO ExitStatus
render options
  | problems@(_ : _) <- renderUsageProblems options = complainAll UsageError problems
  | otherwise = renderedScenes options >>= either ((BadInput <$) . mapM_ say) inMode
  where
    inMode (scenes@(scene :| others), coding)
      | Just pixel <- renderPixel options = case pixelProblems (scenePicture scene) pixel of
        [] -> underSky scene (explain scene pixel . fmap skyFileImage)
        problems -> complainAll BadInput problems
      | renderPreview options =
        underSky
          scene
          (\sky -> inWorkers (renderThreads options) (preview (skyFileImage <$> sky) scene))
      | Just part <- renderTile options = case tileProblems part (scenePicture scene) of
        _
          | not (null others) ->
            complain
              BadInput
              "--tile: a picture with motion blur cannot be rendered in tiles"
        [] -> renderTileFile options scene part
        problems -> complainAll UsageError problems
      | otherwise = case outputFormat (renderTarget options) of
        Nothing -> complainAll UsageError [unknownExtensionOf (renderTarget options)]
        Just format -> case codingProblem format coding of
          [] -> renderPicture options format coding scenes
          problems -> complainAll UsageError problems

-- | Renders a whole picture to its file.
renderPicture :: RenderOptions -> Format -> Coding -> NonEmpty Scene -> IO ExitStatus
renderPicture options format coding scenes@(scene :| others) =
  withWork options making scene rows $ \sky workers ->
    tracing how (skyFileImage <$> sky) workers scenes (0, rows) output $ \traced ->
      let film = tracedFilm traced
          encoder =
            pictureEncoder
              workers
              software
              format
              coding
              scenes
              (pure . countsRow scene film)
       in finishing options (skyFileImage <$> sky) workers scene (0, tracedRows traced) traced $
            case encoder of
              Nothing -> complain CannotWrite (noRoom output)
              Just encode ->
                storeBy
                  output
                  (toHandle >=> encode (pure . filmRows (exposedLight film)))
  where
    making = Making (WholePicture format) (not (null others)) (runKeepPartial how)
    rows = pictureHeight (scenePicture scene)
    output = renderTarget options
    how = renderRun options

-- | Renders a part of a picture to a tile file.
renderTileFile :: RenderOptions -> Scene -> Shard -> IO ExitStatus
renderTileFile options scene part =
  withWork options (Making Tile False False) scene (snd band) $ \sky workers ->
    tracing how (skyFileImage <$> sky) workers (scene :| []) band output $ \traced ->
      let Exposed light counts = tracedFilm traced
       in finishing options (skyFileImage <$> sky) workers scene band traced $
            case encodeTile (tileHeader (software : skyLines sky) part scene) counts light of
              Nothing -> complain CannotWrite "the tile cannot be encoded"
              Just bytes -> store output bytes
  where
    band = shardRows part (pictureHeight (scenePicture scene))
    output = renderTarget options
    how = renderRun options

-- | Checks that a picture can be written, and continues with the sky and the workers.
withWork ::
  RenderOptions ->
  Making ->
  Scene ->
  Int ->
  (Maybe SkyFile -> Workers -> IO ExitStatus) ->
  IO ExitStatus
withWork options making scene rows action =
  whenWritable writing (underSky scene (inWorkers (renderThreads options) . action))
  where
    writing =
      Writing
        { writingMaking = making,
          writingScene = scene,
          writingRows = rows,
          writingInputs =
            sceneInputs (renderScene options) scene
              ++ [("--from", from) | Just from <- [renderFrom options]],
          writingOutput = renderTarget options,
          writingReporting = runReporting (renderRun options)
        }

-- | Writes a file from a film by the last argument, unless @--strict@ forbids it, and
-- reports success and statistics. The band consists of the first row and the number of
-- finished rows.
finishing ::
  RenderOptions ->
  Maybe EnvironmentMap ->
  Workers ->
  Scene ->
  (Int, Int) ->
  Traced ->
  IO ExitStatus ->
  IO ExitStatus
finishing options sky workers scene band traced write = do
  start <- subtract (tracedSeconds traced) <$> getMonotonicTime
  faults <- warnOfFaults workers (fst band) (exposedLight (tracedFilm traced))
  if runStrict (renderRun options) && fst faults > 0
    then complain InternalFault "--strict: no file is written because of these pixels"
    else do
      (status, seconds) <- timed write
      memory <- peakMemory
      if status == Done
        then do
          pictureSucceeded
            reported
            start
            (renderTarget options)
            (pictureWidth (scenePicture scene), snd band)
          storeStats
            reported
            ( statsJson
                ( Stats
                    versionLine
                    scene
                    sky
                    workers
                    band
                    (tracedSeconds traced)
                    seconds
                    memory
                    faults
                )
            )
        else pure status
  where
    reported = runReporting (renderRun options)

-- | Explains one pixel on standard output.
explain :: Scene -> (Int, Int) -> Maybe EnvironmentMap -> IO ExitStatus
explain scene (x, y) sky = case tracerWithSky sky scene >>= \traced -> explainPixel traced x y of
  Just explanation -> printed Done (unlines (explanationLines scene explanation))
  Nothing -> untraceable

-- | Draws the picture as text on standard output.
preview :: Maybe EnvironmentMap -> Scene -> Workers -> IO ExitStatus
preview sky scene workers = do
  isTerminal <- hIsTerminalDevice stdout
  environment <- getEnvironment
  window <- Terminal.size
  let (columns, textLines) = maybe (80, 24) (\(Terminal.Window h w) -> (w, h)) window
      Picture width height = scenePicture scene
      (across, down) = previewSize columns textLines (width, height)
      small = scene {scenePicture = Picture across down}
  exposed <- exposeFilm sky workers (const (pure ())) small (0, down)
  case exposed of
    Nothing -> untraceable
    Just (Exposed film _) -> do
      _ <- warnOfFaults workers 0 film
      recorded <- opticsFilm workers small film
      codes <- developFilm workers (sceneDevelopment small) recorded
      printed Done (previewText (palette isTerminal environment) codes)
