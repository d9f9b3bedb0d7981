-- | Picture files from the film of a scene: bloom, development and encoding.
module BlackHole.Image.Write
  ( pictureEncoder,
    pictureBytes,
    pictureMetadata,
  )
where

import BlackHole.Image.Bytes (strict)
import BlackHole.Image.Coding
import BlackHole.Image.Destination
import BlackHole.Image.File
import BlackHole.Image.Metadata
import BlackHole.Image.MotionBlur
import BlackHole.Render.Exposed
import BlackHole.Render.Layer
import BlackHole.Render.Optics
import BlackHole.Render.PixelShape (pixelShape)
import BlackHole.Render.Pyramid (FilmBands)
import BlackHole.Render.Workers (Workers)
import BlackHole.Scene.Camera (Picture (..))
import BlackHole.Scene.File.SceneFile (printScene)
import BlackHole.Scene.Scene
import Control.Monad (unless)
import qualified Data.ByteString.Builder as Builder
import qualified Data.ByteString.Lazy as Lazy
import Data.List.NonEmpty (NonEmpty (..))
import Data.Maybe (fromMaybe)
import Data.Vector.Storable (Vector)

-- | @pictureEncoder workers program format coding scenes countsOf@ is the encoder of a
-- picture of the mean light of some scenes. @countsOf@ returns the numbers of samples of
-- a row. The encoder applies the optics of the first scene, whose layers the file has, and
-- then that of 'fileEncoder'; the metadata hold @program@, its name and version, and the
-- scenes. Bloom keeps a quarter of the picture's light in memory. Throws a user error if
-- a band is missing. 'Nothing' if the picture is too large for the format. The bytes do
-- not depend on the number of workers.
pictureEncoder ::
  Workers ->
  String ->
  Format ->
  Coding ->
  NonEmpty Scene ->
  (Int -> IO (Vector Float)) ->
  Maybe (FilmBands -> Destination -> IO ())
pictureEncoder workers program format coding scenes@(scene :| _) countsOf = do
  shape <- pixelShape width height 3
  encode <-
    fileEncoder
      workers
      format
      (pictureMetadata program coding scenes)
      (sceneDevelopment scene)
      layers
      (width, height)
  Just $ \sharpRows destination -> do
    bands <- opticsBands workers scene shape sharpRows
    complete <- maybe (pure False) (`encode` destination) bands
    unless complete $ ioError (userError "a part of the picture's light cannot be read any more")
  where
    Picture width height = scenePicture scene
    layers
      | format == Exr = fromMaybe noLayers (sceneLayers scene countsOf)
      | otherwise = noLayers

-- | The bytes that 'pictureEncoder' writes for a whole film in memory.
pictureBytes ::
  Workers ->
  String ->
  Format ->
  Coding ->
  NonEmpty Scene ->
  Exposed ->
  IO (Maybe Lazy.ByteString)
pictureBytes workers program format coding scenes@(scene :| _) exposed =
  traverse
    written
    (pictureEncoder workers program format coding scenes (pure . countsRow scene exposed))
  where
    written write = snd <$> inMemory (write (pure . filmRows (exposedLight exposed)))

-- | The metadata of a picture of some scenes.
pictureMetadata :: String -> Coding -> NonEmpty Scene -> Metadata
pictureMetadata program coding scenes =
  Metadata
    program
    coding
    (joinBlurredScenes (fmap (strict . Builder.stringUtf8 . printScene []) scenes))
