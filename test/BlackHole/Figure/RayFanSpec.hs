module BlackHole.Figure.RayFanSpec (spec) where

import BlackHole.Figure.Figure
import BlackHole.Figure.RayFan
import BlackHole.Figure.RayFanFigure
import BlackHole.Figure.StrokeFont (glyph)
import BlackHole.Numeric.Angle (Radians (..))
import BlackHole.Spacetime.Kerr.EquatorialRay
import BlackHole.Spacetime.Kerr.Landmarks
  ( Handedness (..),
    Spin,
    dimensionlessSpin,
    horizonRadius,
    noSpin,
    photonOrbitRadius,
    spin,
  )
import BlackHole.Spacetime.Schwarzschild.Radii (criticalImpactParameter)
import BlackHole.Spacetime.Schwarzschild.Trajectory (Sight (..), trajectoryFromInfinity)
import BlackHole.Vector.XY (XY (..))
import Data.List (sort)
import Data.Maybe (fromMaybe, isNothing, mapMaybe)
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck

spec :: Spec
spec = do
  describe "impact parameters" $ do
    prop "are as many as asked for, in order, and mirror images" $
      forAll (RayFan <$> choose (1, 300) <*> choose (4, 100) <*> pure 600 <*> pure noSpin) $ \fan ->
        let bs = fanImpactParameters fan
         in length bs === fanRays fan
              .&&. bs === sort bs
              .&&. conjoin
                [counterexample (show bs) (abs (a + b) < 1e-9) | (a, b) <- zip bs (reverse bs)]
    it "include both sides of the critical one" $ do
      let near =
            [ abs b / criticalImpactParameter - 1
              | b <- fanImpactParameters defaultRayFan,
                abs (abs b / criticalImpactParameter - 1) < 2e-3
            ]
      map (round . (* 1e5)) near `shouldMatchList` ([100, -100, 100, -100] :: [Int])
  it "rays are classed by their fate and by their turns" $
    map
      (rayClass . trajectoryFromInfinity (Sight (Radians 0) (Radians 0)))
      [0, 1, 2.5, 2.598, 2.6, 2.65, 2.8, 7]
      `shouldBe` [Falling, Falling, Falling, Winding, Winding, Winding, Escaping, Escaping]
  describe "the figure" $ do
    it "has one line per ray, and colours for all three classes" $ do
      let rayLines =
            [ colour
              | Clipped _ shapes <- figureShapes figure,
                Polyline (Stroke colour _ Nothing) _ <- shapes
            ]
      length rayLines `shouldBe` fanRays defaultRayFan
      length (foldr (\c seen -> if c `elem` seen then seen else c : seen) [] rayLines) `shouldBe` 3
    it "draws horizon and photon sphere about one centre, as one to one and a half" $
      [ (centre == centre', ring / disc)
        | Clipped _ shapes <- figureShapes figure,
          Disc _ centre disc <- shapes,
          Ring _ centre' ring <- shapes
      ]
        `shouldBe` [(True, 1.5)]
    it "draws rays that end on the horizon, and others that leave" $ do
      let ends =
            [ sqrt ((x - cx) * (x - cx) + (y - cy) * (y - cy)) / disc
              | Clipped _ shapes <- figureShapes figure,
                Disc _ (XY cx cy) disc <- shapes,
                Polyline (Stroke _ _ Nothing) points <- shapes,
                XY x y <- take 1 (reverse points)
            ]
      length (filter (\r -> abs (r - 1) < 1e-6) ends)
        `shouldBe` length
          (filter ((< criticalImpactParameter) . abs) (fanImpactParameters defaultRayFan))
      length (filter (> 10) ends)
        `shouldBe` length
          (filter ((> criticalImpactParameter) . abs) (fanImpactParameters defaultRayFan))
    it "is the same to the left and right of each ray's mirror image" $ do
      let leftEnds =
            sort
              [ y
                | Clipped (Box _ top _ height) shapes <- figureShapes figure,
                  Polyline (Stroke _ _ Nothing) (XY _ py : _) <- shapes,
                  let y = py - top - 0.5 * height
              ]
      zip leftEnds (reverse leftEnds) `shouldSatisfy` all (\(a, b) -> abs (a + b) < 1e-6)
    it "uses only characters that the line font has" $
      filter
        (isNothing . glyph)
        ( concat
            [ concatMap characters (labelRuns l)
              | extent <- [4, 8, 90],
                Words l <- figureShapes (rayFanFigure defaultRayFan {fanExtent = extent})
            ]
        )
        `shouldBe` ""
  describe "rays around a rotating hole" $ do
    it "are captured between the two critical impact parameters, and only there" $
      [ (s, b)
        | s <- spins,
          let (below, above) = fanCriticalParameters s,
          b <- [below * 1.0001, below * 0.9999, 0, above * 0.9999, above * 1.0001],
          equatorialEscapes (equatorialRay s 12 0.03 pi (negate b)) /= (b < below || b > above)
      ]
        `shouldBe` []
    it
      "have critical impact parameters as Bardeen, Press and Teukolsky give them for the \
      \fastest hole"
      $ [fanCriticalParameters s | Just s <- [spin (1 - 1e-14)]]
        `shouldSatisfy` all (\(below, above) -> abs (below + 1) < 1e-6 && abs (above - 3.5) < 1e-6)
    it "follow the equations of motion of the hole, forwards" $
      -- Simpson's rule of dφ/dw by the potentials of the unreversed hole.
      [ (s, b, turned, expected)
        | s <- spins,
          b <- [-7, -4, 4.5, 7],
          let ((r0, phi0), (r1, phi1)) =
                inwardEnds (equatorialPoints (equatorialRay s 12 0.01 pi (negate b)))
              turned = remainder (phi1 - phi0)
              expected = remainder (azimuthBetween s (negate b) r0 r1),
          abs (turned - expected) > 1e-8
      ]
        `shouldBe` []
    it "come from the direction asked for" $
      [ (s, b)
        | s <- spins,
          b <- [-7, 4.5],
          (_, phi) : _ <- [equatorialPoints (equatorialRay s 1e6 0.03 0 (negate b))],
          abs (remainder phi + b / 1e6) > 1e-10
      ]
        `shouldBe` []
    it "are drawn with horizon, ergosphere and both photon orbits to scale" $
      [ [d / ergosphere | Disc _ _ d <- shapes] ++ [o / ergosphere | Ring _ _ o <- shapes]
        | s <- take 1 spins,
          Clipped _ shapes <- figureShapes (rayFanFigure defaultRayFan {fanSpin = s}),
          Disc _ _ ergosphere <- take 1 shapes
      ]
        `shouldSatisfy` all
          ( \found ->
              and
                ( zipWith
                    (\x y -> abs (x - y) < 1e-9)
                    found
                    [ 1,
                      horizonRadius fast,
                      photonOrbitRadius RightHanded fast,
                      photonOrbitRadius LeftHanded fast
                    ]
                )
                && length found
                == 4
          )
  where
    spins = mapMaybe spin [0.9, -0.9, 0.3, 0.998]
    fast = fromMaybe noSpin (spin 0.9)
    remainder x = x - 2 * pi * fromIntegral (round (x / (2 * pi)) :: Int)
    -- A point at the start and one halfway to the smallest radius.
    inwardEnds points = (entry, last (entry : take (length inward `div` 2) inward))
      where
        inward = [q | (p, q) <- zip points (drop 1 points), fst q < fst p]
        entry = foldr const (0, 0) points
    figure = rayFanFigure defaultRayFan
    characters run = case run of
      Plain s -> s
      Subscript s -> s

-- | The azimuth in radians that light of angular momentum λ turns on the way in from one
-- radius to another: the integral of dφ/dr by Simpson's rule in 1/r.
azimuthBetween :: Spin -> Double -> Double -> Double -> Double
azimuthBetween hole lambda from to =
  h / 3 * sum [weight k * rate (1 / from + h * fromIntegral k) | k <- [0 .. n]]
  where
    n = 4000 :: Int
    h = (1 / to - 1 / from) / fromIntegral n
    weight k
      | k == 0 || k == n = 1
      | odd k = 4
      | otherwise = 2 :: Double
    a = 0.5 * dimensionlessSpin hole
    rate w =
      (lambda - a + a * p / delta) / sqrt (p * p - delta * (lambda - a) * (lambda - a)) / (w * w)
      where
        r = 1 / w
        p = r * r + a * a - a * lambda
        delta = r * r - r + a * a
