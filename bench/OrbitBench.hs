-- | Closed-form light paths: the cost per ray, and the cost per point.
module OrbitBench (benchmarks) where

import BlackHole.Spacetime.Schwarzschild.Deflection
import BlackHole.Spacetime.Schwarzschild.Orbit
import Criterion.Main

-- | Setting up an orbit, evaluating points on it, and the deflection of light.
benchmarks :: Benchmark
benchmarks =
  bgroup
    "orbit"
    [ bgroup "set-up" [bench name (whnf setUp b) | (name, b) <- photons],
      bgroup "u" [bench name (whnf (orbitInverseRadius (setUp b)) 1.5) | (name, b) <- photons],
      bgroup
        "u and du/dφ"
        [ bench name (whnf (sumOf . orbitInverseRadiusAndSlope (setUp b)) 1.5)
          | (name, b) <- photons
        ],
      bgroup
        "60 points"
        [bench name (whnf (sixtyPoints (setUp b)) 0.02) | (name, b) <- photons],
      bgroup
        "deflection"
        [bench ("b = " ++ show b) (nf deflectionAngle b) | b <- [2.7, 5, 50 :: Double]]
    ]
  where
    sumOf (u, w) = u + w

-- | Photons moving inwards from a radius of 20, by impact parameter.
photons :: [(String, Double)]
photons =
  [ ("far, b = 10", 10),
    ("winding, b = 2.61", 2.61),
    ("falling, b = 2.5", 2.5),
    ("nearly radial, b = 0.001", 0.001)
  ]

setUp :: Double -> Orbit
setUp b = orbit 20 (-(sqrt (1 - b * b * 0.95 / 400))) (b / 20)

-- | About as many points as a marching ray evaluates.
sixtyPoints :: Orbit -> Double -> Double
sixtyPoints o step = go (60 :: Int) 0 0
  where
    go :: Int -> Double -> Double -> Double
    go 0 _ total = total
    go n phi total = total `seq` go (n - 1) (phi + step) (total + orbitInverseRadius o phi)
