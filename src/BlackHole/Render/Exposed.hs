{-# LANGUAGE BangPatterns #-}

-- | What was traced: the linear radiance of every pixel, and its development for a
-- display.
module BlackHole.Render.Exposed
  ( Film,
    Exposed (..),
    SampleCounts,
    allRows,
    countsRow,
    filmRows,
    developFilm,
    developedRows,
    developFilmFinely,
    finelyDevelopedRows,
    filmRadiance,
    faultyPixels,
  )
where

import BlackHole.Light.Display
import BlackHole.Light.Radiance
import BlackHole.Render.PixelArray
import BlackHole.Render.PixelRows (convertedRows, mapRows, pixelChannels, pixelRow)
import BlackHole.Render.PixelShape
import BlackHole.Render.Shared (mapShared)
import BlackHole.Render.Workers (Workers)
import BlackHole.Scene.Camera (Picture (..))
import BlackHole.Scene.Scene
import Control.Monad.ST (ST)
import Data.Maybe (fromMaybe)
import Data.Vector.Storable (Vector)
import qualified Data.Vector.Storable as Vector
import Data.Vector.Storable.Mutable (MVector)
import qualified Data.Vector.Storable.Mutable as MVector
import Data.Word (Word16, Word8)

-- | Linear radiance in three channels, row by row from the top.
type Film = PixelArray Float

-- | The number of samples of each pixel, in one channel.
type SampleCounts = PixelArray Float

-- | The result of tracing.
data Exposed = Exposed
  { exposedLight :: !Film,
    -- | 'Nothing' if every pixel got the scene's number of samples.
    exposedCounts :: !(Maybe SampleCounts)
  }

-- | The band of all rows of a picture.
allRows :: Picture -> (Int, Int)
allRows (Picture _ height) = (0, height)

-- | @countsRow scene exposed row@ is the number of samples of each pixel in a row,
-- counted from the first exposed row; empty for other rows.
countsRow :: Scene -> Exposed -> Int -> Vector Float
countsRow scene (Exposed light counts) row
  | row < 0 || row >= shapeHeight (pixelArrayShape light) = Vector.replicate width 0
  | otherwise =
    fromMaybe
      (Vector.replicate width (fromIntegral (sceneSamples scene)))
      (counts >>= (`pixelRow` row))
  where
    width = shapeWidth (pixelArrayShape light)

-- | A band of a film, given by its first row and its number of rows, without copying.
filmRows :: Film -> (Int, Int) -> Maybe Film
filmRows film (first, rows)
  | first < 0 || rows < 1 || first > shapeHeight shape - rows = Nothing
  | otherwise = do
    part <- pixelShape (shapeWidth shape) rows (shapeChannels shape)
    fromPixelVector
      part
      ( Vector.slice
          (first * shapeRowLength shape)
          (rows * shapeRowLength shape)
          (toPixelVector film)
      )
  where
    shape = pixelArrayShape film

-- | The codes for an 8-bit sRGB display, after exposure, tone map, coding and dither.
developFilm :: Workers -> Development -> Film -> IO (PixelArray Word8)
developFilm workers development = mapRows workers (developRow prepared)
  where
    !prepared = developer development

-- | 'developFilm' for a few rows, without workers. The number of the first row in the
-- whole film is needed because grain and dither depend on the position.
developedRows :: Developer -> Int -> Film -> Maybe (PixelArray Word8)
developedRows prepared first = convertedRows (developRow prepared . (first +))

developRow :: Developer -> Int -> Vector Float -> MVector s Word8 -> ST s ()
developRow !prepared !row light codes = go 0 0
  where
    go !column !i
      | i >= Vector.length light = pure ()
      | isBlackAt light i = go (column + 1) (i + 3)
      | otherwise = do
        let (r, g, b) = displayCode prepared column row (radianceAt light i)
        MVector.unsafeWrite codes i r
        MVector.unsafeWrite codes (i + 1) g
        MVector.unsafeWrite codes (i + 2) b
        go (column + 1) (i + 3)

-- | 'developFilm' in 16 bits, which need no dither, for a band of the film that starts at
-- this row.
developFilmFinely :: Workers -> Development -> Int -> Film -> IO (PixelArray Word16)
developFilmFinely workers development first =
  mapRows workers (developRowFinely prepared . (first +))
  where
    !prepared = developer development

-- | 'developFilmFinely' for a few rows, without workers.
finelyDevelopedRows :: Developer -> Int -> Film -> Maybe (PixelArray Word16)
finelyDevelopedRows prepared first = convertedRows (developRowFinely prepared . (first +))

developRowFinely :: Developer -> Int -> Vector Float -> MVector s Word16 -> ST s ()
developRowFinely !prepared !row light codes = go 0 0
  where
    go !column !i
      | i >= Vector.length light = pure ()
      | otherwise = do
        let Signal r g b = developSignal prepared column row (radianceAt light i)
        MVector.unsafeWrite codes i (fineCode r)
        MVector.unsafeWrite codes (i + 1) (fineCode g)
        MVector.unsafeWrite codes (i + 2) (fineCode b)
        go (column + 1) (i + 3)

-- | The radiance of the pixel in a column and a row; 'Nothing' outside the film.
filmRadiance :: Film -> Int -> Int -> Maybe Radiance
filmRadiance film column row = (`radianceAt` 0) <$> pixelChannels film column row

-- | The number of pixels that contain a NaN or an infinity, and the column and row of
-- the first. Any such pixel is a fault of the program.
faultyPixels :: Workers -> Film -> IO (Int, Maybe (Int, Int))
faultyPixels workers film = do
  -- The usual case, at a nanosecond per number.
  sound <- mapShared workers (pure . Vector.all (\v -> v - v == 0)) (slices light)
  pure (if and sound then (0, Nothing) else (Vector.length faulty, place <$> faulty Vector.!? 0))
  where
    slices numbers
      | Vector.null numbers = []
      | otherwise = let (now, later) = Vector.splitAt 1000000 numbers in now : slices later
    faulty = Vector.filter isFaulty (Vector.enumFromN 0 (Vector.length light `quot` 3))
    isFaulty i = not (isFiniteRadiance (radianceAt light (3 * i)))
    light = toPixelVector film
    place i = let (row, column) = i `quotRem` shapeWidth (pixelArrayShape film) in (column, row)

-- | Three channels from an index that the caller knows to be in range.
radianceAt :: Vector Float -> Int -> Radiance
radianceAt light i = Radiance (at 0) (at 1) (at 2)
  where
    at k = realToFrac (Vector.unsafeIndex light (i + k))
{-# INLINE radianceAt #-}

-- | Whether a pixel has no light at all, as in much of the sky. Its codes are zero,
-- which is the initial value of arrays.
isBlackAt :: Vector Float -> Int -> Bool
isBlackAt light i = at 0 == 0 && at 1 == 0 && at 2 == 0
  where
    at k = Vector.unsafeIndex light (i + k)
{-# INLINE isBlackAt #-}
