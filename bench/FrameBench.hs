-- | Complete small pictures, from scene to animation, on one core.
module FrameBench (benchmarks) where

import BlackHole.Render.Exposed
import BlackHole.Render.Film
import BlackHole.Render.Workers (oneWorker)
import BlackHole.Scene.Camera (Picture (..))
import BlackHole.Scene.Preset
import BlackHole.Scene.Scene
import Criterion.Main

benchmarks :: Benchmark
benchmarks =
  bgroup
    "frame of 64 × 36"
    [ frame "default" (small defaultScene),
      frame "report, leapfrog" (small reportScene),
      frame "report, exact" (small reportScene) {sceneIntegrator = Exact},
      frame "lensing alone" (small defaultScene) {sceneDisk = Nothing}
    ]
  where
    small scene = scene {scenePicture = Picture 64 36, sceneSamples = 1}
    frame name scene =
      bench
        name
        ( whnfIO
            (exposeFilm Nothing oneWorker (const (pure ())) scene (allRows (scenePicture scene)))
        )
