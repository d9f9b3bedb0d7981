module BlackHole.Trace.TabulatedSpec (spec) where

import BlackHole.Trace.Tabulated
import Support.Approx
import Support.Generators
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck hiding (tabulate)

spec :: Spec
spec = do
  prop "is exact for straight lines" $
    forAll (inRange (-2) 5) $ \x ->
      closeTo 1e-12 (3 * x - 1) (value lines' 0 x) .&&. closeTo 1e-12 (negate x) (value lines' 1 x)
  prop "errs by an eighth of the second derivative at most" $
    forAll (inRange (-2) 5) $ \x ->
      closeTo (9 / 8 * spacing * spacing) (sin (3 * x)) (value waves 0 x)
        .&&. closeTo (exp 5 / 8 * spacing * spacing) (exp x) (value waves 1 x)
  it "has the function's own values at its arguments, both ends among them" $
    sequence_
      [ value waves 0 x `shouldBeWithin` (1e-12, sin (3 * x))
        | i <- [0 .. 70 :: Int],
          let x = -2 + spacing * fromIntegral i
      ]
  it "holds the ends' values beyond them" $ do
    map (value waves 1) [-3, -1 / 0] `shouldBe` replicate 2 (value waves 1 (-2))
    map (value waves 1) [6, 1 / 0] `shouldBe` replicate 2 (value waves 1 5)
  it "does with two arguments" $
    value (tabulate 1 2 0 1 (: [])) 0 0.25 `shouldBe` 0.25
  where
    spacing = 0.1
    lines' = tabulate 2 8 (-2) 5 (\x -> [3 * x - 1, negate x])
    waves = tabulate 2 71 (-2) 5 (\x -> [sin (3 * x), exp x])
    value table column x = valueAt table (rowAt table x) column
