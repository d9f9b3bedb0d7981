-- | Signals that ask the program to stop: Ctrl-C, SIGTERM, a terminal that closes,
-- and a processor time limit that is reached.
module BlackHole.Cli.Signals
  ( Stopped (..),
    stoppedCode,
    stoppable,
  )
where

import BlackHole.Cli.Console (say)
import Control.Applicative ((<|>))
import Control.Concurrent (forkIO, myThreadId, threadDelay)
import Control.Exception hiding (Handler)
import Control.Monad (unless, void, when)
import Data.Bits (testBit)
import Data.IORef (atomicModifyIORef', newIORef)
import GHC.Clock (getMonotonicTime)
import Numeric (readHex)
import System.Exit (ExitCode (..))
import System.Posix.Process (exitImmediately)
import System.Posix.Signals
  ( Handler (Catch, Ignore),
    Signal,
    installHandler,
    sigHUP,
    sigINT,
    sigTERM,
    sigXCPU,
    sigXFSZ,
  )

-- | The exception that a signal becomes in the main thread.
newtype Stopped = Stopped Signal
  deriving (Eq, Show)

instance Exception Stopped where
  toException = asyncExceptionToException
  fromException = asyncExceptionFromException

-- | 128 plus the signal's number, as in shells: 130 for SIGINT, 143 for SIGTERM.
stoppedCode :: Stopped -> ExitCode
stoppedCode (Stopped signal) = ExitFailure (128 + fromIntegral signal)

-- | Run an action so that SIGINT, SIGTERM, SIGHUP and SIGXCPU throw 'Stopped' to it,
-- once: an impatient second signal does not interrupt its clean-up, except when it
-- comes more than a second later, which ends the process immediately. The handlers
-- stay installed, since the process is about to end. A file size limit (SIGXFSZ)
-- becomes an error of the write instead.
--
-- An action that has nothing to finish when it is stopped (the first argument) is
-- also ended if it is still running 0.4 seconds later, as it may be on a machine
-- with much else to do.
stoppable :: Bool -> IO ExitCode -> IO ExitCode
stoppable atOnce action = do
  thread <- myThreadId
  first <- newIORef Nothing
  let stopFor signal = Catch $ do
        now <- getMonotonicTime
        before <- atomicModifyIORef' first (\seen -> (seen <|> Just now, seen))
        case before of
          Nothing -> do
            when atOnce . void . forkIO $ do
              threadDelay 400000
              exitImmediately (stoppedCode (Stopped signal))
            throwTo thread (Stopped signal)
          Just at -> when (now - at > 1) $ exitImmediately (stoppedCode (Stopped signal))
      stopBy signal = installHandler signal (stopFor signal) Nothing
  mapM_ stopBy [sigINT, sigTERM, sigXCPU]
  -- nohup ignores it on purpose.
  hangUpIgnored <- ignored sigHUP
  unless hangUpIgnored . void $ stopBy sigHUP
  _ <- installHandler sigXFSZ Ignore Nothing
  action `catch` stopped
  where
    stopped reason = stoppedCode reason <$ say (word reason)
    word (Stopped signal)
      | signal == sigINT = "interrupted"
      | signal == sigTERM = "ended by SIGTERM"
      | signal == sigHUP = "ended by SIGHUP"
      | otherwise = "ended by the limit on processor time"

-- | Whether the process was started with a signal ignored, where the system tells.
ignored :: Signal -> IO Bool
ignored signal = do
  status <-
    try (readFile "/proc/self/status" >>= \text -> text <$ evaluate (length text)) ::
      IO
        (Either IOException String)
  pure $
    case [ bits
           | Right text <- [status],
             ["SigIgn:", digits] <- map words (lines text),
             (bits, "") <- readHex digits
         ] of
      bits : _ -> testBit (bits :: Integer) (fromIntegral signal - 1)
      [] -> False
