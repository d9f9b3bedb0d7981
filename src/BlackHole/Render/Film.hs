{-# LANGUAGE BangPatterns #-}

-- | The film: the linear radiance of every pixel, and its development for a display.
module BlackHole.Render.Film
  ( Film,
    Exposed (..),
    SampleCounts,
    exposeFilm,
    exposeTraced,
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
import BlackHole.Trace.Adaptive
import BlackHole.Trace.EnvironmentMap (EnvironmentMap)
import BlackHole.Trace.Estimate
import BlackHole.Trace.Pixel
import BlackHole.Trace.Tracer
import Control.Monad (when)
import Control.Monad.ST (ST)
import Data.Foldable (for_)
import Data.Maybe (fromMaybe)
import Data.Vector.Storable (Vector)
import qualified Data.Vector.Storable as Vector
import Data.Vector.Storable.Mutable (IOVector, MVector)
import qualified Data.Vector.Storable.Mutable as MVector
import Data.Word (Word16, Word8)
import System.Mem (performMajorGC)

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
  | otherwise = fromMaybe (Vector.replicate width (fromIntegral (sceneSamples scene))) (counts >>= (`pixelRow` row))
  where
    width = shapeWidth (pixelArrayShape light)

-- | A band of a film, given by its first row and its number of rows, without copying.
filmRows :: Film -> (Int, Int) -> Maybe Film
filmRows film (first, rows)
  | first < 0 || rows < 1 || first > shapeHeight shape - rows = Nothing
  | otherwise = do
    part <- pixelShape (shapeWidth shape) rows (shapeChannels shape)
    fromPixelVector part (Vector.slice (first * shapeRowLength shape) (rows * shapeRowLength shape) (toPixelVector film))
  where
    shape = pixelArrayShape film

-- | @exposeFilm sky workers progress scene (first, rows)@ traces a band of a picture,
-- given by its first row and its number of rows (at least 1). @sky@ is the environment
-- map, for a scene that has one ('BlackHole.Trace.Sky.neededPicture'). @progress@ is
-- called with the number of finished rows. The numbers equal those of the same rows of
-- any other band, for any number of workers. 'Nothing' if the scene is not valid or lacks
-- its map, or if the picture has no such rows.
exposeFilm :: Maybe EnvironmentMap -> Workers -> (Int -> IO ()) -> Scene -> (Int, Int) -> IO (Maybe Exposed)
exposeFilm sky workers progress scene band = maybe (pure Nothing) (\traced -> exposeTraced traced workers progress band) (tracerWithSky sky scene)

-- | 'exposeFilm' for a scene that is prepared already.
exposeTraced :: Tracer -> Workers -> (Int -> IO ()) -> (Int, Int) -> IO (Maybe Exposed)
exposeTraced traced workers progress (first, rows)
  | first < 0 || first > height - rows = pure Nothing
  | otherwise = case pixelShape width rows 3 of
    Nothing -> pure Nothing
    Just shape -> do
      _ <- mapShared workers pure (tracerTables traced)
      if mostSamples scene > sceneSamples scene
        then refineRows workers progress traced shape first
        else Just . (`Exposed` Nothing) <$> generateRows workers progress shape (traceRow traced width . (first +))
  where
    scene = tracerScene traced
    Picture width height = scenePicture scene

-- | The work of 'exposeFilm' for adaptive sampling: traces the first samples of some
-- rows, then, once all their neighbours are known, the additional samples of these
-- rows, and continues with the next rows. The number of rows at a time is a compromise:
-- workers seldom wait for each other, and the sums of all samples need little memory in
-- a large picture.
refineRows :: Workers -> (Int -> IO ()) -> Tracer -> PixelShape -> Int -> IO (Maybe Exposed)
refineRows workers progress traced shape first = do
  -- All bands are written here directly, to avoid copies.
  light <- MVector.unsafeNew (shapeLength shape)
  counts <- MVector.unsafeNew (width * rows)
  let go from before
        | from >= rows = exposed <$> Vector.unsafeFreeze light <*> Vector.unsafeFreeze counts
        | otherwise = case (,) <$> pixelShape width count 4 <*> pixelShape width haloRows sumCount of
          Nothing -> pure Nothing
          Just (bandShape, haloShape) -> do
            sums <- generateRows workers (progress . (from +) . (`quot` 2)) haloShape $ \y row ->
              case before >>= \(beforeFirst, known) -> pixelRow known (haloFirst + y - beforeFirst) of
                Just known -> Vector.unsafeCopy row known
                Nothing -> sumRow traced width (haloFirst + y) row
            band <- generateRows workers (progress . (from +) . half . (count +)) bandShape (refineRow traced width haloFirst sums . (first + from +))
            separate (toPixelVector band) (MVector.slice (3 * width * from) (3 * width * count) light) (MVector.slice (width * from) (width * count) counts)
            -- The sums are the largest object besides the film.
            when (from + count < rows) performMajorGC
            go (from + count) (Just (haloFirst, sums))
        where
          count = min 256 (rows - from)
          -- Neighbours also decide whether a pixel needs more samples.
          haloFirst = max 0 (first + from - 1)
          haloRows = min height (first + from + count + 1) - haloFirst
  go 0 Nothing
  where
    Picture width height = scenePicture (tracerScene traced)
    rows = shapeHeight shape
    half n = (n + 1) `quot` 2
    exposed light counts = do
      countShape <- pixelShape width rows 1
      Exposed <$> fromPixelVector shape light <*> (Just <$> fromPixelVector countShape counts)

-- | Separates light and counts, which are computed together.
separate :: Vector Float -> IOVector Float -> IOVector Float -> IO ()
separate both light counts = go 0
  where
    go :: Int -> IO ()
    go !i = when (i < MVector.length counts) $ do
      for_ [0 .. 2] $ \k -> MVector.unsafeWrite light (3 * i + k) (Vector.unsafeIndex both (4 * i + k))
      MVector.unsafeWrite counts i (Vector.unsafeIndex both (4 * i + 3))
      go (i + 1)

-- | Traces one row into its part of the film.
traceRow :: Tracer -> Int -> Int -> MVector s Float -> ST s ()
traceRow traced !width !row pixels
  | sceneSamples scene == 1 && sceneIntegrator scene /= Leapfrogging = oneByOne 0
  | otherwise =
    forThrees width (firstSamples traced width row) $ \column sums ->
      writeRadiance pixels column (estimatedRadiance sums)
  where
    scene = tracerScene traced
    oneByOne !column = when (column < width) $ do
      writeRadiance pixels column (onlySample traced column row)
      oneByOne (column + 1)

-- | The first samples of three pixels, starting at a column. Pixels beyond the width
-- are not traced.
firstSamples :: Tracer -> Int -> Int -> Int -> (Estimate, Estimate, Estimate)
firstSamples traced width row column
  | column + 3 <= width = addSamplesToThree traced 0 count noSamples noSamples noSamples column row
  | otherwise = (one column, one (column + 1), one (column + 2))
  where
    count = sceneSamples (tracerScene traced)
    one c
      | c < width = addSamples traced 0 count noSamples c row
      | otherwise = noSamples
{-# INLINE firstSamples #-}

-- | Runs an action for every pixel of a row with its estimate, three pixels at a time.
forThrees :: Int -> (Int -> (Estimate, Estimate, Estimate)) -> (Int -> Estimate -> ST s ()) -> ST s ()
forThrees !width estimates act = go 0
  where
    go !column = when (column < width) $ do
      let (e0, e1, e2) = estimates column
      act column e0
      when (column + 1 < width) $ act (column + 1) e1
      when (column + 2 < width) $ act (column + 2) e2
      go (column + 3)
{-# INLINE forThrees #-}

writeRadiance :: MVector s Float -> Int -> Radiance -> ST s ()
writeRadiance pixels column (Radiance r g b) = do
  MVector.unsafeWrite pixels (3 * column) (realToFrac r)
  MVector.unsafeWrite pixels (3 * column + 1) (realToFrac g)
  MVector.unsafeWrite pixels (3 * column + 2) (realToFrac b)
{-# INLINE writeRadiance #-}

-- | Stores the sums of the first samples of one row.
sumRow :: Tracer -> Int -> Int -> MVector s Float -> ST s ()
sumRow traced !width !row sums =
  forThrees width (firstSamples traced width row) $ \column estimate ->
    forSums estimate $ \k v ->
      MVector.unsafeWrite sums (sumCount * column + k) (realToFrac v)

-- | Finishes one row, from the first sums and the number of their first row: light in
-- three channels, and the number of samples.
refineRow :: Tracer -> Int -> Int -> PixelArray Float -> Int -> MVector s Float -> ST s ()
refineRow traced !width !sumsFirst sums !row pixels = go 0
  where
    go !column = when (column < width) $ do
      let estimate = refinedEstimate traced uncertain (first column) column row
          Radiance r g b = estimatedRadiance estimate
      MVector.unsafeWrite pixels (4 * column) (realToFrac r)
      MVector.unsafeWrite pixels (4 * column + 1) (realToFrac g)
      MVector.unsafeWrite pixels (4 * column + 2) (realToFrac b)
      MVector.unsafeWrite pixels (4 * column + 3) (fromIntegral (estimateCount estimate))
      go (column + 1)
    scene = tracerScene traced
    !numbers = toPixelVector sums
    sumOf :: Int -> Int -> Int -> Double
    sumOf c r k = realToFrac (Vector.unsafeIndex numbers (sumCount * (width * (r - sumsFirst) + c) + k))
    first c = estimateFromSums (sceneSamples scene) (sumOf c row)
    uncertain c r = uncertainEstimate scene (sumOf c r seenPlace) (sumOf c r (seenPlace + 1))

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
developFilmFinely workers development first = mapRows workers (developRowFinely prepared . (first +))
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
