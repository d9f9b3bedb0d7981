-- | A reader for uncompressed TIFF files (TIFF 6.0).
--
-- JuicyPixels' decoder follows the offsets of a damaged file, even outside its own
-- memory, and allocates any amount of memory. This reader accepts only the plain kinds
-- of TIFF, and checks every position before it reads there.
module BlackHole.Image.PlainTiff
  ( PlainTiff (..),
    readPlainTiff,
  )
where

import Control.Monad (guard)
import Data.Bits (shiftL, (.|.))
import Data.ByteString (ByteString)
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Char8 as Characters
import Data.ByteString.Unsafe (unsafeIndex)
import qualified Data.Vector.Unboxed as U
import Data.Word (Word32)
import GHC.Float (castWord32ToFloat)

-- | A picture whose samples are read from the file on demand.
data PlainTiff = PlainTiff
  { tiffWidth :: !Int,
    tiffHeight :: !Int,
    -- | Whether samples are floating-point numbers; otherwise they are codes.
    tiffFloating :: !Bool,
    -- | The red, green and blue sample in a column and row: a code as a fraction of the
    -- greatest one, 0 to 1, or the number itself. Grey has three equal samples; alpha
    -- and further samples are ignored. 0 outside the picture.
    tiffSamples :: Int -> Int -> (Float, Float, Float)
  }

-- | The first picture of a file with 8-bit, 16-bit or 32-bit floating-point samples,
-- grey or RGB, whose samples are contiguous and uncompressed. 'Nothing' for all other
-- files and for damaged ones. Linear in the number of strips.
readPlainTiff :: ByteString -> Maybe PlainTiff
readPlainTiff bytes
  | Characters.pack "II*\0" `Bytes.isPrefixOf` bytes = reading [0 ..]
  | Characters.pack "MM\0*" `Bytes.isPrefixOf` bytes = reading [3, 2, 1, 0]
  | otherwise = Nothing
  where
    -- The positions of the bytes of a four-byte number, lowest byte first.
    reading :: [Int] -> Maybe PlainTiff
    reading order = do
      directory <- word 4 4
      entryCount <- word 2 directory
      let places = [directory + 2 + 12 * i | i <- [0 .. entryCount - 1]]
      tags <- traverse (word 2) places
      let valuesOf tag = lookup tag (zip tags places) >>= valuesAt
          single tag usual = case lookup tag (zip tags places) of
            Nothing -> usual
            Just at -> valuesAt at >>= first
      width <- single 256 Nothing
      height <- single 257 Nothing
      bits <- valuesOf 258
      depth <- first bits
      compression <- single 259 (Just 1)
      photometric <- single 262 Nothing
      offsets <- U.fromList <$> valuesOf 273
      samples <- single 277 (Just 1)
      rowsPerStrip <- single 278 (Just height)
      planar <- single 284 (Just 1)
      format <- single 339 (Just 1)
      guard (width >= 1 && height >= 1 && width <= 65536 && height <= 65536 && rowsPerStrip >= 1)
      guard (compression == 1 && planar == 1 && length bits == samples && all (== depth) bits)
      guard ((photometric == 1 && samples >= 1 || photometric == 2 && samples >= 3) && samples <= 8)
      guard ((depth, format) `elem` [(8, 1), (16, 1), (32, 3)])
      let size = depth `quot` 8
          rowBytes = width * samples * size
          rowsIn i = min rowsPerStrip (height - i * rowsPerStrip)
      guard (U.length offsets == (height + rowsPerStrip - 1) `quot` rowsPerStrip)
      guard
        (U.and (U.imap (\i offset -> offset <= Bytes.length bytes - rowsIn i * rowBytes) offsets))
      let numberAt :: Int -> Word32
          numberAt at =
            foldr
              (\k n -> n `shiftL` 8 .|. fromIntegral (unsafeIndex bytes (at + k)))
              0
              (placesOf size order)
          sample at = case depth of
            8 -> fromIntegral (unsafeIndex bytes at) / 255
            16 -> fromIntegral (numberAt at) / 65535
            _ -> castWord32ToFloat (numberAt at)
          samplesAt column row
            | column < 0 || row < 0 || column >= width || row >= height = (0, 0, 0)
            | samples < 3 = let v = sample start in (v, v, v)
            | otherwise = (sample start, sample (start + size), sample (start + 2 * size))
            where
              (strip, inside) = row `quotRem` rowsPerStrip
              start = U.unsafeIndex offsets strip + inside * rowBytes + column * samples * size
      pure (PlainTiff width height (depth == 32) samplesAt)
      where
        first list = case list of
          v : _ -> Just v
          [] -> Nothing
        placesOf size places = case places of
          0 : _ -> take size places
          _ -> drop (4 - size) places
        word :: Int -> Int -> Maybe Int
        word size at
          | at < 0 || at > Bytes.length bytes - size = Nothing
          | otherwise =
            Just
              ( foldr
                  (\k n -> n `shiftL` 8 .|. fromIntegral (unsafeIndex bytes (at + k)))
                  0
                  (placesOf size order)
              )
        -- Up to four bytes are stored in the entry itself, more elsewhere.
        valuesAt at = do
          kind <- word 2 (at + 2)
          count <- word 4 (at + 4)
          size <- lookup kind [(1, 1), (3, 2), (4, 4 :: Int)]
          guard (count >= 1 && count <= 65536)
          start <- if count * size <= 4 then Just (at + 8) else word 4 (at + 8)
          traverse (\i -> word size (start + size * i)) [0 .. count - 1]
