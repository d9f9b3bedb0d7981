module BlackHole.Explore.SliderSpec (spec) where

import BlackHole.Explore.Slider
import BlackHole.Scene.Field.Field
import BlackHole.Scene.Field.Kind
import BlackHole.Scene.Field.Table
import BlackHole.Scene.Preset
import Data.Maybe (isJust)
import Test.Hspec

spec :: Spec
spec = do
  it "gives every number a slider, and nothing else" $
    [fieldPath f | f <- sceneFields, isJust (slider f) /= isNumber (fieldKind f)] `shouldBe` []
  it "runs from a smaller to a greater value within the range" $
    [ fieldPath f
      | f <- sceneFields,
        Just bar <- [slider f],
        let (low, high) = ends bar,
        low >= high || any (outside f) [low, high]
    ]
      `shouldBe` []
  it "has room for the values of the presets on either side" $
    [ (fieldPath f, v)
      | f <- sceneFields,
        Just bar <- [slider f],
        let (low, high) = ends bar,
        (_, scene) <- presets,
        Just v <- [fieldGet f scene >>= size],
        v < low && not (fromZero bar && v >= 0) || v > high
    ]
      `shouldBe` []
  it "has equal ratios for ranges that span many orders of magnitude" $ do
    (fmap isLogarithmic . slider =<< findField "disk.temperature") `shouldBe` Just True
    (slider <$> findField "camera.inclination") `shouldBe` Just (Just (Straight 0 180))
    (slider <$> findField "hole.spin") `shouldBe` Just (Just (Straight (-1) 1))
  where
    isNumber kind = case kind of
      NumberKind _ -> True
      WholeKind {} -> True
      _ -> False
    ends bar = case bar of
      Straight low high -> (low, high)
      Logarithmic low high _ -> (low, high)
    isLogarithmic bar = case bar of
      Logarithmic {} -> True
      Straight _ _ -> False
    fromZero bar = case bar of
      Logarithmic _ _ zero -> zero
      Straight _ _ -> False
    size value = case value of
      NumberValue v -> Just v
      WholeValue n -> Just (fromIntegral n)
      _ -> Nothing
    -- An excluded bound is allowed: the page does not set it.
    outside f v = case fieldKind f of
      NumberKind quantity -> below (quantityLeast quantity) v || above (quantityMost quantity) v
      WholeKind low high _ -> v < fromIntegral low || v > fromIntegral high
      _ -> False
    below least v = case least of
      Anything -> False
      From l -> v < l
      Above l -> v < l
    above most v = case most of
      Endless -> False
      UpTo h -> v > h
      Below h -> v > h
