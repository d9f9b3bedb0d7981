-- | The light of a frame: that of one scene, or the mean of several for motion blur.
module BlackHole.Animation.Exposure
  ( exposeMotionBlur,
  )
where

import BlackHole.Render.Exposed
import BlackHole.Render.Film
import BlackHole.Render.PixelArray (PixelArray, fromPixelVector, pixelArrayShape, toPixelVector)
import BlackHole.Render.PixelShape
import BlackHole.Render.Workers (Workers)
import BlackHole.Scene.Scene
import BlackHole.Trace.EnvironmentMap (EnvironmentMap)
import Control.Monad (join)
import Data.Foldable (foldlM)
import Data.List.NonEmpty (NonEmpty (..))
import Data.Maybe (isJust)
import qualified Data.Vector.Storable as Vector

-- | @exposeMotionBlur sky workers progress scenes band@ traces a band of every scene
-- ('exposeFilm') and averages their linear light; the numbers of samples are added. The
-- callback receives the finished fraction of all rows. Needs the memory of two films for
-- any number of scenes, which must have equal environment maps. 'Nothing' if a scene is
-- not valid or their pictures differ in size.
exposeMotionBlur ::
  Maybe EnvironmentMap ->
  Workers ->
  (Double -> IO ()) ->
  NonEmpty Scene ->
  (Int, Int) ->
  IO (Maybe Exposed)
exposeMotionBlur sky workers progress (first :| rest) (firstRow, rows) = do
  start <- expose 0 first
  total <- foldlM next start (zip [1 ..] rest)
  pure (total >>= divided)
  where
    count = 1 + length rest
    expose :: Int -> Scene -> IO (Maybe Exposed)
    expose k scene
      | scenePicture scene /= scenePicture first = pure Nothing
      | otherwise =
        (>>= counted scene)
          <$> exposeFilm
            sky
            workers
            ( \done ->
                progress
                  ( (fromIntegral k + fromIntegral done / fromIntegral (max 1 rows))
                      / fromIntegral count
                  )
            )
            scene
            (firstRow, rows)
    next before (k, scene) = do
      seen <- expose k scene
      pure $! join (together <$> before <*> seen)
    together a b =
      Exposed <$> plus (exposedLight a) (exposedLight b)
        <*> (Just <$> join (plus <$> exposedCounts a <*> exposedCounts b))
    -- A sum needs the number of samples of every pixel.
    counted scene exposed@(Exposed film counts)
      | count == 1 || isJust counts = Just exposed
      | otherwise = do
        shape <-
          pixelShape
            (shapeWidth (pixelArrayShape film))
            (shapeHeight (pixelArrayShape film))
            1
        Exposed film . Just
          <$> fromPixelVector
            shape
            (Vector.replicate (shapeLength shape) (fromIntegral (sceneSamples scene)))
    divided (Exposed film counts)
      | count == 1 = Just (Exposed film counts)
      | otherwise =
        (`Exposed` counts)
          <$> fromPixelVector
            (pixelArrayShape film)
            (Vector.map (/ fromIntegral count) (toPixelVector film))

-- | The sum of two arrays of equal shape.
plus :: PixelArray Float -> PixelArray Float -> Maybe (PixelArray Float)
plus a b
  | pixelArrayShape a == pixelArrayShape b =
    fromPixelVector (pixelArrayShape a) (Vector.zipWith (+) (toPixelVector a) (toPixelVector b))
  | otherwise = Nothing
