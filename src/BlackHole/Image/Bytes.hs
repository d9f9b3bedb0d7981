-- | Numbers from the bytes of files.
module BlackHole.Image.Bytes
  ( littleEndian,
    bigEndian,
    slice,
    strict,
  )
where

import Data.ByteString (ByteString)
import qualified Data.ByteString as Bytes
import Data.ByteString.Builder (Builder, toLazyByteString)
import qualified Data.ByteString.Lazy as Lazy

-- | @littleEndian size place bytes@ is the integer whose bytes start at a position,
-- lowest byte first; 'Nothing' if they extend beyond the end. At most seven bytes.
littleEndian :: Int -> Int -> ByteString -> Maybe Int
littleEndian size place =
  fmap (Bytes.foldr' (\byte n -> n * 256 + fromIntegral byte) 0)
    . slice place size

-- | Like 'littleEndian', with the highest byte first.
bigEndian :: Int -> Int -> ByteString -> Maybe Int
bigEndian size place =
  fmap (Bytes.foldl' (\n byte -> n * 256 + fromIntegral byte) 0)
    . slice place size

-- | @slice place size bytes@ are the bytes from a position; 'Nothing' if they extend
-- beyond either end.
slice :: Int -> Int -> ByteString -> Maybe ByteString
slice place size bytes
  | place < 0 || size < 0 || size > Bytes.length bytes
      || place > Bytes.length bytes - size =
    Nothing
  | otherwise = Just (Bytes.take size (Bytes.drop place bytes))

-- | The output of a builder as one strict string, for small sizes.
strict :: Builder -> ByteString
strict = Lazy.toStrict . toLazyByteString
