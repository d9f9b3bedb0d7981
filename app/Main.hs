-- | The program @blackhole@.
module Main (main) where

import BlackHole.Cli.Leave (leave)
import BlackHole.Cli.Run (run)
import BlackHole.Cli.Signals (stoppable)
import System.Environment (getArgs)
import System.IO (hSetEncoding, mkTextEncoding, stderr, stdout)

main :: IO ()
main = do
  -- Without a locale, the first character outside ASCII in a message (the program's
  -- own, or part of an argument) would end the program.
  encoding <- mkTextEncoding "UTF-8//ROUNDTRIP"
  mapM_ (`hSetEncoding` encoding) [stdout, stderr]
  arguments <- getArgs
  -- Films must release their claims, and --keep-partial still writes a file.
  let atOnce = take 1 arguments == ["render"] && "--keep-partial" `notElem` arguments
  stoppable atOnce (run arguments) >>= leave
