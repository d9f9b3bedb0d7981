{-# LANGUAGE BangPatterns #-}
{-# OPTIONS_GHC -fmax-worker-args=64 #-}

-- | The samples of a pixel, as a pure function of the scene.
module BlackHole.Trace.Pixel
  ( addSamples,
    addSamplesToThree,
    onlySample,
    samplePoint,
  )
where

import BlackHole.Light.Radiance
import BlackHole.Scene.Scene
import BlackHole.Trace.Estimate
import BlackHole.Trace.Ray
import BlackHole.Trace.Sampling
import BlackHole.Trace.SkyLight
import BlackHole.Trace.Tracer
import GHC.Exts (lazy)

-- | @addSamples traced from to estimate column row@ is the estimate with the pixel's
-- samples numbered @from@ to @to − 1@ added.
addSamples :: Tracer -> Int -> Int -> Estimate -> Int -> Int -> Estimate
addSamples prepared from to estimate column row = go from estimate
  where
    traced = lazy prepared
    shared = pixelSky traced column row
    go !index !sums
      | index < to =
        let Sample place weight = samplePoint (tracerScene traced) column row index
         in go
              (index + 1)
              (addSample (tracerGain traced) weight (sharingRadiance traced shared place) sums)
      | otherwise = sums

-- | 'addSamples' for three pixels in a row, starting at a column.
addSamplesToThree ::
  Tracer ->
  Int ->
  Int ->
  Estimate ->
  Estimate ->
  Estimate ->
  Int ->
  Int ->
  (Estimate, Estimate, Estimate)
addSamplesToThree traced from to estimate0 estimate1 estimate2 column row =
  case sceneIntegrator scene of
    Leapfrogging | Nothing <- tracerLens traced -> go from estimate0 estimate1 estimate2
    _ -> (single estimate0 column, single estimate1 (column + 1), single estimate2 (column + 2))
  where
    scene = tracerScene traced
    single estimate c = addSamples traced from to estimate c row
    go !index !sums0 !sums1 !sums2
      | index < to =
        let Sample p0 w0 = samplePoint scene column row index
            Sample p1 w1 = samplePoint scene (column + 1) row index
            Sample p2 w2 = samplePoint scene (column + 2) row index
            (r0, r1, r2) = threeSights traced p0 p1 p2
            add = addSample (tracerGain traced)
         in go (index + 1) (add w0 r0 sums0) (add w1 r1 sums1) (add w2 r2 sums2)
      | otherwise = (sums0, sums1, sums2)

-- | The estimate of 'addSamples' from a single sample: its radiance, with neither
-- weights nor the negative values that a filter or a sum might produce.
onlySample :: Tracer -> Int -> Int -> Radiance
onlySample traced column row = mapRadiance (max 0) (sightRadiance traced place)
  where
    Sample place _ = samplePoint (tracerScene traced) column row 0
{-# INLINE onlySample #-}

-- | One of a pixel's samples, by column, row and sample number.
samplePoint :: Scene -> Int -> Int -> Int -> Sample
samplePoint scene = sampleOf (sceneFilter scene) (sceneSeed scene) (mostSamples scene)
