-- | What all pages of @blackhole explore@ share: the picture that is being rendered to a
-- file, and the small pictures of the presets.
module BlackHole.Explore.Hall
  ( Hall (..),
    newHall,
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

-- | What all pages share.
data Hall = Hall
  { hallStudio :: !Studio,
    -- | The scene that pages begin with, and the preset it comes from.
    hallStart :: !(String, Scene),
    -- | The number of open pages.
    hallPages :: !(TVar Int),
    -- | The picture that is rendered to a file, and its thread.
    hallJob :: !(TVar JobState),
    hallWorker :: !(TVar (Maybe (Async ()))),
    hallThumbnails :: !(MVar (Map.Map String Lazy.ByteString)),
    -- | A reply as JSON.
    hallText :: Reply -> Lazy.ByteString
  }

-- | No pages yet.
newHall :: Studio -> (String, Scene) -> (Reply -> Lazy.ByteString) -> IO Hall
newHall studio start text = do
  pages <- newTVarIO 0
  job <- newTVarIO NoJob
  worker <- newTVarIO Nothing
  thumbnails <- newMVar Map.empty
  pure (Hall studio start pages job worker thumbnails text)

-- | Whether the program is needed: a page is open, or a picture is being rendered.
busy :: Hall -> STM Bool
busy hall = do
  pages <- readTVar (hallPages hall)
  job <- readTVar (hallJob hall)
  pure $
    pages > 0 || case job of
      JobRuns _ _ -> True
      _ -> False

-- | A small JPEG of a preset, rendered at the first request, one at a time.
presetThumbnail :: Hall -> String -> IO (Maybe Lazy.ByteString)
presetThumbnail hall name = case findPreset name of
  Nothing -> pure Nothing
  Just scene -> modifyMVar (hallThumbnails hall) $ \known -> case Map.lookup name known of
    Just picture -> pure (known, Just picture)
    Nothing -> do
      made <- thumbnail (hallStudio hall) scene
      pure (maybe known (\picture -> Map.insert name picture known) made, made)

-- | Render a scene to a file, as @blackhole render@ does, unless another picture is being
-- rendered.
startJob :: Hall -> Scene -> Format -> FilePath -> IO Bool
startJob hall scene format name = do
  free <- atomically $ do
    before <- readTVar state
    case before of
      JobRuns _ _ -> pure False
      _ -> True <$ writeTVar state (JobRuns name 0)
  when free $ do
    worker <- async $ do
      outcome <- try job
      atomically . writeTVar state $ case outcome of
        Right end -> end
        Left failure
          | Just AsyncCancelled <- fromException failure -> JobStopped name
          | otherwise -> JobFailed name (unwords (lines (displayException (failure :: SomeException))))
    atomically (writeTVar (hallWorker hall) (Just worker))
  pure free
  where
    state = hallJob hall
    studio = hallStudio hall
    rows = pictureHeight (scenePicture scene)
    failed = pure . JobFailed name
    job = do
      start <- getMonotonicTime
      room <- studioRoom studio format scene
      sky <- studioSky studio scene
      case (room, sky) of
        (Just problem, _) -> failed problem
        (_, Left problem) -> failed problem
        (Nothing, Right picture) -> do
          exposed <- exposeFilm picture (studioWorkers studio) (\done -> atomically (writeTVar state (JobRuns name (fromIntegral done / fromIntegral rows)))) scene (0, rows)
          case exposed of
            Nothing -> failed "the scene cannot be traced"
            Just light -> case pictureEncoder (studioWorkers studio) software format defaultCoding (scene :| []) (pure . countsRow scene light) of
              Nothing -> failed "the picture is too large for this format"
              Just write -> do
                written <- writeAtomically name (toHandle >=> write (pure . filmRows (exposedLight light)))
                end <- getMonotonicTime
                pure (either (JobFailed name . renderWriteProblem) (const (JobDone name (end - start))) written)
