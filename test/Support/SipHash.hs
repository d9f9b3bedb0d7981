-- | SipHash-2-4 of byte strings, written from the specification (Aumasson and Bernstein
-- 2012) without regard to speed.
module Support.SipHash (sipHash) where

import BlackHole.Noise.SipHash (SipKey (..))
import Data.Bits (rotateL, shiftL, xor, (.|.))
import qualified Data.ByteString as Bytes
import Data.Word (Word64)

type State = (Word64, Word64, Word64, Word64)

-- | The hash of a byte string of any length.
sipHash :: SipKey -> Bytes.ByteString -> Word64
sipHash (SipKey k0 k1) message = a `xor` b `xor` c `xor` d
  where
    (a, b, c, d) = iterate sipRound (w0, w1, w2 `xor` 0xff, w3) !! 4
    (w0, w1, w2, w3) = foldl absorb start (wordsOf message)
    start =
      ( k0 `xor` 0x736f6d6570736575,
        k1 `xor` 0x646f72616e646f6d,
        k0 `xor` 0x6c7967656e657261,
        k1 `xor` 0x7465646279746573
      )
    -- The last word ends with the length modulo 256.
    wordsOf bytes
      | Bytes.length bytes < 8 =
        [littleEndian bytes .|. (fromIntegral (Bytes.length message) `shiftL` 56)]
      | otherwise = littleEndian (Bytes.take 8 bytes) : wordsOf (Bytes.drop 8 bytes)
    littleEndian = Bytes.foldr (\byte n -> n `shiftL` 8 .|. fromIntegral byte) 0

absorb :: State -> Word64 -> State
absorb (v0, v1, v2, v3) m = (w0 `xor` m, w1, w2, w3)
  where
    (w0, w1, w2, w3) = sipRound (sipRound (v0, v1, v2, v3 `xor` m))

sipRound :: State -> State
sipRound (v0, v1, v2, v3) = (c0, c1, rotateL c2 32, c3)
  where
    (a0, a2) = (v0 + v1, v2 + v3)
    (a1, a3) = (rotateL v1 13 `xor` a0, rotateL v3 16 `xor` a2)
    (c0, c2) = (rotateL a0 32 + a3, a2 + a1)
    (c1, c3) = (rotateL a1 17 `xor` c2, rotateL a3 21 `xor` c0)
