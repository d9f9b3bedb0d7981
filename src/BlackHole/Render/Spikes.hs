{-# LANGUAGE BangPatterns #-}

-- | Diffraction spikes: the rays around bright points in pictures from telescopes and
-- lenses with straight edges in their aperture.
--
-- An edge diffracts light along the line across it. An aperture with an even number of
-- blades makes as many spikes, one with an odd number twice as many.
module BlackHole.Render.Spikes (spikeBands) where

import BlackHole.Render.PixelArray
import BlackHole.Render.PixelShape
import BlackHole.Render.Pyramid
import BlackHole.Render.Shared (mapShared)
import BlackHole.Render.Workers (Workers)
import Data.Vector.Storable (Vector)
import qualified Data.Vector.Storable as Vector

-- | @spikeBands workers blades strength shape rowsOf@: the film with this part of its
-- light, 0 to 1, in the spikes of an aperture with this many blades; with 0 blades the film
-- itself. The spikes cover the same part of the picture at any resolution, for they are
-- drawn on the first copy of the film at most 1024 pixels wide and high. Light that leaves
-- the picture along them is lost. Rows are asked for as in
-- 'BlackHole.Render.Bloom.bloomBands'.
spikeBands :: Workers -> Int -> Double -> PixelShape -> FilmBands -> IO (Maybe FilmBands)
spikeBands workers blades strength shape rowsOf
  | blades > 0 && strength > 0 = finestEnergy workers shape rowsOf >>= traverse spread
  | otherwise = pure (Just rowsOf)
  where
    spread energy = do
      spiked <-
        spikesFrom
          (coarserAxis (finestAxis (shapeWidth shape)))
          (coarserAxis (finestAxis (shapeHeight shape)))
          energy
      pure (withSpread workers shape (1 - part) part spiked rowsOf)
    part = realToFrac strength :: Float
    spikesFrom across down energy
      | max (shapeWidth size) (shapeHeight size) > 1024 = do
        coarser <- shrunk workers energy >>= spikesFrom (coarserAxis across) (coarserAxis down)
        enlarged workers size coarser
      | otherwise = do
        spikes <-
          mapShared workers (pure . spike size (meanLight across down energy)) (spikeAngles blades)
        pure $ case ( spikes,
                      fromPixelVector
                        size
                        ( foldr1
                            (Vector.zipWith (+))
                            (map (Vector.map (/ fromIntegral (length spikes))) spikes)
                        )
                    ) of
          (_ : _, Just summed) -> summed
          _ -> energy
      where
        size = pixelArrayShape energy

-- | Directions of the spikes, in radians from screen-up; an upright one among them.
spikeAngles :: Int -> [Double]
spikeAngles blades = [2 * pi * fromIntegral k / fromIntegral count | k <- [0 .. count - 1]]
  where
    count = if even blades then blades else 2 * blades

-- | Light per pixel of the film.
meanLight :: Axis -> Axis -> PixelArray Float -> Vector Float
meanLight (Axis across) (Axis down) energy =
  Vector.imap
    ( \i v ->
        let (y, x) =
              (i `quot` 3) `quotRem` Vector.length across
         in v / (Vector.unsafeIndex across x * Vector.unsafeIndex down y)
    )
    (toPixelVector energy)

-- | All light smeared in one direction, by a sum of two exponentials: short and bright,
-- long and faint. Adding to the light itself, moved by a step and dimmed, makes the first
-- two terms of an exponential; adding to these themselves, moved by two steps, makes four,
-- and so on. So few moves keep the spikes thin.
spike :: PixelShape -> Vector Float -> Double -> Vector Float
spike size light angle =
  Vector.zipWith (+) (smeared 0.7 (0.006 * longest)) (smeared 0.3 (0.05 * longest))
  where
    width = shapeWidth size
    height = shapeHeight size
    longest = fromIntegral (max width height)
    (right, down) = (sin angle, negate (cos angle))
    -- A step is one pixel along the axis that is nearer to the direction.
    steep = abs down >= abs right
    (acrossStep, downStep) =
      if steep then (right / abs down, signum down) else (signum right, down / abs right)
    smeared :: Float -> Double -> Vector Float
    smeared part len = go 1 light
      where
        kept = exp (negate (sqrt (acrossStep * acrossStep + downStep * downStep)) / len)
        go :: Int -> Vector Float -> Vector Float
        go steps terms
          | faded < 1e-3 = Vector.map (part * realToFrac (1 - kept) *) terms
          | otherwise = go (2 * steps) (moved (fromIntegral steps) (realToFrac faded) terms)
          where
            faded = kept ^ steps
    -- With what lies so many steps back, between two pixels, dimmed and added.
    moved :: Double -> Float -> Vector Float -> Vector Float
    moved steps faded terms = Vector.imap (\i v -> v + faded * behind i) terms
      where
        (lineShift, placeShift) =
          if steep
            then (steps * downStep, steps * acrossStep)
            else (steps * acrossStep, steps * downStep)
        !lines' = if steep then height else width
        !places = if steep then width else height
        !stride = if steep then 3 else 3 * width
        !lineStride = if steep then 3 * width else 3
        !back = round lineShift :: Int
        !first = floor (negate placeShift) :: Int
        !part = realToFrac (negate placeShift - fromIntegral first) :: Float
        behind i
          | line < 0 || line >= lines' = 0
          | otherwise = (1 - part) * at (place + first) + part * at (place + first + 1)
          where
            (pixel, k) = i `quotRem` 3
            (y, x) = pixel `quotRem` width
            line = (if steep then y else x) - back
            place = if steep then x else y
            at p =
              if p < 0 || p >= places
                then 0
                else Vector.unsafeIndex terms (k + lineStride * line + stride * p)
