-- | The program @blackhole@.
module Main (main) where

import BlackHole.Cli.Run (run)
import BlackHole.Cli.Signals (stoppable)
import GHC.Environment (getFullArgs)
import GHC.TopHandler (flushStdHandles)
import System.Environment (getArgs)
import System.Exit (exitWith)
import System.IO (hSetEncoding, mkTextEncoding, stderr, stdout)
import System.Posix.Process (exitImmediately)

main :: IO ()
main = do
  -- Without a locale, a message would end the program at the first letter
  -- outside ASCII: one of its own, or one of an argument that it repeats.
  encoding <- mkTextEncoding "UTF-8//ROUNDTRIP"
  mapM_ (`hSetEncoding` encoding) [stdout, stderr]
  arguments <- getArgs
  -- Films give back their claims, and a picture's part may be wanted.
  let atOnce = take 1 arguments == ["render"] && "--keep-partial" `notElem` arguments
  code <- stoppable atOnce (run arguments)
  flushStdHandles
  -- All is written. The run-time system would wait for its clock's next tick and put
  -- its memory in order before it ends: 15 ms, a tenth of a quick picture. Only who
  -- asks it for something, statistics or a profile, gets it at the end.
  asked <- elem "+RTS" <$> getFullArgs
  if asked then exitWith code else exitImmediately code
