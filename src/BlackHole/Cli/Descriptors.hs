-- | Descriptors 0 to 2 that were closed when the program was started, as by @>&-@.
module BlackHole.Cli.Descriptors (openClosedDescriptors) where

import Control.Exception (IOException, handle)
import Control.Monad (filterM, unless, when)
import Data.Functor (($>))
import Foreign.C (throwErrnoIfMinus1, withCString)
import GHC.Environment (getFullArgs)
import System.Environment (getExecutablePath)
import System.Exit (ExitCode (..))
import System.Posix.IO (FdOption (CloseOnExec), closeFd, dupTo, queryFdOption)
import System.Posix.Internals (c_open, o_RDONLY, o_WRONLY)
import System.Posix.Process (executeFile, exitImmediately)
import System.Posix.Types (Fd)

-- | Open what is closed on @\/dev\/null@, so that reading from it or writing to it
-- is an error. Does nothing, in microseconds, where all three are open.
--
-- The run-time system opens descriptors of its own before any Haskell code runs, and
-- gets those numbers if they are free: what is then written to standard output goes
-- to its timer or its poller, which can hang forever. They are distinguished from inherited
-- ones by their flag close-on-exec, which nothing inherited can have. As they are in
-- use, the program starts itself again with the right ones, or exits with code 4 where that
-- is impossible.
openClosedDescriptors :: IO ()
openClosedDescriptors = do
  closed <- filterM wasClosed [0, 1, 2]
  unless (null closed) . handle impossible $ do
    program <- getExecutablePath
    arguments <- drop 1 <$> getFullArgs
    mapM_ openUseless closed
    executeFile program False arguments Nothing
  where
    impossible :: IOException -> IO ()
    impossible _ = exitImmediately (ExitFailure 4)

wasClosed :: Fd -> IO Bool
wasClosed descriptor = handle unknown (queryFdOption descriptor CloseOnExec)
  where
    unknown :: IOException -> IO Bool
    unknown _ = pure True

-- | Standard input for writing only, the others for reading only.
openUseless :: Fd -> IO ()
openUseless descriptor = do
  opened <-
    fromIntegral
      <$> withCString "/dev/null" (\path -> throwErrnoIfMinus1 "open" (c_open path mode 0))
  when (opened /= descriptor) $ dupTo opened descriptor *> closeFd opened $> ()
  where
    mode = if descriptor == 0 then o_WRONLY else o_RDONLY
