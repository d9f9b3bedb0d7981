-- | The program @blackhole@.
module Main (main) where

main :: IO ()
main = pure ()
