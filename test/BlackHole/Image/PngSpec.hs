module BlackHole.Image.PngSpec (spec) where

import BlackHole.Image.Coding
import BlackHole.Image.Destination
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
  it "asks for bands of all rows once, in order" $
    forM_ [(1, 1), (640, 360), (300, 3000), (90000, 7)] $ \(width, height) ->
      forM_ (mapMaybe workersFromCount [1, 3]) $ \workers -> do
        asked <- newIORef []
        let bandOf range@(first, count) = do
              modifyIORef asked (range :)
              pure . Just $ \(from, rows) -> do
                -- Of a band no other rows are to be had.
                guard (from >= first && from + rows <= first + count)
                codesOf width height (from, rows)
        file <- inBands workers width height bandOf
        ranges <- readIORef asked
        decodedPixels file == Just (width, height, picture width height) `shouldBe` True
        concat [[first .. first + count - 1] | (first, count) <- reverse ranges]
          `shouldBe` [0 .. height - 1]
  it "breaks off when a band or its rows are missing or have another shape or size" $
    forM_
      [ Nothing,
        Just Nothing,
        Just (Codes8 <$> (pixelShape 4 4 3 >>= \shape -> fromPixelVector shape (picture 4 4))),
        Just
          ( Codes16
              <$> (pixelShape 5 4 3 >>= \shape -> fromPixelVector shape (Vector.replicate 60 0))
          )
      ]
      $ \band -> do
        let bandOf = const (pure (const <$> band))
        done <-
          maybe
            (pure True)
            (\shape -> encodePng oneWorker metadata shape 1 bandOf (const (pure ())))
            (pixelShape 5 4 3)
        done `shouldBe` False
  where
    metadata = Metadata "spec" defaultCoding Bytes.empty
    roundTrip (width, height) = do
      file <- encoded oneWorker width height
      decodedPixels file == Just (width, height, picture width height) `shouldBe` True
    encoded workers width height =
      inBands workers width height (const (pure (Just (codesOf width height))))
    inBands workers width height bandOf = case pixelShape width height 3 of
      Nothing -> Lazy.empty <$ expectationFailure "not a picture"
      Just shape -> do
        (complete, file) <- inMemory (encodePng workers metadata shape 1 bandOf . putBytes)
        file <$ (complete `shouldBe` True)
    codesOf width height (from, rows) = do
      shape <- pixelShape width rows 3
      Codes8
        <$> fromPixelVector
          shape
          (Vector.slice (3 * width * from) (3 * width * rows) (picture width height))
    decodedPixels file = case decodePng (Lazy.toStrict file) of
      Right (ImageRGB8 (Image w h codes)) -> Just (w, h, codes)
      _ -> Nothing
    -- Gradients, black, and something like noise.
    picture :: Int -> Int -> Vector.Vector Word8
    picture width height = Vector.generate (3 * width * height) code
    code i
      | i `mod` 1000 < 400 = 0
      | i `mod` 1000 < 700 = fromIntegral (i `quot` 7)
      | otherwise = fromIntegral (i * i `quot` 11)
