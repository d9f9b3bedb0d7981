-- | From the film of a scene to the bytes of its file.
module BlackHole.Image.Write
  ( finishFilm,
    finishBands,
    pictureLabel,
  )
where

import BlackHole.Image.Bytes (strict)
import BlackHole.Image.Coding
import BlackHole.Image.Exr
import BlackHole.Image.File
import BlackHole.Image.Hdr
import BlackHole.Image.Metadata
import BlackHole.Image.MotionBlur
import BlackHole.Image.Png
import BlackHole.Image.Tiff
import BlackHole.Light.Display (developer)
import BlackHole.Render.Bloom
import BlackHole.Render.Film
import BlackHole.Render.Layer
import BlackHole.Render.PixelShape (PixelShape, pixelShape)
import BlackHole.Render.Workers (Workers, workersCount)
import BlackHole.Scene.Camera (Picture (..))
import BlackHole.Scene.File.SceneFile (printScene)
import BlackHole.Scene.Scene
import Control.Monad (unless, (>=>))
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Builder as Builder
import qualified Data.ByteString.Lazy as Lazy
import Data.List.NonEmpty (NonEmpty (..))
import Data.Maybe (fromMaybe)
import Data.Vector.Storable (Vector)
import System.IO (Handle, hIsSeekable)

-- | @finishFilm workers software format coding scenes exposed@ applies bloom and then
-- 'encodeFile'. The label contains the program's name and version and the scenes whose
-- mean light the film is; the layers are those of the first scene. The bytes do not
-- depend on the number of workers.
finishFilm :: Workers -> String -> Format -> Coding -> NonEmpty Scene -> Exposed -> IO (Maybe Lazy.ByteString)
finishFilm workers software format coding scenes@(scene :| _) exposed = do
  bloomed <- bloomFilm workers (sceneBloom scene) (exposedLight exposed)
  encodeFile workers format (pictureLabel software coding scenes) (developmentOf scene) (layersFor format scene (pure . countsRow scene exposed)) bloomed

developmentOf :: Scene -> Development
developmentOf scene = Development (sceneExposure scene) (sceneToneMap scene) (sceneDither scene)

layersFor :: Format -> Scene -> (Int -> IO (Vector Float)) -> Layers
layersFor format scene counts
  | format == Exr = fromMaybe noLayers (sceneLayers scene counts)
  | otherwise = noLayers

-- | 'finishFilm' for a picture that need not be in memory as a whole, and neither need
-- its file. @rowsOf (first, count)@ returns bands of its light, and the next argument
-- the numbers of samples of a row. The action writes the file with the bytes of
-- 'finishFilm', and throws a user error if a band is missing. Bloom keeps a quarter of
-- the picture's light in memory, and JPEG all of it. 'Nothing' if the picture is too
-- large for the format.
finishBands :: Workers -> String -> Format -> Coding -> NonEmpty Scene -> FilmBands -> (Int -> IO (Vector Float)) -> Maybe (Handle -> IO ())
finishBands workers software format coding scenes@(scene :| _) sharpRows countsOf = do
  shape <- pixelShape width height 3
  write <- written shape
  Just $ \handle -> do
    bands <- bloomBands workers (sceneBloom scene) shape sharpRows
    complete <- maybe (pure False) (write handle) bands
    unless complete $ ioError (userError "a part of the picture's light cannot be read any more")
  where
    Picture width height = scenePicture scene
    bits = codingBitsOf format coding
    label = pictureLabel software coding scenes
    layers = layersFor format scene countsOf
    written :: PixelShape -> Maybe (Handle -> FilmBands -> IO Bool)
    written shape = case format of
      Png -> Just (\handle rowsOf -> encodePngBands workers label shape (bits `quot` 8) (codes rowsOf) (Bytes.hPut handle))
      Tiff -> do
        header <- tiffHeader label bits (width, height)
        Just $ \handle rowsOf -> do
          Builder.hPutBuilder handle header
          banded rowsOf $ \film -> do
            numbers <- if bits == 32 then pure (TiffLight film) else TiffCodes <$> finely film
            Builder.hPutBuilder handle (tiffRows numbers)
      Hdr -> Just $ \handle rowsOf -> do
        Bytes.hPut handle (hdrHeader label (width, height))
        banded rowsOf (hdrRows workers >=> mapM_ (Bytes.hPut handle))
      Exr -> Just $ \handle rowsOf -> do
        let precision = if bits == 32 then Single else Half
        canSeek <- hIsSeekable handle
        if canSeek
          then maybe (pure False) (\write -> write handle) (writeExr workers precision label (width, height) layers rowsOf)
          else whole handle rowsOf
      Jpeg
        | width > 65535 || height > 65535 -> Nothing
        | otherwise -> Just whole
    -- The case in which the format or a pipe requires everything at once.
    whole handle rowsOf = do
      film <- rowsOf (0, height)
      bytes <- maybe (pure Nothing) (encodeFile workers format label (developmentOf scene) layers) film
      maybe (pure False) (\b -> True <$ Lazy.hPut handle b) bytes
    -- Enough rows to keep all workers busy.
    banded rowsOf act = go 0
      where
        go first
          | first >= height = pure True
          | otherwise = do
            let count = min (16 * workersCount workers) (height - first)
            band <- rowsOf (first, count)
            maybe (pure False) (\film -> act film >> go (first + count)) band
    codes rowsOf range = fmap (codesOf (fst range)) <$> rowsOf range
    codesOf bandFirst film (first, count) = do
      rows <- filmRows film (first - bandFirst, count)
      if bits == 16
        then Codes16 <$> finelyDevelopedRows prepared rows
        else Codes8 <$> developedRows prepared (sceneDither scene) first rows
    prepared = developer (sceneExposure scene) (sceneToneMap scene)
    finely = developFilmFinely workers (sceneExposure scene) (sceneToneMap scene)

-- | The label of a picture of some scenes.
pictureLabel :: String -> Coding -> NonEmpty Scene -> Label
pictureLabel software coding scenes =
  Label software coding (joinMoments (fmap (strict . Builder.stringUtf8 . printScene []) scenes))
