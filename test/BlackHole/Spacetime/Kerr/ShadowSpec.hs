module BlackHole.Spacetime.Kerr.ShadowSpec (spec) where

import BlackHole.Spacetime.Fate
import BlackHole.Spacetime.Kerr.Landmarks
import BlackHole.Spacetime.Kerr.Path
import BlackHole.Spacetime.Kerr.Shadow
import BlackHole.Spacetime.Kerr.Sight
import Data.Maybe (fromMaybe)
import Support.Approx
import Support.KerrReference
import Test.Hspec
import Text.Read (readMaybe)

spec :: Spec
spec = do
  it "has the extent that 30-digit shooting finds" $ do
    rows <- kerrRows "kerr-shadow.csv"
    length rows `shouldSatisfy` (> 5)
    sequence_
      [ maybe
          (pure ())
          (\known -> degrees (extreme side direction (seen s r i)) `shouldBeWithin` (1e-8, known))
          (readMaybe cell)
        | s : r : i : "static" : cells <- rows,
          (side, direction, cell) <-
            zip3 [minimum, maximum, maximum, minimum] [right, right, up, up] (take 4 cells)
      ]
  it "is a circle of the known size without spin, seen from anywhere" $
    sequence_
      [ forward (shadowEdge (seen "0" r i) alpha)
          `shouldBeWithin` (1e-13, sqrt (1 - 27 / 4 * (1 - 1 / read r) / (read r * read r)))
        | r <- ["3", "30"],
          i <- ["80", "25"],
          alpha <- [0, 0.7 .. 6]
      ]
  it "parts what is captured from what escapes" $
    sequence_
      [ [fate hole place (towards scale direction) | scale <- [1 - 1e-6, 1 + 1e-6]]
          `shouldBe` ["captured", "escapes"]
        | (s, r, i) <-
            [(0.9, 20, 80), (0.998, 10, 30), (0.9, 1.4, 80), (-0.7, 5, 120), (1e-7, 8, 60)],
          let hole = spinOf s
              place = Place r (i * pi / 180),
          alpha <- [0.1, 0.6 .. 6.2],
          let direction = shadowEdge (fromMaybe (error "no shadow") (shadow hole place)) alpha
      ]
  it "comes from spherical orbits between the circular ones" $
    sequence_
      [ sphericalOrbitRadius hole lambda
          `shouldSatisfy` ( \r ->
                              r > photonOrbitRadius RightHanded hole - 1e-9
                                && r < photonOrbitRadius LeftHanded hole + 1e-9
                          )
        | hole <- map spinOf [0.5, 0.99],
          lambda <- [-3, -2 .. 1]
      ]
  where
    seen s r i =
      fromMaybe (error "no shadow") (shadow (spinOf (read s)) (Place (read r) (read i * pi / 180)))
    right (Direction nr _ nphi) = atan2 nphi (negate nr)
    up (Direction nr ntheta _) = atan2 (negate ntheta) (negate nr)
    forward (Direction nr _ _) = negate nr
    degrees x = x * 180 / pi
    -- The extreme over the edge, by parabolas through ever closer points.
    extreme side angle rim = refine (8 :: Int) (0 :: Double) pi
      where
        refine 0 middle _ = value middle
        refine n middle width =
          let points = [middle + width * fromIntegral k / 50 | k <- [-50 .. 50 :: Int]]
              best = side (map value points)
           in case filter ((== best) . value) points of
                at : _ -> refine (n - 1) at (width / 20)
                [] -> best
        value = angle . shadowEdge rim
    -- The direction at a slightly smaller or greater angle from straight inward.
    towards scale (Direction nr ntheta nphi) =
      let psi = scale * atan2 (sqrt (ntheta * ntheta + nphi * nphi)) (negate nr)
          eta = atan2 (negate ntheta) nphi
       in aimed psi eta
    fate hole place direction =
      case kerrFate . kerrPath hole (BoyerLindquist 0) <$> lightRay hole place AtRest direction of
        Just Captured -> "captured"
        Just (Escaped _) -> "escapes"
        _ -> "neither"
