{-# LANGUAGE BangPatterns #-}

-- | OpenEXR files with one part of scan lines and ZIP compression in blocks of 16
-- lines, after "OpenEXR File Layout" and "Technical Introduction to OpenEXR" (Academy
-- Software Foundation). Light is linear, in the primaries of BT.709, as on the film.
--
-- Written by hand because no library for this format is packaged for Debian or Stackage.
module BlackHole.Image.Exr
  ( ExrPrecision (..),
    encodeExr,
    exrMetadata,
    halfBits,
  )
where

import BlackHole.Image.Bytes
import BlackHole.Image.Deflate
import BlackHole.Image.Destination
import BlackHole.Image.Metadata
import BlackHole.Image.Sphere
import BlackHole.Render.Exposed (Film)
import BlackHole.Render.Layer
import BlackHole.Render.PixelArray (pixelArrayShape, toPixelVector)
import BlackHole.Render.PixelShape
import BlackHole.Render.Release
import BlackHole.Render.Shared (mapShared)
import BlackHole.Render.Workers (Workers, workersCount)
import Data.Bits (complement, shiftL, shiftR, xor, (.&.), (.|.))
import Data.ByteString (ByteString)
import qualified Data.ByteString as Bytes
import Data.ByteString.Builder (Builder)
import qualified Data.ByteString.Builder as Builder
import qualified Data.ByteString.Char8 as Characters
import Data.ByteString.Internal (unsafeCreate)
import Data.ByteString.Unsafe (unsafeIndex)
import Data.IORef (modifyIORef', newIORef, readIORef)
import Data.List (sort, sortOn)
import qualified Data.Vector.Storable as Vector
import Data.Word (Word16, Word32, Word8)
import Foreign.Ptr (Ptr)
import Foreign.Storable (pokeByteOff)

-- | The precision of the light. Layers always have 32 bits.
data ExrPrecision
  = -- | 16-bit floating point: within 1 in 2048, from 6e-8 to 65504.
    Half
  | -- | The film's own 32 bits.
    Single
  deriving (Eq, Show, Enum, Bounded)

-- | A channel: its name, and whether it is written in 16 bits.
data Channel = Channel !String !Bool

channelName :: Channel -> String
channelName (Channel name _) = name

channelBytes :: Channel -> Int
channelBytes (Channel _ half) = if half then 2 else 4

-- | The numbers of one channel in a row, as bits: whether they are written in 16 bits,
-- their first index in the array, and their distance.
data ChannelRow = ChannelRow !Bool !Int !Int !(Vector.Vector Word32)

-- | @encodeExr workers precision metadata (width, height) layers@ is the encoder of files
-- with a film's light in the channels R, G and B, additional layers and the metadata
-- (attributes @software@ and @comments@). It keeps a few rows in memory, but all
-- compressed blocks if the destination cannot go back, because their offsets precede
-- them. 'Nothing' if names of layers are equal, empty or longer than 31 characters. The
-- bytes do not depend on the number of workers.
encodeExr :: Workers -> ExrPrecision -> Metadata -> (Int, Int) -> Layers -> Maybe Encoder
encodeExr workers precision metadata (width, height) layers
  | layersFit layers = Just $ \rowsOf destination ->
    let eachIn = eachBlock workers precision width height layers rowsOf
     in case overwriteBytes destination of
          Just overwrite -> do
            sizes <- newIORef []
            putBytes destination header
            putBytes destination (Bytes.replicate (8 * length (blocksOf height)) 0)
            complete <- eachIn $ \bytes -> do
              -- Evaluated now; otherwise the thunk of the length would retain the bytes.
              let !size = Bytes.length bytes
              modifyIORef' sizes (size :)
              putBytes destination bytes
            written <- reverse <$> readIORef sizes
            complete <$ overwrite (Bytes.length header) (offsets written)
          Nothing -> do
            kept <- newIORef []
            complete <- eachIn (\bytes -> modifyIORef' kept (bytes :))
            blocks <- reverse <$> readIORef kept
            mapM_ (putBytes destination) (header : offsets (map Bytes.length blocks) : blocks)
            pure complete
  | otherwise = Nothing
  where
    header = strict (headerOf metadata width height (channelsOf precision layers))
    -- The offsets of blocks of these sizes, after the header and this table.
    offsets sizes =
      strict . foldMap (Builder.word64LE . fromIntegral) $
        zipWith const (scanl (+) (Bytes.length header + 8 * length sizes) sizes) sizes

layersFit :: Layers -> Bool
layersFit layers = and (zipWith (/=) names (drop 1 names)) && all good (layerNames layers)
  where
    names = sort (["R", "G", "B"] ++ layerNames layers)
    good name = let size = length name in size > 0 && size < 32 && all (`elem` ['!' .. '~']) name

-- | The channels in the order of their names, as the format requires.
channelsOf :: ExrPrecision -> Layers -> [Channel]
channelsOf precision layers =
  sortOn channelName $
    [Channel name (precision == Half) | name <- ["R", "G", "B"]]
      ++ [Channel name False | name <- layerNames layers]

-- | The first row of each block and the row after its last.
blocksOf :: Int -> [(Int, Int)]
blocksOf height =
  [(row, min height (row + linesPerBlock)) | row <- [0, linesPerBlock .. height - 1]]

-- | Passes on all blocks in order, each preceded by its row and size.
eachBlock ::
  Workers ->
  ExrPrecision ->
  Int ->
  Int ->
  Layers ->
  ((Int, Int) -> IO (Maybe Film)) ->
  (ByteString -> IO ()) ->
  IO Bool
eachBlock workers precision width height layers rowsOf put = go (blocksOf height)
  where
    go blocks = case splitAt (4 * workersCount workers) blocks of
      ([], _) -> pure True
      (group, rest) -> do
        let first = minimum (map fst group)
            count = maximum (map snd group) - first
        band <- rowsOf (first, count)
        case band of
          Just film
            | ( shapeWidth (pixelArrayShape film),
                shapeHeight (pixelArrayShape film),
                shapeChannels (pixelArrayShape film)
              )
                == (width, count, 3) ->
              do
                done <- mapShared workers (coded first film) group
                mapM_ put done
                release (12 * width * count)
                go rest
          _ -> pure False
    coded first film (from, to) = do
      rows <- mapM (rowChannels first film) [from .. to - 1]
      let content = block width rows
      pure
        ( strict
            ( Builder.int32LE (fromIntegral from)
                <> Builder.int32LE (fromIntegral (Bytes.length content))
            )
            <> content
        )
    -- The channels of a row in the order of their names.
    rowChannels first film row = do
      further <- layerRow layers row
      let light = Vector.unsafeCast (toPixelVector film)
          named =
            [ (name, ChannelRow (precision == Half) (3 * width * (row - first) + k) 3 light)
              | (name, k) <- zip ["R", "G", "B"] [0 ..]
            ]
              ++ [ (name, ChannelRow False 0 1 (Vector.unsafeCast (fitted values)))
                   | (name, values) <- zip (layerNames layers) (further ++ repeat Vector.empty)
                 ]
      pure (map snd (sortOn fst named))
    -- Values that a layer lacks are unknown.
    fitted :: Vector.Vector Float -> Vector.Vector Float
    fitted values
      | Vector.length values >= width = values
      | otherwise = values <> Vector.replicate (width - Vector.length values) (0 / 0)

linesPerBlock :: Int
linesPerBlock = 16

headerOf :: Metadata -> Int -> Int -> [Channel] -> Builder
headerOf metadata width height channels =
  Builder.byteString magic
    <> attribute "channels" "chlist" (foldMap described channels <> Builder.word8 0)
    <> attribute
      "chromaticities"
      "chromaticities"
      (foldMap Builder.floatLE [0.64, 0.33, 0.30, 0.60, 0.15, 0.06, 0.3127, 0.3290])
    <> attribute commentsName "string" (Builder.byteString (metadataText metadata))
    <> attribute "compression" "compression" (Builder.word8 3)
    <> attribute "dataWindow" "box2i" window
    <> attribute "displayWindow" "box2i" window
    -- A map of all directions by latitude and longitude.
    <> ( if isWholeSphere metadata (width, height)
           then attribute "envmap" "envmap" (Builder.word8 0)
           else mempty
       )
    <> attribute "lineOrder" "lineOrder" (Builder.word8 0)
    <> attribute "pixelAspectRatio" "float" (Builder.floatLE 1)
    <> attribute "screenWindowCenter" "v2f" (Builder.floatLE 0 <> Builder.floatLE 0)
    <> attribute "screenWindowWidth" "float" (Builder.floatLE 1)
    <> attribute "software" "string" (Builder.string7 (metadataSoftware metadata))
    <> Builder.word8 0
  where
    window = foldMap (Builder.int32LE . fromIntegral) [0, 0, width - 1, height - 1]
    described channel =
      Builder.string7 (channelName channel) <> Builder.word8 0
        -- The type (1 is half, 2 is float), no perceptual coding, and every pixel of
        -- every line.
        <> Builder.int32LE (if channelBytes channel == 2 then 1 else 2)
        <> Builder.word32LE 0
        <> Builder.int32LE 1
        <> Builder.int32LE 1
    attribute name kind value =
      let content = strict value
       in Builder.string7 name <> Builder.word8 0 <> Builder.string7 kind <> Builder.word8 0
            <> Builder.int32LE (fromIntegral (Bytes.length content))
            <> Builder.byteString content

-- | The magic number, and version 2 without flags.
magic :: ByteString
magic = Bytes.pack [0x76, 0x2f, 0x31, 0x01, 2, 0, 0, 0]

commentsName :: String
commentsName = "comments"

-- | The metadata of an OpenEXR file written by this program.
exrMetadata :: ByteString -> Maybe Metadata
exrMetadata bytes = Bytes.stripPrefix magic bytes >>= go
  where
    go rest
      | Bytes.null name = Nothing
      | otherwise = do
        size <- littleEndian 4 0 sized
        content <- slice 4 size sized
        if name == Characters.pack commentsName
          then parseMetadata content
          else go (Bytes.drop (4 + size) sized)
      where
        (name, afterName) = Bytes.break (== 0) rest
        sized = Bytes.drop 1 (Bytes.dropWhile (/= 0) (Bytes.drop 1 afterName))

-- | Several lines, channel by channel, compressed: the bytes are split into even and
-- odd ones, replaced by their differences, and written as a zlib stream; or stored
-- unchanged if that is no longer.
block :: Int -> [[ChannelRow]] -> ByteString
block width rows
  | Bytes.length compressed < Bytes.length raw = compressed
  | otherwise = raw
  where
    raw = unsafeCreate (sum (map rowBytes (concat rows))) (\out -> writeRows out 0 (concat rows))
    compressed = zlibStream (differences (evenOdd raw))
    rowBytes (ChannelRow half _ _ _) = if half then 2 * width else 4 * width
    writeRows :: Ptr Word8 -> Int -> [ChannelRow] -> IO ()
    writeRows _ !_ [] = pure ()
    writeRows out !at (row : rest) = do
      writeRow out at row
      writeRows out (at + rowBytes row) rest
    writeRow :: Ptr Word8 -> Int -> ChannelRow -> IO ()
    writeRow out !at (ChannelRow half first stride numbers) = go 0
      where
        go !x
          | x >= width = pure ()
          | half = do
            let h = halfBits (number x)
            byte (at + 2 * x) (fromIntegral h)
            byte (at + 2 * x + 1) (fromIntegral (h `shiftR` 8))
            go (x + 1)
          | otherwise = do
            let w = number x
            byte (at + 4 * x) (fromIntegral w)
            byte (at + 4 * x + 1) (fromIntegral (w `shiftR` 8))
            byte (at + 4 * x + 2) (fromIntegral (w `shiftR` 16))
            byte (at + 4 * x + 3) (fromIntegral (w `shiftR` 24))
            go (x + 1)
        number x = Vector.unsafeIndex numbers (first + stride * x)
        byte :: Int -> Word8 -> IO ()
        byte = pokeByteOff out

-- | The bytes at even positions, followed by those at odd positions.
evenOdd :: ByteString -> ByteString
evenOdd bytes = unsafeCreate size (go 0)
  where
    size = Bytes.length bytes
    half = (size + 1) `quot` 2
    go :: Int -> Ptr Word8 -> IO ()
    go !i !out
      | i >= size = pure ()
      | otherwise = do
        pokeByteOff out ((if even i then 0 else half) + i `quot` 2) (unsafeIndex bytes i)
        go (i + 1) out

-- | The first byte, followed by each byte minus its predecessor plus 128.
differences :: ByteString -> ByteString
differences bytes = unsafeCreate (Bytes.length bytes) (go 0 128)
  where
    go :: Int -> Word8 -> Ptr Word8 -> IO ()
    go !i !before !out
      | i >= Bytes.length bytes = pure ()
      | otherwise = do
        let byte = unsafeIndex bytes i
        pokeByteOff out i (byte - before + 128)
        go (i + 1) byte out

-- | The bits of the 16-bit floating-point number (IEEE 754 binary16) nearest to the
-- given 32 bits, with ties to even. Finite values beyond the largest, 65504, become
-- 65504. Infinities stay infinite, and NaN stays NaN.
halfBits :: Word32 -> Word16
halfBits bits
  | magnitude > 0x7f800000 = sign .|. 0x7e00
  | magnitude == 0x7f800000 = sign .|. 0x7c00
  | magnitude >= 0x477ff000 = sign .|. 0x7bff
  -- Normal numbers, from 2^-14 up.
  | magnitude >= 0x38800000 = sign .|. fromIntegral (rounded 13 (magnitude - 0x38000000))
  -- At most half of 2^-24, which rounds to zero.
  | magnitude <= 0x33000000 = sign
  | otherwise = sign .|. fromIntegral (rounded shift ((magnitude .&. 0x7fffff) .|. 0x800000))
  where
    sign = fromIntegral ((bits `xor` magnitude) `shiftR` 16)
    magnitude = bits .&. complement 0x80000000
    -- The number of bits by which the fraction moves below the smallest exponent.
    shift = 126 - fromIntegral (magnitude `shiftR` 23) :: Int
    rounded :: Int -> Word32 -> Word32
    rounded by v = (v + (1 `shiftL` (by - 1)) - 1 + ((v `shiftR` by) .&. 1)) `shiftR` by
{-# INLINE halfBits #-}
