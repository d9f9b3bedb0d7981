-- | JPEG files, for when a small file matters more than every detail.
module BlackHole.Image.Jpeg
  ( encodeJpeg,
    jpegMetadata,
  )
where

import BlackHole.Image.Bytes
import BlackHole.Image.Metadata
import BlackHole.Image.Sphere
import BlackHole.Render.PixelArray (PixelArray, pixelArrayShape, toPixelVector)
import BlackHole.Render.PixelShape
import Codec.Picture (Image (..), PixelRGB8)
import Codec.Picture.Jpg (encodeJpegAtQuality)
import Codec.Picture.Types (convertImage)
import Data.ByteString (ByteString)
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Builder as Builder
import qualified Data.ByteString.Char8 as Characters
import qualified Data.ByteString.Lazy as Lazy
import Data.Word (Word8)

-- | @encodeJpeg quality metadata codes@ is a JPEG file with colours at full resolution;
-- the quality is from 1 to 100. The metadata becomes a comment, truncated at 64 KiB. The
-- format allows sides of up to 65535 pixels. Takes about 0.1 µs per pixel, on one
-- worker.
encodeJpeg :: Int -> Metadata -> PixelArray Word8 -> Lazy.ByteString
encodeJpeg quality metadata codes = Lazy.concat [before, Lazy.fromStrict (sphere <> comment), after]
  where
    shape = pixelArrayShape codes
    coded =
      encodeJpegAtQuality (fromIntegral (max 1 (min 100 quality))) $
        convertImage
          (Image (shapeWidth shape) (shapeHeight shape) (toPixelVector codes) :: Image PixelRGB8)
    -- After the start marker and the JFIF segment, if there is one.
    (before, after) = Lazy.splitAt (fromIntegral headSize) coded
    start = Lazy.toStrict (Lazy.take 64 coded)
    headSize = case (slice 2 2 start, bigEndian 2 4 start) of
      (Just marker, Just size) | marker == Bytes.pack [0xff, 0xe0] -> 4 + size
      _ -> 2
    comment = segment 0xfffe (Bytes.take 65533 (metadataText metadata))
    sphere =
      foldMap
        (segment 0xffe1 . (Characters.pack "http://ns.adobe.com/xap/1.0/\0" <>))
        (spherePacket metadata (shapeWidth shape, shapeHeight shape))
    segment marker content =
      strict $
        Builder.word16BE marker <> Builder.word16BE (fromIntegral (Bytes.length content + 2))
          <> Builder.byteString content

-- | The metadata of a JPEG file written by this program.
jpegMetadata :: ByteString -> Maybe Metadata
jpegMetadata bytes = Bytes.stripPrefix (Bytes.pack [0xff, 0xd8]) bytes >>= go
  where
    go rest = do
      marker <- bigEndian 2 0 rest
      size <- bigEndian 2 2 rest
      content <- slice 4 (size - 2) rest
      case marker of
        0xfffe | Characters.pack "# " `Bytes.isPrefixOf` content -> parseMetadata content
        -- The start of the picture itself.
        0xffda -> Nothing
        _ -> go (Bytes.drop (2 + size) rest)
