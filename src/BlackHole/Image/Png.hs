-- | PNG coding of developed pictures.
module BlackHole.Image.Png
  ( encodePicture,
  )
where

import BlackHole.Render.PixelArray (PixelArray, pixelArrayShape, toPixelVector)
import BlackHole.Render.PixelShape (shapeHeight, shapeWidth)
import Codec.Picture (Image (..), PixelRGB8)
import Codec.Picture.Metadata (Keys (..), singleton)
import Codec.Picture.Png (encodePngWithMetadata)
import qualified Data.ByteString.Lazy as Lazy
import Data.Word (Word8)

-- | An 8-bit RGB PNG of a three-channel array, without a time stamp: equal
-- pixels give equal bytes.
encodePicture :: String -> PixelArray Word8 -> Lazy.ByteString
encodePicture software codes =
  encodePngWithMetadata
    (singleton Software software)
    (Image (shapeWidth shape) (shapeHeight shape) (toPixelVector codes) :: Image PixelRGB8)
  where
    shape = pixelArrayShape codes
