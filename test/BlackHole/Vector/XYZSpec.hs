module BlackHole.Vector.XYZSpec (spec) where

import BlackHole.Vector.XYZ (XYZ (..), (*^), (^+^), (^-^))
import qualified BlackHole.Vector.XYZ as XYZ
import Support.Approx
import Support.Generators
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck

spec :: Spec
spec = do
  describe "vector space" $ do
    prop "addition commutes" $ \(Coordinates a) (Coordinates b) ->
      a ^+^ b === b ^+^ a
    prop "addition is associative" $ \(Coordinates a) (Coordinates b) (Coordinates c) ->
      nearXYZ 1e-12 (a ^+^ (b ^+^ c)) ((a ^+^ b) ^+^ c)
    prop "zero is neutral" $ \(Coordinates a) -> a ^+^ XYZ.zero === a
    prop "subtraction undoes addition" $ \(Coordinates a) (Coordinates b) ->
      nearXYZ 1e-12 ((a ^+^ b) ^-^ b) a
    prop "negation is the difference from zero" $ \(Coordinates a) ->
      XYZ.negated a ^+^ a === XYZ.zero
    prop "scaling distributes" $ \(Coordinates a) (Coordinates b) ->
      forAll (inRange (-10) 10) $ \k ->
        nearXYZ 1e-11 (k *^ (a ^+^ b)) (k *^ a ^+^ k *^ b)
    prop "lerp meets its ends" $ \(Coordinates a) (Coordinates b) ->
      XYZ.lerp 0 a b === a .&&. nearXYZ 1e-12 (XYZ.lerp 1 a b) b
  describe "products" $ do
    prop "the scalar product is symmetric" $ \(Coordinates a) (Coordinates b) ->
      XYZ.dot a b === XYZ.dot b a
    prop "Cauchy-Schwarz" $ \(Coordinates a) (Coordinates b) ->
      abs (XYZ.dot a b) <= XYZ.norm a * XYZ.norm b * (1 + 1e-14)
    prop "the vector product is at right angles to both" $ \(Coordinates a) (Coordinates b) ->
      let c = XYZ.cross a b
       in closeTo 1e-8 0 (XYZ.dot c a) .&&. closeTo 1e-8 0 (XYZ.dot c b)
    prop "Lagrange's identity" $ \(Coordinates a) (Coordinates b) ->
      closeTo 1e-5 (XYZ.normSquared a * XYZ.normSquared b) $
        XYZ.normSquared (XYZ.cross a b) + XYZ.dot a b * XYZ.dot a b
    it "is right-handed" $
      XYZ.cross (XYZ 1 0 0) (XYZ 0 1 0) `shouldBe` XYZ 0 0 1
  describe "length" $ do
    prop "the triangle inequality" $ \(Coordinates a) (Coordinates b) ->
      XYZ.norm (a ^+^ b) <= XYZ.norm a + XYZ.norm b + 1e-12
    prop "distance is symmetric" $ \(Coordinates a) (Coordinates b) ->
      XYZ.distance a b === XYZ.distance b a
    prop "unit vectors have unit length and keep the direction" $ \(Coordinates a) ->
      case XYZ.normalize a of
        Nothing -> property (XYZ.norm a == 0)
        Just u -> closeTo 1e-15 1 (XYZ.norm u) .&&. nearXYZ 1e-12 (XYZ.norm a *^ u) a
    it "nothing has the direction of zero, of NaN, or of infinity" $
      map XYZ.normalize [XYZ.zero, XYZ (0 / 0) 1 1, XYZ (1 / 0) 0 0, XYZ 1e-320 0 0]
        `shouldBe` replicate 4 Nothing
    it "knows finite vectors" $
      map XYZ.isFinite [XYZ 1 2 3, XYZ 1 (0 / 0) 3, XYZ 1 2 (-1 / 0)]
        `shouldBe` [True, False, False]
