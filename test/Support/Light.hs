-- | Quantities of light that only tests need.
module Support.Light
  ( spectralRadiance,
    blackBodyLuminance,
    visibleIntensity,
    chromaticityXy,
    xyzOfRadiance,
  )
where

import BlackHole.Light.BlackBody
import BlackHole.Light.Cie
import BlackHole.Light.Radiance
import Numeric (expm1)

-- | Planck's law: @spectralRadiance wavelength temperature@ in W sr⁻¹ m⁻² nm⁻¹, with
-- the wavelength in nanometres. 0 if the temperature is not positive.
spectralRadiance :: Double -> Double -> Double
spectralRadiance wavelength temperature
  | temperature > 0 =
    1e-9 * 2 * planckConstant * lightSpeed * lightSpeed
      / (metres ^ (5 :: Int) * expm1 z)
  | otherwise = 0
  where
    metres = 1e-9 * wavelength
    z = secondRadiationConstant / (wavelength * temperature)

-- | In J s, exact (SI 2019).
planckConstant :: Double
planckConstant = 6.62607015e-34

-- | In m/s, exact.
lightSpeed :: Double
lightSpeed = 299792458

-- | The luminance of a black body in cd/m²: 6e5 at the freezing point of platinum, the
-- old definition of the candela. 0 if the temperature is not positive.
blackBodyLuminance :: Double -> Double
blackBodyLuminance = exp . logLuminance

-- | @visibleIntensity reference temperature@ is the luminance relative to that of a
-- black body at the reference temperature, which is what a camera records. It falls
-- much faster than T⁴ towards the red and rises only as T towards the blue.
visibleIntensity :: Double -> Double -> Double
visibleIntensity reference temperature =
  exp (logLuminance temperature - logLuminance reference)

-- | The chromaticity coordinates (x, y); 'Nothing' if X + Y + Z is not a positive
-- finite number (black has no colour).
chromaticityXy :: Xyz -> Maybe (Double, Double)
chromaticityXy (Xyz x y z)
  | total > 0 && not (isInfinite total) = Just (x / total, y / total)
  | otherwise = Nothing
  where
    total = x + y + z

-- | Converts linear Rec. 709 to XYZ; the inverse of 'radianceOfXyz'.
xyzOfRadiance :: Radiance -> Xyz
xyzOfRadiance (Radiance r g b) =
  Xyz
    (0.4123907992659595 * r + 0.35758433938387796 * g + 0.1804807884018343 * b)
    (0.21263900587151036 * r + 0.7151686787677559 * g + 0.07219231536073371 * b)
    (0.01933081871559185 * r + 0.11919477979462599 * g + 0.9505321522496606 * b)
