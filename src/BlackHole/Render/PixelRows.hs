{-# LANGUAGE RankNTypes #-}

-- | Access to rows of pixel arrays, and row-by-row conversion of one array into
-- another.
module BlackHole.Render.PixelRows
  ( pixelRow,
    pixelChannels,
    mapRows,
    convertedRows,
  )
where

import BlackHole.Render.PixelArray
  ( PixelArray,
    fromPixelVector,
    generateRows,
    pixelArrayShape,
    toPixelVector,
  )
import BlackHole.Render.PixelShape
  ( shapeChannels,
    shapeHeight,
    shapeLength,
    shapeRowLength,
    shapeWidth,
  )
import BlackHole.Render.Workers (Workers)
import Control.Monad.ST (ST)
import Data.Foldable (for_)
import Data.Vector.Storable (Storable, Vector)
import qualified Data.Vector.Storable as Vector
import Data.Vector.Storable.Mutable (MVector)
import qualified Data.Vector.Storable.Mutable as MVector

-- | The numbers of row @y@ (0 is the top row), width × channels of them, without
-- copying; 'Nothing' outside the array.
pixelRow :: Storable e => PixelArray e -> Int -> Maybe (Vector e)
pixelRow pixels y
  | y < 0 || y >= shapeHeight shape = Nothing
  | otherwise =
    Just $ Vector.slice (y * shapeRowLength shape) (shapeRowLength shape) (toPixelVector pixels)
  where
    shape = pixelArrayShape pixels

-- | @pixelChannels pixels x y@ are the channels of the pixel in column @x@ of row @y@,
-- both counted from 0 at the top left, without copying; 'Nothing' outside the array.
pixelChannels :: Storable e => PixelArray e -> Int -> Int -> Maybe (Vector e)
pixelChannels pixels x y
  | x < 0 || x >= shapeWidth shape = Nothing
  | otherwise = Vector.slice (x * shapeChannels shape) (shapeChannels shape) <$> pixelRow pixels y
  where
    shape = pixelArrayShape pixels

-- | @mapRows workers convert pixels@ is an array of equal shape whose rows are computed
-- by @convert y old new@: row number, numbers to read, numbers to write. This turns
-- light into codes. Threads and exceptions behave as in 'generateRows'.
mapRows ::
  (Storable a, Storable b) =>
  Workers ->
  (forall s. Int -> Vector a -> MVector s b -> ST s ()) ->
  PixelArray a ->
  IO (PixelArray b)
mapRows workers convert pixels =
  generateRows workers (const (pure ())) (pixelArrayShape pixels) $ \y new ->
    for_ (pixelRow pixels y) $ \old -> convert y old new

-- | The result of 'mapRows', computed on the caller's thread. For workers that convert
-- a few rows themselves.
convertedRows ::
  (Storable a, Storable b, Num b) =>
  (forall s. Int -> Vector a -> MVector s b -> ST s ()) ->
  PixelArray a ->
  Maybe (PixelArray b)
convertedRows convert pixels =
  fromPixelVector shape $
    Vector.create $ do
      made <- MVector.replicate (shapeLength shape) 0
      for_ [0 .. shapeHeight shape - 1] $ \y ->
        for_ (pixelRow pixels y) $ \old ->
          convert y old (MVector.slice (y * shapeRowLength shape) (shapeRowLength shape) made)
      pure made
  where
    shape = pixelArrayShape pixels
