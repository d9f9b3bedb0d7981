-- | The state that all pages of @blackhole explore@ share: the picture that is being rendered to a
-- file, and the small pictures of the presets.
module BlackHole.Explore.ServerState
  ( ServerState (..),
    newServerState,
    busy,
    presetThumbnail,
    startJob,
  )
where

import BlackHole.Explore.Picture
import BlackHole.Explore.Reply
import BlackHole.Image.AtomicFile
import BlackHole.Image.Coding
import BlackHole.Image.Destination
import BlackHole.Image.Metadata (software)
import BlackHole.Image.Write
import BlackHole.Render.Exposed
import BlackHole.Render.Film
import BlackHole.Scene.Camera (Picture (..))
import BlackHole.Scene.Preset
import BlackHole.Scene.Scene
import Control.Concurrent.Async
import Control.Concurrent.MVar
import Control.Concurrent.STM
import Control.Exception (SomeException, displayException, fromException, try)
import Control.Monad (when, (>=>))
import qualified Data.ByteString.Lazy as Lazy
import Data.List.NonEmpty (NonEmpty (..))
import qualified Data.Map.Strict as Map
import GHC.Clock (getMonotonicTime)

-- | The shared state.
data ServerState = ServerState
  { stateRenderer :: !Renderer,
    -- | The scene that pages begin with, and the preset it comes from.
    stateStart :: !(String, Scene),
    -- | The number of open pages.
    statePages :: !(TVar Int),
    -- | The picture that is rendered to a file, and its thread.
    stateJob :: !(TVar JobState),
    stateWorker :: !(TVar (Maybe (Async ()))),
    stateThumbnails :: !(MVar (Map.Map String Lazy.ByteString)),
    -- | A reply as JSON.
    stateText :: Reply -> Lazy.ByteString
  }

-- | The state before the first page opens.
newServerState :: Renderer -> (String, Scene) -> (Reply -> Lazy.ByteString) -> IO ServerState
newServerState renderer start text = do
  pages <- newTVarIO 0
  job <- newTVarIO NoJob
  worker <- newTVarIO Nothing
  thumbnails <- newMVar Map.empty
  pure (ServerState renderer start pages job worker thumbnails text)

-- | Whether the program is needed: a page is open, or a picture is being rendered.
busy :: ServerState -> STM Bool
busy state = do
  pages <- readTVar (statePages state)
  job <- readTVar (stateJob state)
  pure $
    pages > 0 || case job of
      JobRuns _ _ -> True
      _ -> False

-- | A small JPEG of a preset, rendered at the first request, one at a time.
presetThumbnail :: ServerState -> String -> IO (Maybe Lazy.ByteString)
presetThumbnail state name = case findPreset name of
  Nothing -> pure Nothing
  Just scene -> modifyMVar (stateThumbnails state) $ \known -> case Map.lookup name known of
    Just picture -> pure (known, Just picture)
    Nothing -> do
      made <- thumbnail (stateRenderer state) scene
      pure (maybe known (\picture -> Map.insert name picture known) made, made)

-- | Render a scene to a file, as @blackhole render@ does, unless another picture is being
-- rendered.
startJob :: ServerState -> Scene -> Format -> FilePath -> IO Bool
startJob state scene format name = do
  free <- atomically $ do
    before <- readTVar jobState
    case before of
      JobRuns _ _ -> pure False
      _ -> True <$ writeTVar jobState (JobRuns name 0)
  when free $ do
    worker <- async $ do
      outcome <- try job
      atomically . writeTVar jobState $ case outcome of
        Right end -> end
        Left failure
          | Just AsyncCancelled <- fromException failure -> JobStopped name
          | otherwise ->
            JobFailed name (unwords (lines (displayException (failure :: SomeException))))
    atomically (writeTVar (stateWorker state) (Just worker))
  pure free
  where
    jobState = stateJob state
    renderer = stateRenderer state
    rows = pictureHeight (scenePicture scene)
    failed = pure . JobFailed name
    job = do
      start <- getMonotonicTime
      room <- rendererRoom renderer format scene
      sky <- rendererSky renderer scene
      case (room, sky) of
        (Just problem, _) -> failed problem
        (_, Left problem) -> failed problem
        (Nothing, Right picture) -> do
          exposed <-
            exposeFilm
              picture
              (rendererWorkers renderer)
              ( \done ->
                  atomically
                    (writeTVar jobState (JobRuns name (fromIntegral done / fromIntegral rows)))
              )
              scene
              (0, rows)
          case exposed of
            Nothing -> failed "the scene cannot be traced"
            Just light -> case pictureEncoder
              (rendererWorkers renderer)
              software
              format
              defaultCoding
              (scene :| [])
              (pure . countsRow scene light) of
              Nothing -> failed "the picture is too large for this format"
              Just write -> do
                written <-
                  writeAtomically name (toHandle >=> write (pure . filmRows (exposedLight light)))
                end <- getMonotonicTime
                pure
                  ( either
                      (JobFailed name . renderWriteProblem)
                      (const (JobDone name (end - start)))
                      written
                  )
