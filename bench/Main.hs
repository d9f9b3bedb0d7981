-- | All benchmarks, one file per topic.
module Main (main) where

import Criterion.Main (defaultMain)

main :: IO ()
main = defaultMain []
