-- | From linear radiance to the codes of a display, in separate steps: exposure, tone
-- map ("BlackHole.Light.ToneMap"), sRGB coding (IEC 61966-2-1) and dither
-- ("BlackHole.Light.Dither"). No step depends on any other pixel's light, so equal
-- light at the same position always gives equal bytes.
module BlackHole.Light.Display
  ( Exposure (..),
    expose,
    ToneMap (..),
    toneMapName,
    applyToneMap,
    encodeSrgb,
    decodeSrgb,
    quantise,
    Developer,
    developer,
    developSignal,
    Signal (..),
    ditheredCode,
    displayCode,
    fineCode,
  )
where

import BlackHole.Light.Dither
import BlackHole.Light.Gamut (fitGamut)
import BlackHole.Light.Radiance
import BlackHole.Light.ToneMap
import qualified Data.Vector.Unboxed as U
import Data.Word (Word16, Word8)

-- | Exposure in stops: each stop doubles the light, and 0 leaves it unchanged.
newtype Exposure = Exposure {exposureStops :: Double}
  deriving (Eq, Ord, Show)

-- | Multiplies the light by two to the power of the exposure.
expose :: Exposure -> Radiance -> Radiance
expose (Exposure stops) = scaleRadiance (2 ** stops)
{-# INLINE expose #-}

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

-- | The nearest of 256 codes to a signal in 0 to 1. Values outside the range, and NaN,
-- go to its ends.
quantise :: Double -> Word8
quantise s
  | s >= 1 = 255
  | s > 0 = ditheredCode 0.5 s
  | otherwise = 0
{-# INLINE quantise #-}

-- | @ditheredCode threshold signal@ is 'quantise' with a rounding threshold other than
-- one half. The signal lies in 0 to 1; the threshold is above 0 and below 1.
ditheredCode :: Double -> Double -> Word8
ditheredCode threshold s = fromIntegral (truncate (s * 255 + threshold) :: Int)
{-# INLINE ditheredCode #-}

-- | The nearest of 65536 codes to a signal, with the same treatment of the ends.
fineCode :: Double -> Word16
fineCode s
  | s >= 1 = 65535
  | s > 0 = fromIntegral (truncate (s * 65535 + 0.5) :: Int)
  | otherwise = 0
{-# INLINE fineCode #-}

-- | Three sRGB signals, each in 0 to 1.
data Signal
  = Signal
      {-# UNPACK #-} !Double
      {-# UNPACK #-} !Double
      {-# UNPACK #-} !Double
  deriving (Eq, Show)

-- | Exposure, tone map and coding, prepared for many pixels. Both curves are tabulated
-- over the square root of light, in which they are nearly straight.
data Developer
  = -- | The factor of the exposure, and the tone map's curve from root to root.
    Curved !Double !Double !Double (Double -> Double) !(U.Vector Double)
  | -- | The factor alone.
    Fitted !Double

-- | Prepares the tables, in about a millisecond, for all pixels.
developer :: Exposure -> ToneMap -> Developer
developer (Exposure stops) tone = case toneCurve tone of
  Nothing -> Fitted factor
  Just (ToneCurve inset kept curve) ->
    let root u = sqrt (curve (u * u))
     in Curved factor inset kept root (U.generate (curveNodes + 2) (\i -> root (curveReach * fromIntegral i / fromIntegral curveNodes)))
  where
    factor = 2 ** stops

-- | The signals of a radiance, within 2e-6 of the exact functions, in about 20 ns.
-- Negative components and NaN count as zero.
developSignal :: Developer -> Radiance -> Signal
developSignal prepared light = case prepared of
  Fitted factor ->
    let Radiance r g b = fitGamut (scaleRadiance factor light) in coded (sqrt r) (sqrt g) (sqrt b)
  Curved factor inset kept root table ->
    let Radiance r g b = keepingHue inset kept (tabulated root table) (scaleRadiance factor light) in coded r g b
  where
    coded r g b = Signal (codedRoot r) (codedRoot g) (codedRoot b)
{-# INLINE developSignal #-}

-- | The curve interpolated between nodes; beyond the table, the curve itself.
tabulated :: (Double -> Double) -> U.Vector Double -> Double -> Double
tabulated root table u
  | u < curveReach = interpolated table (u * (fromIntegral curveNodes / curveReach))
  | otherwise = root u
{-# INLINE tabulated #-}

-- | The sRGB signal of linear light from the square root of that light: 0 to 1 up to
-- rounding, and 0 for NaN.
codedRoot :: Double -> Double
codedRoot u
  | u > 0 = interpolated signalTable (u * fromIntegral signalNodes)
  | otherwise = 0
{-# INLINE codedRoot #-}

-- | The value at a position from 0 to the table's last node but one.
interpolated :: U.Vector Double -> Double -> Double
interpolated table place = a + (place - fromIntegral node) * (U.unsafeIndex table (node + 1) - a)
  where
    node = truncate place :: Int
    a = U.unsafeIndex table node
{-# INLINE interpolated #-}

signalTable :: U.Vector Double
signalTable = U.generate (signalNodes + 2) (\i -> let u = fromIntegral i / fromIntegral signalNodes in encodeSrgb (u * u))
{-# NOINLINE signalTable #-}

signalNodes :: Int
signalNodes = 2048

curveNodes :: Int
curveNodes = 4096

-- | The square root of the brightest light in the table, which is 36 times display
-- white.
curveReach :: Double
curveReach = 6

-- | All steps for the pixel in a column and a row: red, green and blue codes.
displayCode :: Developer -> Dither -> Int -> Int -> Radiance -> (Word8, Word8, Word8)
displayCode prepared dither column row light =
  (ditheredCode (threshold 0) r, ditheredCode (threshold 1) g, ditheredCode (threshold 2) b)
  where
    Signal r g b = developSignal prepared light
    threshold channel = case dither of
      NoDither -> 0.5
      BlueNoise -> ditherThreshold channel column row
{-# INLINE displayCode #-}
