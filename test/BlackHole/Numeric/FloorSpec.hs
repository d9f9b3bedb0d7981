module BlackHole.Numeric.FloorSpec (spec) where

import BlackHole.Numeric.Floor
import Support.Generators
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck

spec :: Spec
spec = do
  describe "floorOf" $ do
    prop "is the floor and what is left, to the last bit" $
      forAll number $ \x ->
        let Floor whole rest = floorOf x
         in not (isWhole x) ==> (whole, rest) === (floor x, x - fromInteger (floor x))
    it "takes whole numbers from either side" $
      sequence_
        [ (fromIntegral whole + rest, rest `elem` [0, 1]) `shouldBe` (x, True)
          | n <- [-6 .. 6 :: Int] ++ [2 ^ (50 :: Int) + 1, -(2 ^ (50 :: Int)) - 3],
            let x = fromIntegral n
                Floor whole rest = floorOf x
        ]
    it "takes the neighbours of whole numbers" $
      sequence_
        [ do
            abs (fromIntegral whole + rest - x) `shouldSatisfy` (<= 2e-16)
            rest `shouldSatisfy` (\t -> t >= 0 && t <= 1)
          | n <- [-3 .. 3 :: Int],
            apart <- [-1e-16, -2e-16, -4e-16, 1e-16, 4e-16, -1e-300, 1e-300],
            let x = fromIntegral n + apart
                Floor whole rest = floorOf x
        ]
  describe "turnFraction" $
    prop "is the same angle within half a turn" $
      forAll number $ \x ->
        let t = turnFraction x
         in conjoin
              [ counterexample (show t) (abs t <= 0.5),
                counterexample (show t) (isWhole (x - t))
              ]
  where
    isWhole x = x == fromInteger (round x)
    -- Down to a last place of a quarter.
    number =
      (\sign e m -> sign * m * 2 ** e) <$> elements [-1, 1] <*> inRange (-20) 50 <*> inRange 0.5 1
