-- | The light of a frame: that of one moment, or the mean of several.
module BlackHole.Animation.Exposure
  ( exposeMoments,
  )
where

import BlackHole.Render.Film (Film, exposeFilmUnder)
import BlackHole.Render.PixelArray (fromPixelVector, pixelArrayShape, toPixelVector)
import BlackHole.Render.Workers (Workers)
import BlackHole.Scene.Camera (Picture (..))
import BlackHole.Scene.Scene
import BlackHole.Trace.SkyImage (SkyImage)
import Control.Monad (join)
import Data.Foldable (foldlM)
import Data.List.NonEmpty (NonEmpty (..))
import qualified Data.Vector.Storable as Vector

-- | Trace every moment and average their linear light. The callback hears what
-- part of all rows is done. Memory is that of two films for any number of moments.
-- The first argument is the picture of the sky if the scenes' is a panorama, which
-- has to be one and the same for all. 'Nothing' if a scene is not valid or their
-- pictures differ in size.
exposeMoments :: Maybe SkyImage -> Workers -> (Double -> IO ()) -> NonEmpty Scene -> IO (Maybe Film)
exposeMoments sky crew progress (first :| rest) = do
  start <- expose 0 first
  total <- foldlM next start (zip [1 ..] rest)
  pure (total >>= divided)
  where
    count = 1 + length rest
    expose :: Int -> Scene -> IO (Maybe Film)
    expose k scene =
      let rows = max 1 (pictureHeight (scenePicture scene))
       in exposeFilmUnder sky crew (\done -> progress ((fromIntegral k + fromIntegral done / fromIntegral rows) / fromIntegral count)) scene
    next before (k, scene) = do
      light <- expose k scene
      pure $! join (plus <$> before <*> light)
    divided film
      | count == 1 = Just film
      | otherwise = fromPixelVector (pixelArrayShape film) (Vector.map (/ fromIntegral count) (toPixelVector film))

-- | The sum of the light of two films of one shape.
plus :: Film -> Film -> Maybe Film
plus a b
  | pixelArrayShape a == pixelArrayShape b =
    fromPixelVector (pixelArrayShape a) (Vector.zipWith (+) (toPixelVector a) (toPixelVector b))
  | otherwise = Nothing
