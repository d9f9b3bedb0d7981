{-# LANGUAGE BangPatterns #-}

-- | Ever coarser copies of a film, each of half the size of the one before, for what
-- spreads light over many pixels.
--
-- Going down, a pixel's light is shared among the four nearest coarser ones; going up,
-- each pixel takes from the same four in the same proportions. These are transposes of
-- each other, so no light is lost or made, at the picture's edges neither, and a uniform
-- picture stays as it is.
module BlackHole.Render.Pyramid
  ( FilmBands,
    finestEnergy,
    shrunk,
    enlarged,
    withSpread,
    Axis (..),
    finestAxis,
    coarserAxis,
    enlargeRow,
  )
where

import BlackHole.Render.Exposed (Film)
import BlackHole.Render.PixelArray
import BlackHole.Render.PixelRows (mapRows)
import BlackHole.Render.PixelShape
import BlackHole.Render.Workers (Workers)
import Control.Monad.ST (ST)
import Data.Vector.Storable (Vector)
import qualified Data.Vector.Storable as Vector
import Data.Vector.Storable.Mutable (MVector)
import qualified Data.Vector.Storable.Mutable as MVector

-- | Bands of a film, which need not be in memory as a whole: from the first row and the
-- number of rows to their light. 'Nothing' if the rows cannot be read.
type FilmBands = (Int, Int) -> IO (Maybe Film)

-- | The film's light on the first level, of half its size, summed and not averaged, from
-- bands of the film. Pixels without a finite radiance count as black: a NaN would spread
-- over the whole picture. 'Nothing' if a band is missing.
finestEnergy :: Workers -> PixelShape -> FilmBands -> IO (Maybe (PixelArray Float))
finestEnergy workers shape rowsOf = do
  bands <-
    sequence
      <$> mapM
        energyOf
        [(from, min 64 (halved height - from)) | from <- [0, 64 .. halved height - 1]]
  pure $ do
    parts <- bands
    finest <- pixelShape (halved width) (halved height) 3
    fromPixelVector finest (Vector.concat (map toPixelVector parts))
  where
    width = shapeWidth shape
    height = shapeHeight shape
    energyOf (from, rows) = do
      let first = max 0 (2 * from - 1)
          end = min height (2 * (from + rows) + 1)
      band <- rowsOf (first, end - first)
      case (,) <$> band <*> pixelShape (halved width) rows 3 of
        Nothing -> pure Nothing
        Just (light, smaller) -> do
          finite <- cleaned light
          Just <$> generateRows workers ignore smaller (shrinkRow height first finite . (from +))
    cleaned band
      | Vector.all isFinite (toPixelVector band) = pure band
      | otherwise = mapRows workers (const clean) band
    clean old new =
      Vector.imapM_ (\i v -> MVector.unsafeWrite new i (if isFinite v then v else 0)) old

-- | The next level: light, summed and not averaged, at half the size.
shrunk :: Workers -> PixelArray Float -> IO (PixelArray Float)
shrunk workers finer = case pixelShape (halved (shapeWidth size)) (halved (shapeHeight size)) 3 of
  Nothing -> pure finer
  Just smaller -> generateRows workers ignore smaller (shrinkRow (shapeHeight size) 0 finer)
  where
    size = pixelArrayShape finer

-- | @enlarged workers shape coarser@: means on the finer level of this shape.
enlarged :: Workers -> PixelShape -> PixelArray Float -> IO (PixelArray Float)
enlarged workers shape coarser = generateRows workers ignore shape $ \y row ->
  enlargeRow coarser (shapeWidth shape) (shapeHeight shape) y (MVector.unsafeWrite row)

-- | @withSpread workers shape kept gain spread rowsOf@: bands of the film with its light
-- times @kept@, and with @gain@ times the light on the first level.
withSpread :: Workers -> PixelShape -> Float -> Float -> PixelArray Float -> FilmBands -> FilmBands
withSpread workers shape !kept !gain spread rowsOf (first, rows) =
  rowsOf (first, rows) >>= traverse (mapRows workers (blend . (first +)))
  where
    blend :: Int -> Vector Float -> MVector s Float -> ST s ()
    blend y light row = enlargeRow spread (shapeWidth shape) (shapeHeight shape) y $ \i v ->
      MVector.unsafeWrite row i (kept * Vector.unsafeIndex light i + gain * v)

ignore :: Int -> IO ()
ignore = const (pure ())

-- | For each pixel along a side, the number of finest pixels that it represents.
newtype Axis = Axis (Vector Float)

-- | Of the film itself, for a side of this length.
finestAxis :: Int -> Axis
finestAxis size = Axis (Vector.replicate size 1)

-- | Of the next level.
coarserAxis :: Axis -> Axis
coarserAxis (Axis weights) = Axis (Vector.generate (halved size) total)
  where
    size = Vector.length weights
    total j = sum [share size t j * Vector.unsafeIndex weights (source size t j) | t <- [0 .. 3]]

halved :: Int -> Int
halved n = (n + 1) `quot` 2

-- | Of the four pixels 2j − 1 … 2j + 2 that share their light with the coarser
-- pixel j: the part that the t-th gives. The outer ones give it a quarter, the
-- inner ones three; at the edges nothing goes outside.
share :: Int -> Int -> Int -> Float
share size t j
  | i < 0 || i >= size = 0
  | t == 0 || t == 3 = 0.25
  | i == 0 || (i == size - 1 && even size) = 1
  | otherwise = 0.75
  where
    i = 2 * j - 1 + t
{-# INLINE share #-}

-- | That pixel, or the nearest there is.
source :: Int -> Int -> Int -> Int
source size t j = max 0 (min (size - 1) (2 * j - 1 + t))
{-# INLINE source #-}

-- | A row of the coarser level from four of the finer, of which there are so many in
-- all; the array holds those from a first one on.
shrinkRow :: Int -> Int -> PixelArray Float -> Int -> MVector s Float -> ST s ()
shrinkRow !height !first finer y row = go 0
  where
    shape = pixelArrayShape finer
    !width = shapeWidth shape
    !newWidth = halved width
    !light = toPixelVector finer
    !part0 = share height 0 y
    !part1 = share height 1 y
    !part2 = share height 2 y
    !part3 = share height 3 y
    !line0 = 3 * width * (source height 0 y - first)
    !line1 = 3 * width * (source height 1 y - first)
    !line2 = 3 * width * (source height 2 y - first)
    !line3 = 3 * width * (source height 3 y - first)
    go !x
      | x >= newWidth = pure ()
      | x > 0 && 2 * x + 3 < width = channels x inner (3 * (2 * x - 1)) >> go (x + 1)
      | otherwise = channels x (edge x) 0 >> go (x + 1)
    channels !x along !at = channel x along at 0 >> channel x along at 1 >> channel x along at 2
    {-# INLINE channels #-}
    channel !x along !at !k =
      MVector.unsafeWrite row (3 * x + k) $
        part0 * along (line0 + at + k) + part1 * along (line1 + at + k)
          + part2 * along (line2 + at + k)
          + part3 * along (line3 + at + k)
    {-# INLINE channel #-}
    inner !i = 0.25 * (number i + number (i + 9)) + 0.75 * (number (i + 3) + number (i + 6))
    {-# INLINE inner #-}
    edge !x !i = sum [share width s x * number (i + 3 * source width s x) | s <- [0 .. 3]]
    number = Vector.unsafeIndex light

-- | Each number of a row of the finer level, of the given size, from two rows of
-- the coarser.
enlargeRow :: PixelArray Float -> Int -> Int -> Int -> (Int -> Float -> ST s ()) -> ST s ()
enlargeRow coarser width height y use = go 0
  where
    shape = pixelArrayShape coarser
    coarseWidth = shapeWidth shape
    light = toPixelVector coarser
    -- The nearer row or column has three quarters, the next one a quarter.
    near n size = min (size - 1) (n `quot` 2)
    next n size = max 0 (min (size - 1) (if even n then n `quot` 2 - 1 else n `quot` 2 + 1))
    !nearRow = near y (halved height) * coarseWidth
    !nextRow = next y (halved height) * coarseWidth
    go !x
      | x >= width = pure ()
      | otherwise = do
        let a = 3 * near x coarseWidth
            b = 3 * next x coarseWidth
        use (3 * x) (number a b)
        use (3 * x + 1) (number (a + 1) (b + 1))
        use (3 * x + 2) (number (a + 2) (b + 2))
        go (x + 1)
    number !a !b =
      0.75 * (0.75 * at (3 * nearRow + a) + 0.25 * at (3 * nearRow + b))
        + 0.25 * (0.75 * at (3 * nextRow + a) + 0.25 * at (3 * nextRow + b))
    at = Vector.unsafeIndex light
{-# INLINE enlargeRow #-}

isFinite :: Float -> Bool
isFinite v = v - v == 0
{-# INLINE isFinite #-}
