-- | Mapping colours into the range of a display without changing their hue.
module BlackHole.Light.Gamut
  ( desaturateIntoGamut,
    fitGamut,
  )
where

import BlackHole.Light.Radiance

-- | The nearest colour without negative components, at equal luminance. Colours without
-- negative components are returned unchanged. Light without a positive luminance has no
-- such neighbour and becomes 'black'. NaN stays NaN.
--
-- If red or blue is the smallest component, white is mixed in until it is zero, which
-- preserves the direction from the white point (the dominant wavelength). Clipping that
-- component alone would change the hue.
--
-- If green is the smallest component, beyond the purple side of the display's triangle,
-- mixing in white would add blue to the deepest reds, which no eye sees there: light at
-- 700 nm would become pink. In that case negative components are set to zero and the
-- rest is scaled, so the end of the spectrum becomes the display's red. Both rules
-- agree where they meet.
desaturateIntoGamut :: Radiance -> Radiance
desaturateIntoGamut colour@(Radiance r g b)
  | least >= 0 = colour
  | y <= 0 = black
  | g <= least = scaleRadiance (y / luminance positive) positive
  | otherwise = mapRadiance towardsWhite colour
  where
    least = min r (min g b)
    y = luminance colour
    positive = mapRadiance (max 0) colour
    saturation = y / (y - least)
    -- Exactly zero for the smallest component, where the formula would leave a rounding
    -- error of either sign.
    towardsWhite c
      | c <= least = 0
      | otherwise = max 0 (y + saturation * (c - y))
{-# INLINE desaturateIntoGamut #-}

-- | Clips to 0 to 1 without changing the hue: a colour too bright for the display is
-- mixed with white of equal luminance until it fits. Clipping each primary alone would
-- turn bright orange into yellow.
fitGamut :: Radiance -> Radiance
fitGamut light@(Radiance r g b)
  | peak <= 1 = positive
  | y >= 1 = grey 1
  | otherwise = mapRadiance (\x -> min 1 (y + (x - y) * (1 - y) / (peak - y))) positive
  where
    positive = mapRadiance (max 0) light
    peak = max r (max g b)
    y = luminance positive
