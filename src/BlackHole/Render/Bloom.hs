{-# LANGUAGE BangPatterns #-}

-- | Bloom: the light that a lens scatters away from where it belongs.
--
-- No lens and no eye brings all light of a point to a point. A part is scattered by
-- glass, dust and edges into a glare that has a narrow core and a wide halo. The shape
-- here was measured on human eyes: Vos 1984, as given by Spencer et al. 1995,
-- "Physically-based glare effects for digital images", table 1, with a core that falls
-- with the third power of the angle and a halo that falls with the second. The angles are
-- those of a picture 40 degrees wide, whatever its field of view and resolution: the
-- glare always covers the same part of the picture. It is put together from ever coarser
-- copies of the film ("BlackHole.Render.Pyramid").
module BlackHole.Render.Bloom
  ( bloomFilm,
    bloomBands,
  )
where

import BlackHole.Render.Exposed (Film, filmRows)
import BlackHole.Render.PixelArray
import BlackHole.Render.PixelShape
import BlackHole.Render.Pyramid
import BlackHole.Render.Release
import BlackHole.Render.Workers (Workers)
import Control.Monad.ST (ST)
import Data.Maybe (fromMaybe)
import Data.Vector.Storable (Vector)
import qualified Data.Vector.Storable as Vector
import Data.Vector.Storable.Mutable (MVector)
import qualified Data.Vector.Storable.Mutable as MVector

-- | @bloomFilm workers strength film@: the film with this part of its light, 0 to
-- 1, scattered. With 0 it is the film itself. Pixels without a finite radiance
-- scatter nothing. The result is the same for any number of workers. It takes about
-- 40 ns a pixel, and a third of the memory of another film.
bloomFilm :: Workers -> Double -> Film -> IO Film
bloomFilm workers strength film = do
  bands <- bloomBands workers strength shape (pure . filmRows film)
  bloomed <- maybe (pure Nothing) ($ (0, shapeHeight shape)) bands
  -- A film in memory has all its rows.
  pure (fromMaybe film bloomed)
  where
    shape = pixelArrayShape film

-- | 'bloomFilm' for a film of this shape in bands. It reads each row twice: once now, and
-- again when a band with bloom is read. Keeps a quarter of the film's size in memory, and
-- half of it for a moment.
bloomBands :: Workers -> Double -> PixelShape -> FilmBands -> IO (Maybe FilmBands)
bloomBands workers strength shape rowsOf
  | strength > 0 = finestEnergy workers shape rowsOf >>= traverse spread
  | otherwise = pure (Just rowsOf)
  where
    width = shapeWidth shape
    height = shapeHeight shape
    spread light = do
      glare <- glareOf 1 (coarserAxis (finestAxis width)) (coarserAxis (finestAxis height)) light
      -- The finer levels' energies are of no use any more.
      release (2 * shapeLength shape)
      pure (withSpread workers shape (1 - scattered * Vector.sum shares) scattered glare rowsOf)
    scattered = realToFrac (min 1 strength) :: Float
    -- The finest level is half the film's size: the scattered part of a film of
    -- one pixel stays where it is.
    depth = max 1 (ceilingLog2 (max width height) - 1)
    shares = glareShares width depth
    -- The glare of one level and all coarser ones, on this level, from its energy.
    glareOf :: Int -> Axis -> Axis -> PixelArray Float -> IO (PixelArray Float)
    glareOf level across down energy = do
      coarser <-
        if level < depth
          then
            Just
              <$> ( shrunk workers energy
                      >>= glareOf (level + 1) (coarserAxis across) (coarserAxis down)
                  )
          else pure Nothing
      generateRows workers (const (pure ())) (pixelArrayShape energy) $ \y row ->
        levelRow (shares Vector.! (level - 1)) across down energy coarser y row

-- | A level's own part of the glare, per pixel of the finest level, and what the
-- coarser ones add.
levelRow ::
  Float ->
  Axis ->
  Axis ->
  PixelArray Float ->
  Maybe (PixelArray Float) ->
  Int ->
  MVector s Float ->
  ST s ()
levelRow part (Axis across) (Axis down) energy coarser y row = case coarser of
  Nothing -> own 0
  Just glare ->
    enlargeRow glare width (shapeHeight shape) y $ \i v -> MVector.unsafeWrite row i (v + ownAt i)
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

-- | The parts of the glare that the levels have, finest first: each what the
-- glare sends to angles from one half octave below its pixels' size to one above,
-- the last one all beyond. What is missing in the sum stays within a pixel.
glareShares :: Int -> Int -> Vector Float
glareShares width depth =
  Vector.generate
    depth
    (\i -> realToFrac ((beyond i - (if i == depth - 1 then 0 else beyond (i + 1))) / glareBeyond 0))
  where
    beyond :: Int -> Double
    beyond i = glareBeyond (40 * 2 ** (fromIntegral i + 0.5) / fromIntegral width)

-- | The glare that goes farther than an angle in degrees, up to a constant: the integral
-- of θ (0.478 · 20.91 (θ + 0.02)⁻³ + 0.138 · 72.37 (θ + 0.02)⁻²) from there to 40°.
glareBeyond :: Double -> Double
glareBeyond angle =
  0.478 * 20.91 * (cube angle - cube widest) + 0.138 * 72.37 * (square angle - square widest)
  where
    cube t = (t + 0.5 * core) / ((t + core) * (t + core))
    square t = negate (log (t + core)) - core / (t + core)
    core = 0.02
    widest = max angle 40

ceilingLog2 :: Int -> Int
ceilingLog2 n = length (takeWhile (< n) (iterate (* 2) 1))
