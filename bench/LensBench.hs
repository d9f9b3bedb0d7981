-- | The table of a camera's light paths: building it, and one lookup.
module LensBench (benchmarks) where

import BlackHole.Spacetime.Schwarzschild.LensTable
import BlackHole.Spacetime.Schwarzschild.Orbit
import BlackHole.Spacetime.Schwarzschild.OrbitSeries
import Criterion.Main

benchmarks :: Benchmark
benchmarks =
  bgroup
    "lens table"
    [ bgroup
        "make"
        [ bench ("r = " ++ show r) (whnf (lensTableSize . lensTable) r)
          | r <- [0.5, 2, 30 :: Double]
        ],
      bgroup
        "look up"
        [ bench name (whnf (seriesAngle . uncurry (lensSeries table)) photon)
          | (name, photon) <- photons
        ],
      bgroup
        "look up, and a place on the path"
        [ bench name (whnf (placeOn . uncurry (lensSeries table)) photon)
          | (name, photon) <- photons
        ],
      bgroup
        "the same from the closed form"
        [ bench name (whnf (placeOn . orbitSeries . uncurry (orbit 30)) photon)
          | (name, photon) <- photons
        ],
      bench "a place on a path that is known" (whnf (expansionValue (expand 1.5 0.1 0.2)) 0.1)
    ]
  where
    table = lensTable 30

-- | Photons by the angle from the outward radius, for an observer at rest at r = 30.
photons :: [(String, (Double, Double))]
photons =
  [ (name, (cos psi, sin psi / sqrt (1 - 1 / 30)))
    | (name, psi) <- [("far", 2.4), ("winding", 3.056), ("falling", 3.1)]
  ]

placeOn :: OrbitSeries -> Double
placeOn series = expansionValue (expand 1.5 u slope) 0.1
  where
    (u, slope) =
      waypoint (seriesWaypoints series) (seriesSpacing series) (seriesCells series `quot` 2)
