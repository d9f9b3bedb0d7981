{-# LANGUAGE OverloadedStrings #-}

module BlackHole.Noise.SipHashSpec (spec) where

import BlackHole.Noise.SipHash (SipKey (..), sipAfter2, sipHash2, sipHash3, sipThird)
import Data.Bits (shiftR)
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Builder as Builder
import qualified Data.ByteString.Lazy as Lazy
import Data.Foldable (for_)
import Data.Word (Word64, Word8)
import Support.SipHash
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck ((===))

spec :: Spec
spec = do
  describe "the published vectors: key 00 … 0f, message 00, 01, 02, …" $
    for_ (zip [0 ..] published) $ \(len, expected) ->
      it ("length " <> show len) $
        hexadecimal (sipHash publishedKey (Bytes.pack (take len [0 ..])))
          `shouldBe` expected

  it "counts the length modulo 256" $
    -- From an independent implementation.
    map (hexadecimal . sipHash publishedKey . (`Bytes.replicate` 7)) [255, 256, 1000]
      `shouldBe` ["94c8e734081d245e", "8f371cca76b57627", "a5ece63585d714f3"]

  prop "two words are their 16 bytes" $ \k0 k1 a b ->
    sipHash2 (SipKey k0 k1) a b === sipHash (SipKey k0 k1) (bytesOf [a, b])

  prop "three words are their 24 bytes" $ \k0 k1 a b c ->
    sipHash3 (SipKey k0 k1) a b c === sipHash (SipKey k0 k1) (bytesOf [a, b, c])

  prop "hashes a third word after two as it hashes three at once" $ \k0 k1 a b c ->
    sipThird (sipAfter2 (SipKey k0 k1) a b) c === sipHash3 (SipKey k0 k1) a b c

publishedKey :: SipKey
publishedKey = SipKey 0x0706050403020100 0x0f0e0d0c0b0a0908

-- | The words' bytes, least significant first.
bytesOf :: [Word64] -> Bytes.ByteString
bytesOf = Lazy.toStrict . Builder.toLazyByteString . foldMap Builder.word64LE

-- | The bytes of a hash in the order in which they are published.
hexadecimal :: Word64 -> Lazy.ByteString
hexadecimal h =
  Builder.toLazyByteString (foldMap (Builder.word8HexFixed . byte) [0 .. 7])
  where
    byte i = fromIntegral (h `shiftR` (8 * i)) :: Word8

-- | The 64 outputs that come with the reference implementation of SipHash-2-4.
published :: [Lazy.ByteString]
published =
  [ "310e0edd47db6f72",
    "fd67dc93c539f874",
    "5a4fa9d909806c0d",
    "2d7efbd796666785",
    "b7877127e09427cf",
    "8da699cd64557618",
    "cee3fe586e46c9cb",
    "37d1018bf50002ab",
    "6224939a79f5f593",
    "b0e4a90bdf82009e",
    "f3b9dd94c5bb5d7a",
    "a7ad6b22462fb3f4",
    "fbe50e86bc8f1e75",
    "903d84c02756ea14",
    "eef27a8e90ca23f7",
    "e545be4961ca29a1",
    "db9bc2577fcc2a3f",
    "9447be2cf5e99a69",
    "9cd38d96f0b3c14b",
    "bd6179a71dc96dbb",
    "98eea21af25cd6be",
    "c7673b2eb0cbf2d0",
    "883ea3e395675393",
    "c8ce5ccd8c030ca8",
    "94af49f6c650adb8",
    "eab8858ade92e1bc",
    "f315bb5bb835d817",
    "adcf6b0763612e2f",
    "a5c91da7acaa4dde",
    "716595876650a2a6",
    "28ef495c53a387ad",
    "42c341d8fa92d832",
    "ce7cf2722f512771",
    "e37859f94623f3a7",
    "381205bb1ab0e012",
    "ae97a10fd434e015",
    "b4a31508beff4d31",
    "81396229f0907902",
    "4d0cf49ee5d4dcca",
    "5c73336a76d8bf9a",
    "d0a704536ba93e0e",
    "925958fcd6420cad",
    "a915c29bc8067318",
    "952b79f3bc0aa6d4",
    "f21df2e41d4535f9",
    "87577519048f53a9",
    "10a56cf5dfcd9adb",
    "eb75095ccd986cd0",
    "51a9cb9ecba312e6",
    "96afadfc2ce666c7",
    "72fe52975a4364ee",
    "5a1645b276d592a1",
    "b274cb8ebf87870a",
    "6f9bb4203de7b381",
    "eaecb2a30b22a87f",
    "9924a43cc1315724",
    "bd838d3aafbf8db7",
    "0b1a2a3265d51aea",
    "135079a3231ce660",
    "932b2846e4d70666",
    "e1915f5cb1eca46c",
    "f325965ca16d629f",
    "575ff28e60381be5",
    "724506eb4c328a95"
  ]
