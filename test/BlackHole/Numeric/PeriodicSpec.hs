module BlackHole.Numeric.PeriodicSpec (spec) where

import BlackHole.Numeric.Periodic
import Support.Approx
import Support.Generators
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck

spec :: Spec
spec = do
  prop "an integral is that of calculus, however far it goes" $
    forAll ((,) <$> inRange 0 1 <*> inRange (-20) 20) $ \(q, x) ->
      let n = 4 + ceiling (20 * q) :: Int
          root = sqrt (1 + q)
          -- The arc tangent on the branch of x.
          turn = pi * fromIntegral (round (x / pi) :: Int)
          known = (turn + atan (root * tan (x - turn))) / root
          integrand sine2 = 1 / (1 + q * sine2)
       in closeTo (1e-13 * (1 + abs x) + 0.5 ^ n) known (integral (2 * n) integrand x)
  it "more values make the error fall geometrically" $ do
    let known = atan (sqrt 1.1 * tan 0.7) / sqrt 1.1
        errors = [abs (integral n (\sine2 -> 1 / (1 + 0.1 * sine2)) 0.7 - known) | n <- [2, 4, 6]]
    zipWith (/) (drop 1 errors) errors `shouldSatisfy` all (< 1e-2)
  it "knows the mean" $
    integralPerRadian (periodicIntegral (resolution 5) id) `shouldBeWithin` (1e-15, 0.5)
  where
    integral n f x = integralTo (periodicIntegral (resolution n) f) x (sin x) (cos x)
