-- | Work through a film's frames beside any number of other processes, and over
-- any number of interruptions.
module BlackHole.Animation.Queue
  ( Job (..),
    Outcome (..),
    Patience (..),
    workThrough,
  )
where

import BlackHole.Animation.Claim
import BlackHole.Animation.Digest
import BlackHole.Animation.Ledger
import Control.Concurrent (threadDelay)
import Control.Exception (SomeAsyncException, SomeException, displayException, evaluate, finally, fromException, throwIO, try)
import qualified Data.ByteString.Lazy as Lazy
import Data.Foldable (for_)
import GHC.Clock (getMonotonicTime)

-- | A frame to be made.
data Job = Job
  { jobFrame :: !Int,
    -- | The fingerprint of its scene.
    jobScene :: !Digest
  }
  deriving (Eq, Show)

-- | What became of a frame.
data Outcome
  = -- | It was there already.
    WasDone
  | -- | It is there now; after so many seconds.
    Rendered !Double
  | -- | Another process is at it.
    Elsewhere !(Maybe Holder)
  | -- | Why it could not be made.
    Failed !String
  deriving (Eq, Show)

-- | What to do about frames that other processes are at.
data Patience
  = -- | Leave them.
    LeaveOthers
  | -- | Wait until they are done, or abandoned and then taken over.
    WaitForOthers
  deriving (Eq, Show)

-- | Make what is missing, stale or damaged of the frames, in order. The
-- callbacks hear of each frame when its rendering begins, with the state it was
-- in, and when its outcome is known; a frame that others are at is told of once,
-- when it is left. The outcomes are returned in the order of the jobs.
--
-- A frame that fails, by a message of the renderer or an exception, does not
-- keep the others from being made; exceptions from outside (an interrupt) end
-- all of it, and the frame's claim is given back.
workThrough ::
  Ledger ->
  Patience ->
  (Job -> Condition -> IO ()) ->
  (Job -> Outcome -> IO ()) ->
  (Job -> IO (Either String Lazy.ByteString)) ->
  [Job] ->
  IO [(Job, Outcome)]
workThrough ledger patience begun ended render jobs = do
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
      before <- frameCondition ledger (jobFrame job) (jobScene job)
      case before of
        Finished _ -> WasDone <$ sweepFrame ledger (jobFrame job)
        _ -> do
          claimed <- takeClaim claims (name job)
          case claimed of
            HeldBy holder -> pure (Elsewhere holder)
            Claimed former ->
              keepingAlive claims (name job) (underClaim job former)
                `finally` releaseClaim claims (name job)
    -- Between the look and the claim, somebody may have finished the frame.
    underClaim job former = do
      for_ former (removeLeftOver ledger (jobFrame job))
      condition <- frameCondition ledger (jobFrame job) (jobScene job)
      case condition of
        Finished _ -> pure WasDone
        _ -> do
          begun job condition
          start <- getMonotonicTime
          rendered <- render job
          case rendered of
            Left reason -> pure (Failed reason)
            Right bytes -> do
              -- What is lazy in them is part of the work.
              _ <- evaluate (Lazy.length bytes)
              seconds <- subtract start <$> getMonotonicTime
              storeFrame ledger (jobFrame job) (jobScene job) seconds bytes
              Rendered . subtract start <$> getMonotonicTime
    claims = ledgerClaims ledger
    name = frameLabel ledger . jobFrame
    caught action = do
      result <- try action
      case result of
        Right outcome -> pure outcome
        Left failure
          | Just asynchronous <- fromException failure -> throwIO (asynchronous :: SomeAsyncException)
          | otherwise -> pure (Failed (unwords (lines (displayException (failure :: SomeException)))))
