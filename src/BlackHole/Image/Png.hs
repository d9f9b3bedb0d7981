{-# LANGUAGE BangPatterns #-}

-- | PNG coding of developed pictures (ISO/IEC 15948), by several workers.
--
-- Every row is filtered by taking the pixel to its left from each pixel, which
-- is within a few per cent of the best filter for each row of a rendered
-- picture. Strips of rows are compressed independently of each other
-- ("BlackHole.Image.Deflate") and become one zlib stream.
module BlackHole.Image.Png
  ( encodePicture,
  )
where

import BlackHole.Image.Checksum
import BlackHole.Image.Deflate
import BlackHole.Render.PixelArray (PixelArray, pixelArrayShape, toPixelVector)
import BlackHole.Render.PixelShape
import BlackHole.Render.Shared (mapShared)
import BlackHole.Render.Workers (Workers)
import Data.Bits (complement, xor, (.&.), (.|.))
import Data.ByteString (ByteString)
import qualified Data.ByteString as Bytes
import Data.ByteString.Builder (Builder)
import qualified Data.ByteString.Builder as Builder
import qualified Data.ByteString.Char8 as Characters
import Data.ByteString.Internal (unsafeCreate)
import qualified Data.ByteString.Lazy as Lazy
import qualified Data.Vector.Storable as Vector
import Data.Word (Word64, Word8)
import Foreign.ForeignPtr (withForeignPtr)
import Foreign.Ptr (Ptr, plusPtr)
import Foreign.Storable (peekByteOff, pokeByteOff)

-- | An 8-bit RGB PNG of a three-channel array, which names the software that
-- made it and no time: equal pixels give equal bytes, for any number of workers.
-- About 5 ns a pixel.
encodePicture :: Workers -> String -> PixelArray Word8 -> IO Lazy.ByteString
encodePicture crew software codes = do
  strips <- mapShared crew (pure . compressedStrip codes) (stripsOf shape)
  let (sums, pieces) = unzip [(total, piece) | Strip total piece <- strips]
      body = (zlibHeader : pieces) ++ [zlibTrailer (mconcat sums)]
  pure . Builder.toLazyByteString $
    Builder.byteString signature
      <> chunk "IHDR" (Lazy.toStrict (Builder.toLazyByteString header))
      <> chunk "tEXt" (Bytes.concat [Characters.pack "Software", Bytes.singleton 0, Characters.pack software])
      <> chunk "IDAT" (Bytes.concat body)
      <> chunk "IEND" Bytes.empty
  where
    shape = pixelArrayShape codes
    signature = Bytes.pack [0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a]
    header =
      Builder.word32BE (fromIntegral (shapeWidth shape))
        <> Builder.word32BE (fromIntegral (shapeHeight shape))
        -- Eight bits, RGB, the only compression and filtering, no interlace.
        <> foldMap Builder.word8 [8, 2, 0, 0, 0]

chunk :: String -> ByteString -> Builder
chunk name content =
  Builder.word32BE (fromIntegral (Bytes.length content))
    <> Builder.byteString named
    <> Builder.word32BE (crc32 named)
  where
    named = Characters.pack name <> content

-- | Rows from one to before another, and whether they are the last.
data Rows = Rows !Int !Int !Place

-- | Of about 256 KiB, so that there is work for many and little is lost at the
-- seams.
stripsOf :: PixelShape -> [Rows]
stripsOf shape = go 0
  where
    height = shapeHeight shape
    rows = max 1 (262144 `quot` shapeRowLength shape)
    go row
      | row + rows >= height = [Rows row height Last]
      | otherwise = Rows row (row + rows) Inside : go (row + rows)

-- | A strip's check sum and its compressed bytes.
data Strip = Strip !Adler32 !ByteString

compressedStrip :: PixelArray Word8 -> Rows -> Strip
compressedStrip codes (Rows from to place) = Strip (adler32 filtered) (deflatePiece place filtered)
  where
    shape = pixelArrayShape codes
    rowLength = shapeRowLength shape
    filtered = unsafeCreate ((rowLength + 1) * (to - from)) $ \out ->
      withForeignPtr pixels $ \start ->
        mapM_ (\i -> filterRow 3 rowLength (start `plusPtr` (rowLength * (from + i))) (out `plusPtr` ((rowLength + 1) * i))) [0 .. to - from - 1]
    (pixels, _) = Vector.unsafeToForeignPtr0 (toPixelVector codes)

-- | @filterRow pixel size row out@: the filter's number, then every byte less
-- the one a pixel before it (modulo 256), eight at a time.
filterRow :: Int -> Int -> Ptr Word8 -> Ptr Word8 -> IO ()
filterRow !pixel !size !row !out = do
  pokeByteOff out 0 (1 :: Word8)
  mapM_ (\i -> at i >>= put i) [0 .. min pixel size - 1]
  eights pixel
  where
    at :: Int -> IO Word8
    at = peekByteOff row
    put i = pokeByteOff out (i + 1)
    eights !i
      | i + 8 > size = singles i
      | otherwise = do
        a <- peekByteOff row i
        b <- peekByteOff row (i - pixel)
        pokeByteOff out (i + 1) (byteDifferences a b)
        eights (i + 8)
    singles !i
      | i >= size = pure ()
      | otherwise = do
        a <- at i
        b <- at (i - pixel)
        put i (a - b)
        singles (i + 1)

-- | Eight differences of bytes, none of which borrows from its neighbour.
byteDifferences :: Word64 -> Word64 -> Word64
byteDifferences a b = ((a .|. high) - (b .&. complement high)) `xor` ((a `xor` complement b) .&. high)
  where
    high = 0x8080808080808080
{-# INLINE byteDifferences #-}
