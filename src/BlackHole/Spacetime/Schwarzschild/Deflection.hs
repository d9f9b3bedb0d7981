{-# LANGUAGE BangPatterns #-}

-- | Light from infinity to infinity around a hole without spin: its deflection and its
-- closest approach.
module BlackHole.Spacetime.Schwarzschild.Deflection
  ( deflectionAngle,
    closestApproach,
  )
where

import BlackHole.Numeric.Elliptic
import BlackHole.Spacetime.Schwarzschild.OrbitShape
import BlackHole.Spacetime.Schwarzschild.Radii (criticalImpactParameter)

-- | The deflection in radians of light that comes from infinity and returns there, by
-- its impact parameter. 'Nothing' if the light does not return: for @b@ at or below the
-- true @3√3\/2@, and for NaN.
--
-- The relative accuracy is a few 1e-16 for large @b@; the absolute accuracy is 1e-15
-- for small @b@ and 1e-16 \/ (b − b_c) near the critical value.
--
-- Source: Darwin 1959. Beyond @b = 20@, where the closed form would be a small
-- difference from π, the expansion in @1\/b@ with the terms @√π Γ((3n+1)\/2) \/ (n!
-- Γ(n\/2+1)) b⁻ⁿ@ replaces it, with at most twenty terms.
deflectionAngle :: Double -> Maybe Double
deflectionAngle b
  | b > 20 = Just (weakField (1 / b))
  | b > 0 && excess > 0 = Just (2 * halfSweep - pi)
  | otherwise = Nothing
  where
    excess = excessOf b
    rt = roots (1 / (b * b)) excess
    m1 = rootUpperSpan rt / rootFullSpan rt
    halfSweep =
      2 / sqrt (rootFullSpan rt)
        * (completeK m1 - firstQuadrantF m1 (-(rootLow rt)) (rootMiddle rt))

-- | @4\/27 − 1\/b²@, exact to the last digit of @b@: corrected by the difference
-- between the 'Double' next to @3√3\/2@ and that number.
excessOf :: Double -> Double
excessOf b = 4 / 27 * gap / b * ((b + criticalImpactParameter) / b)
  where
    gap = (b - criticalImpactParameter) + 7.151834159792767e-17

-- | The sum of the expansion of the deflection in @1\/b@, without the term π.
weakField :: Double -> Double
weakField x = go 1 (2 * x) (15 / 16 * pi * x * x) 0
  where
    -- The ratio of every other term is rational.
    go :: Double -> Double -> Double -> Double -> Double
    go !n !term !following !total
      | term <= 1e-18 * total = total
      | otherwise = go (n + 1) following (term * ratio n) (total + term)
    ratio n = 0.75 * (3 * n + 1) * (3 * n + 5) / ((n + 2) * (n + 2)) * x * x

-- | The closest approach @r₀@ of light from infinity in Schwarzschild radii, by its
-- impact parameter; 'Nothing' as for 'deflectionAngle'. The relative accuracy is 1e-15,
-- except near @b_c@, where @r₀ − 3\/2@ varies as @√(b − b_c)@.
closestApproach :: Double -> Maybe Double
closestApproach b
  | b > 0 && excess > 0 = Just (1 / rootMiddle (roots (1 / b / b) excess))
  | otherwise = Nothing
  where
    excess = excessOf b
