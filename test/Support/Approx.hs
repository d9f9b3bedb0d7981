-- | Comparing numbers with a stated tolerance.
module Support.Approx
  ( shouldBeWithin,
    closeTo,
    nearXYZ,
  )
where

import BlackHole.Vector.XYZ (XYZ)
import qualified BlackHole.Vector.XYZ as XYZ
import Test.Hspec
import Test.QuickCheck (Property, counterexample)

-- | @value `shouldBeWithin` (tolerance, reference)@, absolutely.
shouldBeWithin :: HasCallStack => Double -> (Double, Double) -> Expectation
shouldBeWithin value (tolerance, reference)
  | abs (value - reference) <= tolerance = pure ()
  | otherwise =
    expectationFailure $
      show value ++ " is not within " ++ show tolerance ++ " of " ++ show reference

-- | The same as a property.
closeTo :: Double -> Double -> Double -> Property
closeTo tolerance reference value =
  counterexample
    (show value ++ " is not within " ++ show tolerance ++ " of " ++ show reference)
    (abs (value - reference) <= tolerance)

-- | Two points no farther apart than a tolerance.
nearXYZ :: Double -> XYZ -> XYZ -> Property
nearXYZ tolerance a b =
  counterexample
    (show a ++ " is not within " ++ show tolerance ++ " of " ++ show b)
    (XYZ.distance a b <= tolerance)
