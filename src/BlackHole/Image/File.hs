-- | Picture files of any format: a film's bytes, and a file's label.
module BlackHole.Image.File
  ( Development (..),
    encodeFile,
    fileLabel,
  )
where

import BlackHole.Image.Coding
import BlackHole.Image.Exr
import BlackHole.Image.Hdr
import BlackHole.Image.Jpeg
import BlackHole.Image.Metadata
import BlackHole.Image.Png
import BlackHole.Image.Tiff
import BlackHole.Light.Display (Exposure, ToneMap)
import BlackHole.Light.Dither (Dither)
import BlackHole.Render.Film
import BlackHole.Render.Layer
import BlackHole.Render.PixelArray (pixelArrayShape)
import BlackHole.Render.PixelShape (shapeHeight, shapeWidth)
import BlackHole.Render.Workers (Workers)
import Control.Applicative ((<|>))
import Data.ByteString (ByteString)
import qualified Data.ByteString.Lazy as Lazy

-- | The development of light for formats that store display codes.
data Development = Development
  { developmentExposure :: !Exposure,
    developmentToneMap :: !ToneMap,
    -- | For formats with 8 bits.
    developmentDither :: !Dither
  }
  deriving (Eq, Show)

-- | The bytes of a file, encoded as the label says; 'codingProblem' must accept that
-- coding. Linear formats store the film's light without exposure and tone map. Only
-- OpenEXR stores layers. 'Nothing' if the picture is too large for the format, or if
-- the layers do not fit ('encodeExr'). The bytes do not depend on the number of
-- workers.
encodeFile :: Workers -> Format -> Label -> Development -> Layers -> Film -> IO (Maybe Lazy.ByteString)
encodeFile workers format label (Development exposure tone dither) layers film = case (format, bits) of
  (Png, 16) -> Just <$> (fine >>= encodePng workers label . Codes16)
  (Png, _) -> Just <$> (coarse >>= encodePng workers label . Codes8)
  (Jpeg, _)
    | shapeWidth shape > 65535 || shapeHeight shape > 65535 -> pure Nothing
    | otherwise -> Just . encodeJpeg (codingQualityOf coding) label <$> coarse
  (Tiff, 32) -> pure (encodeTiff label (TiffLight film))
  (Tiff, _) -> encodeTiff label . TiffCodes <$> fine
  (Hdr, _) -> Just <$> encodeHdr workers label film
  (Exr, _) -> encodeExr workers (if bits == 32 then Single else Half) label layers film
  where
    shape = pixelArrayShape film
    coding = labelCoding label
    bits = codingBitsOf format coding
    coarse = developFilm workers exposure tone dither film
    fine = developFilmFinely workers exposure tone film

-- | The label of a picture file written by this program; 'Nothing' for other files.
fileLabel :: ByteString -> Maybe Label
fileLabel bytes =
  pngLabel bytes <|> exrLabel bytes <|> tiffLabel bytes <|> jpegLabel bytes <|> hdrLabel bytes
