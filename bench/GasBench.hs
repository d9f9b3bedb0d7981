-- | The cost of a sample of the gas, and of the noise in it.
module GasBench (benchmarks) where

import BlackHole.Scene.Disk
import BlackHole.Scene.Preset
import BlackHole.Scene.Shifts
import BlackHole.Spacetime.LightPath
import BlackHole.Spacetime.Photon
import BlackHole.Spacetime.Types (Spacetime (Schwarzschild))
import BlackHole.Trace.Gas
import BlackHole.Vector.XYZ (XYZ (..))
import Criterion.Main
import GasPlaces

benchmarks :: Benchmark
benchmarks =
  bgroup
    "gas"
    [ bgroup
        "one sample"
        [ bench name (whnf (transparency . gatherGas (made disk) 1 nothingYet) segment)
          | (name, disk) <-
              [ ("default", defaultDisk),
                ("smooth", defaultDisk {diskArms = 0, diskTurbulence = 0}),
                ("report", reportDisk)
              ]
        ],
      env (pure (placesOf 20000 defaultScene)) $ \places ->
        bgroup
          "noise at 20000 places of the default disk"
          [ bgroup
              (fieldName field)
              [ bench "remembered" (whnf (total (fieldCached field) places) 0),
                bench "hashed" (whnf (total (fieldHashed field) places) 0)
              ]
            | field <- fields defaultDisk
          ]
    ]
  where
    made disk = gas Schwarzschild 0 (Shifts True True) disk (XYZ 0 5 30) 1e-3
    segment = planarSegment (Photon (XYZ 4 0.005 2) (XYZ 0.1 (-0.9) 0.3)) 0.01
    transparency (Continue g) = gatheredTransmittance g
    transparency (Stop g) = gatheredTransmittance g
