-- | Being asked to stop: Ctrl-C and SIGTERM.
module BlackHole.Cli.Signals
  ( Stopped (..),
    stoppedCode,
    stoppable,
  )
where

import Control.Applicative ((<|>))
import Control.Concurrent (forkIO, myThreadId, threadDelay)
import Control.Exception hiding (Handler)
import Control.Monad (void, when)
import Data.IORef (atomicModifyIORef', newIORef)
import GHC.Clock (getMonotonicTime)
import System.Exit (ExitCode (..))
import System.IO (hPutStrLn, stderr)
import System.Posix.Process (exitImmediately)
import System.Posix.Signals (Handler (Catch), installHandler, sigINT, sigTERM)

-- | The exception that a signal becomes in the main thread.
data Stopped = Interrupted | Terminated
  deriving (Eq, Show)

instance Exception Stopped where
  toException = asyncExceptionToException
  fromException = asyncExceptionFromException

-- | 128 and the signal's number, as shells have it: 130 or 143.
stoppedCode :: Stopped -> ExitCode
stoppedCode Interrupted = ExitFailure 130
stoppedCode Terminated = ExitFailure 143

-- | Run an action so that SIGINT and SIGTERM throw 'Stopped' to it, once: what
-- it does to clean up is not interrupted by an impatient second signal. Only
-- one that comes a second later ends the process on the spot. The handlers stay
-- installed, since the process is about to end.
--
-- An action that has nothing to finish then (the first argument) is also ended
-- on the spot if it has not stopped by itself after 0.4 seconds, as on a machine
-- with much more to do.
stoppable :: Bool -> IO ExitCode -> IO ExitCode
stoppable atOnce action = do
  thread <- myThreadId
  first <- newIORef Nothing
  let stopFor reason = Catch $ do
        now <- getMonotonicTime
        before <- atomicModifyIORef' first (\seen -> (seen <|> Just now, seen))
        case before of
          Nothing -> do
            when atOnce . void . forkIO $ do
              threadDelay 400000
              exitImmediately (stoppedCode reason)
            throwTo thread reason
          Just at -> when (now - at > 1) $ exitImmediately (stoppedCode reason)
  mapM_ (\(signal, reason) -> installHandler signal (stopFor reason) Nothing) [(sigINT, Interrupted), (sigTERM, Terminated)]
  action `catch` stopped
  where
    stopped reason = stoppedCode reason <$ hPutStrLn stderr ("blackhole: " ++ word reason)
    word Interrupted = "interrupted"
    word Terminated = "ended by SIGTERM"
