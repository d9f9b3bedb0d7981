-- | The work queue of an animation's frames, shared with any number of other processes and
-- resumable after interruptions.
module BlackHole.Animation.Queue
  ( Job (..),
    Outcome (..),
    Patience (..),
    workThrough,
  )
where

import BlackHole.Animation.FrameStore
import BlackHole.Animation.Lease
import BlackHole.Image.Digest
import Control.Concurrent (threadDelay)
import Control.Exception
  ( SomeAsyncException,
    SomeException,
    displayException,
    evaluate,
    finally,
    fromException,
    throwIO,
    try,
  )
import qualified Data.ByteString.Lazy as Lazy
import Data.Foldable (for_)
import GHC.Clock (getMonotonicTime)

-- | A frame to be rendered.
data Job = Job
  { jobFrame :: !Int,
    -- | The fingerprint of its scene.
    jobScene :: !Digest
  }
  deriving (Eq, Show)

-- | The outcome of a frame.
data Outcome
  = -- | It was already finished.
    WasDone
  | -- | It is now finished; the seconds it took.
    Rendered !Double
  | -- | Another process is rendering it.
    Elsewhere !(Maybe Holder)
  | -- | The reason why it could not be rendered.
    Failed !String
  deriving (Eq, Show)

-- | What to do about frames that other processes are rendering.
data Patience
  = -- | Leave them to those processes.
    LeaveOthers
  | -- | Wait until they are finished, or until they are abandoned and can be taken
    -- over.
    WaitForOthers
  deriving (Eq, Show)

-- | Renders the missing, stale and damaged frames in order. One callback is called with
-- each frame and its former state when its rendering begins, the other when its outcome
-- is known. A frame that another process is rendering is reported once, when it is left
-- to that process. The outcomes are returned in the order of the jobs.
--
-- A frame that fails, by a message of the renderer or an exception, does not stop the
-- others. Asynchronous exceptions (an interrupt) end all work and release the lease on
-- the current frame.
workThrough ::
  FrameStore ->
  Patience ->
  (Job -> FrameState -> IO ()) ->
  (Job -> Outcome -> IO ()) ->
  (Job -> IO (Either String Lazy.ByteString)) ->
  [Job] ->
  IO [(Job, Outcome)]
workThrough store patience begun ended render jobs = do
  first <- mapM (\job -> (,) job <$> settle job) jobs
  if patience == WaitForOthers then mapM revisit first else pure first
  where
    settle job = do
      outcome <- attempt job
      case outcome of
        Elsewhere _ | patience == WaitForOthers -> pure ()
        _ -> ended job outcome
      pure outcome
    revisit (job, Elsewhere _) = do
      outcome <- waitFor job
      ended job outcome
      pure (job, outcome)
    revisit settled = pure settled
    waitFor job = do
      outcome <- attempt job
      case outcome of
        Elsewhere _ -> threadDelay 500000 >> waitFor job
        _ -> pure outcome
    attempt job = caught (make job)
    make job = do
      before <- frameState store (jobFrame job) (jobScene job)
      case before of
        Finished _ -> WasDone <$ sweepFrame store (jobFrame job)
        _ -> do
          leased <- takeLease leases (name job)
          case leased of
            HeldBy holder -> pure (Elsewhere holder)
            Leased former ->
              keepingAlive leases (name job) (underLease job former)
                `finally` releaseLease leases (name job)
    -- Another process may have finished the frame between the check and the lease.
    underLease job former = do
      for_ former (removeLeftOver store (jobFrame job))
      condition <- frameState store (jobFrame job) (jobScene job)
      case condition of
        Finished _ -> pure WasDone
        _ -> do
          begun job condition
          start <- getMonotonicTime
          rendered <- render job
          case rendered of
            Left reason -> pure (Failed reason)
            Right bytes -> do
              -- Evaluating the lazy bytes is part of the work.
              _ <- evaluate (Lazy.length bytes)
              seconds <- subtract start <$> getMonotonicTime
              storeFrame store (jobFrame job) (jobScene job) seconds bytes
              Rendered . subtract start <$> getMonotonicTime
    leases = frameStoreLeases store
    name = frameLabel store . jobFrame
    caught action = do
      result <- try action
      case result of
        Right outcome -> pure outcome
        Left failure
          | Just asynchronous <- fromException failure ->
            throwIO
              (asynchronous :: SomeAsyncException)
          | otherwise ->
            pure
              (Failed (unwords (lines (displayException (failure :: SomeException)))))
