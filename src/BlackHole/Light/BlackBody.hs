-- | Black bodies as the eye sees them: Planck's spectrum through the CIE 1931 2°
-- observer. These are the exact functions, at about 3 µs each; the renderer uses the
-- tables of "BlackHole.Light.BlackBodyTable".
--
-- Temperatures are in kelvin. Light of a black body at T that arrives with ν_obs/ν_em =
-- g is light of a black body at g T, because I_ν/ν³ is the same for every observer.
-- Pass g T wherever a function takes a temperature; no further power of g is needed.
module BlackHole.Light.BlackBody
  ( secondRadiationConstant,
    blackBodyXyz,
    blackBodyChromaticity,
    unmappedColour,
    blackBodyColour,
    logLuminance,
    bolometricIntensity,
  )
where

import BlackHole.Light.Cie
import BlackHole.Light.Gamut (desaturateIntoGamut)
import BlackHole.Light.Radiance
import Numeric (expm1)

-- | hc/k = 1.438776877…e-2 m K, in nanometre kelvin. Exact since the SI of 2019; older
-- colour tables use 1.4388e-2 or, for illuminant A, 1.435e-2.
secondRadiationConstant :: Double
secondRadiationConstant =
  1e9 * planckConstant * lightSpeed / boltzmannConstant

-- | Tristimulus values scaled to Y = 1, for every temperature. Below 1 K, and for zero,
-- negative values and NaN, the limit T → 0: the deep red of the longest wavelength.
-- Above 1e20 K the limit T → ∞: the bluish white of λ⁻⁴ at (0.2399, 0.2340).
blackBodyXyz :: Double -> Xyz
blackBodyXyz temperature = Xyz (x / y) 1 (z / y)
  where
    Xyz x y z = reducedXyz (clampTemperature temperature)

-- | The chromaticity (x, y) on the Planckian locus, for any argument, with the limits
-- of 'blackBodyXyz'.
blackBodyChromaticity :: Double -> (Double, Double)
blackBodyChromaticity temperature = (x / total, y / total)
  where
    Xyz x y z = blackBodyXyz temperature
    total = x + y + z

-- | The colour at luminance 1 in linear Rec. 709, straight from the matrix: blue is
-- negative below 1900 K.
unmappedColour :: Double -> Radiance
unmappedColour = radianceOfXyz . blackBodyXyz

-- | The colour at luminance 1 in linear Rec. 709, without negative components. Below
-- 1900 K, where the locus leaves the triangle of the primaries, the colour is mapped
-- into it at constant luminance and hue. Below 890 K, where it is redder than any
-- display, it becomes the display's red ('desaturateIntoGamut').
blackBodyColour :: Double -> Radiance
blackBodyColour = desaturateIntoGamut . unmappedColour

-- | The natural logarithm of the luminance in cd/m², which itself underflows below about
-- 24 K. Minus infinity if the temperature is not positive.
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

-- | @bolometricIntensity reference temperature@ is the radiance over all wavelengths
-- relative to that of a black body at the reference temperature, (T/T₀)⁴.
bolometricIntensity :: Double -> Double -> Double
bolometricIntensity reference temperature = square (square ratio)
  where
    ratio = temperature / reference
    square a = a * a
{-# INLINE bolometricIntensity #-}

-- | XYZ of (λ₀/λ)⁴ z e^{z₁}/(e^z − 1) with z = hc/(λkT): Planck's spectrum without the
-- factors that do not depend on the wavelength. Taking out e^{−z₁}, with z₁ at the
-- longest wavelength, prevents underflow at low temperatures, and the factor z prevents
-- overflow at high ones.
reducedXyz :: Double -> Xyz
reducedXyz temperature = xyzOfSpectrum reduced
  where
    z1 = secondRadiationConstant / (longestWavelength * temperature)
    reduced wavelength =
      let z = secondRadiationConstant / (wavelength * temperature)
          q = pivotWavelength / wavelength
          q2 = q * q
       in q2 * q2 * z * exp (z1 - z) / negate (expm1 (-z))

-- | At both ends the limits are reached to double precision.
clampTemperature :: Double -> Double
clampTemperature temperature
  | temperature > 1e20 = 1e20
  | temperature > 1 = temperature
  | otherwise = 1

-- | The end of the table of matching functions, in nanometres.
longestWavelength :: Double
longestWavelength = 830

-- | The wavelength in nanometres at which the reduced spectrum is of order one.
pivotWavelength :: Double
pivotWavelength = 560

-- | In J s, exact (SI 2019).
planckConstant :: Double
planckConstant = 6.62607015e-34

-- | In m/s, exact.
lightSpeed :: Double
lightSpeed = 299792458

-- | In J/K, exact (SI 2019).
boltzmannConstant :: Double
boltzmannConstant = 1.380649e-23
