-- | The cost of the sky behind one sample, and of preparing it.
module SkyBench (benchmarks) where

import BlackHole.Light.Radiance
import BlackHole.Noise.PerlinG (Seed (..))
import BlackHole.Trace.EnvironmentMap
import BlackHole.Trace.MilkyWay
import BlackHole.Trace.RayDifferential
import BlackHole.Trace.RealSky
import BlackHole.Trace.SkyFiles
import BlackHole.Trace.StarCatalogue
import BlackHole.Trace.StarField
import BlackHole.Vector.XYZ (XYZ (..), (*^))
import qualified BlackHole.Vector.XYZ as XYZ
import Criterion.Main

benchmarks :: Benchmark
benchmarks =
  bgroup
    "sky"
    [ bench "catalogue of 60000 stars" (whnf (starCount . starCatalogue (Seed 1)) 60000),
      bench "arranging them" (whnf (\flux -> through (starField flux stars) (beams 8e-4)) 1),
      bench "decoding the real stars" (whnf (starCount . decodeStars) starBytes),
      bench
        "decoding the real Milky Way"
        (whnf (fmap environmentMapMean . decodeMilkyWay) milkyWayBytes),
      bench "random Milky Way" (whnf (luminance . environmentMapMean . milkyWay . Seed) 1),
      bench "1000 beams of a pixel, stars" (whnf (through field) (beams 8e-4)),
      bench "1000 beams of a pixel, Milky Way" (whnf (behind band) (beams 8e-4)),
      bench "1000 beams of 0.01 rad, stars" (whnf (through field) (beams 1e-2)),
      bench "1000 beams of 0.2 rad, stars" (whnf (through field) (beams 0.2)),
      bench "1000 beams of 0.02 by 0.2 rad, picture" (whnf (behind band) (map slender (beams 0.02)))
    ]
  where
    stars = starCatalogue (Seed 1) 60000
    field = starField 1 stars
    band = milkyWay (Seed 1)
    through :: StarField -> [RayDifferential] -> Double
    through f = sum . map (luminance . starFieldRadiance f 1)
    behind :: EnvironmentMap -> [RayDifferential] -> Double
    behind image = sum . map (luminance . environmentMapRadiance image)
    slender (RayDifferential d a b) = RayDifferential d (10 *^ a) b

-- | Beams of one width in radians, spread over the sky.
beams :: Double -> [RayDifferential]
beams width = map differential [0 .. 999 :: Int]
  where
    differential i =
      let y = 1 - (2 * fromIntegral i + 1) / 1000
          t = fromIntegral i * 2.399963229728653
          s = sqrt (1 - y * y)
          d = XYZ (s * cos t) y (s * sin t)
          a = XYZ (-(sin t)) 0 (cos t)
       in RayDifferential d (width *^ a) (width *^ XYZ.cross d a)
