module BlackHole.Image.PngSpec (spec) where

import BlackHole.Image.Coding
import BlackHole.Image.Metadata
import BlackHole.Image.Png
import BlackHole.Render.PixelArray
import BlackHole.Render.PixelShape
import BlackHole.Render.Workers
import Codec.Picture hiding (encodePng)
import Control.Monad (forM_, guard)
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Lazy as Lazy
import Data.IORef
import Data.Maybe (mapMaybe)
import qualified Data.Vector.Storable as Vector
import Data.Word (Word8)
import Test.Hspec

spec :: Spec
spec = do
  it "is read back with every code, at any size" $
    mapM_ roundTrip [(1, 1), (2, 1), (3, 5), (7, 2), (640, 360), (300, 1000)]
  it "has the same bytes for any number of workers" $ do
    files <- traverse (\workers -> encoded workers 500 400) (mapMaybe workersFromCount [1, 2, 3])
    files `shouldSatisfy` all (\file -> take 1 files == [file])
  it "has the same bytes made of bands, of which it asks for all rows once" $
    forM_ [(1, 1), (640, 360), (300, 3000), (90000, 7)] $ \(width, height) ->
      forM_ (mapMaybe workersFromCount [1, 3]) $ \workers -> do
        whole <- encoded workers width height
        written <- newIORef []
        asked <- newIORef []
        let bandOf range@(first, count) = do
              modifyIORef asked (range :)
              pure . Just $ \(from, rows) -> do
                -- Of a band no other rows are to be had.
                guard (from >= first && from + rows <= first + count)
                shape <- pixelShape width rows 3
                Codes8 <$> fromPixelVector shape (Vector.slice (3 * width * from) (3 * width * rows) (picture width height))
        done <- maybe (pure False) (\shape -> encodePngBands workers label shape 1 bandOf (\bytes -> modifyIORef written (bytes :))) (pixelShape width height 3)
        file <- readIORef written
        ranges <- readIORef asked
        (done, Lazy.fromChunks (reverse file) == whole) `shouldBe` (True, True)
        concat [[first .. first + count - 1] | (first, count) <- reverse ranges] `shouldBe` [0 .. height - 1]
  it "breaks off when a band or its rows are missing or have another shape or size" $
    forM_
      [ Nothing,
        Just Nothing,
        Just (Codes8 <$> (pixelShape 4 4 3 >>= \shape -> fromPixelVector shape (picture 4 4))),
        Just (Codes16 <$> (pixelShape 5 4 3 >>= \shape -> fromPixelVector shape (Vector.replicate 60 0)))
      ]
      $ \band -> do
        let bandOf = const (pure (const <$> band))
        done <- maybe (pure True) (\shape -> encodePngBands oneWorker label shape 1 bandOf (const (pure ()))) (pixelShape 5 4 3)
        done `shouldBe` False
  where
    label = Label "spec" defaultCoding Bytes.empty
    roundTrip (width, height) = do
      file <- encoded oneWorker width height
      case decodePng (Lazy.toStrict file) of
        Right (ImageRGB8 (Image w h codes)) -> do
          (w, h) `shouldBe` (width, height)
          codes == picture width height `shouldBe` True
        _ -> expectationFailure "this is no 8-bit RGB PNG"
    encoded workers width height =
      case pixelShape width height 3 >>= \shape -> fromPixelVector shape (picture width height) of
        Just pixels -> encodePng workers label (Codes8 pixels)
        Nothing -> Lazy.empty <$ expectationFailure "not a picture"
    -- Gradients, black, and something like noise.
    picture :: Int -> Int -> Vector.Vector Word8
    picture width height = Vector.generate (3 * width * height) code
    code i
      | i `mod` 1000 < 400 = 0
      | i `mod` 1000 < 700 = fromIntegral (i `quot` 7)
      | otherwise = fromIntegral (i * i `quot` 11)
