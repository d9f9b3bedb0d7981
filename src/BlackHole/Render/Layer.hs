-- | Additional layers of a picture: one number per pixel each.
module BlackHole.Render.Layer
  ( Layers (..),
    noLayers,
    sceneLayers,
  )
where

import BlackHole.Scene.Camera (Picture (..))
import BlackHole.Scene.Scene
import BlackHole.Spacetime.PlaneCrossing (PlaneCrossing (..))
import BlackHole.Trace.PixelGeometry
import Data.Vector.Storable (Vector)
import qualified Data.Vector.Storable as Vector

-- | Layers that are computed row by row while they are written, so that no layer is
-- ever in memory as a whole. A pixel without a value has NaN.
data Layers = Layers
  { -- | Names of up to 31 printable ASCII characters each.
    layerNames :: ![String],
    -- | The numbers of every layer in a row of the picture, in the order of the names.
    layerRow :: !(Int -> IO [Vector Float])
  }

-- | No layers.
noLayers :: Layers
noLayers = Layers [] (const (pure []))

-- | @sceneLayers scene counts@ are redshift, deflection and radius of 'pixelGeometry',
-- and the number of samples, which the caller provides for each row. 'Nothing' for a
-- scene that cannot be traced.
sceneLayers :: Scene -> (Int -> IO (Vector Float)) -> Maybe Layers
sceneLayers scene counts = layers <$> pixelGeometry scene
  where
    layers look = Layers ["redshift.V", "deflection.V", "radius.V", "samples.V"] (rowOf look)
    width = pictureWidth (scenePicture scene)
    rowOf look row = do
      samples <- counts row
      let numbers = Vector.unfoldrExactN (3 * width) (next look row) (0, [])
          plane k = Vector.generate width (\x -> Vector.unsafeIndex numbers (3 * x + k))
      pure [plane 0, plane 1, plane 2, samples]
    next look row (column, pending) = case pending of
      v : rest -> (v, (column, rest))
      [] ->
        let PixelGeometry deflection hit = look column row
         in ( number (crossingLight <$> hit),
              (column + 1 :: Int, [number deflection, number (crossingRadius <$> hit)])
            )
    number = maybe (0 / 0) realToFrac :: Maybe Double -> Float
