-- | Following light: a leapfrog step, and complete rays by both integrators.
module PathBench (benchmarks) where

import BlackHole.Spacetime.Fate
import BlackHole.Spacetime.LightPath
import BlackHole.Spacetime.Photon
import BlackHole.Spacetime.Schwarzschild.ExactPath
import BlackHole.Spacetime.Schwarzschild.Leapfrog
import BlackHole.Spacetime.Schwarzschild.StepRule
import BlackHole.Spacetime.Types
import BlackHole.Vector.XYZ (XYZ (..))
import Criterion.Main

benchmarks :: Benchmark
benchmarks =
  bgroup
    "path"
    [ bench "a thousand leapfrog steps" (whnf (leapfrogOf 1000) (aimedAt 5)),
      bgroup
        "leapfrog ray"
        [bench ("b = " ++ show b) (whnf (leapfrogOf 200000) (aimedAt b)) | b <- impacts],
      bgroup
        "exact ray past the gas"
        [bench ("b = " ++ show b) (whnf (exactOf slab) (aimedAt b)) | b <- impacts],
      bgroup
        "exact ray without gas"
        [bench ("b = " ++ show b) (whnf (exactOf emptyRegion) (aimedAt b)) | b <- impacts]
    ]
  where
    impacts = [2.7, 5, 50] :: [Double]

-- | A photon of unit energy at r = 100 with this impact parameter, moving inwards, 20°
-- out of the disk's plane.
aimedAt :: Double -> Photon
aimedAt b = Photon (tilted (XYZ p 0 (sqrt (10000 - p * p)))) (tilted (XYZ 0 0 (negate speed)))
  where
    speed = sqrt (1 + b * b / 1000000)
    p = b / speed
    tilted (XYZ x y z) = XYZ x (y * cos 0.35 - z * sin 0.35) (y * sin 0.35 + z * cos 0.35)

leapfrogOf :: Int -> Photon -> Fate XYZ
leapfrogOf limit photon =
  followedFate $
    followLeapfrog
      defaultLeapfrog {leapfrogSteps = rule, leapfrogStepLimit = limit}
      Schwarzschild
      emptyRegion
      photon
      (\() _ -> Continue ())
      ()
  where
    -- A low step limit measures the cost of a single step, so no step may be skipped.
    rule = if limit < 10000 then ReportSteps 1e-3 0.01 else reportStepRule

exactOf :: Region -> Photon -> Double
exactOf region photon =
  followedState
    (followExact Schwarzschild region photon (\s t -> Continue (s + segmentAffineLength t)) 0)

slab :: Region
slab = Region 12 0 0.3 0 0.13 0.02 1
