-- | All benchmarks, one file per topic.
module Main (main) where

import Criterion.Main (defaultMain)
import qualified FilmBench
import qualified FrameBench
import qualified LightBench
import qualified NoiseBench
import qualified OrbitBench
import qualified PathBench
import qualified SkyBench

main :: IO ()
main =
  defaultMain
    [ NoiseBench.benchmarks,
      OrbitBench.benchmarks,
      PathBench.benchmarks,
      LightBench.benchmarks,
      SkyBench.benchmarks,
      FrameBench.benchmarks,
      FilmBench.benchmarks
    ]
