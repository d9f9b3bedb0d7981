module BlackHole.Figure.RasterSpec (spec) where

import BlackHole.Figure.Figure
import BlackHole.Figure.Raster
import BlackHole.Vector.XY (XY (..))
import Codec.Picture (Image (..), PixelRGB8 (..), pixelAt)
import Support.Approx
import Test.Hspec

spec :: Spec
spec = do
  it "is white and has the figure's size" $ do
    let image = drawn []
    (imageWidth image, imageHeight image) `shouldBe` (60, 40)
    inkOf image `shouldBe` 0
  it "a disc has the ink of its area" $
    inkOf (drawn [Disc black (XY 30.3 19.6) 12]) `shouldBeWithin` (1, pi * 144)
  it "a ring has the ink of its length times its width" $
    inkOf (drawn [Ring (line 2) (XY 30.3 19.6) 12]) `shouldBeWithin` (4, 2 * pi * 12 * 2)
  it "a slanting line too, with its round ends" $
    inkOf (drawn [Polyline (line 3) [XY 10.2 5.1, XY 50.4 33.7]])
      `shouldBeWithin` (3, 3 * sqrt (40.2 * 40.2 + 28.6 * 28.6) + pi * 2.25)
  it "a line drawn in many pieces, or twice over itself, is the same line" $ do
    let whole = drawn [Polyline (line 2) [XY 10 5, XY 50 33]]
        onTheLine t = XY (10 + 40 * t) (5 + 28 * t)
        pieces = drawn [Polyline (line 2) (map onTheLine ([0, 0.05 .. 1] ++ [0]))]
    abs (inkOf whole - inkOf pieces) `shouldSatisfy` (< 0.5)
  it "thin lines get paler" $
    inkOf (drawn [Polyline (line 0.5) [XY 10 20.5, XY 50 20.5]]) `shouldBeWithin` (2, 20)
  it "a polygon is filled, whichever way round" $ do
    let corners = [XY 10 10, XY 40 10, XY 40 30, XY 10 30]
    mapM_
      (\p -> inkOf (drawn [Polygon black p]) `shouldBeWithin` (1, 600))
      [corners, reverse corners]
  it "nothing is drawn outside the clip" $ do
    let image = drawn [Clipped (Box 0 0 30 40) [Disc black (XY 30 20) 10]]
    inkOf image `shouldBeWithin` (2, 50 * pi)
    pixelAt image 32 20 `shouldBe` PixelRGB8 255 255 255
    pixelAt image 27 20 `shouldBe` PixelRGB8 0 0 0
  it "later shapes lie on top, in their own colour" $
    pixelAt (drawn [Disc black (XY 30 20) 10, Disc (Colour 10 200 30) (XY 30 20) 5]) 30 20
      `shouldBe` PixelRGB8 10 200 30
  it "shapes that lie outside, or are no shapes, leave the picture white" $
    inkOf
      ( drawn
          [ Disc black (XY 500 20) 10,
            Polyline (line 2) [XY 0 (-50), XY 60 (-50)],
            Polyline (line 2) [],
            Polygon black [],
            Polygon black [XY 3 3]
          ]
      )
      `shouldBeWithin` (0.6, 0)
  it "text is where its anchor says" $ do
    let written anchor =
          drawn [Words (Label (XY 30 25) anchor 14 black False [Plain "b", Subscript "c"])]
        columns image =
          [x | x <- [0 .. 59], any (\y -> pixelAt image x y /= PixelRGB8 255 255 255) [0 .. 39]]
    minimum (60 : columns (written AtStart)) `shouldSatisfy` (>= 28)
    maximum (0 : columns (written AtEnd)) `shouldSatisfy` (<= 31)
    inkOf (written AtMiddle) `shouldSatisfy` (> 20)
  where
    black = Colour 0 0 0
    line width = Stroke black width Nothing
    drawn = rasterise . Figure 60 40 ""

-- | How much of the picture is black, in pixels.
inkOf :: Image PixelRGB8 -> Double
inkOf image =
  sum
    [ 1 - fromIntegral r / 255
      | y <- [0 .. imageHeight image - 1],
        x <- [0 .. imageWidth image - 1],
        let PixelRGB8 r _ _ = pixelAt image x y
    ]
