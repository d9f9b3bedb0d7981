{-# LANGUAGE BangPatterns #-}

-- | OpenEXR files, after "OpenEXR File Layout" and "Technical Introduction to
-- OpenEXR" (Academy Software Foundation): one part of scan lines, ZIP
-- compression in blocks of 16 lines. Light is linear, in the primaries of
-- BT.709, as the film has it.
module BlackHole.Image.Exr
  ( ExrPrecision (..),
    encodeExr,
    exrLabel,
    halfBits,
  )
where

import BlackHole.Image.Bytes
import BlackHole.Image.Deflate
import BlackHole.Image.Label
import BlackHole.Render.Film (Film)
import BlackHole.Render.Layer
import BlackHole.Render.PixelArray (pixelArrayShape, toPixelVector)
import BlackHole.Render.PixelShape
import BlackHole.Render.Shared (mapShared)
import BlackHole.Render.Workers (Workers)
import Data.Bits (complement, shiftL, shiftR, xor, (.&.), (.|.))
import Data.ByteString (ByteString)
import qualified Data.ByteString as Bytes
import Data.ByteString.Builder (Builder)
import qualified Data.ByteString.Builder as Builder
import qualified Data.ByteString.Char8 as Characters
import Data.ByteString.Internal (unsafeCreate)
import qualified Data.ByteString.Lazy as Lazy
import Data.ByteString.Unsafe (unsafeIndex)
import Data.List (sortOn)
import qualified Data.Vector.Storable as Vector
import Data.Word (Word16, Word32, Word8)
import Foreign.Ptr (Ptr)
import Foreign.Storable (pokeByteOff)

-- | How finely light is kept. Layers always have 32 bits.
data ExrPrecision
  = -- | 16-bit floating point: within 1 in 2048, from 6e-8 to 65504.
    Half
  | -- | The film's own 32 bits.
    Single
  deriving (Eq, Show, Enum, Bounded)

-- | One plane of numbers: its name, whether it is written in 16 bits, where it
-- begins in an array, and how far its numbers lie apart there. The numbers are
-- seen as their bits.
data Channel = Channel !String !Bool !Int !Int !(Vector.Vector Word32)

channelName :: Channel -> String
channelName (Channel name _ _ _ _) = name

channelBytes :: Channel -> Int
channelBytes (Channel _ half _ _ _) = if half then 2 else 4

-- | A file of a film's light, channels R, G and B, with further layers and the
-- label (attributes @software@ and @comments@). 'Nothing' if a layer is not one channel
-- of the film's size, or names do not differ or are empty or longer than 31
-- characters. Equal bytes for any number of workers.
encodeExr :: Workers -> ExrPrecision -> Label -> [Layer] -> Film -> IO (Maybe Lazy.ByteString)
encodeExr crew precision label layers film
  | all fitting layers && distinct (map channelName channels) && all goodName layers = Just <$> encoded
  | otherwise = pure Nothing
  where
    shape = pixelArrayShape film
    width = shapeWidth shape
    height = shapeHeight shape
    fitting layer =
      let own = pixelArrayShape (layerValues layer)
       in shapeWidth own == width && shapeHeight own == height && shapeChannels own == 1
    goodName layer = let size = length (layerName layer) in size > 0 && size < 32 && all (`elem` ['!' .. '~']) (layerName layer)
    distinct names = and (zipWith (/=) names (drop 1 names))
    -- The format wants them in the order of their names.
    channels =
      sortOn channelName $
        [Channel name (precision == Half) k 3 light | (name, k) <- zip ["R", "G", "B"] [0 ..]]
          ++ [Channel (layerName layer) False 0 1 (Vector.unsafeCast (toPixelVector (layerValues layer))) | layer <- layers]
    light = Vector.unsafeCast (toPixelVector film)
    encoded = do
      blocks <- mapShared crew (pure . block width channels) [(row, min height (row + linesPerBlock)) | row <- [0, linesPerBlock .. height - 1]]
      let header = strict (headerOf label width height channels)
          starts = scanl (+) (Bytes.length header + 8 * length blocks) (map ((+ 8) . Bytes.length) blocks)
      pure . Builder.toLazyByteString $
        Builder.byteString header
          <> foldMap (Builder.word64LE . fromIntegral) (zipWith const starts blocks)
          <> mconcat
            [ Builder.int32LE (fromIntegral row) <> Builder.int32LE (fromIntegral (Bytes.length content)) <> Builder.byteString content
              | (row, content) <- zip [0 :: Int, linesPerBlock ..] blocks
            ]

linesPerBlock :: Int
linesPerBlock = 16

headerOf :: Label -> Int -> Int -> [Channel] -> Builder
headerOf label width height channels =
  Builder.byteString magic
    <> attribute "channels" "chlist" (foldMap described channels <> Builder.word8 0)
    <> attribute "chromaticities" "chromaticities" (foldMap Builder.floatLE [0.64, 0.33, 0.30, 0.60, 0.15, 0.06, 0.3127, 0.3290])
    <> attribute commentsName "string" (Builder.byteString (labelText label))
    <> attribute "compression" "compression" (Builder.word8 3)
    <> attribute "dataWindow" "box2i" window
    <> attribute "displayWindow" "box2i" window
    <> attribute "lineOrder" "lineOrder" (Builder.word8 0)
    <> attribute "pixelAspectRatio" "float" (Builder.floatLE 1)
    <> attribute "screenWindowCenter" "v2f" (Builder.floatLE 0 <> Builder.floatLE 0)
    <> attribute "screenWindowWidth" "float" (Builder.floatLE 1)
    <> attribute "software" "string" (Builder.string7 (labelSoftware label))
    <> Builder.word8 0
  where
    window = foldMap (Builder.int32LE . fromIntegral) [0, 0, width - 1, height - 1]
    described channel =
      Builder.string7 (channelName channel) <> Builder.word8 0
        -- The type: 1 is half, 2 is float; then no perceptual coding, and every
        -- pixel of every line.
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

-- | The label of an OpenEXR file that this program wrote.
exrLabel :: ByteString -> Maybe Label
exrLabel bytes = Bytes.stripPrefix magic bytes >>= go
  where
    go rest
      | Bytes.null name = Nothing
      | otherwise = do
        size <- littleEndian 4 0 sized
        content <- slice 4 size sized
        if name == Characters.pack commentsName then parseLabel content else go (Bytes.drop (4 + size) sized)
      where
        (name, afterName) = Bytes.break (== 0) rest
        sized = Bytes.drop 1 (Bytes.dropWhile (/= 0) (Bytes.drop 1 afterName))

-- | Some lines, channel by channel, compressed: bytes split into even and odd
-- ones, replaced by their differences, as a zlib stream; or as they are if that
-- is no shorter.
block :: Int -> [Channel] -> (Int, Int) -> ByteString
block width channels (from, to)
  | Bytes.length compressed < Bytes.length raw = compressed
  | otherwise = raw
  where
    raw = unsafeCreate (sum (map (\c -> width * channelBytes c) channels) * (to - from)) (\out -> writeLines out 0 from)
    compressed = zlibStream (differences (evenOdd raw))
    writeLines :: Ptr Word8 -> Int -> Int -> IO ()
    writeLines out !at !row
      | row >= to = pure ()
      | otherwise = writeChannels out at row channels
    writeChannels out !at !row [] = writeLines out at (row + 1)
    writeChannels out !at !row (channel : rest) = do
      writeRow out at channel row
      writeChannels out (at + width * channelBytes channel) row rest
    writeRow :: Ptr Word8 -> Int -> Channel -> Int -> IO ()
    writeRow out !at (Channel _ half start stride numbers) row = go 0
      where
        !first = start + stride * width * row
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

-- | The bytes at even places, then those at odd ones.
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

-- | The first byte, then each byte less the one before it, plus 128.
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

-- | The bits of the nearest 16-bit floating-point number (IEEE 754 binary16, ties
-- to even) to that of the given 32. What is beyond the largest, 65504, becomes that
-- one unless it is infinite: light without end is no picture. NaN stays NaN.
halfBits :: Word32 -> Word16
halfBits bits
  | magnitude > 0x7f800000 = sign .|. 0x7e00
  | magnitude == 0x7f800000 = sign .|. 0x7c00
  | magnitude >= 0x477ff000 = sign .|. 0x7bff
  -- Normal numbers: from 2^-14.
  | magnitude >= 0x38800000 = sign .|. fromIntegral (rounded 13 (magnitude - 0x38000000))
  -- Below 2^-24 times a half, which rounds to even: nothing.
  | magnitude <= 0x33000000 = sign
  | otherwise = sign .|. fromIntegral (rounded shift ((magnitude .&. 0x7fffff) .|. 0x800000))
  where
    sign = fromIntegral ((bits `xor` magnitude) `shiftR` 16)
    magnitude = bits .&. complement 0x80000000
    -- By so many bits the fraction moves below the smallest exponent.
    shift = 126 - fromIntegral (magnitude `shiftR` 23) :: Int
    rounded :: Int -> Word32 -> Word32
    rounded by v = (v + (1 `shiftL` (by - 1)) - 1 + ((v `shiftR` by) .&. 1)) `shiftR` by
{-# INLINE halfBits #-}
