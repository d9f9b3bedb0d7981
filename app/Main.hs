-- | The program @blackhole@.
module Main (main) where

import BlackHole.Cli.Run (run)
import System.Environment (getArgs)
import System.Exit (exitWith)

main :: IO ()
main = getArgs >>= run >>= exitWith
