module Support.DifferenceSpec (spec) where

import Codec.Picture
import Support.Difference
import Test.Hspec

spec :: Spec
spec = do
  it "measures mean, maximum and count" $
    differenceOf 2 (flat 10) (generateImage spot 4 5)
      `shouldBe` Just (Difference (-0.05) 0.15 6 1)
  it "knows pictures of other sizes" $
    differenceOf 2 (flat 10) (generateImage (\_ _ -> PixelRGB8 0 0 0) 5 4) `shouldBe` Nothing
  where
    flat v = generateImage (\_ _ -> PixelRGB8 v v v) 4 5
    -- Three codes of sixty differ: by −6, +1 and +2.
    spot x y
      | (x, y) == (1, 1) = PixelRGB8 4 11 12
      | otherwise = PixelRGB8 10 10 10
