{-# LANGUAGE BangPatterns #-}

-- | SipHash-2-4: a keyed hash of 64 bits whose values cannot be distinguished from
-- random ones without the key (Aumasson and Bernstein 2012, "SipHash: a fast
-- short-input PRF").
--
-- The noise takes its random values from it, with the seed as the key (Will Yager,
-- "Accurately Rendering a Black Hole", section "Texture Generation"). 'sipHash2' and
-- 'sipHash3' take a few 64-bit words, whose bytes in little-endian order are the message,
-- and allocate nothing.
module BlackHole.Noise.SipHash
  ( SipKey (..),
    sipHash2,
    sipHash3,
    SipState,
    sipAfter2,
    sipThird,
  )
where

import Data.Bits (unsafeShiftL, unsafeShiftR, xor, (.|.))
import Data.Word (Word64)

-- | The 128-bit key: the first eight and the last eight of its bytes, each half read in
-- little-endian order.
data SipKey = SipKey {-# UNPACK #-} !Word64 {-# UNPACK #-} !Word64
  deriving (Eq, Ord, Show)

-- | The state of an unfinished hash: the algorithm's four words v0 to v3.
data SipState
  = SipState
      {-# UNPACK #-} !Word64
      {-# UNPACK #-} !Word64
      {-# UNPACK #-} !Word64
      {-# UNPACK #-} !Word64

-- | The hash of two words, which are 16 bytes.
sipHash2 :: SipKey -> Word64 -> Word64 -> Word64
sipHash2 key a b =
  finish (16 `unsafeShiftL` 56) (sipAfter2 key a b)

-- | The hash of three words, which are 24 bytes.
sipHash3 :: SipKey -> Word64 -> Word64 -> Word64 -> Word64
sipHash3 key a b = third (sipAfter2 key a b)

-- | The state of 'sipHash3' after the key and the first two words. This is a third of
-- its work, and one state serves many third words.
sipAfter2 :: SipKey -> Word64 -> Word64 -> SipState
sipAfter2 key a b = absorb b (absorb a (initial key))
{-# INLINE sipAfter2 #-}

-- | The hash after the third word: @sipThird ('sipAfter2' key a b) c@ equals
-- @'sipHash3' key a b c@.
sipThird :: SipState -> Word64 -> Word64
sipThird = third
{-# NOINLINE sipThird #-}

third :: SipState -> Word64 -> Word64
third state c = finish (24 `unsafeShiftL` 56) (absorb c state)
{-# INLINE third #-}

-- | The state before the first word. The constants are the ASCII text
-- "somepseudorandomlygeneratedbytes".
initial :: SipKey -> SipState
initial (SipKey k0 k1) =
  SipState
    (k0 `xor` 0x736f6d6570736575)
    (k1 `xor` 0x646f72616e646f6d)
    (k0 `xor` 0x6c7967656e657261)
    (k1 `xor` 0x7465646279746573)
{-# INLINE initial #-}

-- | Mixes in one word of the message, with two rounds.
absorb :: Word64 -> SipState -> SipState
absorb m (SipState v0 v1 v2 v3) =
  case sipRound (sipRound (SipState v0 v1 v2 (v3 `xor` m))) of
    SipState w0 w1 w2 w3 -> SipState (w0 `xor` m) w1 w2 w3
{-# INLINE absorb #-}

-- | Mixes in the last word and runs four more rounds.
finish :: Word64 -> SipState -> Word64
finish lastWord state =
  case absorb lastWord state of
    SipState v0 v1 v2 v3 ->
      case sipRound (sipRound (sipRound (sipRound (SipState v0 v1 (v2 `xor` 0xff) v3)))) of
        SipState w0 w1 w2 w3 -> (w0 `xor` w1) `xor` (w2 `xor` w3)
{-# INLINE finish #-}

sipRound :: SipState -> SipState
sipRound (SipState v0 v1 v2 v3) =
  let !a0 = v0 + v1
      !a1 = rotated 13 v1 `xor` a0
      !a2 = v2 + v3
      !a3 = rotated 16 v3 `xor` a2
      !b0 = rotated 32 a0 + a3
      !b3 = rotated 21 a3 `xor` b0
      !b2 = a2 + a1
      !b1 = rotated 17 a1 `xor` b2
   in SipState b0 b1 (rotated 32 b2) b3
{-# INLINE sipRound #-}

-- | Rotation to the left by 1 to 63 bits.
rotated :: Int -> Word64 -> Word64
rotated n x = (x `unsafeShiftL` n) .|. (x `unsafeShiftR` (64 - n))
{-# INLINE rotated #-}
