{-# LANGUAGE BangPatterns #-}

-- | Radiance's picture format: linear light as three 8-bit mantissas with a shared
-- exponent, accurate to 1 in 256 of the strongest primary (Ward 1991, "Real Pixels").
--
-- The encoder of JuicyPixels does not serve here: it cuts mantissas off instead of
-- rounding them, which halves the accuracy and darkens the picture, has no place for
-- metadata in the header, and needs the whole picture in memory.
module BlackHole.Image.Hdr
  ( hdrHeader,
    hdrRows,
    hdrMetadata,
  )
where

import BlackHole.Image.Metadata
import BlackHole.Render.Exposed (Film)
import BlackHole.Render.PixelArray (pixelArrayShape)
import BlackHole.Render.PixelRows (pixelRow)
import BlackHole.Render.PixelShape
import BlackHole.Render.Shared (mapShared)
import BlackHole.Render.Workers (Workers)
import Data.Bits (shiftR, (.&.))
import Data.ByteString (ByteString)
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Char8 as Characters
import Data.ByteString.Internal (unsafeCreate)
import Data.ByteString.Unsafe (unsafeIndex)
import Data.Maybe (mapMaybe)
import qualified Data.Vector.Storable as Vector
import Data.Word (Word32, Word8)
import Foreign.Ptr (Ptr)
import Foreign.Storable (pokeByteOff)

-- | The lines of the file before the rows of a picture of this width and height.
hdrHeader :: Metadata -> (Int, Int) -> ByteString
hdrHeader metadata (width, height) =
  Characters.pack . unlines $
    ["#?RADIANCE", "SOFTWARE=" ++ metadataSoftware metadata]
      ++ map ((commentMark ++) . Characters.unpack) (Characters.lines (metadataText metadata))
      ++ ["FORMAT=32-bit_rle_rgbe", "", "-Y " ++ show height ++ " +X " ++ show width]

-- | The encoded rows of a band, in order. Negative components and NaN become 0;
-- components above 1e38 become 1e38. Rows are run-length encoded where the format allows
-- it (8 to 32767 pixels). The bytes do not depend on the number of workers.
hdrRows :: Workers -> Film -> IO [ByteString]
hdrRows workers film =
  mapShared
    workers
    (pure . codedRow)
    (mapMaybe (pixelRow film) [0 .. shapeHeight shape - 1])
  where
    shape = pixelArrayShape film
    width = shapeWidth shape
    codedRow light
      | width < 8 || width > 32767 = interleaved
      | otherwise =
        Bytes.concat $
          Bytes.pack
            [2, 2, fromIntegral (width `shiftR` 8), fromIntegral (width .&. 255)] :
          map runLengths planes
      where
        planes = [Bytes.take width (Bytes.drop (k * width) separate) | k <- [0 .. 3]]
        separate = rgbe width light
        interleaved =
          Bytes.pack
            [unsafeIndex separate (k * width + x) | x <- [0 .. width - 1], k <- [0 .. 3]]

-- | The metadata of a Radiance file written by this program.
hdrMetadata :: ByteString -> Maybe Metadata
hdrMetadata bytes = case Characters.lines (Bytes.take 1000000 bytes) of
  first : rest
    | first == Characters.pack "#?RADIANCE" ->
      parseMetadata . Characters.unlines
        . mapMaybe (Bytes.stripPrefix (Characters.pack commentMark))
        $ takeWhile (not . Bytes.null) rest
  _ -> Nothing

-- | Marks the metadata's lines, because the header ends at the first empty line.
commentMark :: String
commentMark = "# | "

-- | The red components of a row, then the green and blue ones and the exponents.
rgbe :: Int -> Vector.Vector Float -> ByteString
rgbe width light = unsafeCreate (4 * width) (go 0)
  where
    words32 = Vector.unsafeCast light :: Vector.Vector Word32
    go :: Int -> Ptr Word8 -> IO ()
    go !x !out
      | x >= width = pure ()
      | otherwise = do
        let amount k =
              bounded
                (Vector.unsafeIndex light (3 * x + k))
                (Vector.unsafeIndex words32 (3 * x + k))
            r = amount 0
            g = amount 1
            b = amount 2
            peak = max r (max g b)
            -- The power of two above the peak; one more if rounding requires it.
            least = exponent peak
            power = if codeOf (factorOf least) peak > 255 then least + 1 else least
            factor = factorOf power
            put k v = pokeByteOff out (k * width + x) (fromIntegral v :: Word8)
        if peak < 1e-38
          then mapM_ (`put` (0 :: Int)) [0 .. 3]
          else do
            put 0 (codeOf factor r)
            put 1 (codeOf factor g)
            put 2 (codeOf factor b)
            put 3 (power + 128)
        go (x + 1) out
    factorOf power = 2 ** fromIntegral (8 - power) :: Double
    codeOf :: Double -> Float -> Int
    codeOf factor v = truncate (realToFrac v * factor + 0.5)
    -- Detects NaN: all bits of the exponent are set, and others.
    bounded v bits
      | bits .&. 0x7fffffff > 0x7f800000 = 0
      | otherwise = max 0 (min 1e38 v)

-- | Run-length encoding: runs of four or more equal bytes as a count above 128 and the
-- byte, and other bytes as a count of up to 128 and those bytes.
runLengths :: ByteString -> ByteString
runLengths = Bytes.concat . go
  where
    go bytes = case Bytes.uncons bytes of
      Nothing -> []
      Just (byte, _)
        | runLength >= 4 ->
          Bytes.pack [128 + fromIntegral runLength, byte] :
          go
            (Bytes.drop runLength bytes)
        | otherwise ->
          let literal = Bytes.take (literalLength bytes) bytes
           in Bytes.cons (fromIntegral (Bytes.length literal)) literal :
              go
                (Bytes.drop (Bytes.length literal) bytes)
        where
          runLength = Bytes.length (Bytes.takeWhile (== byte) (Bytes.take 127 bytes))
    -- Up to the start of the next run of four.
    literalLength bytes = segment 1
      where
        size = min 128 (Bytes.length bytes)
        segment n
          | n >= size = size
          | n + 3 < Bytes.length bytes
              && all (\k -> unsafeIndex bytes (n + k) == unsafeIndex bytes n) [1 .. 3] =
            n
          | otherwise = segment (n + 1)
