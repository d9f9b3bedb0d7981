{-# LANGUAGE BangPatterns #-}

-- | Bloom: the light that a lens scatters away from where it belongs.
--
-- No lens and no eye brings all light of a point to a point. A part is scattered
-- by glass, dust and edges into a glare whose brightness falls with the angle's
-- power of −2 to −3 (Spencer et al. 1995, "Physically-based glare effects for
-- digital images"); here −2.5, flat within 1/400 of the picture's width. The
-- glare is the same part of the picture at any resolution.
--
-- It is put together from ever coarser copies of the film, each of half the size
-- of the one before. Going down, a pixel's light is shared among the four
-- nearest coarser ones; going up, each pixel takes from the same four in the same
-- proportions. These are transposes of each other, so no light is lost or made, at the
-- picture's edges neither, and a uniform picture stays as it is.
module BlackHole.Render.Bloom
  ( bloomFilm,
    FilmBands,
    bloomBands,
  )
where

import BlackHole.Render.Film (Film, filmRows)
import BlackHole.Render.PixelArray
import BlackHole.Render.PixelRows (mapRows)
import BlackHole.Render.PixelShape
import BlackHole.Render.Workers (Workers)
import Control.Monad.ST (ST)
import Data.Maybe (fromMaybe)
import Data.Vector.Storable (Vector)
import qualified Data.Vector.Storable as Vector
import Data.Vector.Storable.Mutable (MVector)
import qualified Data.Vector.Storable.Mutable as MVector
import System.Mem (performMajorGC)

-- | Bands of a film that need not be in memory as a whole: of some rows, from
-- which and how many, the light. 'Nothing' for rows that are not to be had.
type FilmBands = (Int, Int) -> IO (Maybe Film)

-- | @bloomFilm workers strength film@: the film with this part of its light, 0 to
-- 1, scattered. With 0 it is the film itself. Pixels without a finite radiance
-- scatter nothing. The same for any number of workers; about 40 ns a pixel, and
-- a third more memory than another film.
bloomFilm :: Workers -> Double -> Film -> IO Film
bloomFilm workers strength film
  | strength > 0 = do
    bands <- bloomBands workers strength shape (pure . filmRows film)
    bloomed <- maybe (pure Nothing) ($ (0, shapeHeight shape)) bands
    -- A film in memory has all its rows.
    pure (fromMaybe film bloomed)
  | otherwise = pure film
  where
    shape = pixelArrayShape film

-- | The same for a film of this shape by bands: those of the film with bloom, for
-- which each row is asked for once now, and once more when it is wanted. Keeps a
-- quarter of the film's size in memory, and half of it for a moment.
bloomBands :: Workers -> Double -> PixelShape -> FilmBands -> IO (Maybe FilmBands)
bloomBands workers strength shape rowsOf
  | strength > 0 = do
    energy <- finestEnergy
    case energy of
      Nothing -> pure Nothing
      Just light -> do
        glare <- glareOf 1 (coarserAxis (Axis (Vector.replicate width 1))) (coarserAxis (Axis (Vector.replicate height 1))) light
        -- The finer levels' energies are large and of no use any more, but few:
        -- the collector would not notice them in time.
        performMajorGC
        pure (Just (\(first, rows) -> rowsOf (first, rows) >>= traverse (mapRows workers (blend glare . (first +)))))
  | otherwise = pure (Just rowsOf)
  where
    width = shapeWidth shape
    height = shapeHeight shape
    ignore = const (pure ())
    -- A NaN would spread over the whole picture.
    cleaned band
      | Vector.all isFinite (toPixelVector band) = pure band
      | otherwise = mapRows workers (const clean) band
    clean old new = Vector.imapM_ (\i v -> MVector.unsafeWrite new i (if isFinite v then v else 0)) old
    scattered = realToFrac (min 1 strength) :: Float
    -- The finest level is half the film's size: the scattered part of a film of
    -- one pixel stays where it is.
    depth = max 1 (ceilingLog2 (max width height) - 1)
    shares = glareShares width depth
    !sent = Vector.sum shares
    -- The finest level's energy, from bands of the film.
    finestEnergy = do
      bands <- sequence <$> mapM energyOf [(from, min 64 (halved height - from)) | from <- [0, 64 .. halved height - 1]]
      pure $ do
        parts <- bands
        finest <- pixelShape (halved width) (halved height) 3
        fromPixelVector finest (Vector.concat (map toPixelVector parts))
    energyOf (from, rows) = do
      let first = max 0 (2 * from - 1)
          end = min height (2 * (from + rows) + 1)
      band <- rowsOf (first, end - first)
      case (,) <$> band <*> pixelShape (halved width) rows 3 of
        Nothing -> pure Nothing
        Just (light, smaller) -> do
          finite <- cleaned light
          Just <$> generateRows workers ignore smaller (shrinkRow height first finite . (from +))
    -- The glare of one level and all coarser ones, on this level, from its energy.
    glareOf :: Int -> Axis -> Axis -> PixelArray Float -> IO (PixelArray Float)
    glareOf level across down energy = do
      let across' = coarserAxis across
          down' = coarserAxis down
      coarser <-
        if level < depth
          then Just <$> (shrunk energy >>= glareOf (level + 1) across' down')
          else pure Nothing
      generateRows workers ignore (pixelArrayShape energy) $ \y row ->
        levelRow (shares Vector.! (level - 1)) across down energy coarser y row
    -- Light, summed and not averaged, at half the size.
    shrunk finer =
      let size = pixelArrayShape finer
       in case pixelShape (halved (shapeWidth size)) (halved (shapeHeight size)) 3 of
            Nothing -> pure finer
            Just smaller -> generateRows workers ignore smaller (shrinkRow (shapeHeight size) 0 finer)
    blend :: PixelArray Float -> Int -> Vector Float -> MVector s Float -> ST s ()
    blend glare y light row = enlargeRow glare width height y $ \i v ->
      let own = Vector.unsafeIndex light i
       in MVector.unsafeWrite row i (own + scattered * (v - (if isFinite own then sent * own else 0)))

-- | For each place along a side, how many of the finest pixels it stands for.
newtype Axis = Axis (Vector Float)

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
        part0 * along (line0 + at + k) + part1 * along (line1 + at + k) + part2 * along (line2 + at + k) + part3 * along (line3 + at + k)
    {-# INLINE channel #-}
    inner !i = 0.25 * (number i + number (i + 9)) + 0.75 * (number (i + 3) + number (i + 6))
    {-# INLINE inner #-}
    edge !x !i = sum [share width s x * number (i + 3 * source width s x) | s <- [0 .. 3]]
    number = Vector.unsafeIndex light

-- | A level's own part of the glare, per pixel of the finest level, and what the
-- coarser ones add.
levelRow :: Float -> Axis -> Axis -> PixelArray Float -> Maybe (PixelArray Float) -> Int -> MVector s Float -> ST s ()
levelRow part (Axis across) (Axis down) energy coarser y row = case coarser of
  Nothing -> own 0
  Just glare -> enlargeRow glare width (shapeHeight shape) y $ \i v -> MVector.unsafeWrite row i (v + ownAt i)
  where
    shape = pixelArrayShape energy
    width = shapeWidth shape
    light = toPixelVector energy
    ownAt i =
      part * Vector.unsafeIndex light (y * 3 * width + i)
        / (Vector.unsafeIndex across (i `quot` 3) * Vector.unsafeIndex down y)
    own !i
      | i >= 3 * width = pure ()
      | otherwise = MVector.unsafeWrite row i (ownAt i) >> own (i + 1)

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

-- | The parts of the glare that the levels have, finest first: each what the
-- glare sends to angles from one half octave below its pixels' size to one above,
-- the last one all beyond. What is missing in the sum stays within a pixel.
glareShares :: Int -> Int -> Vector Float
glareShares width depth = Vector.generate depth (\i -> realToFrac ((beyond i - (if i == depth - 1 then 0 else beyond (i + 1))) / everything))
  where
    -- The integral of θ (θ² + core²)^(−5/4) from an angle on, in twos.
    beyond :: Int -> Double
    beyond i = let angle = 2 ** (fromIntegral i + 0.5) / fromIntegral width in (angle * angle + core * core) ** (-0.25)
    everything = (core * core) ** (-0.25)
    core = 1 / 400

ceilingLog2 :: Int -> Int
ceilingLog2 n = length (takeWhile (< n) (iterate (* 2) 1))

isFinite :: Float -> Bool
isFinite v = v - v == 0
{-# INLINE isFinite #-}
