module BlackHole.Image.PlainTiffSpec (spec) where

import BlackHole.Image.PlainTiff
import qualified Codec.Picture as Juicy
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Lazy as Lazy
import Data.Maybe (isJust)
import Test.Hspec

spec :: Spec
spec = do
  it "reads what an encoder writes, of 8 and 16 bits" $ do
    samplesOf plain 7 5 `shouldBe` Just (35 / 255, 99 / 255, 5 / 255)
    samplesOf
      ( Lazy.toStrict
          ( Juicy.encodeTiff
              ( Juicy.generateImage
                  (\x y -> Juicy.PixelRGB16 (fromIntegral x) 99 (fromIntegral (300 * y)))
                  48
                  24
              )
          )
      )
      7
      5
      `shouldBe` Just (7 / 65535, 99 / 65535, 1500 / 65535)
    samplesOf
      ( Lazy.toStrict
          (Juicy.encodeTiff (Juicy.generateImage (\x _ -> fromIntegral x :: Juicy.Pixel8) 48 24))
      )
      7
      5
      `shouldBe` Just (7 / 255, 7 / 255, 7 / 255)
  it "reads numbers with the highest byte first, and floating-point ones" $ do
    samplesOf (big 16 1 [0x12, 0x34, 0x56, 0x78]) 1 0
      `shouldBe` Just (0x5678 / 65535, 0x5678 / 65535, 0x5678 / 65535)
    samplesOf (big 32 3 [0x3f, 0xc0, 0, 0, 0xbf, 0, 0, 0]) 0 0 `shouldBe` Just (1.5, 1.5, 1.5)
    samplesOf (big 32 3 [0x3f, 0xc0, 0, 0, 0xbf, 0, 0, 0]) 1 0 `shouldBe` Just (-0.5, -0.5, -0.5)
  it "has nothing outside the picture" $
    samplesOf plain 48 0 `shouldBe` Just (0, 0, 0)
  it "refuses strips outside the file, with which JuicyPixels reads outside its memory" $ do
    -- The value of the entry is its last four bytes.
    refused (entry 273 + 11) 0x7f
    refused (entry 273 + 9) 0x01
  it "refuses rows without a strip, and other kinds of files" $ do
    refused (entry 257 + 8) 25
    refused (entry 278 + 8) 23
    refused (entry 278 + 8) 0
    refused (entry 256 + 8) 99
    refused (entry 259 + 8) 5
    refused (entry 262 + 8) 3
  it "refuses what is no TIFF, and one cut short" $ do
    isJust (readPlainTiff Bytes.empty) `shouldBe` False
    isJust (readPlainTiff (Bytes.take (Bytes.length plain - 80) plain)) `shouldBe` False
  where
    samplesOf bytes column row = (\t -> tiffSamples t column row) <$> readPlainTiff bytes
    refused at byte =
      isJust (readPlainTiff (Bytes.take at plain <> Bytes.cons byte (Bytes.drop (at + 1) plain)))
        `shouldBe` False
    plain =
      Lazy.toStrict
        ( Juicy.encodeTiff
            ( Juicy.generateImage
                (\x y -> Juicy.PixelRGB8 (fromIntegral (x * y)) 99 (fromIntegral y))
                48
                24
            )
        )
    -- Where the entry of a tag begins, little end first, after the pixels.
    entry tag =
      8 + 48 * 24 * 3
        + Bytes.length
          ( fst
              ( Bytes.breakSubstring
                  (Bytes.pack [fromIntegral (tag - 256 :: Int), 1])
                  (Bytes.drop (8 + 48 * 24 * 3) plain)
              )
          )
    -- Two grey pixels: the header, the samples, and a directory of seven tags.
    big depth format pixels =
      Bytes.pack $
        [0x4d, 0x4d, 0, 42, 0, 0, 0, 8 + fromIntegral (length pixels)]
          ++ pixels
          ++ [0, 7]
          ++ concat
            [ [1, tag, 0, 3, 0, 0, 0, 1, 0, value, 0, 0]
              | (tag, value) <- [(0, 2), (1, 1), (2, depth), (3, 1), (6, 1), (17, 8), (83, format)]
            ]
