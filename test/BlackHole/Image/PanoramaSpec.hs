module BlackHole.Image.PanoramaSpec (spec) where

import BlackHole.Image.Panorama
import BlackHole.Light.Display (decodeSrgb)
import BlackHole.Light.Radiance
import BlackHole.Trace.EnvironmentMap
import qualified Codec.Compression.Zlib as Zlib
import Codec.Picture
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Builder as Builder
import qualified Data.ByteString.Char8 as Char8
import qualified Data.ByteString.Lazy as Lazy
import Data.List (isInfixOf)
import Support.Approx
import Support.Panorama
import System.FilePath ((</>))
import System.IO.Temp (withSystemTempDirectory)
import System.Mem (getAllocationCounter)
import Test.Hspec

spec :: Spec
spec = do
  it "takes every kind of file, whole numbers as sRGB and floating-point ones as linear" $
    sequence_
      [ do
          panoramaSize bytes `shouldBe` Just (16, 8)
          decoded <- decodePanorama bytes
          case decoded of
            Left problem -> expectationFailure (name ++ " " ++ problem)
            Right image ->
              luminance (environmentMapMean image) `shouldBeWithin` (tolerance, expected)
        | (name, bytes, tolerance, expected) <- files
      ]
  it "says in one line what is wrong with other files" $
    sequence_
      [ do
          decoded <- decodePanorama bytes
          case fmap environmentMapMean decoded of
            Left line -> lines line `shouldBe` [line]
            Right _ -> expectationFailure ("took " ++ show (Bytes.take 12 bytes))
        | bytes <-
            [ Bytes.empty,
              Char8.pack "not a picture",
              Bytes.take 20 png,
              -- A header that claims four billion pixels a side.
              Bytes.take 16 png <> Bytes.replicate 8 0xff <> Bytes.drop 24 png,
              Lazy.toStrict (encodePng (plain 16 9 :: Image PixelRGB8)),
              Char8.pack "#?RADIANCE\n\n-Y 99999999 +X 199999998\n"
            ]
      ]
  it "survives files that end anywhere" $
    withSystemTempDirectory "panorama" $ \folder ->
      sequence_
        [ do
            let file = folder </> "cut"
            Bytes.writeFile file (Bytes.take (Bytes.length bytes * k `quot` 7) bytes)
            outcome <- readPanorama file
            case outcome of
              Left line -> length (lines line) `shouldBe` 1
              -- Some decoders fill up what is missing.
              Right image -> environmentMapMean image `shouldSatisfy` isFiniteRadiance
          | (_, bytes, _, _) <- files,
            k <- [0 .. 6]
        ]
  it "does not unpack a PNG beyond its pixels" $ do
    -- Twenty million bytes for 128 pixels.
    let packed = Zlib.compress (Lazy.replicate 20000000 0)
        file = Lazy.toStrict (bloated packed)
    file `seq` pure ()
    allowance <- getAllocationCounter
    outcome <- decodePanorama file
    fmap environmentMapMean outcome
      `shouldSatisfy` either (isInfixOf "more than its pixels") (const False)
    left <- getAllocationCounter
    allowance - left `shouldSatisfy` (< 10000000)
  it "names no file that is not there" $ do
    outcome <- readPanorama "/nowhere/sky.png"
    fmap environmentMapMean outcome `shouldSatisfy` either (const True) (const False)
  where
    files =
      [ ("png", png, 1e-4, decodeSrgb (100 / 255)),
        ( "jpeg",
          Lazy.toStrict
            (encodeJpegAtQuality 100 (generateImage (\_ _ -> PixelYCbCr8 100 128 128) 16 8)),
          2e-3,
          decodeSrgb (100 / 255)
        ),
        ( "tiff",
          Lazy.toStrict (encodeTiff (generateImage (\_ _ -> PixelRGB16 25700 25700 25700) 16 8)),
          1e-4,
          decodeSrgb (100 / 255)
        ),
        ("hdr", Lazy.toStrict (encodeHDR (generateImage (\_ _ -> PixelRGBF 3 3 3) 16 8)), 0.05, 3)
      ]
    -- The header of a small picture before other data.
    bloated packed =
      Builder.toLazyByteString
        ( Builder.byteString (Bytes.take 33 png)
            <> Builder.word32BE (fromIntegral (Lazy.length packed))
            <> Builder.string7 "IDAT"
            <> Builder.lazyByteString packed
            <> Builder.word32BE 0
        )
    png = Lazy.toStrict (encodePng (plain 16 8 :: Image PixelRGB8))
    plain = generateImage (\_ _ -> PixelRGB8 100 100 100)
