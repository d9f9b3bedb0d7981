{-# LANGUAGE BangPatterns #-}

-- | The beam of a radio telescope: a Gaussian that blurs the picture.
module BlackHole.Render.Beam (beamBands) where

import BlackHole.Render.PixelArray
import BlackHole.Render.PixelShape
import BlackHole.Render.Pyramid
import BlackHole.Render.Workers (Workers)
import qualified Data.Vector.Storable as Vector
import qualified Data.Vector.Storable.Mutable as MVector

-- | @beamBands workers sigma shape rowsOf@: the film with its light convolved with a
-- Gaussian of this standard deviation in pixels. With 0 it is the film itself. At the edges
-- it is the mean over the part of the Gaussian within the picture, so that a uniform picture
-- stays uniform. Pixels without a finite radiance stay as they are and spread nothing. The
-- time hardly depends on the width: the Gaussian acts on a coarser copy of the film, on
-- which its standard deviation is 2 to 4 pixels. The weights of the copy's pixels add
-- 1/2 pixel² to the variance, of which the Gaussian has that much less. Rows are asked for
-- as in 'BlackHole.Render.Bloom.bloomBands'.
beamBands :: Workers -> Double -> PixelShape -> FilmBands -> IO (Maybe FilmBands)
beamBands workers sigma shape rowsOf
  | sigma > 0 = finestEnergy workers shape rowsOf >>= traverse spread
  | otherwise = pure (Just rowsOf)
  where
    spread energy = do
      blurred <-
        blurredFrom
          1
          (coarserAxis (finestAxis (shapeWidth shape)))
          (coarserAxis (finestAxis (shapeHeight shape)))
          energy
      pure (withSpread workers shape (1 - part) part blurred rowsOf)
    -- The first level alone has a variance of 1.5; a narrower beam takes less of it.
    part = realToFrac (min 1 (sigma * sigma / 1.5)) :: Float
    depth = max 1 (floor (logBase 2 (sigma / 2)))
    blurredFrom :: Int -> Axis -> Axis -> PixelArray Float -> IO (PixelArray Float)
    blurredFrom level across down energy
      | level < depth = do
        coarser <-
          shrunk workers energy >>= blurredFrom (level + 1) (coarserAxis across) (coarserAxis down)
        enlarged workers (pixelArrayShape energy) coarser
      | otherwise = convolved workers (kernel level) across down energy
    kernel level =
      let size = 4 ^ level
          variance = max 0 ((sigma * sigma - 0.5 * (size - 1)) / size) :: Double
          reach = ceiling (5 * sqrt variance) :: Int
       in if variance < 0.5
            then
              Vector.map
                realToFrac
                (Vector.fromList [0.5 * variance, 1 - variance, 0.5 * variance])
            else
              Vector.generate
                (2 * reach + 1)
                ( \i ->
                    let d = fromIntegral (i - reach) in realToFrac (exp (-0.5 * d * d / variance))
                )

-- | Means per finest pixel from a level's energy, under a kernel along both sides.
convolved ::
  Workers -> Vector.Vector Float -> Axis -> Axis -> PixelArray Float -> IO (PixelArray Float)
convolved workers kernel (Axis across) (Axis down) energy = do
  lines' <- generateRows workers (const (pure ())) shape $ \y row ->
    pixels $ \i x k ->
      MVector.unsafeWrite
        row
        i
        ( total
            across
            x
            (\x' -> Vector.unsafeIndex (toPixelVector energy) (3 * (width * y + x') + k))
        )
  generateRows workers (const (pure ())) shape $ \y row ->
    pixels $ \i x k ->
      MVector.unsafeWrite
        row
        i
        (total down y (\y' -> Vector.unsafeIndex (toPixelVector lines') (3 * (width * y' + x) + k)))
  where
    shape = pixelArrayShape energy
    width = shapeWidth shape
    reach = Vector.length kernel `quot` 2
    pixels act = mapM_ (\i -> act i (i `quot` 3) (i `rem` 3)) [0 .. 3 * width - 1]
    -- The weighted mean around a point of a row or column.
    total weights at value = go (max 0 (at - reach)) 0 0
      where
        !end = min (Vector.length weights - 1) (at + reach)
        go !j !amount !weight
          | j > end = amount / weight
          | otherwise =
            let w =
                  Vector.unsafeIndex kernel (j - at + reach)
             in go (j + 1) (amount + w * value j) (weight + w * Vector.unsafeIndex weights j)
    {-# INLINE total #-}
