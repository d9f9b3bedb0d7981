-- | The program @blackhole@.
module Main (main) where

import BlackHole.Cli.Descriptors (openClosedDescriptors)
import BlackHole.Cli.ExitStatus (ExitStatus (BadInput), exitCode)
import BlackHole.Cli.FastExit (fastExit)
import BlackHole.Cli.Run (run)
import BlackHole.Cli.Signals (stoppable)
import BlackHole.Image.Exhaustion (handleExhaustion)
import System.Environment (getArgs)
import System.IO
  ( BufferMode (LineBuffering),
    hSetBuffering,
    hSetEncoding,
    mkTextEncoding,
    stderr,
    stdout,
  )

main :: IO ()
main = do
  openClosedDescriptors
  handleExhaustion (exitCode BadInput)
  -- Without a locale, the first letter outside ASCII in a message would end the
  -- program, and messages repeat arguments.
  encoding <- mkTextEncoding "UTF-8//ROUNDTRIP"
  mapM_ (`hSetEncoding` encoding) [stdout, stderr]
  -- One write for a line, not one for each character.
  hSetBuffering stderr LineBuffering
  arguments <- getArgs
  -- An animation still has leases to release, and --keep-partial a picture to write.
  let atOnce = take 1 arguments == ["render"] && "--keep-partial" `notElem` arguments
  stoppable atOnce (run arguments) >>= fastExit
