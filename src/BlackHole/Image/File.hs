-- | Picture files of any format: their encoders, and the metadata that they hold.
module BlackHole.Image.File
  ( fileEncoder,
    fileMetadata,
  )
where

import BlackHole.Image.Coding
import BlackHole.Image.Destination
import BlackHole.Image.Exr
import BlackHole.Image.Hdr
import BlackHole.Image.Jpeg
import BlackHole.Image.Metadata
import BlackHole.Image.Png
import BlackHole.Image.Tiff
import BlackHole.Light.Display (Development, developer)
import BlackHole.Render.Exposed
import BlackHole.Render.Layer
import BlackHole.Render.PixelShape (pixelShape)
import BlackHole.Render.Workers (Workers, workersCount)
import Control.Applicative ((<|>))
import Data.ByteString (ByteString)
import qualified Data.ByteString.Lazy as Lazy

-- | @fileEncoder workers format metadata development layers (width, height)@ is the
-- encoder of a file, coded as the metadata say; 'codingProblem' must accept that coding.
-- Linear formats store the film's light without exposure and tone map. Only OpenEXR
-- stores layers. JPEG needs the whole film in memory, the other formats a few rows.
-- 'Nothing' if the picture is too large for the format, or if the layers do not fit
-- ('encodeExr'). The bytes do not depend on the number of workers.
fileEncoder :: Workers -> Format -> Metadata -> Development -> Layers -> (Int, Int) -> Maybe Encoder
fileEncoder workers format metadata development layers size@(width, height) = case format of
  Png -> do
    shape <- pixelShape width height 3
    Just $ \rowsOf destination ->
      encodePng
        workers
        metadata
        shape
        (bits `quot` 8)
        (\range -> fmap (codesOf (fst range)) <$> rowsOf range)
        (putBytes destination)
  Jpeg
    | width > 65535 || height > 65535 -> Nothing
    | otherwise -> Just $ \rowsOf destination -> do
      film <- rowsOf (0, height)
      case film of
        Nothing -> pure False
        Just light -> do
          codes <- developFilm workers development light
          True
            <$ mapM_
              (putBytes destination)
              (Lazy.toChunks (encodeJpeg (codingQualityOf coding) metadata codes))
  Tiff -> banded tiffBand <$> tiffHeader metadata bits size
  Hdr -> Just (banded (const (hdrRows workers)) (hdrHeader metadata size))
  Exr -> encodeExr workers (if bits == 32 then Single else Half) metadata size layers
  where
    coding = metadataCoding metadata
    bits = codingBitsOf format coding
    codesOf bandFirst film (first, count) = do
      rows <- filmRows film (first - bandFirst, count)
      if bits == 16
        then Codes16 <$> finelyDevelopedRows prepared first rows
        else Codes8 <$> developedRows prepared first rows
    prepared = developer development
    tiffBand first film
      | bits == 32 = pure (tiffRows (TiffLight film))
      | otherwise = tiffRows . TiffCodes <$> developFilmFinely workers development first film
    -- A header, then the rows of bands that keep all workers busy.
    banded rowsIn header rowsOf destination = putBytes destination header >> go 0
      where
        go first
          | first >= height = pure True
          | otherwise = do
            let count = min (16 * workersCount workers) (height - first)
            band <- rowsOf (first, count)
            case band of
              Nothing -> pure False
              Just film -> rowsIn first film >>= mapM_ (putBytes destination) >> go (first + count)

-- | The metadata of a picture file written by this program; 'Nothing' for other files.
fileMetadata :: ByteString -> Maybe Metadata
fileMetadata bytes =
  pngMetadata bytes <|> exrMetadata bytes <|> tiffMetadata bytes <|> jpegMetadata bytes
    <|> hdrMetadata bytes
