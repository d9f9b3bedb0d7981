{-# LANGUAGE BangPatterns #-}

-- | How many samples a pixel gets.
--
-- All pixels get the scene's number of samples. Those that are uncertain then, or
-- have a neighbour that is (thin things escape a pixel's few samples and hit those
-- of the next), get twice as many, and again, until they are certain or have the
-- most.
module BlackHole.Trace.Adaptive
  ( firstEstimate,
    refinedEstimate,
    uncertainEstimate,
    pixelEstimate,
  )
where

import BlackHole.Scene.Camera (Picture (..))
import BlackHole.Scene.Scene
import BlackHole.Trace.Estimate
import BlackHole.Trace.Pixel

-- | A pixel (column and row from the top left, from 0) after the samples that
-- every pixel gets.
firstEstimate :: Tracer -> Int -> Int -> Estimate
firstEstimate traced = addSamples traced 0 (sceneSamples (tracedScene traced)) noSamples

-- | @refinedEstimate traced uncertain first column row@: a pixel in the end, from
-- its own first estimate and whether those of it and its neighbours, by column and
-- row, are 'uncertainEstimate's, all as they are stored ('asStored').
refinedEstimate :: Tracer -> (Int -> Int -> Bool) -> Estimate -> Int -> Int -> Estimate
refinedEstimate traced uncertain first !column !row
  | anyFrom (max 0 (row - 1)) = moreSamples traced first column row
  | otherwise = first
  where
    Picture width height = scenePicture (tracedScene traced)
    !left = max 0 (column - 1)
    !right = min (width - 1) (column + 1)
    !bottom = min (height - 1) (row + 1)
    anyFrom !r = r <= bottom && (anyIn left r || anyFrom (r + 1))
    anyIn !c !r = c <= right && (uncertain c r || anyIn (c + 1) r)
{-# INLINE refinedEstimate #-}

-- | Whether an estimate is to be refined, from the scene's number of samples and
-- its 'estimateSeen' and 'estimateSeenSquare'.
uncertainEstimate :: Scene -> Double -> Double -> Bool
uncertainEstimate scene seen square = standardError (sceneSamples scene) seen square > sceneNoise scene
{-# INLINE uncertainEstimate #-}

moreSamples :: Tracer -> Estimate -> Int -> Int -> Estimate
moreSamples traced first !column !row = refined (sceneSamples scene) first
  where
    scene = tracedScene traced
    most = mostSamples scene
    refined !count estimate
      | count >= most = estimate
      | estimatedError more > sceneNoise scene = refined count' more
      | otherwise = more
      where
        count' = min most (max (count + 4) (2 * count))
        more = addSamples traced count count' estimate column row

-- | A pixel by itself: the same bits as in a film. Up to nine times the work.
pixelEstimate :: Tracer -> Int -> Int -> Estimate
pixelEstimate traced column row
  | mostSamples scene > sceneSamples scene = refinedEstimate traced uncertain (stored column row) column row
  | otherwise = firstEstimate traced column row
  where
    scene = tracedScene traced
    stored c r = asStored (firstEstimate traced c r)
    uncertain c r = let estimate = stored c r in uncertainEstimate scene (estimateSeen estimate) (estimateSeenSquare estimate)
