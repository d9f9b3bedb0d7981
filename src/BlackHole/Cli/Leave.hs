-- | The end of the program.
module BlackHole.Cli.Leave (leave) where

import GHC.Environment (getFullArgs)
import GHC.TopHandler (flushStdHandles)
import System.Exit (ExitCode, exitWith)
import System.Posix.Process (exitImmediately)

-- | End the process with an exit code, from its main thread, when all is written and
-- no other thread has anything left to do.
--
-- The run-time system would wait for its clock's next tick and put its memory in
-- order: 15 ms, a tenth of a quick picture. Only who asked it for something, as
-- statistics or a profile, has it end as it wants, and gets that.
leave :: ExitCode -> IO ()
leave code = do
  flushStdHandles
  asked <- elem "+RTS" <$> getFullArgs
  if asked then exitWith code else exitImmediately code
