-- | Reading numbers out of files' bytes.
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

-- | The whole number whose bytes begin at a place, lowest first; 'Nothing' where
-- they reach beyond the end. Up to seven bytes.
littleEndian :: Int -> Int -> ByteString -> Maybe Int
littleEndian size place = fmap (Bytes.foldr' (\byte n -> n * 256 + fromIntegral byte) 0) . slice place size

-- | The same, highest byte first.
bigEndian :: Int -> Int -> ByteString -> Maybe Int
bigEndian size place = fmap (Bytes.foldl' (\n byte -> n * 256 + fromIntegral byte) 0) . slice place size

-- | @slice place size bytes@: 'Nothing' where it reaches beyond either end.
slice :: Int -> Int -> ByteString -> Maybe ByteString
slice place size bytes
  | place < 0 || size < 0 || size > Bytes.length bytes || place > Bytes.length bytes - size = Nothing
  | otherwise = Just (Bytes.take size (Bytes.drop place bytes))

-- | What a builder builds, in one piece; for small things.
strict :: Builder -> ByteString
strict = Lazy.toStrict . toLazyByteString
