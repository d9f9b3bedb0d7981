{-# LANGUAGE BangPatterns #-}

-- | The cost of colour, temperature and shift of a gas sample.
module LightBench (benchmarks) where

import BlackHole.Light.BlackBody
import BlackHole.Light.BlackBodyTable
import BlackHole.Light.Radiance
import BlackHole.Matter.GasFlow
import BlackHole.Matter.Redshift
import BlackHole.Matter.ThinDisk
import BlackHole.Spacetime.Kerr.Landmarks (noSpin)
import BlackHole.Spacetime.Momentum
import BlackHole.Spacetime.Types
import Criterion.Main

benchmarks :: Benchmark
benchmarks =
  bgroup
    "light"
    [ bench "black-body colour, exact" (whnf blackBodyColour 4321),
      bench "black-body colour, table" (whnf tabulatedColour 4321),
      bench "black-body radiance, bolometric" $
        whnf (luminance . blackBodyRadiance Bolometric 4500) 4321,
      bench "black-body radiance, visible" $
        let radiance = blackBodyRadiance Visible 4500
         in whnf (luminance . radiance) 4321,
      bench "Page-Thorne temperature, r = 3.1" (whnf temperature 3.1),
      bench "Page-Thorne temperature, r = 7" (whnf temperature 7),
      bench "redshift, orbit" (whnf shift 7),
      bench "redshift, plunge" (whnf shift 2)
    ]
  where
    !temperature = relativeTemperature (thinDisk noSpin)
    flow = gasFlow Schwarzschild
    shift r = redshiftFactor (redshift 1 (gasFrequencies flow r 0.1 (Momentum 0.3 0.9)))
