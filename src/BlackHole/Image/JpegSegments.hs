-- | Whether the segments of a JPEG file are what a decoder can rely on (ITU-T T.81,
-- annex B).
--
-- JuicyPixels builds its trees from the tables of Huffman codes without looking
-- whether such a code is possible: a single changed byte can keep it busy for ever.
module BlackHole.Image.JpegSegments (soundJpeg) where

import Data.Bits (shiftL, shiftR, (.&.))
import Data.ByteString (ByteString)
import qualified Data.ByteString as Bytes

-- | Whether the file has one frame header, with possible sampling factors, and
-- tables of possible Huffman codes alone, up to its end or the end of its data.
-- Linear in its size.
soundJpeg :: ByteString -> Bool
soundJpeg bytes = Bytes.take 2 bytes == Bytes.pack [0xff, 0xd8] && segments (0 :: Int) (Bytes.drop 2 bytes)
  where
    segments frames rest = case Bytes.unpack (Bytes.take 4 rest) of
      [0xff, 0xff, _, _] -> segments frames (Bytes.drop 1 rest)
      [0xff, marker, high, low]
        | marker == 0xd9 -> frames == 1
        | size < 2 || Bytes.length rest < size + 2 -> False
        | marker == 0xc4 -> huffmanTables content && segments frames after
        | marker == 0xda -> frames == 1 && segments frames (Bytes.drop (scanLength after) after)
        | marker >= 0xc0 && marker <= 0xcf && marker `notElem` [0xc8, 0xcc] ->
          frames == 0 && frameHeader content && segments (frames + 1) after
        | otherwise -> segments frames after
        where
          size = fromIntegral high `shiftL` 8 + fromIntegral low
          content = Bytes.drop 4 (Bytes.take (size + 2) rest)
          after = Bytes.drop (size + 2) rest
      -- Decoders go without the last marker.
      end -> frames == 1 && take 2 end `elem` [[], [0xff], [0xff, 0xd9]]

-- | How far the coded data go, up to a marker that is no restart.
scanLength :: ByteString -> Int
scanLength bytes = go 0
  where
    go at = case Bytes.elemIndex 0xff (Bytes.drop at bytes) of
      Nothing -> Bytes.length bytes
      Just ahead -> case Bytes.unpack (Bytes.take 1 (Bytes.drop (at + ahead + 1) bytes)) of
        [next]
          | next == 0 || next == 0xff || (next >= 0xd0 && next <= 0xd7) -> go (at + ahead + 1)
          | otherwise -> at + ahead
        _ -> Bytes.length bytes

-- | One to four components whose factors are 1 to 4.
frameHeader :: ByteString -> Bool
frameHeader content = case Bytes.unpack content of
  _ : _ : _ : _ : _ : count : components -> count >= 1 && count <= 4 && length components == 3 * fromIntegral count && possible components
  _ -> False
  where
    possible (_ : factors : _ : others) = all (\n -> n >= 1 && n <= 4) [factors `shiftR` 4, factors .&. 15] && possible others
    possible others = null others

-- | Tables one after the other: class and number, how many codes there are of each
-- length up to 16, and a symbol for each.
huffmanTables :: ByteString -> Bool
huffmanTables content = case Bytes.uncons content of
  Nothing -> True
  Just (kind, rest) ->
    kind `shiftR` 4 <= 1 && kind .&. 15 <= 3 && Bytes.length rest >= 16 + total && total <= 256 && room <= 65536 && huffmanTables (Bytes.drop (16 + total) rest)
    where
      counts = map fromIntegral (Bytes.unpack (Bytes.take 16 rest)) :: [Int]
      total = sum counts
      -- Of all words of 16 bits, those that begin with a code (Kraft 1949).
      room = sum (zipWith (\n size -> n `shiftL` (16 - size)) counts [1 ..])
