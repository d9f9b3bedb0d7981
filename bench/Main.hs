-- | All benchmarks, one file per topic.
module Main (main) where

import Criterion.Main (defaultMain)
import OrbitBench (orbitBenchmarks)

main :: IO ()
main =
  defaultMain
    [ orbitBenchmarks
    ]
