-- | Rendering an animation: each frame once into its file, also if several processes
-- share the work, and on request a video file of all frames.
module BlackHole.Animation.Shoot
  ( Shooting (..),
    Report (..),
    Shot (..),
    shoot,
    frameDigest,
    scenesText,
  )
where

import BlackHole.Animation.Animation
import BlackHole.Animation.Exposure
import BlackHole.Animation.FrameName
import BlackHole.Animation.FrameStore
import BlackHole.Animation.Lease (currentHolder)
import BlackHole.Animation.Progress
import BlackHole.Animation.Queue
import BlackHole.Animation.Video (VideoCoding)
import BlackHole.Animation.VideoFeed
import BlackHole.Image.Digest
import qualified BlackHole.Render.Exposed as Light
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

-- | The work of one run.
data Shooting = Shooting
  { shootingAnimation :: !Animation,
    -- | Numbers of this run's frames, in the order in which they are rendered.
    shootingFrames :: ![Int],
    shootingName :: !FrameName,
    -- | Seconds after which leases from other machines count as abandoned.
    shootingPatience :: !Double,
    shootingWorkers :: !Workers,
    -- | The path of ffmpeg, the encoding and the path of the video file, if one is asked
    -- for.
    shootingVideo :: !(Maybe (FilePath, VideoCoding, FilePath)),
    -- | The environment map, if the scenes have one.
    shootingSky :: !(Maybe EnvironmentMap),
    -- | A text that is equal for equal scenes, skies and versions of the program.
    shootingText :: !(Scene -> String),
    -- | The bytes of a frame's file, from its scenes and their mean light; 'Nothing' if
    -- the picture is too large for the format.
    shootingDevelop :: !(NonEmpty Scene -> Light.Exposed -> IO (Maybe Lazy.ByteString))
  }

-- | What a run reports to its listener.
data Report
  = -- | The frame in progress, if any, and the work done so far.
    Progressed !(Maybe Int) !Tally
  | -- | A message for the user, in one line.
    Remark !String

-- | The result of a run.
data Shot = Shot
  { shotTally :: !Tally,
    -- | The outcome of each frame.
    shotOutcomes :: ![(Int, Outcome)],
    -- | The reason why a requested video file is missing.
    shotVideoFault :: !(Maybe String)
  }

-- | The fingerprint of a frame, from the texts of its scenes.
frameDigest :: (Scene -> String) -> NonEmpty Scene -> Digest
frameDigest text = digestText . scenesText text

-- | The texts of a frame's scenes.
scenesText :: (Scene -> String) -> NonEmpty Scene -> String
scenesText text = concatMap text . NonEmpty.toList

-- | Renders the missing, outdated and damaged frames. Calls the listener with the
-- progress, from one thread at a time. Frames with invalid scenes fail; 'frameScenes'
-- finds them beforehand. Throws the exceptions of the file system that concern the frame
-- store, and asynchronous ones; an unfinished video file is then removed.
shoot :: Shooting -> (Report -> IO ()) -> IO Shot
shoot shooting listen = do
  holder <- currentHolder
  store <- openFrameStore (shootingName shooting) holder (shootingPatience shooting)
  -- For an animation of hours the list takes minutes; rendering need not wait for it.
  withAsync
    ( writeFrameList
        store
        [(n, digest) | n <- [0 .. animationFrames animation - 1], Right digest <- [digestOf n]]
    )
    $ \listing -> do
      shot <- shootFrames store
      shot <$ wait listing
  where
    animation = shootingAnimation shooting
    frames = shootingFrames shooting
    patience = maybe LeaveOthers (const WaitForOthers) (shootingVideo shooting)
    digestOf n = frameDigest (shootingText shooting) <$> frameScenes animation n
    shootFrames store = do
      state <- newMVar (startTally (length frames))
      clock <- newIORef Nothing
      feed <-
        traverse
          ( \(coder, kind, target) ->
              startVideoFeed
                coder
                kind
                (animationRate animation)
                target
                (shootingName shooting)
                frames
          )
          (shootingVideo shooting)
      forM_ (feed >>= videoFeedFault) (listen . Remark . ("the video file cannot be made: " ++))
      let run =
            workThrough
              store
              patience
              (begun state clock)
              (ended state clock feed)
              (render state clock)
              $ [Job n (fromRight (digestText "") (digestOf n)) | n <- frames]
      outcomes <- run `onException` mapM_ abandonVideoFeed feed
      fault <- join <$> traverse finishVideoFeed feed
      tally <- readMVar state
      pure (Shot tally [(jobFrame job, outcome) | (job, outcome) <- outcomes] fault)
    begun state clock job condition = do
      now <- getMonotonicTime
      -- The pace counts rendering only, without checking the frames that exist.
      started <- readIORef clock
      when (isNothing started) $ writeIORef clock (Just now)
      case condition of
        Damaged ->
          listen
            (Remark ("frame " ++ show (jobFrame job) ++ " is damaged and is rendered again"))
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
    render state clock job = case frameScenes animation (jobFrame job) of
      Left problems -> pure (Left (unwords (map show problems)))
      Right scenes -> do
        exposed <-
          exposeMotionBlur
            (shootingSky shooting)
            (shootingWorkers shooting)
            (\part -> update state clock (Just (jobFrame job)) (\tally -> tally {tallyPart = part}))
            scenes
            (Light.allRows (scenePicture (animationScene animation)))
        case exposed of
          Nothing -> pure (Left "its scenes cannot be traced together")
          Just light -> do
            faults <- Light.faultyPixels (shootingWorkers shooting) (Light.exposedLight light)
            case faults of
              (count, Just (x, y)) ->
                listen
                  ( Remark
                      ( "frame " ++ show (jobFrame job) ++ ": " ++ show count
                          ++ " pixels have no finite radiance, the first at "
                          ++ show x
                          ++ ","
                          ++ show y
                      )
                  )
              _ -> pure ()
            maybe (Left "its format has no room for so large a picture") Right
              <$> shootingDevelop shooting scenes light
