{-# LANGUAGE BangPatterns #-}

-- | Deflate and zlib streams (RFC 1951 and 1950) for filtered pixels.
--
-- The encoder looks only for runs of one byte and leaves the rest to a Huffman code
-- made for the data. Matches at other distances would save a few per cent on a rendered
-- picture at several times the cost. The output depends on the data alone, not on the
-- version of a library.
--
-- Written by hand because zlib, the library at hand, takes several times as long for a
-- rendered picture and cannot compress the pieces of one stream in parallel.
module BlackHole.Image.Deflate
  ( deflatePiece,
    zlibHeader,
    zlibTrailer,
    zlibStream,
    Place (..),
  )
where

import BlackHole.Image.Checksum
import BlackHole.Image.Huffman
import Data.Bits (shiftL, shiftR, unsafeShiftL, unsafeShiftR, (.&.), (.|.))
import Data.ByteString (ByteString)
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Builder as Builder
import Data.ByteString.Internal (unsafeCreateUptoN)
import qualified Data.ByteString.Lazy as Lazy
import Data.ByteString.Unsafe (unsafeUseAsCString)
import qualified Data.Vector.Unboxed as U
import qualified Data.Vector.Unboxed.Mutable as MU
import Data.Word (Word32, Word64, Word8, byteSwap32)
import Foreign.Ptr (Ptr, castPtr)
import Foreign.Storable (peekByteOff, pokeByteOff)
import GHC.ByteOrder (ByteOrder (..), targetByteOrder)
import System.IO.Unsafe (unsafeDupablePerformIO)

-- | Whether more pieces of the stream follow.
data Place = Inside | Last
  deriving (Eq, Show)

-- | One piece of a raw deflate stream. Pieces compressed independently and concatenated
-- form one stream, because each but the last ends at a byte boundary (with an empty
-- stored block). Pieces should have some hundred kilobytes, because each carries its
-- own code of about 150 bytes.
--
-- Takes 3 to 5 ns per byte, less in runs. Total for any data; the output is at most 300
-- bytes longer than the input.
deflatePiece :: Place -> ByteString -> ByteString
deflatePiece place bytes =
  unsafeCreateUptoN (bitCount `quot` 8 + 16) (emit place bytes code)
  where
    tokens = tokenCounts bytes
    code@(Code _ packed) = blockCode tokens
    bitCount = headerBits + U.sum (U.zipWith (*) tokens (U.map (.&. 31) packed))
    headerBits = 3 + 14 + 3 * codeLengthCount + 7 * (literalCount + 1)

-- | The two bytes before the compressed data of a zlib stream.
zlibHeader :: ByteString
zlibHeader = Bytes.pack [0x78, 0x01]

-- | The four bytes after the compressed data.
zlibTrailer :: Adler32 -> ByteString
zlibTrailer = Lazy.toStrict . Builder.toLazyByteString . Builder.word32BE . adlerWord

-- | A complete zlib stream in one piece.
zlibStream :: ByteString -> ByteString
zlibStream bytes = Bytes.concat [zlibHeader, deflatePiece Last bytes, zlibTrailer (adler32 bytes)]

-- | The number of tokens. Tokens 0 to 255 are bytes, 256 ends the block, and 256 + n is
-- a run of n further bytes equal to the one before, with n from 3 to 258.
tokenCount :: Int
tokenCount = 256 + longestRun + 1

longestRun :: Int
longestRun = 258

-- | The number of symbols for literals and lengths, 0 to 285.
literalCount :: Int
literalCount = 286

-- | The number of occurrences of each token.
tokenCounts :: ByteString -> U.Vector Int
tokenCounts bytes = unsafeDupablePerformIO $ do
  counts <- MU.replicate tokenCount 0
  let count !token = MU.unsafeRead counts token >>= MU.unsafeWrite counts token . (+ 1)
  unsafeUseAsCString bytes $ \start ->
    eachToken
      (castPtr start)
      (Bytes.length bytes)
      ()
      (\() byte -> count byte)
      (\() n -> count (256 + n))
  count 256
  U.unsafeFreeze counts

-- | Goes through the bytes token by token: calls the first function with each byte sent
-- as it is, and the second with the length of each run.
eachToken :: Ptr Word8 -> Int -> s -> (s -> Int -> IO s) -> (s -> Int -> IO s) -> IO s
eachToken !start !size state literal run = go state (-1) 0
  where
    at :: Int -> IO Int
    at i = fromIntegral <$> (peekByteOff start i :: IO Word8)
    -- Each function argument is called in only one place, so that it is inlined there
    -- and the state stays in registers. There is no byte before the first.
    go !s !before !i
      | i >= size = pure s
      | otherwise = do
        byte <- at i
        end <- if byte == before then runEnd before (i + 1) (min size (i + longestRun)) else pure i
        if end - i >= 3
          then run s (end - i) >>= \s' -> go s' before end
          else literal s byte >>= \s' -> go s' byte (i + 1)
    -- The end of the run, or the limit; compares eight bytes at a time where possible.
    runEnd !before !i !end
      | i + 8 <= end = do
        eight <- peekByteOff start i :: IO Word64
        if eight == fromIntegral before * 0x0101010101010101
          then runEnd before (i + 8) end
          else single before i end
      | otherwise = single before i end
    single !before !i !end
      | i >= end = pure end
      | otherwise = do
        byte <- at i
        if byte == before then single before (i + 1) end else pure i
{-# INLINE eachToken #-}

-- | A block's code: the lengths of its literals' codes, and for each token the bits to
-- send and their number, packed as bits × 32 + count.
data Code = Code !(U.Vector Int) !(U.Vector Int)

blockCode :: U.Vector Int -> Code
blockCode tokens = Code lengths (U.generate tokenCount packed)
  where
    symbols =
      U.accumulate
        (+)
        (U.replicate literalCount 0)
        (U.imap (\token n -> (symbolOf token, n)) tokens)
    symbolOf token
      | token <= 256 = token
      | otherwise = let (symbol, _, _) = runSymbol (token - 256) in symbol
    lengths = codeLengths 15 symbols
    codes = canonicalCodes lengths
    packed token
      | token <= 256 = (U.unsafeIndex codes token `shiftL` 5) .|. U.unsafeIndex lengths token
      | otherwise =
        let (symbol, extra, extraBits) = runSymbol (token - 256)
            n = U.unsafeIndex lengths symbol
            -- The code of the distance, a single 0 bit for distance 1, comes last.
            bits = U.unsafeIndex codes symbol .|. (extra `shiftL` n)
         in (bits `shiftL` 5) .|. (n + extraBits + 1)

-- | The symbol of a run, the value of its extra bits, and their number (RFC 1951,
-- 3.2.5); those of the shortest length for lengths below 3.
runSymbol :: Int -> (Int, Int, Int)
runSymbol n
  | n >= longestRun = (285, 0, 0)
  | n < 11 = (257 + max 0 (n - 3), 0, 0)
  | otherwise =
    let m = n - 3
        extraBits = floorLog2 m - 2
     in (257 + 4 * extraBits + m `shiftR` extraBits, m .&. ((1 `shiftL` extraBits) - 1), extraBits)
  where
    floorLog2 m = length (takeWhile (<= m) (iterate (* 2) 1)) - 1

-- | Bits that wait for their byte: the position of the next byte, the bits, and their
-- number.
data Writer = Writer !Int !Word64 !Int

emit :: Place -> ByteString -> Code -> Ptr Word8 -> IO Int
emit place bytes (Code lengths tokens) out = do
  begun <- blockHeader
  filled <- unsafeUseAsCString bytes $ \start ->
    eachToken (castPtr start) (Bytes.length bytes) begun token (\writer n -> token writer (256 + n))
  ended <- token filled 256
  Writer end _ _ <- case place of
    Last -> align ended
    Inside -> do
      Writer at _ _ <- put ended 0 3 >>= align
      mapM_ (\(i, b) -> pokeByteOff out (at + i) (b :: Word8)) (zip [0 ..] [0, 0, 0xff, 0xff])
      pure (Writer (at + 4) 0 0)
  pure end
  where
    token writer t =
      let packed = U.unsafeIndex tokens t
       in put writer (packed `unsafeShiftR` 5) (packed .&. 31)
    {-# INLINE token #-}
    -- At most 31 bits wait and at most 32 arrive, so no bit is lost.
    put :: Writer -> Int -> Int -> IO Writer
    put (Writer at waiting count) bits n
      | count' >= 32 = do
        pokeByteOff out at (littleEndian32 (fromIntegral waiting'))
        pure (Writer (at + 4) (waiting' `unsafeShiftR` 32) (count' - 32))
      | otherwise = pure (Writer at waiting' count')
      where
        waiting' = waiting .|. (fromIntegral bits `unsafeShiftL` count)
        count' = count + n
    {-# INLINE put #-}
    byte :: Int -> Word64 -> IO ()
    byte at w = pokeByteOff out at (fromIntegral w :: Word8)
    align writer@(Writer at waiting count)
      | count <= 0 = pure writer
      | otherwise =
        byte at waiting
          >> align (Writer (at + 1) (waiting `shiftR` 8) (max 0 (count - 8)))
    blockHeader =
      putAll (Writer 0 0 0) $
        [ (if place == Last then 1 else 0, 1),
          (2, 2),
          (literalCount - 257, 5),
          (0, 5),
          (codeLengthCount - 4, 4)
        ]
          ++ [(U.unsafeIndex lengthLengths symbol, 3) | symbol <- codeLengthOrder]
          ++ [(U.unsafeIndex lengthCodes n, U.unsafeIndex lengthLengths n) | n <- sent]
    putAll = foldl (\writer (bits, n) -> writer >>= \w -> put w bits n) . pure
    -- The lengths of the codes of all literals and of the single distance.
    sent = U.toList lengths ++ [1]
    lengthLengths = codeLengths 7 (U.accum (+) (U.replicate codeLengthCount 0) [(n, 1) | n <- sent])
    lengthCodes = canonicalCodes lengthLengths

littleEndian32 :: Word32 -> Word32
littleEndian32 w = case targetByteOrder of
  LittleEndian -> w
  BigEndian -> byteSwap32 w
{-# INLINE littleEndian32 #-}

-- | The number of symbols for code lengths: the lengths 0 to 15, and three kinds of
-- repetition, which are not used here.
codeLengthCount :: Int
codeLengthCount = 19

codeLengthOrder :: [Int]
codeLengthOrder = [16, 17, 18, 0, 8, 7, 9, 6, 10, 5, 11, 4, 12, 3, 13, 2, 14, 1, 15]
