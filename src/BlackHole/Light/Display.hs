-- | From linear radiance to what a display is told, in three separate steps:
-- exposure, tone curve, sRGB coding (IEC 61966-2-1). Nothing here depends on
-- any other pixel, so equal light always gives equal bytes.
module BlackHole.Light.Display
  ( Exposure (..),
    expose,
    ToneMap (..),
    toneMapName,
    applyToneMap,
    encodeSrgb,
    decodeSrgb,
    quantise,
    displayCode,
  )
where

import BlackHole.Light.Radiance
import Data.Word (Word8)

-- | Exposure in stops: each doubles the light; 0 leaves it alone.
newtype Exposure = Exposure {exposureStops :: Double}
  deriving (Eq, Ord, Show)

-- | Multiply the light by two to the exposure.
expose :: Exposure -> Radiance -> Radiance
expose (Exposure stops) = scaleRadiance (2 ** stops)
{-# INLINE expose #-}

-- | How exposed light above display white is brought into range.
data ToneMap
  = -- | Not at all: what fits is shown as it is, and what does not keeps its
    -- hue and loses saturation on its way to white ('fitGamut').
    ToneNone
  | -- | The response of a photographic emulsion, @1 − e^{−x}@ per primary:
    -- proportional in the shadows, rolling off softly to white.
    ToneFilm
  deriving (Eq, Show, Read, Enum, Bounded)

-- | The name on the command line.
toneMapName :: ToneMap -> String
toneMapName ToneNone = "none"
toneMapName ToneFilm = "film"

-- | Bring exposed light into 0…1 for each primary.
applyToneMap :: ToneMap -> Radiance -> Radiance
applyToneMap ToneNone = fitGamut
applyToneMap ToneFilm = mapRadiance (\x -> 1 - exp (negate (max 0 x)))
{-# INLINE applyToneMap #-}

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

-- | Linear 0…1 to the sRGB signal 0…1.
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

-- | A signal 0…1 to the nearest of 256 codes; values outside, and NaN, go to
-- the ends of the range.
quantise :: Double -> Word8
quantise s
  | s >= 1 = 255
  | s > 0 = fromIntegral (truncate (s * 255 + 0.5) :: Int)
  | otherwise = 0
{-# INLINE quantise #-}

-- | All three steps for one pixel: red, green and blue codes.
displayCode :: Exposure -> ToneMap -> Radiance -> (Word8, Word8, Word8)
displayCode exposure tone light = (code r, code g, code b)
  where
    Radiance r g b = applyToneMap tone (expose exposure light)
    code = quantise . encodeSrgb
{-# INLINE displayCode #-}
