-- | The slider of a setting: the part of its range that is worth trying, and its scale.
module BlackHole.Explore.Slider
  ( Slider (..),
    slider,
  )
where

import BlackHole.Scene.Field.Field
import BlackHole.Scene.Field.Kind
import BlackHole.Scene.Preset
import Data.Maybe (fromMaybe, mapMaybe)

-- | The ends of a slider.
data Slider
  = -- | Equal steps.
    Straight !Double !Double
  | -- | Equal ratios between two numbers above 0. The flag says whether the left end
    -- stands for 0 instead.
    Logarithmic !Double !Double !Bool
  deriving (Eq, Show)

-- | The slider of a setting that is a number. Its ends lie in the setting's range, except
-- that they may be an excluded bound; typed values may lie beyond them. A range that
-- spans a factor of up to a thousand is shown whole; of a longer one the part around the
-- values that the presets have.
slider :: Field -> Maybe Slider
slider field = case fieldKind field of
  NumberKind quantity
    | take 7 (quantityUnit quantity) == "degrees" -> Just (angles (lower quantity) (upper quantity))
    | otherwise -> Just (between (lower quantity) (upper quantity))
  WholeKind low high _ -> Just (between (Just (fromIntegral low)) (Just (fromIntegral high)))
  _ -> Nothing
  where
    angles low high =
      Straight
        (max (-180) (orElse (-180) low))
        (min 360 (if maybe False (< 0) low then 180 else orElse 180 high))
    between low high = case (low, high) of
      (Just l, Just h)
        | h - l <= 1000 && (l < 0 || h <= 20 || (l > 0 && h / l <= 100)) ->
          Straight l h
      (Just l, _)
        | l >= 0 ->
          Logarithmic
            (max l (min (greatest / 100) (smallest / 2)))
            (maybe id min high (50 * greatest))
            (l == 0)
      _ -> Straight (maybe id max low (negate (4 * greatest))) (maybe id min high (4 * greatest))
    -- Of the sizes of the presets' values.
    (smallest, greatest) = case filter
      (> 0)
      (map abs (mapMaybe (\(_, scene) -> fieldGet field scene >>= size) presets)) of
      [] -> (1, 1)
      sizes -> (minimum sizes, maximum sizes)
    size value = case value of
      NumberValue v -> Just v
      WholeValue n -> Just (fromIntegral n)
      _ -> Nothing
    lower quantity = case quantityLeast quantity of
      Anything -> Nothing
      From v -> Just v
      Above v -> Just v
    upper quantity = case quantityMost quantity of
      Endless -> Nothing
      UpTo v -> Just v
      Below v -> Just v
    orElse = fromMaybe
