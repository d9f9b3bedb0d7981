{-# LANGUAGE RankNTypes #-}

-- | Arrays of pixels, filled row by row on several threads.
--
-- This is the back end on plain storable vectors with a shared row counter. The back
-- end on massiv exports the same names with the same meaning.
module BlackHole.Render.PixelArray
  ( PixelArray,
    backendName,
    pixelArrayShape,
    generateRows,
    fromPixelVector,
    toPixelVector,
  )
where

import BlackHole.Render.PixelShape (PixelShape, shapeHeight, shapeLength, shapeRowLength)
import BlackHole.Render.RowCount (withRowCount)
import BlackHole.Render.Workers (Workers, onWorkers)
import Control.Monad (when)
import Control.Monad.ST (RealWorld, ST, stToIO)
import Data.IORef (atomicModifyIORef', newIORef)
import Data.Vector.Storable (Storable, Vector)
import qualified Data.Vector.Storable as Vector
import Data.Vector.Storable.Mutable (MVector)
import qualified Data.Vector.Storable.Mutable as MVector
import Data.Word (Word8)

-- | An immutable array of pixels in the order of "BlackHole.Render.PixelShape". The
-- film of linear light is a @PixelArray Float@ with three channels.
data PixelArray e = PixelArray !PixelShape !(Vector e)

-- | The name of this back end: @"vector"@ or @"massiv"@.
backendName :: String
backendName = "vector"

-- | Width, height and channels.
pixelArrayShape :: PixelArray e -> PixelShape
pixelArrayShape (PixelArray shape _) = shape

-- | @generateRows workers progress shape fillRow@ makes an array by running @fillRow y
-- row@ once for each row @y@, from 0 at the top to height − 1. @row@ is that row's part
-- of the array, width × channels numbers, initially zero.
--
-- Each worker takes the next row as soon as it is free, so rows of unequal cost keep
-- all workers busy. The contents do not depend on the number of workers.
-- 'BlackHole.Render.Workers.withWorkers' determines how many run at the same time.
--
-- One thread calls @progress@ with increasing counts of finished rows, the last of
-- which is the height. Counts are skipped while a call is running.
--
-- An exception in a row or in @progress@ stops all workers and is rethrown to the
-- caller. An exception thrown to the caller (an interrupt or a time limit) also stops
-- them. Workers then abandon their rows midway. Only a row that allocates no memory at
-- all cannot be interrupted and is finished first.
--
-- Beyond the array, the function needs at most a small constant of memory per row.
generateRows ::
  Storable e =>
  Workers ->
  (Int -> IO ()) ->
  PixelShape ->
  (forall s. Int -> MVector s e -> ST s ()) ->
  IO (PixelArray e)
generateRows workers progress shape fillRow = do
  -- Each worker clears a row before filling it, so that all workers touch the memory of
  -- a huge picture at the same time.
  pixels <- MVector.unsafeNew (shapeLength shape)
  nextRow <- newIORef 0
  let worker :: IO () -> IO ()
      worker rowFinished = do
        y <- atomicModifyIORef' nextRow $ \next -> (next + 1, next)
        when (y < shapeHeight shape) $ do
          let row = MVector.slice (y * shapeRowLength shape) (shapeRowLength shape) pixels
          MVector.set (MVector.unsafeCast row :: MVector RealWorld Word8) 0
          stToIO (fillRow y row)
          rowFinished
          worker rowFinished
  withRowCount (shapeHeight shape) progress $
    onWorkers workers (shapeHeight shape) . worker
  PixelArray shape <$> Vector.unsafeFreeze pixels

-- | An array of the given shape that shares the vector's memory; 'Nothing' if the
-- vector's length does not match the shape.
fromPixelVector :: Storable e => PixelShape -> Vector e -> Maybe (PixelArray e)
fromPixelVector shape pixels
  | Vector.length pixels == shapeLength shape = Just (PixelArray shape pixels)
  | otherwise = Nothing

-- | All numbers in order, without copying.
toPixelVector :: PixelArray e -> Vector e
toPixelVector (PixelArray _ pixels) = pixels
