-- | The thin accretion disk of Page and Thorne around a hole that does not rotate: the
-- flux and temperature of each ring when no torque acts at the innermost stable orbit.
-- Radii are in Schwarzschild radii.
module BlackHole.Matter.ThinDisk
  ( pageThorneFlux,
    peakRadius,
    peakFlux,
    relativeTemperature,
    log1pMinus,
  )
where

import Numeric (log1p)

-- | Energy flux from one face of the disk at a radius, as measured in the frame of the
-- gas, in units of 3Ṁ/(8πM²) (with r_s = 1, that is 3Ṁ/(2π)). It is 0 at the innermost
-- stable orbit r = 3, inside it, and for NaN (Page and Thorne 1974, eq. 15n without
-- rotation). With x = √(2r) it is
--
-- > [x − √6 + (√3/2) ln((x+√3)(√6−√3) / ((x−√3)(√6+√3)))] / ((x²−3) x⁵)
--
-- The factor of the logarithm is √3/2. Some printed versions have √3/3, with which the
-- flux would not vanish quadratically at r = 3. At large r the flux is 1/(8r³).
--
-- Close to r = 3 the bracket is a difference of nearly equal terms, so it is computed
-- as (√3/2) [p(d/(√6+√3)) − p(d/(√6−√3))] with d = x − √6 and p(t) = ln(1+t) − t: the
-- linear terms of the two logarithms add up to x − √6. The relative error stays below
-- 5e-15 at every radius.
pageThorneFlux :: Double -> Double
pageThorneFlux r
  | r > 3 && not (isInfinite r) =
    bracket / ((x * x - 3) * x * (x * x) * (x * x))
  | otherwise = 0
  where
    x = sqrt (2 * r)
    -- x − √6, without cancellation.
    d = 2 * (r - 3) / (x + sqrt 6)
    bracket =
      0.5 * sqrt 3
        * ( log1pMinus (d / (sqrt 6 + sqrt 3))
              - log1pMinus (d / (sqrt 6 - sqrt 3))
          )

-- | The radius of greatest flux and temperature, where the derivative of
-- 'pageThorneFlux' vanishes, computed with 40 digits.
peakRadius :: Double
peakRadius = 4.775464038971935

-- | @pageThorneFlux peakRadius@, precomputed.
peakFlux :: Double
peakFlux = 1.1458947324417218e-4

-- | The temperature of the gas relative to the hottest ring, (F/F_peak)^¼: 0 at and
-- inside r = 3, 1 at 'peakRadius', and falling as r^(−3/4) at large r.
relativeTemperature :: Double -> Double
relativeTemperature r = min 1 (sqrt (sqrt (pageThorneFlux r / peakFlux)))

-- | ln(1+t) − t for t ≥ 0, with a small relative error for small t as well. There the
-- logarithm is 2 artanh w = 2w + 2w³/3 + 2w⁵/5 + … with w = t/(2+t), and 2w − t = −tw
-- removes the difference. The omitted terms are below 1e-17 of the sum where the two
-- branches meet.
log1pMinus :: Double -> Double
log1pMinus t
  | t > 0.25 = log1p t - t
  | otherwise = w * (2 * q * series - t)
  where
    w = t / (2 + t)
    q = w * w
    series = foldr (\n s -> 1 / n + q * s) 0 [3, 5, 7, 9, 11, 13, 15, 17]
