-- | Environment maps from image files.
--
-- For any content of the file, the outcome is a picture or a one-line message. The size
-- claimed by the header is checked before memory is allocated, and errors of a decoder
-- become messages as well.
module BlackHole.Image.Panorama
  ( readPanoramaBytes,
    decodePanorama,
    panoramaFault,
    panoramaSize,
    maximumPanoramaPixels,
  )
where

import BlackHole.Image.JpegSegments (soundJpeg)
import BlackHole.Image.PlainTiff
import BlackHole.Light.Display (decodeSrgb)
import BlackHole.Light.Radiance
import BlackHole.Trace.EnvironmentMap
import qualified Codec.Compression.Zlib as Zlib
import Codec.Picture
import Codec.Picture.Types (convertImage, promoteImage)
import Control.Applicative ((<|>))
import Control.Exception
  ( IOException,
    SomeAsyncException (..),
    SomeException,
    evaluate,
    fromException,
    throwIO,
    try,
  )
import Data.Bits (shiftL, (.|.))
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Char8 as Char8
import qualified Data.ByteString.Lazy as Lazy
import Data.List (find)
import qualified Data.Vector.Unboxed as U
import System.IO (IOMode (..), hFileSize, withBinaryFile)
import System.IO.Error (ioeGetErrorString)

-- | The most pixels of an environment map: 8192 by 4096. Such a picture takes 550 MB,
-- and with 16 bits per channel 1.4 GB while it is decoded.
maximumPanoramaPixels :: Int
maximumPanoramaPixels = 8192 * 4096

-- | The file's bytes if the file exists and has a plausible size, or a message.
readPanoramaBytes :: FilePath -> IO (Either String Bytes.ByteString)
readPanoramaBytes file = do
  contents <- try (withBinaryFile file ReadMode sized)
  pure $ case contents of
    Left problem -> Left ("can't be read: " ++ ioeGetErrorString (problem :: IOException))
    Right Nothing -> Left "is too large for a panorama"
    Right (Just bytes) -> Right bytes
  where
    -- No file of that many pixels needs more than 16 bytes for each.
    sized handle = do
      size <- hFileSize handle
      if size > 16 * fromIntegral maximumPanoramaPixels
        then pure Nothing
        else Just <$> Bytes.hGet handle (fromInteger size)

-- | The environment map in the bytes of an equirectangular picture, twice as wide as high:
-- PNG, JPEG, plain TIFF or Radiance HDR. Files with 8 or 16 bits per channel are
-- interpreted as sRGB, and those with floating-point numbers as linear. 'Left' holds a
-- message without the file's name. Takes about 0.2 µs per pixel.
decodePanorama :: Bytes.ByteString -> IO (Either String EnvironmentMap)
decodePanorama bytes = do
  decoded <-
    try
      (evaluate (maybe (decodedByKind bytes) Left (panoramaFault bytes <|> swollen bytes)))
  case decoded of
    Right outcome -> pure outcome
    Left fault
      | Just (SomeAsyncException _) <- fromException fault -> throwIO (fault :: SomeException)
      | otherwise -> pure (Left "is damaged: its decoder gave up")

-- | Chooses the decoder by the kind of file. A decoder that tries all kinds takes a
-- damaged file for a Targa of any size, because Targa has no signature.
decodedByKind :: Bytes.ByteString -> Either String EnvironmentMap
decodedByKind bytes
  | Bytes.isPrefixOf (Bytes.pack [0x89]) bytes = case Bytes.unpack
    (Bytes.take 1 (Bytes.drop 28 bytes)) of
    -- JuicyPixels can access memory out of bounds in a damaged interlaced PNG.
    [0] -> decodedBy decodePng
    _ -> Left "is interlaced, or damaged; save it without interlacing"
  | Bytes.isPrefixOf (Bytes.pack [0xff]) bytes =
    if soundJpeg bytes
      then decodedBy decodeJpeg
      else Left "is damaged"
  | Bytes.isPrefixOf (Char8.pack "#?") bytes = decodedBy decodeHDR
  | otherwise =
    maybe
      ( Left
          "is damaged, or not a plain TIFF: 8 or 16 bits or floating-point numbers, not compressed"
      )
      plain
      (readPlainTiff bytes)
  where
    decodedBy decoder = either (const (Left "is damaged")) pictured (decoder bytes)
    plain tiff =
      maybe
        (Left "is empty")
        Right
        ( environmentMapFromPixels
            (tiffWidth tiff)
            (tiffHeight tiff)
            (\i j -> light (tiffFloating tiff) (tiffSamples tiff i j))
        )
    light floating (r, g, b)
      | floating = Radiance (positive r) (positive g) (positive b)
      | otherwise = Radiance (linear r) (linear g) (linear b)
    linear = decodeSrgb . realToFrac

