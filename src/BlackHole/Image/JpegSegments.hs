-- | Validation of the segments of a JPEG file before decoding (ITU-T T.81, annex B).
--
-- JuicyPixels builds its trees from the tables of Huffman codes without checking
-- whether such a code is possible, so a single changed byte can keep it busy forever.
module BlackHole.Image.JpegSegments (soundJpeg) where

import Data.Bits (shiftL, shiftR, (.&.), (.|.))
import Data.ByteString (ByteString)
import qualified Data.ByteString as Bytes
import Data.List (nub)
import Data.Maybe (isJust)
import Data.Word (Word8)

-- | Whether the file has one frame header with valid sampling factors, only tables of
-- valid Huffman codes, and scans that refer to existing components and tables, up to
-- its end or the end of its data. Linear in the file's size.
soundJpeg :: ByteString -> Bool
soundJpeg bytes =
  Bytes.take 2 bytes == Bytes.pack [0xff, 0xd8]
    && segments [] Nothing (Bytes.drop 2 bytes)
  where
    -- The Huffman tables so far, and the numbers of the frame's components.
    segments tables frame rest = case Bytes.unpack (Bytes.take 4 rest) of
      [0xff, 0xff, _, _] -> segments tables frame (Bytes.drop 1 rest)
      [0xff, marker, high, low]
        | marker == 0xd9 -> isJust frame
        | size < 2 || Bytes.length rest < size + 2 -> False
        | marker == 0xc4 ->
          maybe
            False
            (\new -> segments (new ++ tables) frame after)
            (huffmanTables content)
        | marker == 0xda ->
          maybe False (scanHeader tables content) frame
            && segments tables frame (Bytes.drop (scanLength after) after)
        | marker >= 0xc0 && marker <= 0xcf && marker
            `notElem` [0xc8, 0xcc] -> case (frame, frameHeader content) of
          (Nothing, Just components) -> segments tables (Just components) after
          _ -> False
        | otherwise -> segments tables frame after
        where
          size = fromIntegral high `shiftL` 8 + fromIntegral low
          content = Bytes.drop 4 (Bytes.take (size + 2) rest)
          after = Bytes.drop (size + 2) rest
      -- Decoders accept a missing last marker.
      end -> isJust frame && take 2 end `elem` [[], [0xff], [0xff, 0xd9]]

-- | Whether the scan refers to components of the frame, each once, with existing tables
-- for the coefficients it needs.
scanHeader :: [Word8] -> ByteString -> [Word8] -> Bool
scanHeader tables content frame = case Bytes.unpack content of
  count : rest
    | (components, [from, to, _]) <- splitAt (2 * fromIntegral count) rest ->
      let numbers = evens components
          chosen = evens (drop 1 components)
       in count >= 1 && count <= 4 && nub numbers == numbers && all (`elem` frame) numbers
            && from <= to
            && to <= 63
            && all
              ( \both ->
                  (from > 0 || both `shiftR` 4 `elem` tables)
                    && (to == 0 || (0x10 .|. (both .&. 15)) `elem` tables)
              )
              chosen
  _ -> False
  where
    evens (a : rest) = a : evens (drop 1 rest)
    evens [] = []

-- | The length of the entropy-coded data, up to a marker other than a restart.
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

-- | The numbers of one to four components with factors from 1 to 4.
frameHeader :: ByteString -> Maybe [Word8]
frameHeader content = case Bytes.unpack content of
  _ : _ : _ : _ : _ : count : components
    | count >= 1 && count <= 4 && length components == 3 * fromIntegral count -> possible components
  _ -> Nothing
  where
    possible (number : factors : table : others)
      | all (\n -> n >= 1 && n <= 4) [factors `shiftR` 4, factors .&. 15]
          && table <= 3 =
        (number :) <$> possible others
    possible [] = Just []
    possible _ = Nothing

-- | The classes and numbers of consecutive tables. Each table holds its class and
-- number, the number of codes of each length up to 16, and a symbol for each code.
huffmanTables :: ByteString -> Maybe [Word8]
huffmanTables content = case Bytes.uncons content of
  Nothing -> Just []
  Just (kind, rest)
    | kind `shiftR` 4 <= 1 && kind .&. 15 <= 3 && Bytes.length rest >= 16 + total
        && total >= 1
        && total <= 256
        && room <= 65536 ->
      (kind :) <$> huffmanTables (Bytes.drop (16 + total) rest)
    | otherwise -> Nothing
    where
      counts = map fromIntegral (Bytes.unpack (Bytes.take 16 rest)) :: [Int]
      total = sum counts
      -- The number of 16-bit words that begin with a code (Kraft 1949).
      room = sum (zipWith (\n size -> n `shiftL` (16 - size)) counts [1 ..])
