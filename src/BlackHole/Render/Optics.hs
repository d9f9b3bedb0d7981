-- | What the instrument makes of the light of a scene: beam, bloom, diffraction spikes
-- and the scale bar. All of it works on linear light.
module BlackHole.Render.Optics
  ( opticsFilm,
    opticsBands,
  )
where

import BlackHole.Light.Display (Exposure (..))
import BlackHole.Numeric.Angle
import BlackHole.Render.Beam
import BlackHole.Render.Bloom
import BlackHole.Render.Exposed (Film, filmRows)
import BlackHole.Render.PixelArray
import BlackHole.Render.PixelRows (mapRows)
import BlackHole.Render.PixelShape
import BlackHole.Render.Pyramid (FilmBands)
import BlackHole.Render.Spikes
import BlackHole.Render.Workers (Workers)
import BlackHole.Scene.Camera
import BlackHole.Scene.Scene
import Control.Monad.ST (ST)
import Data.Maybe (fromMaybe)
import Data.Vector.Storable (Vector)
import qualified Data.Vector.Storable as Vector
import Data.Vector.Storable.Mutable (MVector)
import qualified Data.Vector.Storable.Mutable as MVector

-- | A scene's film as the instrument records it; the film itself if the scene asks for no
-- effect. The result does not depend on the number of workers.
opticsFilm :: Workers -> Scene -> Film -> IO Film
opticsFilm workers scene film = do
  bands <- opticsBands workers scene shape (pure . filmRows film)
  recorded <- maybe (pure Nothing) ($ (0, shapeHeight shape)) bands
  -- A film in memory has all its rows.
  pure (fromMaybe film recorded)
  where
    shape = pixelArrayShape film

-- | 'opticsFilm' for a film of this shape in bands. Each effect reads each row once now
-- and again when a finished band is read, and keeps a quarter of the film in memory.
opticsBands :: Workers -> Scene -> PixelShape -> FilmBands -> IO (Maybe FilmBands)
opticsBands workers scene shape =
  through
    [ beamBands workers (beamDeviation scene),
      bloomBands workers (sceneBloom scene),
      spikeBands workers (sceneSpikes scene) (sceneSpikeLight scene)
    ]
  where
    through [] bands = pure (Just (scaleBarBands workers scene bands))
    through (effect : rest) bands = effect shape bands >>= maybe (pure Nothing) (through rest)

-- | The standard deviation of the scene's beam in pixels of the middle of the picture.
-- The setting is the full width at half maximum in degrees.
beamDeviation :: Scene -> Double
beamDeviation scene =
  width / pixelAngle (sceneProjection scene) (sceneCamera scene) (scenePicture scene)
    / sqrt (8 * log 2)
  where
    Radians width = toRadians (Degrees (sceneBeam scene))

-- | A white bar in the lower right corner, as long as the scene's scale bar would look
-- beside the hole.
scaleBarBands :: Workers -> Scene -> FilmBands -> FilmBands
scaleBarBands workers scene rowsOf (first, rows)
  | sceneScaleBar scene > 0 =
    rowsOf (first, rows) >>= traverse (mapRows workers (barRow . (first +)))
  | otherwise = rowsOf (first, rows)
  where
    Picture width height = scenePicture scene
    margin = 0.05 * fromIntegral height
    right = fromIntegral width - margin :: Double
    left = right - scaleBarPixels scene
    bottom = fromIntegral (height - round margin) :: Double
    top = bottom - fromIntegral (max 1 (round (0.004 * fromIntegral width :: Double)) :: Int)
    -- Bright enough to be white under every tone map.
    Exposure stops = sceneExposure scene
    white = realToFrac (4 * 2 ** negate stops) :: Float
    barRow :: Int -> Vector Float -> MVector s Float -> ST s ()
    barRow row light new =
      Vector.imapM_
        ( \i v ->
            MVector.unsafeWrite
              new
              i
              ( let part =
                      realToFrac (down * overlap left right (i `quot` 3))
                 in v + part * (white - v)
              )
        )
        light
      where
        down = overlap top bottom row
    -- How much of a pixel lies in an interval.
    overlap :: Double -> Double -> Int -> Double
    overlap from to at = max 0 (min to (fromIntegral at + 1) - max from (fromIntegral at))
