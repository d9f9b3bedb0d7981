module BlackHole.Vector.PatchSpec (spec) where

import BlackHole.Vector.Patch
import BlackHole.Vector.XYZ (XYZ (..))
import qualified BlackHole.Vector.XYZ as XYZ
import Data.Maybe (isJust, isNothing)
import Support.Approx
import Support.Generators
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck

spec :: Spec
spec = do
  prop "a smooth function has its values" $
    forAll inside $ \(x, y) ->
      fmap (XYZ.distance (wavy x y)) (patchValue patched x y) `closerThan` 1e-8
  prop "and its derivatives" $
    forAll inside $ \(x, y) ->
      let apart = 1e-5
          quotient f = (0.5 / apart) XYZ.*^ (f apart XYZ.^-^ f (negate apart))
       in case patchChange patched x y of
            Just (Changing alongX alongY) ->
              nearXYZ 1e-5 (quotient (\d -> wavy (x + d) y)) alongX
                .&&. nearXYZ 1e-5 (quotient (\d -> wavy x (y + d))) alongY
            Nothing -> property False
  prop "a jump leaves no value nearby and does no harm elsewhere" $
    forAll inside $ \(x, y) -> case patchValue stepped x y of
      Nothing -> counterexample "far from the jump" (abs (x - 0.3) < 0.4)
      Just value -> nearXYZ 1e-6 (step x y) value
  prop "where the function has no value the patch has none" $
    forAll inside $ \(x, y) -> isNothing (patchValue (patch 1e-6 3 (\_ _ -> Nothing) rectangle) x y)
  it "a curve has the values of its function, or is none" $ do
    let smooth = curve 1e-9 16 cos 0.5 0.7
    [fmap (abs . subtract (cos x) . (`curveValue` x)) smooth | x <- [-0.2, -0.1 .. 1.2]]
      `shouldSatisfy` all (maybe False (< 1e-9))
    isJust (curve 1e-9 16 (abs . subtract 0.4) 0.5 0.7) `shouldBe` False
  where
    rectangle = Rectangle 1 2 (-0.5) 1
    inside = (,) <$> inRange (-1) 3 <*> inRange (-1.5) 0.5
    wavy x y = XYZ (sin (3 * x + y)) (exp (0.5 * x * y)) (1 / (4 + x + y * y))
    step x y = XYZ (if x < 0.3 then y else 1 + y) 0 0
    stepped = patch 1e-6 9 (\p q -> Just (step p q)) rectangle
    patched = patch 1e-7 9 (\x y -> Just (wavy x y)) rectangle
    closerThan found limit = counterexample (show found) (maybe False (< limit) found)
