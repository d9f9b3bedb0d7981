-- | The cost of colour, temperature and shift of a gas sample.
module LightBench (benchmarks) where

import BlackHole.Light.BlackBody
import BlackHole.Light.BlackBodyTable
import BlackHole.Light.Radiance
import BlackHole.Matter.Redshift
import BlackHole.Matter.ThinDisk
import BlackHole.Vector.XYZ (XYZ (..))
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
      bench "Page-Thorne temperature, r = 3.1" (whnf relativeTemperature 3.1),
      bench "Page-Thorne temperature, r = 7" (whnf relativeTemperature 7),
      bench "redshift, orbit" (whnf shift 7),
      bench "redshift, plunge" (whnf shift 2)
    ]
  where
    shift r = gasRedshift distantObserver (XYZ r 0.1 0.3) (XYZ 0.3 0.2 0.9)
