-- | Bringing colours into the range of a display without turning their hue.
module BlackHole.Light.Gamut
  ( desaturateIntoGamut,
    fitGamut,
  )
where

import BlackHole.Light.Radiance

-- | The nearest colour without negative amounts, at the same luminance. Colours
-- that have none are returned as they are; light without a positive luminance
-- has no such neighbour and becomes 'black'. NaN stays NaN.
--
-- Where red or blue is the least amount, white is mixed in until it is zero: the
-- direction from the white point (the dominant wavelength) stays as it is.
-- Clipping that amount alone would turn the hue.
--
-- Where green is the least, beyond the purple side of the display's triangle,
-- the way to white would add blue to the deepest reds, which no eye sees there:
-- light at 700 nm would become pink. So negative amounts are set to zero and the
-- rest is scaled, by which the end of the spectrum becomes the display's red.
-- Both rules agree where they meet.
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
    -- Zero itself for the least amount: the formula would leave it at the
    -- rounding error, on either side.
    towardsWhite c
      | c <= least = 0
      | otherwise = max 0 (y + saturation * (c - y))
{-# INLINE desaturateIntoGamut #-}

-- | Clip to 0…1 without turning the hue: a colour that is too bright for the
-- display is mixed with the white of its own luminance until it fits. Clipping
-- each primary alone would turn bright orange into yellow.
fitGamut :: Radiance -> Radiance
fitGamut light@(Radiance r g b)
  | peak <= 1 = positive
  | y >= 1 = grey 1
  | otherwise = mapRadiance (\x -> min 1 (y + (x - y) * (1 - y) / (peak - y))) positive
  where
    positive = mapRadiance (max 0) light
    peak = max r (max g b)
    y = luminance positive
