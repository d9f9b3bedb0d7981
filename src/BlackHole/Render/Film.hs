{-# LANGUAGE BangPatterns #-}

-- | The film exposed: the light of every pixel, traced by the workers.
module BlackHole.Render.Film
  ( exposeFilm,
    exposeTraced,
    rowsAtOnce,
  )
where

import BlackHole.Light.Radiance
import BlackHole.Render.Exposed (Exposed (..))
import BlackHole.Render.PixelArray
import BlackHole.Render.PixelRows (pixelRow)
import BlackHole.Render.PixelShape
import BlackHole.Render.Release
import BlackHole.Render.Shared (mapShared)
import BlackHole.Render.Workers (Workers)
import BlackHole.Scene.Camera (Picture (..))
import BlackHole.Scene.Scene
import BlackHole.Trace.Adaptive
import BlackHole.Trace.EnvironmentMap (EnvironmentMap)
import BlackHole.Trace.Estimate
import BlackHole.Trace.Layers
import BlackHole.Trace.Pixel
import BlackHole.Trace.SkySpan (skyNode, spanLength)
import BlackHole.Trace.Tracer
import Control.Monad (when)
import Control.Monad.ST (ST)
import Data.Foldable (for_)
import Data.Functor.Identity (runIdentity)
import Data.IORef (newIORef, readIORef, writeIORef)
import Data.Vector.Storable (Vector)
import qualified Data.Vector.Storable as Vector
import Data.Vector.Storable.Mutable (IOVector, MVector)
import qualified Data.Vector.Storable.Mutable as MVector

-- | @exposeFilm sky workers progress scene (first, rows)@ traces a band of a picture,
-- given by its first row and its number of rows (at least 1). @sky@ is the environment
-- map, for a scene that has one ('BlackHole.Trace.Sky.neededPicture'). @progress@ is
-- called with increasing numbers of finished rows. The numbers equal those of the same rows of
-- any other band, for any number of workers. 'Nothing' if the scene is not valid or lacks
-- its map, or if the picture has no such rows.
exposeFilm ::
  Maybe EnvironmentMap ->
  Workers ->
  (Int -> IO ()) ->
  Scene ->
  (Int, Int) ->
  IO (Maybe Exposed)
exposeFilm sky workers progress scene band = case tracerWithSky sky scene of
  Nothing -> pure Nothing
  Just traced -> exposeTraced traced workers progress band

-- | 'exposeFilm' for a scene that is prepared already.
exposeTraced :: Tracer -> Workers -> (Int -> IO ()) -> (Int, Int) -> IO (Maybe Exposed)
exposeTraced traced workers progress (first, rows)
  | first < 0 || first > height - rows = pure Nothing
  | otherwise = case pixelShape width rows 3 of
    Nothing -> pure Nothing
    Just shape -> do
      _ <- mapShared workers pure (tracerTables traced)
      if isAdaptive scene
        then increasing progress >>= \grown -> refineRows workers grown traced shape first
        else
          Just . (`Exposed` Nothing)
            <$> generateRows workers progress shape (traceRow traced width . (first +))
  where
    scene = tracerScene traced
    Picture width height = scenePicture scene

-- | The work of 'exposeFilm' for adaptive sampling: traces the layers of some rows, then,
-- once all their neighbours are known, the additional samples of these rows, and continues
-- with the next rows.
refineRows :: Workers -> (Int -> IO ()) -> Tracer -> PixelShape -> Int -> IO (Maybe Exposed)
refineRows workers progress traced shape first = do
  -- All bands are written here directly, to avoid copies.
  light <- MVector.unsafeNew (shapeLength shape)
  counts <- MVector.unsafeNew (width * rows)
  let go from before
        | from >= rows = exposed <$> Vector.unsafeFreeze light <*> Vector.unsafeFreeze counts
        | otherwise = case shapes of
          Nothing -> pure Nothing
          Just (bandShape, haloShape) -> do
            layers <- generateRows workers (progress . (from +) . (`quot` 2)) haloShape $ \y row ->
              case knownRow (haloFirst + y) of
                Just known -> Vector.unsafeCopy row known
                Nothing -> layerRow traced width (haloFirst + y) row
            band <-
              generateRows workers (progress . (from +) . half . (count +)) bandShape $
                refineRow traced width haloFirst layers . (first + from +)
            separate
              (toPixelVector band)
              (MVector.slice (3 * width * from) (3 * width * count) light)
              (MVector.slice (width * from) (width * count) counts)
            -- The layers are the largest object besides the film.
            when (from + count < rows) $ release (4 * shapeLength haloShape)
            go (from + count) (Just (haloFirst, layers))
        where
          count = min rowsAtOnce (rows - from)
          -- Neighbours also decide whether a pixel needs more samples.
          haloFirst = max 0 (first + from - 1)
          haloRows = min height (first + from + count + 1) - haloFirst
          shapes = (,) <$> pixelShape width count 4 <*> pixelShape width haloRows layerCount
          knownRow y = before >>= \(knownFirst, known) -> pixelRow known (y - knownFirst)
  go 0 Nothing
  where
    Picture width height = scenePicture (tracerScene traced)
    rows = shapeHeight shape
    half n = (n + 1) `quot` 2
    exposed light counts = do
      countShape <- pixelShape width rows 1
      Exposed <$> fromPixelVector shape light <*> (Just <$> fromPixelVector countShape counts)

-- | A report that is passed on if its number exceeds those before, and 0. A row that
-- counts half twice would repeat numbers.
increasing :: (Int -> IO ()) -> IO (Int -> IO ())
increasing report = do
  reported <- newIORef 0
  pure $ \n -> do
    before <- readIORef reported
    when (n > before) $ writeIORef reported n >> report n

-- | The number of rows that are refined at a time. It is a compromise: workers seldom wait
-- for each other, and the layers need little memory in a large picture.
rowsAtOnce :: Int
rowsAtOnce = 256

-- | Separates light and counts, which are computed together.
separate :: Vector Float -> IOVector Float -> IOVector Float -> IO ()
separate both light counts = go 0
  where
    go :: Int -> IO ()
    go !i = when (i < MVector.length counts) $ do
      for_ [0 .. 2] $ \k ->
        MVector.unsafeWrite light (3 * i + k) (Vector.unsafeIndex both (4 * i + k))
      MVector.unsafeWrite counts i (Vector.unsafeIndex both (4 * i + 3))
      go (i + 1)

-- | Traces one row into its part of the film, three pixels at a time where leapfrogs
-- interleave or pixels have several samples.
traceRow :: Tracer -> Int -> Int -> MVector s Float -> ST s ()
traceRow traced !width !row pixels
  | count == 1 && sceneIntegrator scene /= Leapfrogging = oneByOne 0
  | otherwise = byThrees 0
  where
    scene = tracerScene traced
    count = sceneSamples scene
    oneByOne !column = when (column < width) $ do
      writeRadiance pixels column (onlySample traced column row)
      oneByOne (column + 1)
    byThrees !column
      | column + 3 <= width = do
        let (e0, e1, e2) =
              addSamplesToThree traced 0 count noSamples noSamples noSamples column row
        write column e0
        write (column + 1) e1
        write (column + 2) e2
        byThrees (column + 3)
      | otherwise =
        for_ [column .. width - 1] $ \c -> write c (addSamples traced 0 count noSamples c row)
    write column = writeRadiance pixels column . estimatedRadiance

writeRadiance :: MVector s Float -> Int -> Radiance -> ST s ()
writeRadiance pixels column (Radiance r g b) = do
  MVector.unsafeWrite pixels (3 * column) (realToFrac r)
  MVector.unsafeWrite pixels (3 * column + 1) (realToFrac g)
  MVector.unsafeWrite pixels (3 * column + 2) (realToFrac b)
{-# INLINE writeRadiance #-}

-- | Stores the layers of one row, those of the coarsest columns first.
layerRow :: Tracer -> Int -> Int -> MVector s Float -> ST s ()
layerRow traced !width !row layers = for_ [4, 2, 1] (go 0)
  where
    throughout =
      Vector.generate (width `quot` spanLength + 1) $ \n ->
        tracedThroughout traced (n * spanLength) row
    apartAt column =
      coarseness traced (Vector.unsafeIndex throughout (column `quot` spanLength)) column row
    go !column !apart = when (column < width) $ do
      when (apartAt column == apart) $ do
        found <- pixelLayers traced apart at column row
        forLayers found $ \k v ->
          MVector.unsafeWrite layers (layerCount * column + k) (realToFrac v)
      go (column + 1) apart
    at column =
      readLayers $ \k -> realToFrac <$> MVector.unsafeRead layers (layerCount * column + k)

-- | Finishes one row, from the layers and the number of their first row: light in three
-- channels, and the number of rays.
refineRow :: Tracer -> Int -> Int -> PixelArray Float -> Int -> MVector s Float -> ST s ()
refineRow traced !width !layersFirst layers !row pixels = spans 0 (skyNode traced 0 row)
  where
    spans !column node = when (column < width) $ do
      let end = column + spanLength
          next = skyNode traced end row
      go (pixelSpan traced node next layersAt column row) (min width end) column
      spans end next
    go within !end !column = when (column < end) $ do
      let Pixel rays (Radiance r g b) = refinedPixel traced weights within layersAt column row
      MVector.unsafeWrite pixels (4 * column) (realToFrac r)
      MVector.unsafeWrite pixels (4 * column + 1) (realToFrac g)
      MVector.unsafeWrite pixels (4 * column + 2) (realToFrac b)
      MVector.unsafeWrite pixels (4 * column + 3) (fromIntegral rays)
      go within end (column + 1)
    !weights = kernel (sceneFilter (tracerScene traced))
    !numbers = toPixelVector layers
    layersAt c r = runIdentity . readLayers $ \k ->
      pure . realToFrac $
        Vector.unsafeIndex numbers (layerCount * (width * (r - layersFirst) + c) + k)
