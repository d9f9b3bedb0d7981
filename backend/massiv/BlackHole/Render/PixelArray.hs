{-# LANGUAGE RankNTypes #-}

-- | Arrays of pixels, filled row by row on several threads.
--
-- This is the back end on massiv's arrays and scheduler. The back end on plain storable
-- vectors exports the same names with the same meaning.
module BlackHole.Render.PixelArray
  ( PixelArray,
    backendName,
    pixelArrayShape,
    generateRows,
    fromPixelVector,
    toPixelVector,
  )
where

import BlackHole.Render.PixelShape
  ( PixelShape,
    shapeChannels,
    shapeHeight,
    shapeRowLength,
    shapeWidth,
  )
import BlackHole.Render.RowCount (withRowCount)
import BlackHole.Render.Workers (Workers, workersCount)
import Control.Monad.ST (ST, stToIO)
import Data.Foldable (for_)
import Data.Massiv.Array (Array, Comp (ParOn, Seq), Ix3, S, Storable, Sz (Sz3))
import qualified Data.Massiv.Array as Massiv
import Data.Massiv.Array.Manifest.Vector (castFromVector)
import Data.Vector.Storable (Vector)
import Data.Vector.Storable.Mutable (MVector)
import qualified Data.Vector.Storable.Mutable as MVector

-- | An immutable array of pixels in the order of "BlackHole.Render.PixelShape". The
-- film of linear light is a @PixelArray Float@ with three channels.
data PixelArray e = PixelArray !PixelShape !(Array S Ix3 e)

-- | The name of this back end: @"vector"@ or @"massiv"@.
backendName :: String
backendName = "massiv"

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
generateRows workers progress shape fillRow =
  withRowCount (shapeHeight shape) progress $ \rowFinished ->
    PixelArray shape
      <$> Massiv.createArray_
        -- Each worker is bound to a processor. Of 320 measured pictures, the free
        -- workers of 'ParN' rendered 6 on one processor alone, bound workers none.
        (ParOn [0 .. min (workersCount workers) (shapeHeight shape) - 1])
        (massivSize shape)
        ( \scheduler pixels ->
            for_ [0 .. shapeHeight shape - 1] $ \y ->
              Massiv.scheduleWork_ scheduler $ do
                stToIO . fillRow y $
                  MVector.slice
                    (y * shapeRowLength shape)
                    (shapeRowLength shape)
                    (Massiv.toStorableMVector pixels)
                rowFinished
        )

-- | An array of the given shape that shares the vector's memory; 'Nothing' if the
-- vector's length does not match the shape.
fromPixelVector :: Storable e => PixelShape -> Vector e -> Maybe (PixelArray e)
fromPixelVector shape =
  fmap (PixelArray shape) . castFromVector Seq (massivSize shape)

-- | All numbers in order, without copying.
toPixelVector :: PixelArray e -> Vector e
toPixelVector (PixelArray _ pixels) = Massiv.toStorableVector pixels

massivSize :: PixelShape -> Sz Ix3
massivSize shape = Sz3 (shapeHeight shape) (shapeWidth shape) (shapeChannels shape)
