module BlackHole.Animation.FrameNameSpec (spec) where

import BlackHole.Animation.FrameName
import Data.Either (isLeft)
import Test.Hspec

spec :: Spec
spec = do
  it "pads as printf does" $ do
    names "frames/%05d.png"
      `shouldBe` Right ["frames/00000.png", "frames/00042.png", "frames/123456.png"]
    names "%d.png" `shouldBe` Right ["0.png", "42.png", "123456.png"]
    names "a%%b-%03d.png" `shouldBe` Right ["a%b-000.png", "a%b-042.png", "a%b-123456.png"]
  it "can be written and read again" $
    fmap framePattern (parseFrameName "x%%/a%%b-%03d.png") `shouldBe` Right "x%%/a%%b-%03d.png"
  it "wants one place for the number, in the file's name" $
    map
      (isLeft . parseFrameName)
      ["frame.png", "%d-%d.png", "%5d.png", "%s.png", "50%.png", "%d/frame.png", "", "%099d.png"]
      `shouldBe` replicate 8 True
  where
    names text = (\name -> map (frameFile name) [0, 42, 123456]) <$> parseFrameName text
