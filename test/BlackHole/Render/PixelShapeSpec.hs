module BlackHole.Render.PixelShapeSpec (spec) where

import BlackHole.Render.PixelShape
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck (Positive (..))

spec :: Spec
spec = do
  prop "keeps its measures" $ \(Positive w) (Positive h) (Positive c) ->
    fmap measures (pixelShape w h c) `shouldBe` Just [w, h, c, w * c, w * h * c]

  prop "has no empty side" $ \(Positive a) (Positive b) -> do
    pixelShape 0 a b `shouldBe` Nothing
    pixelShape a 0 b `shouldBe` Nothing
    pixelShape a b 0 `shouldBe` Nothing
    pixelShape (negate a) (negate b) 1 `shouldBe` Nothing

  it "counts its bytes in an Int" $ do
    let most = maxBound `div` 8
    fmap shapeLength (pixelShape 1 most 1) `shouldBe` Just most
    pixelShape 1 (most + 1) 1 `shouldBe` Nothing
    pixelShape 2 most 1 `shouldBe` Nothing
    pixelShape maxBound maxBound maxBound `shouldBe` Nothing
  where
    measures shape =
      map ($ shape) [shapeWidth, shapeHeight, shapeChannels, shapeRowLength, shapeLength]
