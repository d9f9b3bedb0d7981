module BlackHole.Noise.ThresholdSpec (spec) where

import BlackHole.Noise.Lattice
import BlackHole.Noise.PerlinG
import BlackHole.Noise.Profile
import BlackHole.Noise.Threshold
import BlackHole.Vector.XYZ (XYZ (..), (*^))
import Support.Generators
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess, prop)
import Test.QuickCheck

spec :: Spec
spec = do
  modifyMaxSuccess (const 2000) $
    prop "is the noise itself, to the last bit, from the threshold on" $ \(Direction d) ->
      forAll somePlace $ \far -> forAll someProfile $ \p -> forAll (choose (-0.6, 0.9)) $ \least ->
        let place = far *^ d
            value = perlin3 seed p place
         in classify (value >= least) "above" $
              perlin3Above seed p least place === if value >= least then Just value else Nothing
  it "passes no place over" $
    length [() | place <- manyPlaces, Just v <- [perlin3Above seed single 0.6 place], v >= 0.6]
      `shouldBe` length (filter (>= 0.6) (map (perlin3 seed single) manyPlaces))
  it "takes no noise for 0, and a place nowhere for silent" $ do
    perlin3Above seed mempty 0 (XYZ 1 2 3) `shouldBe` Just 0
    perlin3Above seed mempty 0.1 (XYZ 1 2 3) `shouldBe` Nothing
    perlin3Above seed single 0.1 (XYZ (0 / 0) 2 3) `shouldBe` Nothing
  describe "the reach of a cell" $ do
    prop "is what a gradient at each corner that points to the place would give" $
      forAll fraction $ \x -> forAll fraction $ \y -> forAll fraction $ \z ->
        abs (noise3 seed unitLevel (XYZ x y z)) <= cellReach3 x y z
    modifyMaxSuccess (const 20000) $
      prop "is never more than the table says, nor less by a fifth of the largest" $
        forAll half $ \x -> forAll half $ \y -> forAll half $ \z ->
          let exact = cellReach3 x y z
              table = tabulatedReach3 x y z
           in counterexample (show (exact, table)) (exact <= table + 1e-12 && table - exact < 0.2)
  where
    seed = Seed 5
    single = normalised (octaves unitLevel 1 0.5)
    fraction = choose (0, 1 :: Double)
    half = choose (0, 0.5 :: Double)
    manyPlaces = [XYZ (0.377 * i) (1.113 * i) (0.7171 * i) | i <- [1 .. 20000]]
    somePlace = oneof [choose (0, 10), choose (0, 400), choose (0, 4e9), elements [0, 0.5, 1, 2]]
    someProfile =
      oneof
        [ normalised . (\n -> octaves unitLevel n 0.5) <$> choose (1, 6),
          profile
            <$> listOf1
              ( (,) . clampedLevel
                  <$> elements [0, 1, 28, 30, 31, 32, 33, 36, 50, 64] <*> choose (-1, 1)
              )
        ]
