-- | The cost of one value of noise.
module NoiseBench (benchmarks) where

import BlackHole.Noise.Lattice (unitLevel)
import BlackHole.Noise.PerlinG (Seed (..), noise2, noise3, perlin2, perlin3)
import BlackHole.Noise.Profile (normalised, octaves)
import BlackHole.Noise.SipHash (SipKey (..), sipHash3)
import BlackHole.Vector.XY (XY (..))
import BlackHole.Vector.XYZ (XYZ (..))
import Criterion.Main (Benchmark, bench, bgroup, whnf)

benchmarks :: Benchmark
benchmarks =
  bgroup
    "noise"
    [ bench "SipHash-2-4 of three words" (whnf (sipHash3 (SipKey 1 2) 3 4) 5),
      bench "noise2" (whnf (noise2 seed unitLevel) (XY 1.3 (-2.7))),
      bench "noise3" (whnf (noise3 seed unitLevel) place),
      bench "perlin2, 4 levels" (whnf (perlin2 seed (cloud 4)) (XY 1.3 (-2.7))),
      bench "perlin3, 4 levels" (whnf (perlin3 seed (cloud 4)) place),
      bench "perlin3, 8 levels" (whnf (perlin3 seed (cloud 8)) place)
    ]
  where
    seed = Seed 42
    place = XYZ 1.3 (-2.7) 0.4
    cloud n = normalised (octaves unitLevel n 0.5)
