module BlackHole.Image.DeflateSpec (spec) where

import BlackHole.Image.Checksum
import BlackHole.Image.Deflate
import BlackHole.Image.Huffman
import qualified Codec.Compression.Zlib as Zlib
import Data.Bits (shiftL)
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Char8 as Characters
import qualified Data.ByteString.Lazy as Lazy
import Data.List (sort)
import qualified Data.Vector.Unboxed as U
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck

spec :: Spec
spec = do
  describe "check sums" $ do
    it "of \"123456789\" are the published ones" $ do
      crc32 (Characters.pack "123456789") `shouldBe` 0xcbf43926
      adlerWord (adler32 (Characters.pack "123456789")) `shouldBe` 0x091e01de
      adlerWord (adler32 (Characters.pack "Wikipedia")) `shouldBe` 0x11e60398
    prop "of pieces combine to that of the whole" $
      forAll (listOf pieces) $ \parts ->
        mconcat (map adler32 parts) === adler32 (Bytes.concat parts)
    it "of many bytes follow their definition" $ do
      let bytes = Bytes.pack (take 70001 (cycle [255, 254 .. 3]))
          step (a, b) byte =
            let a' = (a + fromIntegral byte) `mod` 65521 in (a', (b + a') `mod` 65521)
          (low, high) = Bytes.foldl' step (1, 0) bytes
      adlerWord (adler32 bytes) `shouldBe` high * 65536 + low
  describe "Huffman codes" $ do
    prop "have the least mean length where no limit is met" $
      -- Known by the sum of all joined weights, found without the tree.
      forAll (U.fromList <$> vectorOf 20 (choose (1, 50))) $ \counts ->
        U.sum (U.zipWith (*) counts (codeLengths 15 counts))
          === joinedWeights (sort (U.toList counts))
    prop "fill the code space and no more, within the limit" $
      forAll
        (U.fromList <$> vectorOf 40 (choose (1 :: Int, 16) >>= \k -> choose (1, 1 `shiftL` k)))
        $ \counts ->
          let lengths = codeLengths 7 counts
           in conjoin
                [ property (U.maximum lengths <= 7),
                  U.sum (U.map (\n -> 1 `shiftL` (7 - n)) lengths) === (128 :: Int)
                ]
    it "are those of the standard's example" $
      -- RFC 1951, 3.2.2: lengths 3 3 3 3 3 2 4 4, codes sent first bit first.
      U.toList (canonicalCodes (U.fromList [3, 3, 3, 3, 3, 2, 4, 4]))
        `shouldBe` [2, 6, 1, 5, 3, 0, 7, 15]
    it "give a lone symbol one bit and absent ones none" $
      U.toList (codeLengths 15 (U.fromList [0, 7, 0])) `shouldBe` [0, 1, 0]
  describe "zlib streams" $ do
    prop "are read back by zlib" $
      forAll pieces $ \bytes -> unzlib (zlibStream bytes) === bytes
    prop "are read back when made of pieces" $
      forAll (listOf1 pieces) $ \parts ->
        let compressed = map (deflatePiece Inside) (init parts) ++ [deflatePiece Last (last parts)]
         in unzlib (Bytes.concat (zlibHeader : compressed ++ [zlibTrailer (foldMap adler32 parts)]))
              === Bytes.concat parts
    it "hold runs of every length" $
      let bytes = Bytes.concat [Bytes.snoc (Bytes.replicate n 0) 1 | n <- [1 .. 600]]
       in unzlib (zlibStream bytes) `shouldBe` bytes
    it "are short for a uniform surface and no longer than the data and a little" $ do
      Bytes.length (zlibStream (Bytes.replicate 1000000 7)) `shouldSatisfy` (< 2000)
      let noise = Bytes.pack (take 100000 (iterate (\b -> b * 5 + 3) 1))
      Bytes.length (zlibStream noise) `shouldSatisfy` (< 100300)
  where
    unzlib = Lazy.toStrict . Zlib.decompress . Lazy.fromStrict
    pieces =
      Bytes.concat
        <$> listOf
          ( oneof
              [ Bytes.replicate <$> choose (0, 700) <*> arbitrary,
                Bytes.pack <$> listOf arbitrary,
                Bytes.pack . map (`div` 32) <$> listOf arbitrary
              ]
          )
    joinedWeights (a : b : rest) = a + b + joinedWeights (insertSorted (a + b) rest)
    joinedWeights _ = 0
    insertSorted w rest = let (low, high) = span (< w) rest in low ++ w : high