-- | The error in a file's bytes that its header reveals, if there is one.
panoramaFault :: Bytes.ByteString -> Maybe String
panoramaFault bytes = case panoramaSize bytes of
  Nothing -> Just "is not a PNG, JPEG, TIFF or Radiance HDR picture"
  Just (width, height)
    | width < 2 || height < 1 || width /= 2 * height ->
      Just (size ++ "; a panorama is twice as wide as high")
    | width > maximumPanoramaPixels || width * height > maximumPanoramaPixels ->
      Just (size ++ "; a panorama has at most 8192 by 4096")
    | otherwise -> Nothing
    where
      size = "measures " ++ show width ++ " by " ++ show height ++ " pixels"

-- | Whether a PNG decompresses to more bytes than its pixels can need. A kilobyte may
-- contain a megabyte of zeros, and the decoder would allocate memory for all of them.
-- Decompresses the file once more, up to that limit, in constant memory.
swollen :: Bytes.ByteString -> Maybe String
swollen bytes = do
  packed <- Lazy.fromChunks <$> pngData bytes
  (width, height) <- panoramaSize bytes
  -- Eight bytes per pixel, and one byte for each row of each pass.
  let most = fromIntegral (8 * width * height + 16 * (width + height))
  if Lazy.null (Lazy.drop most (Zlib.decompress packed))
    then Nothing
    else Just "is damaged: it holds more than its pixels"

-- | The compressed data of a PNG; 'Nothing' for other files.
pngData :: Bytes.ByteString -> Maybe [Bytes.ByteString]
pngData bytes
  | pngSignature `Bytes.isPrefixOf` bytes = Just (chunks (Bytes.drop 8 bytes))
  | otherwise = Nothing
  where
    chunks rest
      | Bytes.length rest < 12 = []
      | otherwise =
        let size =
              Bytes.foldl'
                (\n b -> n `shiftL` 8 .|. fromIntegral b)
                0
                (Bytes.take 4 rest) ::
                Int
            contents = Bytes.take size (Bytes.drop 8 rest)
            others = chunks (Bytes.drop (size + 12) rest)
         in if Bytes.take 4 (Bytes.drop 4 rest) == Char8.pack "IDAT"
              then contents : others
              else others

pngSignature :: Bytes.ByteString
pngSignature = Bytes.pack [0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a]

