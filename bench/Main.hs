-- | All benchmarks, one file per topic.
module Main (main) where

import Criterion.Main (defaultMain)
import qualified LightBench
import qualified NoiseBench

main :: IO ()
main = defaultMain [LightBench.benchmarks, NoiseBench.benchmarks]
