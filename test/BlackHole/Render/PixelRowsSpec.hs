module BlackHole.Render.PixelRowsSpec (spec) where

import BlackHole.Render.PixelArray
import BlackHole.Render.PixelRows
import BlackHole.Render.PixelShape
import BlackHole.Render.Workers
import Data.Foldable (for_)
import Data.Maybe (isNothing)
import qualified Data.Vector.Storable as Vector
import qualified Data.Vector.Storable.Mutable as MVector
import Data.Word (Word8)
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck

spec :: Spec
spec = do
  prop "finds every number where the order of pixels says" . forCounted $ \(shape, pixels) ->
    for_ [0 .. shapeHeight shape - 1] $ \y -> do
      let start = y * shapeWidth shape * shapeChannels shape
      fmap Vector.toList (pixelRow pixels y)
        `shouldBe` Just (take (shapeRowLength shape) [start ..])
      for_ [0 .. shapeWidth shape - 1] $ \x ->
        fmap Vector.toList (pixelChannels pixels x y)
          `shouldBe` Just (take (shapeChannels shape) [start + x * shapeChannels shape ..])

  prop "finds nothing outside" . forCounted $ \(shape, pixels) ->
    for_ [(-1, 0), (0, -1), (shapeWidth shape, 0), (0, shapeHeight shape)] $ \(x, y) ->
      pixelChannels pixels x y `shouldSatisfy` isNothing

  prop "maps each row with its number" . forCounted $ \(shape, pixels) -> ioProperty $ do
    bytes <- mapRows oneWorker convert pixels
    pixelArrayShape bytes `shouldBe` shape
    Vector.toList (toPixelVector bytes)
      `shouldBe` [ fromIntegral (3 * i + i `div` shapeRowLength shape)
                   | i <- [0 .. shapeLength shape - 1]
                 ]
  where
    convert y old new =
      for_ [0 .. Vector.length old - 1] $ \i ->
        MVector.write new i (fromIntegral (3 * old Vector.! i + y) :: Word8)

-- An array that holds its own offsets.
counted :: Gen (PixelShape, PixelArray Int)
counted =
  (pixelShape <$> choose (1, 9) <*> choose (1, 9) <*> choose (1, 4)) `suchThatMap` \measured -> do
    shape <- measured
    pixels <- fromPixelVector shape (Vector.enumFromN 0 (shapeLength shape))
    pure (shape, pixels)

forCounted :: Testable p => ((PixelShape, PixelArray Int) -> p) -> Property
forCounted = forAllShow counted (show . fst)
