-- | Positions of observers on geodesics as functions of their proper time: an observer
-- who falls in radially, and one on a circular orbit. Units: G = c = 1 and r_s = 1, so
-- times are in r_s/c.
module BlackHole.Spacetime.Schwarzschild.FreeFall
  ( infallRadius,
    infallTime,
    orbitalPhase,
  )
where

import BlackHole.Spacetime.Schwarzschild.Radii (photonSphereRadius)

-- | @infallRadius r₀ τ@ is the radius, at proper time τ, of an observer who falls
-- straight in from rest at infinity and passes @r₀@ at time 0: @dr/dτ = −√(1/r)@, hence
-- @r^{3/2} = r₀^{3/2} − (3/2)τ@ (Misner, Thorne and Wheeler 1973, /Gravitation/,
-- §31.2). Negative times lie before the passage. 'Nothing' once the observer has
-- reached the centre, and for @r₀ ≤ 0@.
--
-- The proper time of these observers is also the time coordinate of Painlevé and
-- Gullstrand, which at a fixed radius runs like Schwarzschild's. That makes it the
-- natural time for the gas that they see.
infallRadius :: Double -> Double -> Maybe Double
infallRadius start time
  | start > 0 && left > 0 && not (isInfinite left) = Just (left ** (2 / 3))
  | otherwise = Nothing
  where
    left = start * sqrt start - 1.5 * time

-- | The proper time that this observer takes from the first radius to the second:
-- @(2/3)(r₀^{3/2} − r^{3/2})@, negative if the second is larger. Both radii must be at
-- least 0.
infallTime :: Double -> Double -> Double
infallTime start end = (start * sqrt start - end * sqrt end) / 1.5

-- | @orbitalPhase r τ@ is the angle in radians that an observer on the circular
-- geodesic at radius @r@ covers in the proper time τ: @dφ/dτ = √(1/(2r³)) / √(1 −
-- 3/(2r))@ (Bardeen, Press and Teukolsky 1972). 'Nothing' at and inside the photon
-- sphere, where no such orbit exists.
orbitalPhase :: Double -> Double -> Maybe Double
orbitalPhase r time
  | r > photonSphereRadius =
    Just (time * sqrt (1 / (2 * r * r * r)) / sqrt (1 - photonSphereRadius / r))
  | otherwise = Nothing
