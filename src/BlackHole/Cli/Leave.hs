-- | The end of the program.
module BlackHole.Cli.Leave (leave) where

import GHC.Environment (getFullArgs)
import System.Exit (ExitCode, exitWith)
import System.Posix.Process (exitImmediately)

-- | End the process with an exit code, from its main thread, when all is written and
-- no other thread has anything left to do ("BlackHole.Cli.Console" has flushed what it
-- could).
--
-- The run-time system would wait for its clock's next tick and put its memory in
-- order, which takes 15 ms, a tenth of a quick picture. It does so if its options ask
-- for statistics or a profile.
leave :: ExitCode -> IO ()
leave code = do
  asked <- elem "+RTS" <$> getFullArgs
  if asked then exitWith code else exitImmediately code
