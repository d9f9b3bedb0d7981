-- | The edge of the shadow of a Kerr hole, in closed form: the directions in which an
-- observer sees the light that winds for ever round one of the spherical photon
-- orbits (Bardeen 1973; Teo 2003).
module BlackHole.Spacetime.Kerr.Shadow
  ( Shadow,
    shadow,
    shadowEdge,
  )
where

import BlackHole.Numeric.Bisection (bisect)
import BlackHole.Spacetime.Kerr.Landmarks
import BlackHole.Spacetime.Kerr.Sight

-- | The shadow that an observer at rest sees.
data Shadow = Shadow
  { _shadowSpin :: !Spin,
    _shadowPlace :: !Place,
    -- | The range of λ over sin θ on the edge: middle and half width.
    _shadowMiddle :: {-# UNPACK #-} !Double,
    _shadowHalfWidth :: {-# UNPACK #-} !Double
  }

-- | The shadow seen from a position outside the ergosphere; 'Nothing' elsewhere. Two
-- bisections.
shadow :: Spin -> Place -> Maybe Shadow
shadow hole place@(Place r polarAngle)
  | r > ergosphereRadius hole (cos polarAngle) =
    Just (Shadow hole place (0.5 * (greatest + least)) (0.5 * (greatest - least)))
  | otherwise = Nothing
  where
    rim l = polarPotential hole place l >= 0
    -- No photon orbit has |λ| above 7/2.
    furthest = 5 / sineOf place
    greatest = bisect rim 0 furthest
    least = negate (bisect (rim . negate) 0 furthest)

sineOf :: Place -> Double
sineOf = max 1e-100 . sin . placePolarAngle

-- | Carter's constant η of the orbit with λ; free of the division by @a@ that the
-- textbook form has.
sphericalEta :: Spin -> Double -> Double
sphericalEta hole lambda =
  2 * r * (r * r + a * a - a * lambda) / (r - 0.5) - (lambda - a) * (lambda - a)
  where
    a = spinLength hole
    r = sphericalOrbitRadius hole lambda

-- | Θ = (dθ\/dτ)² at the observer, from λ over sin θ.
polarPotential :: Spin -> Place -> Double -> Double
polarPotential hole place l = sphericalEta hole (l * sineOf place) + c * c * (a * a - l * l)
  where
    a = spinLength hole
    c = cos (placePolarAngle place)

-- | @shadowEdge shadow α@: the direction to the edge for the position α in radians on
-- it, any real number. At α = 0 the light has the greatest angular momentum about the
-- axis, which is on the left for a camera upright; the first half turn lies
-- below, where the tracing runs towards greater θ.
shadowEdge :: Shadow -> Double -> Direction
shadowEdge (Shadow hole place@(Place r polarAngle) middle halfWidth) alpha =
  Direction radialPart (signum (sin alpha) * sqrt (max 0 (f2 * theta / sigma))) across
  where
    a = spinLength hole
    s = sineOf place
    c = cos polarAngle
    l = middle + halfWidth * cos alpha
    lambda = l * s
    eta = sphericalEta hole lambda
    theta = max 0 (polarPotential hole place l)
    orbitRadius = sphericalOrbitRadius hole lambda
    sigma = r * r + a * a * c * c
    delta = kerrDelta hole r
    f2 = 1 - r / sigma
    p = r * r + a * a - a * lambda
    kappa = eta + (lambda - a) * (lambda - a)
    -- Light from an orbit farther in than the observer is seen looking inwards.
    radialPart =
      (if orbitRadius < r then -1 else 1)
        * sqrt (max 0 (f2 * (p * p - delta * kappa) / (sigma * delta)))
    across = (negate (a * r * s / sigma) - l * f2) / sqrt delta
