module BlackHole.Figure.RayFanSpec (spec) where

import BlackHole.Figure.Figure
import BlackHole.Figure.RayFan
import BlackHole.Figure.StrokeFont (glyph)
import BlackHole.Numeric.Angle (Radians (..))
import BlackHole.Spacetime.Schwarzschild.Radii (criticalImpactParameter)
import BlackHole.Spacetime.Schwarzschild.Trajectory (Sight (..), trajectoryFromInfinity)
import BlackHole.Vector.XY (XY (..))
import Data.List (sort)
import Data.Maybe (isNothing)
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck

spec :: Spec
spec = do
  describe "impact parameters" $ do
    prop "are as many as asked for, in order, and mirror images" $
      forAll (RayFan <$> choose (1, 300) <*> choose (4, 100) <*> pure 600) $ \fan ->
        let bs = fanImpactParameters fan
         in length bs === fanRays fan
              .&&. bs === sort bs
              .&&. conjoin [counterexample (show bs) (abs (a + b) < 1e-9) | (a, b) <- zip bs (reverse bs)]
    it "include both sides of the critical one" $ do
      let near = [abs b / criticalImpactParameter - 1 | b <- fanImpactParameters defaultRayFan, abs (abs b / criticalImpactParameter - 1) < 2e-3]
      map (round . (* 1e5)) near `shouldMatchList` ([100, -100, 100, -100] :: [Int])
  it "rays are classed by their fate and by their turns" $
    map (rayClass . trajectoryFromInfinity (Sight (Radians 0) (Radians 0))) [0, 1, 2.5, 2.598, 2.6, 2.65, 2.8, 7]
      `shouldBe` [Falling, Falling, Falling, Winding, Winding, Winding, Escaping, Escaping]
  describe "the figure" $ do
    it "has one line per ray, and colours for all three classes" $ do
      let rayLines = [colour | Clipped _ shapes <- figureShapes figure, Polyline (Stroke colour _ Nothing) _ <- shapes]
      length rayLines `shouldBe` fanRays defaultRayFan
      length (foldr (\c seen -> if c `elem` seen then seen else c : seen) [] rayLines) `shouldBe` 3
    it "draws horizon and photon sphere about one centre, as one to one and a half" $
      [(centre == centre', ring / disc) | Clipped _ shapes <- figureShapes figure, Disc _ centre disc <- shapes, Ring _ centre' ring <- shapes]
        `shouldBe` [(True, 1.5)]
    it "draws rays that end on the horizon, and others that leave" $ do
      let ends =
            [ sqrt ((x - cx) * (x - cx) + (y - cy) * (y - cy)) / disc
              | Clipped _ shapes <- figureShapes figure,
                Disc _ (XY cx cy) disc <- shapes,
                Polyline (Stroke _ _ Nothing) points <- shapes,
                XY x y <- take 1 (reverse points)
            ]
      length (filter (\r -> abs (r - 1) < 1e-6) ends) `shouldBe` length (filter ((< criticalImpactParameter) . abs) (fanImpactParameters defaultRayFan))
      length (filter (> 10) ends) `shouldBe` length (filter ((> criticalImpactParameter) . abs) (fanImpactParameters defaultRayFan))
    it "is the same to the left and right of each ray's mirror image" $ do
      let leftEnds = sort [y | Clipped (Box _ top _ height) shapes <- figureShapes figure, Polyline (Stroke _ _ Nothing) (XY _ py : _) <- shapes, let y = py - top - 0.5 * height]
      zip leftEnds (reverse leftEnds) `shouldSatisfy` all (\(a, b) -> abs (a + b) < 1e-6)
    it "uses only characters that the line font has" $
      filter (isNothing . glyph) (concat [concatMap characters (labelRuns l) | extent <- [4, 8, 90], Words l <- figureShapes (rayFanFigure defaultRayFan {fanExtent = extent})])
        `shouldBe` ""
  where
    figure = rayFanFigure defaultRayFan
    characters run = case run of
      Plain s -> s
      Subscript s -> s
