-- | How exposed light of any brightness is brought into a display's range.
--
-- A curve for each primary by itself turns hues: the bright parts of an orange
-- disk become yellow. Here the curve is applied to the strongest and the weakest
-- primary alone. The one between keeps its place between them, measured in
-- square roots of the light, which are close to equal steps for the eye; measured in
-- the light itself, bright orange turns salmon.
--
-- A curve that flattens towards white also brings the weakest primary closer to the
-- strongest, which turns amber into beige. Film keeps the ratio of the primaries
-- instead, and lets it go only close to white, as very bright gas bleaches.
module BlackHole.Light.ToneMap
  ( ToneMap (..),
    toneMapName,
    applyToneMap,
    ToneCurve (..),
    toneCurve,
    keepingHue,
    falseColour,
  )
where

import BlackHole.Light.Gamut (fitGamut)
import BlackHole.Light.Radiance
import BlackHole.Light.Srgb (decodeSrgb)

-- | The tone maps. All leave black black and never darken anything when the
-- light grows.
data ToneMap
  = -- | None: what fits is shown as it is, and what does not keeps its hue and
    -- loses saturation on its way to white ('fitGamut').
    ToneNone
  | -- | The response of a photographic emulsion, @1 − e^{−x}@: proportional in
    -- the shadows, rolling off softly to white.
    ToneFilm
  | -- | Reinhard et al. 2002, equation 3: @x\/(1 + x)@. Never quite white.
    ToneReinhard
  | -- | The contrast of the Academy's reference rendering, by Narkowicz's fit
    -- (2015): dark shadows, and white from 7 times display white on.
    ToneAces
  | -- | After Sobotka's AgX (2022): a soft S over 16.5 stops about middle grey,
    -- of light that was first drawn towards its own grey a little, so that what
    -- is bright gently bleaches.
    ToneAgx
  | -- | False colour, as radio astronomers show maps of brightness: luminance up to
    -- display white from black through red and orange to white ('falseColour').
    ToneRadio
  deriving (Eq, Show, Read, Enum, Bounded)

-- | The name on the command line and in scene files.
toneMapName :: ToneMap -> String
toneMapName tone = case tone of
  ToneNone -> "none"
  ToneFilm -> "film"
  ToneReinhard -> "reinhard"
  ToneAces -> "aces"
  ToneAgx -> "agx"
  ToneRadio -> "radio"

-- | A curve from exposed light, 0 or more, to a display's linear light, 0…1,
-- growing and with 0 at 0; the part of the weakest primary, 0 to 1, that is first
-- replaced by the light's luminance; and how far the ratio of the primaries is kept,
-- 0 to 1.
data ToneCurve = ToneCurve !Double !Double (Double -> Double)

-- | The curve of a tone map; 'Nothing' for 'ToneNone' and 'ToneRadio', which have none.
toneCurve :: ToneMap -> Maybe ToneCurve
toneCurve tone = case tone of
  ToneNone -> Nothing
  ToneRadio -> Nothing
  ToneFilm -> Just (ToneCurve crosstalk 1 (\x -> 1 - exp (negate x)))
  ToneReinhard -> Just (ToneCurve crosstalk 0 (\x -> if isInfinite x then 1 else x / (1 + x)))
  ToneAces -> Just (ToneCurve crosstalk 0 narkowicz)
  ToneAgx -> Just (ToneCurve 0.15 0 agxCurve)
  where
    -- What each layer of an emulsion, or pixel of a sensor, answers to the
    -- others' colours. Without any, a pure colour would never bleach, however
    -- bright it is.
    crosstalk = 0.02

-- | Bring exposed light into 0…1 for each primary. Negative amounts and
-- NaN count as none. These are the exact functions, some 100 ns a pixel;
-- "BlackHole.Light.Display" has tables of them.
applyToneMap :: ToneMap -> Radiance -> Radiance
applyToneMap tone light = case toneCurve tone of
  Nothing
    | tone == ToneRadio ->
      mapRadiance decodeSrgb (falseColour (luminance (mapRadiance (max 0) light)))
    | otherwise -> fitGamut light
  Just (ToneCurve inset kept curve) ->
    mapRadiance square (keepingHue inset kept (\u -> sqrt (curve (u * u))) light)
  where
    square u = min 1 (u * u)

-- | The sRGB signals, 0 to 1, for a luminance of 0 to 1: each primary rises by twice the
-- luminance, green starts at a quarter and blue at half (the colour map @afmhot@ of
-- Gnuplot and matplotlib, of which the Event Horizon Telescope's pictures show a variant).
-- NaN counts as black.
falseColour :: Double -> Radiance
falseColour brightness = Radiance (rising 0) (rising 0.25) (rising 0.5)
  where
    rising start = min 1 (max 0 (2 * (brightness - start)))
{-# INLINE falseColour #-}

-- | @keepingHue inset kept rootCurve light@: the square roots of the three primaries
-- after a curve that takes roots to roots, without falling anywhere. They lie
-- within the curve's range but for the last digit. NaN counts as no light, and
-- beside an infinite primary the result may be NaN.
keepingHue :: Double -> Double -> (Double -> Double) -> Radiance -> Radiance
keepingHue inset kept rootCurve light
  | high <= low = grey high'
  | otherwise = Radiance (between r) (between g) (between b)
  where
    Radiance r g b = mapRadiance (sqrt . max 0) light
    high = max r (max g b)
    low = min r (min g b)
    high' = rootCurve high
    -- The twelfth power of the root: half the light's ratio is kept at 0.9 of white.
    low'
      | kept > 0 =
        let h2 = high' * high'; h4 = h2 * h2
         in bleached
              + kept * max 0 (1 - h4 * h4 * h4) * (low * high' / high - bleached)
      | otherwise = bleached
    bleached
      | inset > 0 =
        rootCurve
          (sqrt ((1 - inset) * (low * low) + inset * luminance (Radiance (r * r) (g * g) (b * b))))
      | otherwise = rootCurve low
    scale = (high' - low') / (high - low)
    between u = low' + (u - low) * scale
{-# INLINE keepingHue #-}

narkowicz :: Double -> Double
narkowicz x
  | x > 100 = 1
  | otherwise = min 1 (x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14))

-- | Light to stops about middle grey, to the display's signal by two branches of
-- a hyperbola-like S that meet in middle grey with one slope, to linear light.
-- Middle grey stays as it is.
agxCurve :: Double -> Double
agxCurve x
  | x <= 0 = 0
  | otherwise =
    signal (max 0 (min 1 ((logBase 2 (x / middleGrey) - darkest) / (brightest - darkest)))) ** gamma
  where
    middleGrey = 0.18
    darkest = -10
    brightest = 6.5
    gamma = 2.2
    slope = 2.4
    pivot = negate darkest / (brightest - darkest)
    pivotSignal = middleGrey ** (1 / gamma)
    signal v
      | v < pivot = max 0 (pivotSignal - branch pivot pivotSignal (pivot - v))
      | otherwise = min 1 (pivotSignal + branch (1 - pivot) (1 - pivotSignal) (v - pivot))
    -- From 0 with the slope, bending so as to be @rise@ after @run@.
    branch run rise v = reach * z / (1 + z ** power) ** (1 / power)
      where
        z = slope * v / reach
        reach = slope * run / ((slope * run / rise) ** power - 1) ** (1 / power)
    power = 1.5
