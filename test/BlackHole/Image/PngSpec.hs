module BlackHole.Image.PngSpec (spec) where

import BlackHole.Image.Coding
import BlackHole.Image.Label
import BlackHole.Image.Png
import BlackHole.Render.PixelArray
import BlackHole.Render.PixelShape
import BlackHole.Render.Workers
import Codec.Picture hiding (encodePng)
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Lazy as Lazy
import Data.Maybe (mapMaybe)
import qualified Data.Vector.Storable as Vector
import Data.Word (Word8)
import Test.Hspec

spec :: Spec
spec = do
  it "is read back with every code, at any size" $
    mapM_ roundTrip [(1, 1), (2, 1), (3, 5), (7, 2), (640, 360), (300, 1000)]
  it "has the same bytes for any number of workers" $ do
    files <- traverse (\crew -> encoded crew 500 400) (mapMaybe workers [1, 2, 3])
    files `shouldSatisfy` all (\file -> take 1 files == [file])
  where
    roundTrip (width, height) = do
      file <- encoded oneWorker width height
      case decodePng (Lazy.toStrict file) of
        Right (ImageRGB8 (Image w h codes)) -> do
          (w, h) `shouldBe` (width, height)
          codes == picture width height `shouldBe` True
        _ -> expectationFailure "this is no 8-bit RGB PNG"
    encoded crew width height =
      case pixelShape width height 3 >>= \shape -> fromPixelVector shape (picture width height) of
        Just pixels -> encodePng crew (Label "spec" defaultCoding Bytes.empty) (Codes8 pixels)
        Nothing -> Lazy.empty <$ expectationFailure "not a picture"
    -- Gradients, black, and something like noise.
    picture :: Int -> Int -> Vector.Vector Word8
    picture width height = Vector.generate (3 * width * height) code
    code i
      | i `mod` 1000 < 400 = 0
      | i `mod` 1000 < 700 = fromIntegral (i `quot` 7)
      | otherwise = fromIntegral (i * i `quot` 11)
