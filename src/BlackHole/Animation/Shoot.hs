-- | Shoot a film: its frames into files, each once, whoever else is at it, and
-- if asked for a film file of them.
module BlackHole.Animation.Shoot
  ( Shooting (..),
    Told (..),
    Shot (..),
    shoot,
    frameDigest,
    momentsText,
  )
where

import BlackHole.Animation.Animation
import BlackHole.Animation.Digest
import BlackHole.Animation.Exposure
import BlackHole.Animation.FrameName
import BlackHole.Animation.FrameStore
import BlackHole.Animation.Lease (currentHolder)
import BlackHole.Animation.Progress
import BlackHole.Animation.Queue
import BlackHole.Animation.Video (VideoCoding)
import BlackHole.Animation.VideoFeed
import qualified BlackHole.Render.Film as Light
import BlackHole.Render.Workers (Workers)
import BlackHole.Scene.Scene
import BlackHole.Trace.EnvironmentMap (EnvironmentMap)
import Control.Concurrent.Async (wait, withAsync)
import Control.Concurrent.MVar (modifyMVar_, newMVar, readMVar)
import Control.Exception (onException)
import Control.Monad (forM_, join, when)
import qualified Data.ByteString.Lazy as Lazy
import Data.Either (fromRight)
import Data.IORef (newIORef, readIORef, writeIORef)
import Data.List.NonEmpty (NonEmpty)
import qualified Data.List.NonEmpty as NonEmpty
import Data.Maybe (isNothing)
import GHC.Clock (getMonotonicTime)

-- | What is to be done.
data Shooting = Shooting
  { shootingFilm :: !Film,
    -- | Numbers of this run's frames, in the order in which they are made.
    shootingFrames :: ![Int],
    shootingName :: !FrameName,
    -- | Seconds after which leases from other machines count as abandoned.
    shootingPatience :: !Double,
    shootingWorkers :: !Workers,
    -- | The film file with the program that codes it.
    shootingVideo :: !(Maybe (FilePath, VideoCoding, FilePath)),
    -- | The picture of the sky if that of the film is a panorama.
    shootingSky :: !(Maybe EnvironmentMap),
    -- | A text that is equal for equal scenes and skies, and says which program this is.
    shootingText :: !(Scene -> String),
    -- | The file of a frame, from its scenes and their mean light; 'Nothing' if
    -- its format has no room for the picture.
    shootingDevelop :: !(NonEmpty Scene -> Light.Exposed -> IO (Maybe Lazy.ByteString))
  }

-- | What the listener hears of.
data Told
  = -- | How far it is, and the frame in work.
    Progressed !(Maybe Int) !Tally
  | -- | Something that somebody should know, in one line.
    Remark !String

-- | How it went.
data Shot = Shot
  { shotTally :: !Tally,
    -- | Each frame's outcome.
    shotOutcomes :: ![(Int, Outcome)],
    -- | Why there is no film file, if one was asked for and is lacking.
    shotVideoFault :: !(Maybe String)
  }

-- | The fingerprint of a frame, by the text of its scenes.
frameDigest :: (Scene -> String) -> NonEmpty Scene -> Digest
frameDigest text = digestText . momentsText text

-- | The texts of a frame's scenes.
momentsText :: (Scene -> String) -> NonEmpty Scene -> String
momentsText text = concatMap text . NonEmpty.toList

-- | Do it. The listener hears often of progress, from one thread at a time.
-- Frames whose scenes are not valid fail; the caller may find them beforehand
-- ('frameScenes'). Exceptions: what the file system says of the frame store, and what
-- comes from outside; a film file begun is then removed.
shoot :: Shooting -> (Told -> IO ()) -> IO Shot
shoot shooting listen = do
  holder <- currentHolder
  store <- openFrameStore (shootingName shooting) holder (shootingPatience shooting)
  -- For a film of hours the list takes minutes, which need not come first.
  withAsync (writeFrameList store [(n, digest) | n <- [0 .. filmFrames film - 1], Right digest <- [digestOf n]]) $ \listing -> do
    shot <- shootFrames store
    shot <$ wait listing
  where
    film = shootingFilm shooting
    frames = shootingFrames shooting
    patience = maybe LeaveOthers (const WaitForOthers) (shootingVideo shooting)
    digestOf n = frameDigest (shootingText shooting) <$> frameScenes film n
    shootFrames store = do
      state <- newMVar (startTally (length frames))
      clock <- newIORef Nothing
      feed <- traverse (\(coder, kind, target) -> startVideoFeed coder kind (filmRate film) target (shootingName shooting) frames) (shootingVideo shooting)
      forM_ (feed >>= videoFeedFault) (listen . Remark . ("the film file cannot be made: " ++))
      let run =
            workThrough store patience (begun state clock) (ended state clock feed) (render state clock) $
              [Job n (fromRight (digestText "") (digestOf n)) | n <- frames]
      outcomes <- run `onException` mapM_ abandonVideoFeed feed
      fault <- join <$> traverse finishVideoFeed feed
      tally <- readMVar state
      pure (Shot tally [(jobFrame job, outcome) | (job, outcome) <- outcomes] fault)
    begun state clock job condition = do
      now <- getMonotonicTime
      -- The pace is that of rendering, without the look at what is there.
      started <- readIORef clock
      when (isNothing started) $ writeIORef clock (Just now)
      case condition of
        Damaged -> listen (Remark ("frame " ++ show (jobFrame job) ++ " is damaged and is rendered again"))
        _ -> pure ()
      update state clock (Just (jobFrame job)) (\tally -> tally {tallyPart = 0})
    ended state clock feed job outcome = do
      update state clock Nothing $ \tally -> case outcome of
        WasDone -> tally {tallyFound = tallyFound tally + 1}
        Rendered _ -> tally {tallyRendered = tallyRendered tally + 1, tallyPart = 0}
        Elsewhere _ -> tally {tallyElsewhere = tallyElsewhere tally + 1}
        Failed _ -> tally {tallyFailed = tallyFailed tally + 1, tallyPart = 0}
      forM_ feed $ \video -> feedFrame video (jobFrame job) outcome
    update state clock current change = modifyMVar_ state $ \before -> do
      now <- getMonotonicTime
      started <- readIORef clock
      let tally = (change before) {tallySeconds = maybe 0 (now -) started}
      listen (Progressed current tally)
      pure tally
    render state clock job = case frameScenes film (jobFrame job) of
      Left problems -> pure (Left (unwords (map show problems)))
      Right scenes -> do
        exposed <- exposeMotionBlur (shootingSky shooting) (shootingWorkers shooting) (\part -> update state clock (Just (jobFrame job)) (\tally -> tally {tallyPart = part})) scenes
        case exposed of
          Nothing -> pure (Left "its scenes cannot be traced together")
          Just light -> do
            faults <- Light.faultyPixels (shootingWorkers shooting) (Light.exposedLight light)
            case faults of
              (count, Just (x, y)) ->
                listen (Remark ("frame " ++ show (jobFrame job) ++ ": " ++ show count ++ " pixels have no finite radiance, the first at " ++ show x ++ "," ++ show y))
              _ -> pure ()
            maybe (Left "its format has no room for so large a picture") Right <$> shootingDevelop shooting scenes light
