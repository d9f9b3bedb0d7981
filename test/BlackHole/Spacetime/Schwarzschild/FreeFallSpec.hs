module BlackHole.Spacetime.Schwarzschild.FreeFallSpec (spec) where

import BlackHole.Spacetime.Schwarzschild.FreeFall
import Support.Approx
import Support.Generators
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck

spec :: Spec
spec = do
  describe "infallRadius" $ do
    prop "solves dr/dτ = −√(1/r), by an independent integration" $
      forAll ((,) <$> inRange 2 40 <*> inRange 0.05 0.95) $ \(r0, part) ->
        let time = part * infallTime r0 0
            slope r = negate (sqrt (1 / r))
         in case infallRadius r0 time of
              Just r -> closeTo (1e-7 * r0) (rungeKutta slope r0 (time / 4000) 4000) r
              Nothing -> property False
    it "is at the horizon after (2/3)(r₀^{3/2} − 1) and reaches the centre 2/3 later" $ do
      maybe
        (expectationFailure "no radius")
        (`shouldBeWithin` (1e-13, 1))
        (infallRadius 9 (2 / 3 * 26))
      infallRadius 9 18 `shouldBe` Nothing
      infallRadius 9 17.999999 `shouldSatisfy` (/= Nothing)
    prop "is undone by infallTime, backwards in time too" $
      forAll ((,) <$> inRange 1 50 <*> inRange 0.1 80) $ \(r0, r) ->
        maybe (property False) (closeTo 1e-10 r) (infallRadius r0 (infallTime r0 r))
    it "does not exist for radii that are not positive" $
      map (`infallRadius` 0) [0, -1, 0 / 0, 1 / 0] `shouldBe` replicate 4 Nothing
  describe "orbitalPhase" $ do
    prop "is γv/r with the speed past the static observer" $
      forAll (inRange 1.6 100) $ \r ->
        let v = sqrt (1 / (2 * (r - 1)))
         in maybe (property False) (closeTo 1e-12 (7 * v / sqrt (1 - v * v) / r)) (orbitalPhase r 7)
    it "turns at the ISCO by 1/√27 in a unit of proper time" $
      -- dφ/dτ = √(1/54)/√(1/2) = 1/√27.
      fmap (* sqrt 27) (orbitalPhase 3 1) `shouldSatisfy` maybe False (\x -> abs (x - 1) < 1e-15)
    it "does not exist from the photon sphere inwards" $
      map (`orbitalPhase` 1) [1.5, 1, 0 / 0] `shouldBe` replicate 3 Nothing
  where
    rungeKutta f x h n = foldl (\y _ -> step f h y) x [1 .. n :: Int]
    step f h y =
      let k1 = f y
          k2 = f (y + h / 2 * k1)
          k3 = f (y + h / 2 * k2)
          k4 = f (y + h * k3)
       in y + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
