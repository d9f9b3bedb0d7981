module BlackHole.Figure.FigureSpec (spec) where

import BlackHole.Figure.Figure
import BlackHole.Vector.XY (XY (..))
import qualified BlackHole.Vector.XY as XY
import Support.Approx
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck

spec :: Spec
spec = do
  describe "dashes" $ do
    it "begin with a dash and leave gaps" $
      dashes 3 2 [XY 0 0, XY 10 0]
        `shouldBe` [[XY 0 0, XY 3 0], [XY 5 0, XY 8 0]]
    it "go around corners" $
      dashes 3 1 [XY 0 0, XY 2 0, XY 2 4]
        `shouldBe` [[XY 0 0, XY 2 0, XY 2 1], [XY 2 2, XY 2 4]]
    it "leave a line whole that has no gaps" $
      dashes 3 0 [XY 0 0, XY 2 0] `shouldBe` [[XY 0 0, XY 2 0]]
    prop "cover dash / (dash + gap) of a long line" $
      forAll ((,) <$> choose (0.5, 5) <*> choose (0.5, 5)) $ \(dash, gap) ->
        let len = 1000
            points = [XY (len * k / 37) 0 | k <- [0 .. 37]]
            drawn =
              sum
                [ XY.norm (q XY.^-^ p)
                  | piece <- dashes dash gap points,
                    (p, q) <- zip piece (drop 1 piece)
                ]
         in closeTo (dash + gap) (len * dash / (dash + gap)) drawn
  describe "the outline of a circle" $ do
    it "is closed and has all its corners on the circle" $ do
      let outline = circleOutline (XY 3 4) 50
      map (\p -> XY.norm (p XY.^-^ XY 3 4)) outline `shouldSatisfy` all (\r -> abs (r - 50) < 1e-9)
      sequence_
        [ XY.norm (p XY.^-^ q) `shouldBeWithin` (1e-9, 0)
          | (p, q) <- take 1 (zip outline (reverse outline))
        ]
    it "is nowhere a fiftieth of a pixel off" $
      sequence_
        [ XY.norm (XY.lerp 0.5 p q) `shouldBeWithin` (0.02, r)
          | r <- [1, 10, 100, 1000, 4000],
            let outline = circleOutline (XY 0 0) r,
            (p, q) <- take 3 (zip outline (drop 1 outline))
        ]
