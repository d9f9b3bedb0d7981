-- | Clocks of observers on geodesics: where somebody who falls, or circles
-- without engines, is when his own watch shows a given time. Units: G = c = 1,
-- r_s = 1, so that times are in r_s/c.
module BlackHole.Physics.FreeFall
  ( infallRadius,
    infallTime,
    orbitalPhase,
  )
where

import BlackHole.Physics.Radii (photonSphereRadius)

-- | The radius after a proper time of somebody who falls straight in, having
-- started from rest at infinity, and who passed the given radius at time 0:
-- @dr/dτ = −√(1/r)@, hence @r^{3/2} = r₀^{3/2} − (3/2)τ@ (Misner, Thorne &
-- Wheeler, /Gravitation/, §31.2). Negative times are earlier ones. 'Nothing' from
-- the moment on at which he is at the centre, and for radii that are not positive.
--
-- The proper time of such observers is also the time of Painlevé's and
-- Gullstrand's coordinates, which at a fixed radius runs like Schwarzschild's:
-- it is the natural "now" for the gas that they see.
infallRadius :: Double -> Double -> Maybe Double
infallRadius start time
  | start > 0 && left > 0 && not (isInfinite left) = Just (left ** (2 / 3))
  | otherwise = Nothing
  where
    left = start * sqrt start - 1.5 * time

-- | The proper time that the same observer takes from the first radius to the
-- second: @(2/3)(r₀^{3/2} − r^{3/2})@, negative if the second is larger. Radii
-- are from 0 up.
infallTime :: Double -> Double -> Double
infallTime start end = (start * sqrt start - end * sqrt end) / 1.5

-- | Radians around the hole after a proper time on the circular geodesic of a
-- radius: @dφ/dτ = √(1/(2r³)) / √(1 − 3/(2r))@ (Bardeen, Press & Teukolsky 1972).
-- 'Nothing' from the photon sphere inwards, where no such orbit exists.
orbitalPhase :: Double -> Double -> Maybe Double
orbitalPhase r time
  | r > photonSphereRadius = Just (time * sqrt (1 / (2 * r * r * r)) / sqrt (1 - photonSphereRadius / r))
  | otherwise = Nothing
