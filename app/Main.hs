-- | The program @blackhole@.
module Main (main) where

import BlackHole.Cli.Leave (leave)
import BlackHole.Cli.Run (run)
import BlackHole.Cli.Signals (stoppable)
import System.Environment (getArgs)
import System.IO (hSetEncoding, mkTextEncoding, stderr, stdout)

main :: IO ()
main = do
  -- Without a locale, a message would end the program at the first letter
  -- outside ASCII: one of its own, or one of an argument that it repeats.
  encoding <- mkTextEncoding "UTF-8//ROUNDTRIP"
  mapM_ (`hSetEncoding` encoding) [stdout, stderr]
  arguments <- getArgs
  -- Films give back their claims, and a picture's part may be wanted.
  let atOnce = take 1 arguments == ["render"] && "--keep-partial" `notElem` arguments
  stoppable atOnce (run arguments) >>= leave
