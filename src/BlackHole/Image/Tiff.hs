{-# LANGUAGE BangPatterns #-}

-- | TIFF files, uncompressed so that every program can read them (revision 6.0).
--
-- Programs interpret 16-bit TIFF as display codes, so these files contain the developed
-- picture, for editing without banding. Programs interpret 32-bit floating point as
-- linear light, so these files contain the film's own light.
module BlackHole.Image.Tiff
  ( TiffPixels (..),
    tiffHeader,
    tiffRows,
    tiffMetadata,
  )
where

import BlackHole.Image.Bytes
import BlackHole.Image.Metadata
import BlackHole.Image.Sphere
import BlackHole.Render.Exposed (Film)
import BlackHole.Render.PixelArray (PixelArray, pixelArrayShape, toPixelVector)
import BlackHole.Render.PixelShape
import Data.Bits (Bits, shiftR)
import Data.ByteString (ByteString)
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Builder as Builder
import qualified Data.ByteString.Char8 as Characters
import Data.ByteString.Internal (unsafeCreate)
import Data.List (sortOn)
import Data.Vector.Storable (Storable)
import qualified Data.Vector.Storable as Vector
import Data.Word (Word16, Word32, Word8)
import Foreign.Storable (pokeByteOff)

-- | The pixels of a file, with three channels.
data TiffPixels
  = -- | Developed codes.
    TiffCodes !(PixelArray Word16)
  | -- | Linear light.
    TiffLight !Film

-- | The rows of a band as they are in the file.
tiffRows :: TiffPixels -> [ByteString]
tiffRows pixels = case pixels of
  TiffCodes codes -> littleEndianRows 2 (pixelArrayShape codes) (toPixelVector codes)
  TiffLight film ->
    littleEndianRows
      4
      (pixelArrayShape film)
      (Vector.unsafeCast (toPixelVector film) :: Vector.Vector Word32)

-- | @tiffHeader metadata bits (width, height)@ is everything before the rows of a
-- little-endian RGB file of 16-bit codes or 32-bit floating point, with the metadata as
-- its image description. 'Nothing' for pictures of 4 GiB or more, which the format cannot
-- hold.
tiffHeader :: Metadata -> Int -> (Int, Int) -> Maybe ByteString
tiffHeader metadata bits (width, height)
  | toInteger width * toInteger height * 3 * toInteger (bits `quot` 8) > 0xf0000000 = Nothing
  | otherwise =
    Just . strict $
      Builder.string7 "II" <> Builder.word16LE 42 <> Builder.word32LE 8
        <> Builder.word16LE (fromIntegral (length entries))
        <> mconcat
          [ Builder.word16LE tag <> Builder.word16LE kind <> Builder.word32LE count <> value
            | (tag, kind, count, value) <- place heapStart entries
          ]
        <> Builder.word32LE 0
        <> Builder.byteString (Bytes.concat (outside entries))
  where
    entries = directoryEntries metadata bits (width, height) dataStart
    heapStart = 8 + 2 + 12 * length anywhere + 4
    dataStart = heapStart + sum (map Bytes.length (outside anywhere))
    -- The sizes of the values do not depend on where the data starts.
    anywhere = directoryEntries metadata bits (width, height) 0
    -- The values that do not fit into their entries.
    outside found = [content | (_, _, _, content) <- found, Bytes.length content > 4]
    place _ [] = []
    place at ((tag, kind, count, content) : rest)
      | Bytes.length content > 4 =
        (tag, kind, count, Builder.word32LE (fromIntegral at)) :
        place (at + Bytes.length content) rest
      | otherwise =
        (tag, kind, count, Builder.byteString (Bytes.take 4 (content <> Bytes.replicate 4 0))) :
        place at rest

-- | The entries in the order of their tags, for data that starts at a byte of the file.
directoryEntries :: Metadata -> Int -> (Int, Int) -> Int -> [DirectoryEntry]
directoryEntries metadata bits (width, height) dataStart =
  sortOn (\(tag, _, _, _) -> tag) $
    [ long 256 width,
      long 257 height,
      shorts 258 (replicate 3 bits),
      shorts 259 [1],
      shorts 262 [2],
      ascii 270 (metadataText metadata),
      long 273 dataStart,
      shorts 277 [3],
      long 278 height,
      long 279 (width * height * 3 * (bits `quot` 8)),
      ratio 282 72,
      ratio 283 72,
      shorts 284 [1],
      shorts 296 [2],
      ascii 305 (Characters.pack (metadataSoftware metadata)),
      shorts 339 (replicate 3 (if bits == 32 then 3 else 1))
    ]
      ++ [ (700, 1, fromIntegral (Bytes.length packet), padded packet)
           | Just packet <- [spherePacket metadata (width, height)]
         ]
  where
    shorts :: Word16 -> [Int] -> DirectoryEntry
    long tag v = (tag, 4, 1, strict (Builder.word32LE (fromIntegral v)))
    shorts tag values =
      ( tag,
        3,
        fromIntegral (length values),
        strict (foldMap (Builder.word16LE . fromIntegral) values)
      )
    ratio tag v = (tag, 5, 1, strict (Builder.word32LE v <> Builder.word32LE 1))
    ascii tag text =
      let ended = Bytes.snoc text 0 in (tag, 2, fromIntegral (Bytes.length ended), padded ended)
    padded bytes = if odd (Bytes.length bytes) then Bytes.snoc bytes 0 else bytes

-- | The numbers of every row, lowest byte first, produced lazily.
littleEndianRows ::
  (Storable e, Integral e, Bits e) =>
  Int ->
  PixelShape ->
  Vector.Vector e ->
  [ByteString]
littleEndianRows bytes shape numbers = map row [0 .. shapeHeight shape - 1]
  where
    size = shapeRowLength shape
    row y = unsafeCreate (bytes * size) $ \out ->
      let go !i
            | i >= size = pure ()
            | otherwise = put i 0 (Vector.unsafeIndex numbers (y * size + i)) >> go (i + 1)
          put !i !k !v
            | k >= bytes = pure ()
            | otherwise = do
              pokeByteOff out (bytes * i + k) (fromIntegral v :: Word8)
              put i (k + 1) (v `shiftR` 8)
       in go 0
{-# INLINE littleEndianRows #-}

-- | Tag, type, count, and the bytes of the value.
type DirectoryEntry = (Word16, Word16, Word32, ByteString)

-- | The metadata of a TIFF file written by this program.
tiffMetadata :: ByteString -> Maybe Metadata
tiffMetadata bytes = do
  _ <- Bytes.stripPrefix (Bytes.pack [0x49, 0x49, 42, 0]) bytes
  directory <- littleEndian 4 4 bytes
  count <- littleEndian 2 directory bytes
  case [ place
         | i <- [0 .. count - 1],
           let place = directory + 2 + 12 * i,
           littleEndian 2 place bytes == Just 270
       ] of
    place : _ -> do
      size <- littleEndian 4 (place + 4) bytes
      start <- littleEndian 4 (place + 8) bytes
      parseMetadata . Bytes.takeWhile (/= 0) =<< slice start size bytes
    [] -> Nothing
