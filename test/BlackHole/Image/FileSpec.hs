module BlackHole.Image.FileSpec (spec) where

import BlackHole.Image.Coding
import BlackHole.Image.Exr (halfBits)
import BlackHole.Image.File
import BlackHole.Image.Metadata
import BlackHole.Light.Display
import BlackHole.Light.Dither
import BlackHole.Render.Exposed
import BlackHole.Render.Layer
import BlackHole.Render.PixelArray
import BlackHole.Render.PixelShape
import BlackHole.Render.Workers
import Codec.Picture
import Control.Monad (forM_)
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Char8 as Characters
import qualified Data.ByteString.Lazy as Lazy
import Data.List (isInfixOf)
import Data.Maybe (fromMaybe, isNothing, mapMaybe)
import qualified Data.Vector.Storable as Vector
import Data.Word (Word16)
import GHC.Float (castFloatToWord32)
import Support.Exposing
import Support.Tool
import System.FilePath ((</>))
import System.IO.Temp (withSystemTempDirectory)
import Test.Hspec
import Test.QuickCheck (choose, forAll, property)

spec :: Spec
spec = do
  describe "every format" $
    forM_ kinds $ \(path, coding) ->
      describe (path ++ maybe "" ((' ' :) . show) (codingBits coding)) $ do
        it "holds its metadata, also with a long scene" $
          forM_ [scene, Bytes.concat (replicate 500 scene)] $ \text -> do
            let metadata = tagged coding text
            fmap (fileMetadata . Lazy.toStrict) <$> coded oneWorker path metadata
              `shouldReturn` Just (Just metadata)
        it "has the same bytes for any number of workers" $ do
          files <-
            mapM
              (\workers -> coded workers path (tagged coding scene))
              (mapMaybe workersFromCount [1, 2, 3])
          files `shouldSatisfy` all (\file -> [file] == take 1 files)
        it "is a picture of this size to ImageMagick or OpenImageIO" $
          inFile path coding $ \file ->
            if formatOf path == Just Exr
              then withTool "oiiotool" $ \tool -> do
                text <- toolOutput tool ["--info", file]
                Characters.unpack text
                  `shouldSatisfy` isInfixOf (show width ++ " x   " ++ show height)
              else withImageMagick "identify" $ \identify ->
                identify ["-format", "%w %h", file]
                  `shouldReturn` Characters.pack (show width ++ " " ++ show height)
  describe "decoded" $ do
    it "PNG in 16 bits has every code, by JuicyPixels and by ImageMagick" $ do
      codes <-
        toPixelVector
          <$> developFilmFinely oneWorker (Development exposure ToneFilm noGrain NoDither) 0 film
      inFile "a.png" (Coding (Just 16) Nothing) $ \file -> do
        picture <- decodePng <$> Bytes.readFile file
        case picture of
          Right (ImageRGB16 image) -> imageData image == codes `shouldBe` True
          _ -> expectationFailure "this is no 16-bit RGB PNG"
        withImageMagick "convert" $ \convert -> do
          raw <- convert [file, "-depth", "16", "-endian", "MSB", "rgb:-"]
          words16 raw == Vector.toList codes `shouldBe` True
    it "TIFF in 16 bits has every code, by JuicyPixels and by ImageMagick" $ do
      codes <-
        toPixelVector
          <$> developFilmFinely oneWorker (Development exposure ToneFilm noGrain NoDither) 0 film
      inFile "a.tif" defaultCoding $ \file -> do
        picture <- decodeTiff <$> Bytes.readFile file
        case picture of
          Right (ImageRGB16 image) -> imageData image == codes `shouldBe` True
          _ -> expectationFailure "this is no 16-bit RGB TIFF"
        withImageMagick "convert" $ \convert -> do
          raw <- convert [file, "-depth", "16", "-endian", "MSB", "rgb:-"]
          words16 raw == Vector.toList codes `shouldBe` True
    it "JPEG is near the developed picture" $ do
      let gentle =
            arrayOf
              3
              ( Vector.generate
                  (3 * width * height)
                  ( \i ->
                      fromIntegral ((i `quot` 3) `rem` width)
                        / fromIntegral (width * (1 + i `rem` 3))
                  )
              )
      codes <-
        toPixelVector
          <$> developFilm oneWorker (Development exposure ToneFilm noGrain NoDither) gentle
      file <-
        encoded oneWorker Jpeg (tagged (Coding Nothing (Just 95)) scene) development noLayers gentle
      case convertRGB8 <$> maybe (Left "not encoded") (decodeJpeg . Lazy.toStrict) file of
        Right image -> do
          let differences =
                Vector.zipWith
                  (\a b -> abs (fromIntegral a - fromIntegral b))
                  codes
                  (imageData image) ::
                  Vector.Vector Double
          Vector.sum differences / fromIntegral (Vector.length differences) `shouldSatisfy` (< 1)
        _ -> expectationFailure "this is no JPEG"
    it "HDR is the film's light within 1/256 of the strongest primary, by JuicyPixels" $
      inFile "a.hdr" defaultCoding $ \file -> do
        picture <- decodeHDR <$> Bytes.readFile file
        case picture of
          Right (ImageRGBF image) -> do
            (imageWidth image, imageHeight image) `shouldBe` (width, height)
            sequence_
              [ abs (a - b) `shouldSatisfy` (<= peak / 256)
                | i <- [0, 3 .. Vector.length light - 3],
                  let peak = Vector.maximum (Vector.slice i 3 light),
                  (a, b) <-
                    zip
                      (Vector.toList (Vector.slice i 3 light))
                      (Vector.toList (Vector.slice i 3 (imageData image)))
              ]
          _ -> expectationFailure "this is no HDR picture"
    it "TIFF in 32 bits is the film's light, by OpenImageIO" $
      inFile "a.tif" (Coding (Just 32) Nothing) $ isDumped 1e-6 (Vector.toList light)
    it "EXR in 32 bits is the film's light with its layer, by OpenImageIO" $
      inFile "a.exr" (Coding (Just 32) Nothing) $ isDumped 1e-6 (withLayer light)
    it "EXR in 16 bits is so within half a step" $
      inFile "a.exr" defaultCoding $ isDumped (1 / 2048 + 1e-6) (withLayer light)
    it "EXR's header is as the standard's own tool wants it" $
      inFile "a.exr" defaultCoding $ \file ->
        withTool "exrheader" $ \tool -> do
          text <- Characters.unpack <$> toolOutput tool [file]
          forM_
            [ "zip, multi-scanline blocks",
              "R, 16-bit floating-point, sampling 1 1",
              "redshift, 32-bit floating-point, sampling 1 1",
              "displayWindow (type box2i): (0 0) - (" ++ show (width - 1) ++ " "
                ++ show (height - 1)
                ++ ")",
              "software (type string): \"blackhole 1.2.3\""
            ]
            $ \line -> text `shouldSatisfy` isInfixOf line
    it "EXR is refused with layers that do not fit" $ do
      let with layers = encoded oneWorker Exr (tagged defaultCoding scene) development layers film
          named names = Layers names (layerRow redshift)
      mapM
        (fmap isNothing . with . named)
        [["redshift"], ["redshift", "redshift"], ["R"], [""], [replicate 32 'a']]
        `shouldReturn` [False, True, True, True, True]
    it "EXR has NaN where a layer says nothing" $ do
      let short = Layers ["a"] (const (pure [Vector.fromList [7]]))
      bytes <-
        encoded oneWorker Exr (tagged (Coding (Just 32) Nothing) scene) development short film
      withSystemTempDirectory "blackhole-spec" $ \folder -> do
        Lazy.writeFile (folder </> "a.exr") (fromMaybe Lazy.empty bytes)
        withTool "oiiotool" $ \tool -> do
          text <- toolOutput tool ["--stats", folder </> "a.exr"]
          Characters.unpack text
            `shouldSatisfy` isInfixOf ("NanCount: 0 0 0 " ++ show ((width - 1) * height))
  describe "16-bit floating point" $ do
    it "has the standard's values" $
      map
        (halfBits . castFloatToWord32)
        [ 0,
          1,
          -2,
          65504,
          65519,
          65520,
          1e9,
          1 / 0,
          2 ** (-14),
          2 ** (-24),
          2 ** (-25),
          1.5 * 2 ** (-24),
          0.1
        ]
        `shouldBe` [ 0,
                     0x3c00,
                     0xc000,
                     0x7bff,
                     0x7bff,
                     0x7bff,
                     0x7bff,
                     0x7c00,
                     0x0400,
                     0x0001,
                     0x0000,
                     0x0002,
                     0x2e66
                   ]
    it "rounds ties to even, above and below the smallest normal number" $ do
      [halfBits (castFloatToWord32 (1 + n / 2048)) | n <- [1, 3, 5, 7, 2047]]
        `shouldBe` [0x3c00, 0x3c02, 0x3c02, 0x3c04, 0x4000]
      [halfBits (castFloatToWord32 (n * 2 ** (-25))) | n <- [1, 3, 5, 7]] `shouldBe` [0, 2, 2, 4]
    it "is the nearest there is" $
      property $
        forAll (choose (-20, 15)) $ \e -> forAll (choose (1, 2)) $ \m ->
          let v = m * 2 ** e :: Float
              h = halfBits (castFloatToWord32 v)
           in all (\other -> abs (valueOf h - v) <= abs (valueOf other - v)) [h - 1, h + 1]
  it "knows no metadata in other files" $
    map
      (fileMetadata . Characters.pack)
      [ "",
        "P6 1 1 255",
        "#?RADIANCE\n\n",
        "\xff\xd8\xff\xda",
        "\137PNG\r\n\26\n",
        "II*\0\8\0\0\0\0\0"
      ]
      `shouldBe` replicate 6 Nothing
  where
    kinds =
      [ ("a.png", defaultCoding),
        ("a.png", Coding (Just 16) Nothing),
        ("a.jpg", Coding Nothing (Just 80)),
        ("a.tif", defaultCoding),
        ("a.tif", Coding (Just 32) Nothing),
        ("a.hdr", defaultCoding),
        ("a.exr", defaultCoding),
        ("a.exr", Coding (Just 32) Nothing)
      ]
    tagged = Metadata "blackhole 1.2.3"
    scene = Characters.pack "camera:\n  distance: 30\n\nname: caf\195\169\n"
    exposure = Exposure 0
    development = Development exposure ToneFilm noGrain NoDither
    coded workers path metadata = case formatOf path of
      Nothing -> pure Nothing
      Just format -> encoded workers format metadata development redshift film
    inFile path coding action = withSystemTempDirectory "blackhole-spec" $ \folder -> do
      bytes <- coded oneWorker path (tagged coding scene)
      case bytes of
        Nothing -> expectationFailure "not encoded"
        Just content -> Lazy.writeFile (folder </> path) content >> action (folder </> path)
    -- Whether these are the numbers of a file as OpenImageIO reads it.
    isDumped bound expected file = do
      text <- toolOutputIfThere "oiiotool" ["--dumpdata", file]
      case text of
        Nothing -> pendingWith "oiiotool is not installed"
        Just bytes -> concatMap numbers (Characters.lines bytes) `shouldSatisfy` near bound expected
    numbers line
      | Characters.pack "Pixel" `Bytes.isInfixOf` line =
        map
          (read . Characters.unpack)
          (Characters.words (Characters.drop 1 (Characters.dropWhile (/= ':') line)))
      | otherwise = []
    near tolerance expected actual =
      length expected == length actual
        && and
          (zipWith (\a b -> abs (a - b) <= tolerance * abs a + 1e-7) expected (actual :: [Float]))
    withLayer numbers' =
      concat
        [ Vector.toList (Vector.slice (3 * i) 3 numbers') ++ [redshiftAt i]
          | i <- [0 .. width * height - 1]
        ]
    words16 raw = case Bytes.unpack (Bytes.take 2 raw) of
      [high, low] ->
        (256 * fromIntegral high + fromIntegral low :: Word16) : words16 (Bytes.drop 2 raw)
      _ -> []
    valueOf h =
      let e = fromIntegral (h `div` 1024) :: Int
          m = fromIntegral (h `mod` 1024) :: Float
       in if e == 0 then m * 2 ** (-24) else (1 + m / 1024) * 2 ^^ (e - 15)

width, height :: Int
width = 41
height = 37

-- | Light over many orders of magnitude, with runs and darkness.
film :: Film
film = arrayOf 3 (Vector.generate (3 * width * height) amount)
  where
    amount i
      | (i `div` 60) `mod` 3 == 0 = 0
      | (i `div` 60) `mod` 3 == 1 = 0.25
      | otherwise = exp (6 * sin (fromIntegral i * 0.37)) * 0.1

light :: Vector.Vector Float
light = toPixelVector film

redshift :: Layers
redshift =
  Layers ["redshift"] (\row -> pure [Vector.generate width (\x -> redshiftAt (row * width + x))])

redshiftAt :: Int -> Float
redshiftAt i = 0.5 + fromIntegral i / 1000

arrayOf :: Int -> Vector.Vector Float -> PixelArray Float
arrayOf channels values =
  case pixelShape width height channels >>= \shape -> fromPixelVector shape values of
    Just pixels -> pixels
    Nothing -> error "the test's picture has another size"
