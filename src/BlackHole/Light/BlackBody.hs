-- | Black bodies as the eye sees them: Planck's spectrum through the CIE 1931
-- 2° observer. These are the exact functions, at about 3 µs each;
-- "BlackHole.Light.BlackBodyTable" has the ones for rendering.
--
-- Temperatures are in kelvin. Light of a black body at T that arrives with
-- ν_obs/ν_em = g is the light of a black body at g T, because I_ν/ν³ is the
-- same for every observer: put g T wherever a temperature is asked for and
-- no further power of g is due.
module BlackHole.Light.BlackBody
  ( secondRadiationConstant,
    spectralRadiance,
    blackBodyXyz,
    blackBodyChromaticity,
    unmappedColour,
    blackBodyColour,
    logLuminance,
    blackBodyLuminance,
    bolometricIntensity,
    visibleIntensity,
  )
where

import BlackHole.Light.Cie
import BlackHole.Light.Gamut (desaturateIntoGamut)
import BlackHole.Light.Radiance
import Numeric (expm1)

-- | hc/k = 1.438776877…e-2 m K, in nanometre kelvin. Exact since the SI of
-- 2019; older colour tables use 1.4388e-2 or, for illuminant A, 1.435e-2.
secondRadiationConstant :: Double
secondRadiationConstant =
  1e9 * planckConstant * lightSpeed / boltzmannConstant

-- | Planck's law: @spectralRadiance wavelength temperature@ in
-- W sr⁻¹ m⁻² nm⁻¹, the wavelength in nanometres. 0 for no positive
-- temperature.
spectralRadiance :: Double -> Double -> Double
spectralRadiance wavelength temperature
  | temperature > 0 =
    1e-9 * 2 * planckConstant * lightSpeed * lightSpeed
      / (metres ^ (5 :: Int) * expm1 z)
  | otherwise = 0
  where
    metres = 1e-9 * wavelength
    z = secondRadiationConstant / (wavelength * temperature)

-- | Tristimulus values scaled to Y = 1, for every temperature: below 1 K (and
-- for what is no temperature: zero, negative, NaN) the limit T → 0, the deep
-- red of the longest wavelength; above 1e20 K the limit T → ∞, the bluish
-- white of λ⁻⁴ at (0.2399, 0.2340).
blackBodyXyz :: Double -> Xyz
blackBodyXyz temperature = Xyz (x / y) 1 (z / y)
  where
    Xyz x y z = reducedXyz (clampTemperature temperature)

-- | The chromaticity (x, y) on the Planckian locus; any argument, with the
-- limits of 'blackBodyXyz'.
blackBodyChromaticity :: Double -> (Double, Double)
blackBodyChromaticity temperature = (x / total, y / total)
  where
    Xyz x y z = blackBodyXyz temperature
    total = x + y + z

-- | The colour at luminance 1 in linear Rec. 709 as the matrix gives it, with
-- negative blue below 1900 K.
unmappedColour :: Double -> Radiance
unmappedColour = radianceOfXyz . blackBodyXyz

-- | The colour at luminance 1 in linear Rec. 709, without negative amounts:
-- below 1900 K, where the locus leaves the triangle of the primaries, it is
-- brought into it at constant luminance and hue; below 890 K, where it is redder
-- than any display, it becomes the display's red ('desaturateIntoGamut').
blackBodyColour :: Double -> Radiance
blackBodyColour = desaturateIntoGamut . unmappedColour

-- | Natural logarithm of 'blackBodyLuminance', which itself underflows below
-- some 24 K. Any positive temperature; at others it is minus infinity.
logLuminance :: Double -> Double
logLuminance temperature
  | temperature > 0 =
    log (xyzY (reducedXyz t) * rayleighJeans)
      + log temperature
      - secondRadiationConstant / (longestWavelength * temperature)
  | otherwise = -1 / 0
  where
    t = clampTemperature temperature
    -- 683 lm/W × 2 c k / λ⁴ at the pivot, per nanometre.
    rayleighJeans =
      683 * 2 * lightSpeed * boltzmannConstant * 1e-9
        / (1e-9 * pivotWavelength) ^ (4 :: Int)

-- | Luminance of a black body in cd/m²: 6e5 at the freezing point of
-- platinum, the old definition of the candela. 0 for no positive temperature.
blackBodyLuminance :: Double -> Double
blackBodyLuminance = exp . logLuminance

-- | @bolometricIntensity reference temperature@: radiance over all wavelengths
-- relative to that of a black body at the reference temperature, (T/T₀)⁴.
bolometricIntensity :: Double -> Double -> Double
bolometricIntensity reference temperature = square (square ratio)
  where
    ratio = temperature / reference
    square a = a * a
{-# INLINE bolometricIntensity #-}

-- | @visibleIntensity reference temperature@: luminance relative to that of a
-- black body at the reference temperature: what a camera records, which falls
-- much faster than T⁴ on the red side and only as T on the blue one.
visibleIntensity :: Double -> Double -> Double
visibleIntensity reference temperature =
  exp (logLuminance temperature - logLuminance reference)

-- | XYZ of (λ₀/λ)⁴ z e^{z₁}/(e^z − 1) with z = hc/(λkT): Planck's spectrum
-- without its factors that are the same for all wavelengths. Taking out
-- e^{−z₁}, z₁ at the longest wavelength, keeps the sum from underflowing at
-- any low temperature, and z keeps it from overflowing at any high one.
reducedXyz :: Double -> Xyz
reducedXyz temperature = xyzOfSpectrum reduced
  where
    z1 = secondRadiationConstant / (longestWavelength * temperature)
    reduced wavelength =
      let z = secondRadiationConstant / (wavelength * temperature)
          q = pivotWavelength / wavelength
          q2 = q * q
       in q2 * q2 * z * exp (z1 - z) / negate (expm1 (-z))

-- | The limits are reached to double precision at both ends.
clampTemperature :: Double -> Double
clampTemperature temperature
  | temperature > 1e20 = 1e20
  | temperature > 1 = temperature
  | otherwise = 1

-- | The end of the table of matching functions, in nanometres.
longestWavelength :: Double
longestWavelength = 830

-- | Where the reduced spectrum is of order one, in nanometres.
pivotWavelength :: Double
pivotWavelength = 560

-- | J s, exact (SI 2019).
planckConstant :: Double
planckConstant = 6.62607015e-34

-- | m/s, exact.
lightSpeed :: Double
lightSpeed = 299792458

-- | J/K, exact (SI 2019).
boltzmannConstant :: Double
boltzmannConstant = 1.380649e-23
