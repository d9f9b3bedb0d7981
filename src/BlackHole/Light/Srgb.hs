-- | The coding of linear light as a display's signal: sRGB (IEC 61966-2-1).
module BlackHole.Light.Srgb
  ( encodeSrgb,
    decodeSrgb,
  )
where

-- | Converts linear light, 0 to 1, to the sRGB signal, 0 to 1.
encodeSrgb :: Double -> Double
encodeSrgb x
  | x <= 0.0031308 = 12.92 * x
  | otherwise = 1.055 * x ** (1 / 2.4) - 0.055
{-# INLINE encodeSrgb #-}

-- | The inverse of 'encodeSrgb'.
decodeSrgb :: Double -> Double
decodeSrgb s
  | s <= 0.04045 = s / 12.92
  | otherwise = ((s + 0.055) / 1.055) ** 2.4
{-# INLINE decodeSrgb #-}
