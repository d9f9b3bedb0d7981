-- | From linear radiance to the codes of a display, in separate steps: exposure, tone
-- map ("BlackHole.Light.ToneMap"), sRGB coding ("BlackHole.Light.Srgb"), grain
-- ("BlackHole.Light.Grain") and dither ("BlackHole.Light.Dither"). No step depends on any
-- other pixel's light, so equal light at the same position always gives equal bytes.
module BlackHole.Light.Display
  ( Exposure (..),
    expose,
    Development (..),
    ToneMap (..),
    toneMapName,
    Grain (..),
    noGrain,
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
import BlackHole.Light.Grain
import BlackHole.Light.Radiance
import BlackHole.Light.Srgb
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

-- | How light becomes the codes of a display.
data Development = Development
  { developmentExposure :: !Exposure,
    developmentToneMap :: !ToneMap,
    developmentGrain :: !Grain,
    -- | For formats with 8 bits.
    developmentDither :: !Dither
  }
  deriving (Eq, Show)

-- | A development prepared for many pixels.
data Developer = Developer !Toning !Grain !Dither

-- | Exposure, tone map and coding. Both curves are tabulated over the square root of
-- light, in which they are nearly straight.
data Toning
  = -- | The factor of the exposure, and the tone map's curve from root to root.
    Curved !Double !Double !Double (Double -> Double) !(U.Vector Double)
  | -- | The factor alone.
    Fitted !Double
  | -- | The factor; luminance as false colour.
    Coloured !Double

-- | Prepares the tables, in about a millisecond, for all pixels.
developer :: Development -> Developer
developer (Development (Exposure stops) tone grain dither) = Developer toning grain dither
  where
    toning = case (tone, toneCurve tone) of
      (ToneRadio, _) -> Coloured factor
      (_, Nothing) -> Fitted factor
      (_, Just (ToneCurve inset kept curve)) ->
        let root u = sqrt (curve (u * u))
         in Curved
              factor
              inset
              kept
              root
              ( U.generate
                  (curveNodes + 2)
                  (\i -> root (curveReach * fromIntegral i / fromIntegral curveNodes))
              )
    factor = 2 ** stops

-- | The signals of a radiance at the pixel in a column and a row, within 2e-6 of the exact
-- functions, in about 20 ns without grain. Negative components and NaN count as zero.
developSignal :: Developer -> Int -> Int -> Radiance -> Signal
developSignal (Developer toning grain _) column row light
  | grainDiameter grain > 0 = grained grain column row toned
  | otherwise = toned
  where
    toned = case toning of
      Fitted factor ->
        let Radiance r g b =
              fitGamut (scaleRadiance factor light)
         in coded (sqrt r) (sqrt g) (sqrt b)
      Coloured factor ->
        let Radiance r g b =
              falseColour (luminance (mapRadiance (max 0) (scaleRadiance factor light)))
         in Signal r g b
      Curved factor inset kept root table ->
        let Radiance r g b =
              keepingHue inset kept (tabulated root table) (scaleRadiance factor light)
         in coded r g b
    coded r g b = Signal (codedRoot r) (codedRoot g) (codedRoot b)
{-# INLINE developSignal #-}

-- | A signal drawn with dots of ink. Not for inlining: few pictures have any.
grained :: Grain -> Int -> Int -> Signal -> Signal
grained grain column row signal@(Signal r g b)
  | brightest > 0 = Signal (drawn r) (drawn g) (drawn b)
  | otherwise = signal
  where
    brightest = decodeSrgb (max r (max g b))
    cover = grainCover grain column row brightest
    drawn s = encodeSrgb (decodeSrgb s * cover / brightest)
{-# NOINLINE grained #-}

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
signalTable =
  U.generate
    (signalNodes + 2)
    (\i -> let u = fromIntegral i / fromIntegral signalNodes in encodeSrgb (u * u))
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
displayCode :: Developer -> Int -> Int -> Radiance -> (Word8, Word8, Word8)
displayCode prepared@(Developer _ _ dither) column row light =
  (ditheredCode (threshold 0) r, ditheredCode (threshold 1) g, ditheredCode (threshold 2) b)
  where
    Signal r g b = developSignal prepared column row light
    threshold channel = case dither of
      NoDither -> 0.5
      BlueNoise -> ditherThreshold channel column row
{-# INLINE displayCode #-}
