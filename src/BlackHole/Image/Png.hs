{-# LANGUAGE BangPatterns #-}

-- | PNG encoding of developed pictures by several workers (ISO/IEC 15948).
--
-- The filter of every row subtracts the pixel to the left from each pixel, which for
-- rendered pictures is within a few per cent of the best filter for each row. Strips of
-- rows are compressed independently ("BlackHole.Image.Deflate") and form one zlib
-- stream, which is why no library's encoder serves here: all of them use one thread and
-- need the whole picture.
module BlackHole.Image.Png
  ( Codes (..),
    encodePng,
    pngMetadata,
  )
where

import BlackHole.Image.Bytes
import BlackHole.Image.Checksum
import BlackHole.Image.Deflate
import BlackHole.Image.Metadata
import BlackHole.Image.Sphere
import BlackHole.Render.PixelArray (PixelArray, pixelArrayShape, toPixelVector)
import BlackHole.Render.PixelShape
import BlackHole.Render.Shared (mapShared)
import BlackHole.Render.Workers (Workers, workersCount)
import Control.Exception (evaluate)
import Data.Bits (complement, shiftR, xor, (.&.), (.|.))
import Data.ByteString (ByteString)
import qualified Data.ByteString as Bytes
import Data.ByteString.Builder (Builder)
import qualified Data.ByteString.Builder as Builder
import qualified Data.ByteString.Char8 as Characters
import Data.ByteString.Internal (unsafeCreate)
import qualified Data.Vector.Storable as Vector
import Data.Word (Word16, Word64, Word8)
import Foreign.Marshal.Alloc (allocaBytes)
import Foreign.Ptr (Ptr, plusPtr)
import Foreign.Storable (Storable, peekByteOff, pokeByteOff)

-- | Developed pixels with three channels.
data Codes
  = Codes8 !(PixelArray Word8)
  | Codes16 !(PixelArray Word16)

-- | @encodePng workers metadata shape bytes rowsOf put@ writes an RGB PNG with its
-- metadata, marked as sRGB and without a time stamp. The picture need not be in memory as
-- a whole: @rowsOf (first, count)@ returns consecutive bands of rows, each of several
-- megabytes of pixels. The workers ask such a band for the codes of a few rows, again by
-- first row and count within the picture, with @bytes@ bytes per number. @put@ receives
-- the bytes of the file. The result is 'False', and the file truncated, as soon as a band
-- or rows of it are missing or have another shape.
--
-- Equal pixels give equal bytes for any number of workers. Takes about 15 ns per pixel,
-- and three times that in 16 bits.
encodePng ::
  Workers ->
  Metadata ->
  PixelShape ->
  Int ->
  ((Int, Int) -> IO (Maybe ((Int, Int) -> Maybe Codes))) ->
  (ByteString -> IO ()) ->
  IO Bool
encodePng workers metadata shape bytes rowsOf put =
  go mempty [pngStart metadata shape bytes] (inGroups (stripsOf shape bytes))
  where
    go !total ready [] = True <$ mapM_ put (ready ++ [pngEnd total])
    go !total ready (strips : rest) = do
      let first = minimum [from | Rows from _ _ <- strips]
      band <- rowsOf (first, maximum [to | Rows _ to _ <- strips] - first)
      -- While one worker writes finished strips, the others continue.
      done <- case band of
        Nothing -> pure Nothing
        Just codesOf ->
          sequence . drop 1
            <$> mapShared
              workers
              id
              ((Nothing <$ mapM_ put ready) : map (evaluate . stripOf codesOf) strips)
      case done of
        Nothing -> pure False
        Just made ->
          go
            (total <> mconcat [part | Strip part _ <- made])
            [piece | Strip _ piece <- made]
            rest
    stripOf codesOf (Rows from to place) = do
      codes <- codesOf (from, to - from)
      let part = codesShape codes
      if (shapeWidth part, shapeHeight part, shapeChannels part)
        == (shapeWidth shape, to - from, shapeChannels shape)
        && codeBytes codes
        == bytes
        then Just $! compressedStrip codes (Rows 0 (to - from) place)
        else Nothing
    -- At the end of a group the workers wait for the last one. A strip with 8 bits
    -- corresponds to a megabyte of light.
    groupSize = max (2 * workersCount workers) (min 48 (16 * workersCount workers))
    inGroups strips = case splitAt groupSize strips of
      ([], _) -> []
      (group, rest) -> group : inGroups rest

-- | Everything before the compressed pixels, and the first bytes of their stream.
pngStart :: Metadata -> PixelShape -> Int -> ByteString
pngStart metadata shape bytes =
  strict $
    Builder.byteString signature
      <> chunk "IHDR" (strict header)
      -- The signal is sRGB, with perceptual rendering intent.
      <> chunk "sRGB" (Bytes.singleton 0)
      <> chunk
        "tEXt"
        (Bytes.concat [Characters.pack "Software\0", Characters.pack (metadataSoftware metadata)])
      -- Uncompressed, without a language.
      <> chunk
        "iTXt"
        (Bytes.concat [sceneKeyword, Characters.pack "\0\0\0\0\0", metadataText metadata])
      <> foldMap
        (chunk "iTXt" . (Characters.pack "XML:com.adobe.xmp\0\0\0\0\0" <>))
        (spherePacket metadata (shapeWidth shape, shapeHeight shape))
      <> chunk "IDAT" zlibHeader
  where
    header =
      Builder.word32BE (fromIntegral (shapeWidth shape))
        <> Builder.word32BE (fromIntegral (shapeHeight shape))
        -- RGB, the only compression and filter method, not interlaced.
        <> foldMap Builder.word8 [8 * fromIntegral bytes, 2, 0, 0, 0]

-- | The last bytes of the stream and the end of the file.
pngEnd :: Adler32 -> ByteString
pngEnd total = strict (chunk "IDAT" (zlibTrailer total) <> chunk "IEND" Bytes.empty)

-- | The metadata of a PNG file written by this program.
pngMetadata :: ByteString -> Maybe Metadata
pngMetadata bytes = Bytes.stripPrefix signature bytes >>= go
  where
    go rest = do
      size <- bigEndian 4 0 rest
      name <- slice 4 4 rest
      content <- slice 8 size rest
      case Bytes.stripPrefix sceneKeyword content of
        Just text | name == Characters.pack "iTXt" -> parseMetadata (Bytes.drop 5 text)
        _ -> go (Bytes.drop (12 + size) rest)

signature :: ByteString
signature = Bytes.pack [0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a]

sceneKeyword :: ByteString
sceneKeyword = Characters.pack "blackhole scene"

codesShape :: Codes -> PixelShape
codesShape (Codes8 pixels) = pixelArrayShape pixels
codesShape (Codes16 pixels) = pixelArrayShape pixels

codeBytes :: Codes -> Int
codeBytes (Codes8 _) = 1
codeBytes (Codes16 _) = 2

chunk :: String -> ByteString -> Builder
chunk name content =
  Builder.word32BE (fromIntegral (Bytes.length content))
    <> Builder.byteString named
    <> Builder.word32BE (crc32 named)
  where
    named = Characters.pack name <> content

-- | A range of rows (from the first to before the last), and whether it ends the
-- picture.
data Rows = Rows !Int !Int !Place

-- | Strips of about 256 KiB, so that many workers have work and little is lost at the
-- boundaries.
stripsOf :: PixelShape -> Int -> [Rows]
stripsOf shape bytes = go 0
  where
    height = shapeHeight shape
    rows = max 1 (262144 `quot` (shapeRowLength shape * bytes))
    go row
      | row + rows >= height = [Rows row height Last]
      | otherwise = Rows row (row + rows) Inside : go (row + rows)

-- | A strip's checksum and its compressed bytes, as a chunk of its own: a chunk's size
-- has 31 bits, and a writer of a huge picture need not know the total size in advance.
data Strip = Strip !Adler32 !ByteString

compressedStrip :: Codes -> Rows -> Strip
compressedStrip codes (Rows from to place) =
  Strip
    (adler32 filtered)
    (strict (chunk "IDAT" (deflatePiece place filtered)))
  where
    rowLength = shapeRowLength (codesShape codes)
    rowBytes = rowLength * codeBytes codes
    filtered = unsafeCreate ((rowBytes + 1) * (to - from)) $ \out -> case codes of
      Codes8 pixels -> eachRow pixels out (filterRow 3 rowBytes)
      Codes16 pixels -> allocaBytes rowBytes $ \swapped ->
        eachRow pixels out $ \row filteredRow -> do
          highFirst rowLength row swapped
          filterRow 6 rowBytes swapped filteredRow
    eachRow :: Storable e => PixelArray e -> Ptr Word8 -> (Ptr Word8 -> Ptr Word8 -> IO ()) -> IO ()
    eachRow pixels out act = Vector.unsafeWith (toPixelVector pixels) $ \start ->
      mapM_
        (\i -> act (start `plusPtr` (rowBytes * (from + i))) (out `plusPtr` ((rowBytes + 1) * i)))
        [0 .. to - from - 1]

-- | Converts 16-bit words to the byte order of PNG, highest byte first.
highFirst :: Int -> Ptr Word8 -> Ptr Word8 -> IO ()
highFirst count from to = mapM_ swapped [0 .. count - 1]
  where
    swapped i = do
      word <- peekByteOff from (2 * i) :: IO Word16
      pokeByteOff to (2 * i) (fromIntegral (word `shiftR` 8) :: Word8)
      pokeByteOff to (2 * i + 1) (fromIntegral word :: Word8)

-- | @filterRow pixel size row out@ writes the number of the filter, followed by every
-- byte minus the byte one pixel before it (modulo 256), eight at a time.
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
byteDifferences a b =
  ((a .|. high) - (b .&. complement high))
    `xor` ((a `xor` complement b) .&. high)
  where
    high = 0x8080808080808080
{-# INLINE byteDifferences #-}
