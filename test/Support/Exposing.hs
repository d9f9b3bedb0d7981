-- | Films and picture files in memory.
module Support.Exposing
  ( exposeWhole,
    exposeBand,
    encoded,
  )
where

import BlackHole.Image.Coding (Format)
import BlackHole.Image.Destination (inMemory)
import BlackHole.Image.File (fileEncoder)
import BlackHole.Image.Metadata (Metadata)
import BlackHole.Light.Display (Development)
import BlackHole.Render.Exposed
import BlackHole.Render.Film
import BlackHole.Render.Layer (Layers)
import BlackHole.Render.PixelArray (pixelArrayShape)
import BlackHole.Render.PixelShape (shapeHeight, shapeWidth)
import BlackHole.Render.Workers (Workers)
import BlackHole.Scene.Scene (Scene (..))
import qualified Data.ByteString.Lazy as Lazy

-- | The film of a scene without an environment map.
exposeWhole :: Workers -> Scene -> IO (Maybe Film)
exposeWhole workers scene = exposeBand workers scene (allRows (scenePicture scene))

-- | A band of that film: its first row and its number of rows.
exposeBand :: Workers -> Scene -> (Int, Int) -> IO (Maybe Film)
exposeBand workers scene band =
  fmap exposedLight <$> exposeFilm Nothing workers (const (pure ())) scene band

-- | The bytes of a file ('fileEncoder').
encoded ::
  Workers -> Format -> Metadata -> Development -> Layers -> Film -> IO (Maybe Lazy.ByteString)
encoded workers format metadata development layers film =
  traverse
    (\encode -> snd <$> inMemory (encode (pure . filmRows film)))
    (fileEncoder workers format metadata development layers size)
  where
    size = (shapeWidth (pixelArrayShape film), shapeHeight (pixelArrayShape film))
