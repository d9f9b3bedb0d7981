-- | All benchmarks, one file per topic; with @--table PROGRAM@, the table of the
-- program's speed and accuracy, and with @--quality@, the error of its sampling.
module Main (main) where

import Criterion.Main (defaultMain)
import qualified FilmBench
import qualified FrameBench
import qualified GasBench
import qualified LensBench
import qualified LightBench
import qualified NoiseBench
import qualified OrbitBench
import qualified PathBench
import Quality (printQuality)
import qualified SkyBench
import System.Environment (getArgs)
import System.IO (hSetEncoding, stdout, utf8)
import Table (printSpinTable, printTable)

main :: IO ()
main = do
  hSetEncoding stdout utf8
  arguments <- getArgs
  case arguments of
    ["--quality"] -> printQuality
    "--table" : program : rest | "--spin" `elem` rest -> printSpinTable program
    "--table" : program : rest -> printTable program ("--huge" `elem` rest)
    _ ->
      defaultMain
        [ NoiseBench.benchmarks,
          OrbitBench.benchmarks,
          LensBench.benchmarks,
          PathBench.benchmarks,
          LightBench.benchmarks,
          GasBench.benchmarks,
          SkyBench.benchmarks,
          FrameBench.benchmarks,
          FilmBench.benchmarks
        ]
