{-# LANGUAGE BangPatterns #-}

-- | Adaptive sampling: the number of samples of each pixel.
--
-- Every pixel first gets the scene's number of samples. A pixel that is then uncertain,
-- or has an uncertain neighbour, gets twice as many, and again, until it is certain or
-- has reached the maximum. Neighbours count because thin structures can escape the few
-- samples of one pixel and hit those of the next. Pixels on the edge of the shadow
-- always get the maximum: the third image of the gas is a tenth of a pixel wide, and
-- too many pixels would miss it altogether.
module BlackHole.Trace.Adaptive
  ( firstEstimate,
    refinedEstimate,
    uncertainEstimate,
    pixelEstimate,
    pixelSamples,
  )
where

import BlackHole.Scene.Camera (Picture (..), closesAround)
import BlackHole.Scene.Scene
import BlackHole.Trace.Estimate
import BlackHole.Trace.PhotonRing
import BlackHole.Trace.Pixel
import BlackHole.Trace.Sampling (Sample)
import BlackHole.Trace.Tracer
import BlackHole.Vector.XY (XY (..))

-- | The estimate of a pixel (column and row from the top left, counted from 0) after
-- the samples that every pixel gets.
firstEstimate :: Tracer -> Int -> Int -> Estimate
firstEstimate traced = addSamples traced 0 (sceneSamples (tracerScene traced)) noSamples

-- | @refinedEstimate traced uncertain first column row@ is the final estimate of a
-- pixel, from its first estimate and a function that says, by column and row, whether
-- the first estimates of it and its neighbours are 'uncertainEstimate's. Both use the
-- values as stored ('asStored').
refinedEstimate :: Tracer -> (Int -> Int -> Bool) -> Estimate -> Int -> Int -> Estimate
refinedEstimate traced uncertain first !column !row
  | Just ring <- pixelRing traced column row = addRingSamples traced ring 0 (mostSamples scene) noSamples column row
  | anyFrom (max 0 (row - 1)) = moreSamples traced first column row
  | otherwise = first
  where
    scene = tracerScene traced
    Picture width height = scenePicture scene
    -- Where a picture closes around the sphere its last column is the first one's
    -- neighbour.
    !closed = closesAround (sceneProjection scene) (sceneCamera scene)
    !left = if closed then column - 1 else max 0 (column - 1)
    !right = if closed then column + 1 else min (width - 1) (column + 1)
    !bottom = min (height - 1) (row + 1)
    anyFrom !r = r <= bottom && (anyIn left r || anyFrom (r + 1))
    anyIn !c !r = c <= right && (uncertain (inside c) r || anyIn (c + 1) r)
    inside c
      | c < 0 = width - 1
      | c >= width = 0
      | otherwise = c
{-# INLINE refinedEstimate #-}

-- | The photon ring at a pixel.
pixelRing :: Tracer -> Int -> Int -> Maybe PhotonRing
pixelRing traced column row = photonRing traced (XY (fromIntegral column + 0.5) (fromIntegral row + 0.5))

-- | The first samples of a pixel's 'pixelEstimate', up to this number.
pixelSamples :: Tracer -> Int -> Int -> Int -> [Sample]
pixelSamples traced count column row = map point [0 .. count - 1]
  where
    scene = tracerScene traced
    point = case pixelRing traced column row of
      Just ring | mostSamples scene > sceneSamples scene -> ringPoint traced ring column row
      _ -> samplePoint scene column row

-- | Whether an estimate needs refinement, from the scene's number of samples, its
-- 'estimateSeen' and its 'estimateSeenSquare'.
uncertainEstimate :: Scene -> Double -> Double -> Bool
uncertainEstimate scene seen square = standardError (sceneSamples scene) seen square > sceneNoise scene
{-# INLINE uncertainEstimate #-}

moreSamples :: Tracer -> Estimate -> Int -> Int -> Estimate
moreSamples traced first !column !row = refined (sceneSamples scene) first
  where
    scene = tracerScene traced
    most = mostSamples scene
    refined !count estimate
      | count >= most = estimate
      | estimatedError more > sceneNoise scene = refined count' more
      | otherwise = more
      where
        count' = min most (max (count + 4) (2 * count))
        more = addSamples traced count count' estimate column row

-- | The final estimate of a single pixel, bit-identical to the one in a film. Takes up
-- to nine times as long as in a film.
pixelEstimate :: Tracer -> Int -> Int -> Estimate
pixelEstimate traced column row
  | mostSamples scene > sceneSamples scene = refinedEstimate traced uncertain (stored column row) column row
  | otherwise = firstEstimate traced column row
  where
    scene = tracerScene traced
    stored c r = asStored (firstEstimate traced c r)
    uncertain c r = let estimate = stored c r in uncertainEstimate scene (estimateSeen estimate) (estimateSeenSquare estimate)