-- | Width and height according to a file's header; 'Nothing' for other kinds of files,
-- and for headers that are truncated. Linear in the number of a JPEG's segments or a
-- TIFF's tags.
panoramaSize :: Bytes.ByteString -> Maybe (Int, Int)
panoramaSize bytes
  | pngSignature `Bytes.isPrefixOf` bytes = (,) <$> big 4 16 <*> big 4 20
  | Bytes.pack [0xff, 0xd8] `Bytes.isPrefixOf` bytes = jpeg 2
  | Char8.pack "#?" `Bytes.isPrefixOf` bytes = radiance
  | Bytes.pack [0x49, 0x49, 42, 0] `Bytes.isPrefixOf` bytes = tiff little
  | Bytes.pack [0x4d, 0x4d, 0, 42] `Bytes.isPrefixOf` bytes = tiff big
  | otherwise = Nothing
  where
    big, little :: Int -> Int -> Maybe Int
    big count at = Bytes.foldl' (\n b -> n `shiftL` 8 .|. fromIntegral b) 0 <$> slice count at
    little count at = Bytes.foldr' (\b n -> n `shiftL` 8 .|. fromIntegral b) 0 <$> slice count at
    slice count at
      | at < 0 || at > Bytes.length bytes - count = Nothing
      | otherwise = Just (Bytes.take count (Bytes.drop at bytes))
    -- Segments up to the first frame header, which contains the size.
    jpeg at = do
      marker <- big 2 at
      size <- big 2 (at + 2)
      if marker >= 0xffc0 && marker <= 0xffcf && marker `notElem` [0xffc4, 0xffc8, 0xffcc]
        then (,) <$> big 2 (at + 7) <*> big 2 (at + 5)
        else if marker < 0xff00 || size < 2 then Nothing else jpeg (at + 2 + size)
    radiance = do
      line <-
        find
          (Char8.pack "-Y " `Bytes.isPrefixOf`)
          (take 64 (Char8.lines (Bytes.take 65536 bytes)))
      case Char8.words line of
        [_, h, _, w] -> do
          (height, rest) <- Char8.readInt h
          (width, rest') <- Char8.readInt w
          if Bytes.null rest && Bytes.null rest' then Just (width, height) else Nothing
        _ -> Nothing
    tiff word = do
      directory <- word 4 4
      count <- word 2 directory
      let entries = [directory + 2 + 12 * i | i <- [0 .. count - 1]]
          tag number = do
            at <- find (\e -> word 2 e == Just number) entries
            kind <- word 2 (at + 2)
            word (if kind == 3 then 2 else 4) (at + 8)
      (,) <$> tag 256 <*> tag 257

-- | The decoded picture as linear light. Uses the decoded size, because the header may
-- be wrong.
pictured :: DynamicImage -> Either String EnvironmentMap
pictured decoded = case decoded of
  ImageY8 image -> made8 (promoteImage image)
  ImageYA8 image -> made8 (promoteImage image)
  ImageRGB8 image -> made8 image
  ImageRGBA8 image -> made8 (pixelMap (\(PixelRGBA8 r g b _) -> PixelRGB8 r g b) image)
  ImageYCbCr8 image -> made8 (convertImage image)
  ImageCMYK8 image -> made8 (convertImage image)
  ImageY16 image -> made16 (promoteImage image)
  ImageYA16 image -> made16 (pixelMap (\(PixelYA16 y _) -> PixelRGB16 y y y) image)
  ImageRGB16 image -> made16 image
  ImageRGBA16 image -> made16 (pixelMap (\(PixelRGBA16 r g b _) -> PixelRGB16 r g b) image)
  ImageCMYK16 image -> made16 (convertImage image)
  ImageYF image -> made image (\y -> let v = positive y in Radiance v v v)
  ImageRGBF image ->
    made
      image
      (\(PixelRGBF r g b) -> Radiance (positive r) (positive g) (positive b))
  ImageY32 _ -> Left "has 32-bit whole numbers, which are of no known meaning"
  where
    made8 image = made image (\(PixelRGB8 r g b) -> Radiance (code8 r) (code8 g) (code8 b))
    made16 image = made image (\(PixelRGB16 r g b) -> Radiance (code16 r) (code16 g) (code16 b))
    code8 v = U.unsafeIndex codes (fromIntegral v)
    code16 v = decodeSrgb (fromIntegral v / 65535)
    codes = U.generate 256 (\v -> decodeSrgb (fromIntegral v / 255))

-- | Replaces negative and infinite values, which light cannot have.
positive :: Float -> Double
positive v
  | v > 0 = min 1e6 (realToFrac v)
  | otherwise = 0

made :: Pixel pixel => Image pixel -> (pixel -> Radiance) -> Either String EnvironmentMap
made image light =
  maybe
    (Left "is empty")
    Right
    (environmentMapFromPixels width height (\i j -> light (pixelAt image i j)))
  where
    width = imageWidth image
    height = imageHeight image
{-# INLINE made #-}
