module BlackHole.Vector.XYSpec (spec) where

import BlackHole.Vector.XY ((*^), (^+^), (^-^))
import qualified BlackHole.Vector.XY as XY
import Support.Approx
import Support.Generators
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck

spec :: Spec
spec = do
  prop "addition commutes and subtraction undoes it" $ \(Plane a) (Plane b) ->
    a ^+^ b === b ^+^ a .&&. near (a ^+^ b ^-^ b) a
  prop "zero is neutral" $ \(Plane a) -> a ^+^ XY.zero === a
  prop "scaling distributes" $ \(Plane a) (Plane b) ->
    forAll (inRange (-10) 10) $ \k -> near (k *^ (a ^+^ b)) (k *^ a ^+^ k *^ b)
  prop "the length squared is the product with itself" $ \(Plane a) ->
    closeTo 1e-9 (XY.dot a a) (XY.norm a * XY.norm a)
  prop "the triangle inequality" $ \(Plane a) (Plane b) ->
    XY.norm (a ^+^ b) <= XY.norm a + XY.norm b + 1e-12
  prop "lerp meets its ends" $ \(Plane a) (Plane b) ->
    XY.lerp 0 a b === a .&&. near (XY.lerp 1 a b) b
  where
    near a b = closeTo 1e-11 0 (sqrt (XY.normSquared (a ^-^ b)))
