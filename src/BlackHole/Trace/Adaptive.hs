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

-- | @refinedEstimate traced first column row@: a pixel in the end, from the first
-- estimates of it and its neighbours, as they are stored ('asStored').
refinedEstimate :: Tracer -> (Int -> Int -> Estimate) -> Int -> Int -> Estimate
refinedEstimate traced first !column !row
  | any uncertain [first c r | r <- rows, c <- columns] = refined (sceneSamples scene) here
  | otherwise = here
  where
    scene = tracedScene traced
    Picture width height = scenePicture scene
    columns = [max 0 (column - 1) .. min (width - 1) (column + 1)]
    rows = [max 0 (row - 1) .. min (height - 1) (row + 1)]
    here = first column row
    most = mostSamples scene
    uncertain estimate = estimatedError estimate > sceneNoise scene
    refined !count estimate
      | count >= most = estimate
      | uncertain more = refined count' more
      | otherwise = more
      where
        count' = min most (max (count + 4) (2 * count))
        more = addSamples traced count count' estimate column row

-- | A pixel by itself: the same bits as in a film. Up to nine times the work.
pixelEstimate :: Tracer -> Int -> Int -> Estimate
pixelEstimate traced column row
  | mostSamples scene > sceneSamples scene = refinedEstimate traced (\c r -> asStored (firstEstimate traced c r)) column row
  | otherwise = firstEstimate traced column row
  where
    scene = tracedScene traced
