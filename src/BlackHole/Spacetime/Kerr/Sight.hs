-- | Lines of sight near a Kerr hole: from a direction in the frame of an observer
-- to the constants of motion of the light that arrives from there.
--
-- Units and conventions are those of "BlackHole.Spacetime.Kerr.Landmarks". The
-- azimuth φ is Boyer–Lindquist's, right-handed about @+y@ and 0 at @+z@; places
-- are drawn at @r (sin θ sin φ, cos θ, sin θ cos φ)@. Light is traced backwards,
-- from the observer to its source: derivatives here are along the tracing, with
-- respect to Mino time τ (@dτ = dl\/Σ@ for the affine length @l@ of light of unit
-- energy at infinity), while the constants λ and η are those of the real photon.
module BlackHole.Spacetime.Kerr.Sight
  ( Place (..),
    Motion (..),
    Azimuth (..),
    Direction (..),
    LightRay (..),
    lightRay,
    Seer,
    seer,
    raySeen,
  )
where

import BlackHole.Spacetime.Kerr.Landmarks

-- | A place in Boyer–Lindquist coordinates: radius, polar angle from @+y@ in
-- radians. (Every azimuth is as good as any other.)
data Place = Place
  { placeRadius :: !Double,
    placePolarAngle :: !Double
  }
  deriving (Eq, Show)

-- | An azimuth of the observer in radians: Boyer–Lindquist's φ, or the ingoing
-- azimuth @φ + a\/(r₊ − r₋) ln |(r − r₊)\/(r − r₋)|@, which is regular at the
-- horizon and equal to φ at infinity. An observer inside the horizon must have the
-- latter.
data Azimuth = BoyerLindquist !Double | Ingoing !Double
  deriving (Eq, Show)

-- | How an observer moves.
data Motion
  = -- | At rest against the stars; possible outside the ergosphere.
    AtRest
  | -- | With no angular momentum, turning with space (Bardeen's locally
    -- non-rotating, or zero-angular-momentum, observer).
    ZeroAngularMomentum
  | -- | On the circular geodesic; off the plane, on a spherical geodesic at its
    -- turning point in latitude.
    OnOrbit !Handedness
  | -- | Falling from rest at infinity without angular momentum (Doran 2000).
    -- Possible at every radius above 0.
    InFreeFall
  deriving (Eq, Show)

-- | A direction of sight in the observer's orthonormal frame, away from the
-- observer: components along e_r, e_θ and e_φ, of unit length.
data Direction = Direction !Double !Double !Double
  deriving (Eq, Show)

-- | One line of sight as a ray of light traced backwards.
data LightRay = LightRay
  { rayRadius :: {-# UNPACK #-} !Double,
    -- | cos θ and sin θ of the observer's place; the sine is never 0.
    rayCosine :: {-# UNPACK #-} !Double,
    raySine :: {-# UNPACK #-} !Double,
    -- | dr\/dτ at the observer.
    rayRadialRate :: {-# UNPACK #-} !Double,
    -- | dθ\/dτ at the observer.
    rayPolarRate :: {-# UNPACK #-} !Double,
    -- | λ = L\/E, the photon's angular momentum about the axis over its energy.
    rayLambda :: {-# UNPACK #-} !Double,
    -- | η = Q\/E², Carter's constant over the squared energy.
    rayEta :: {-# UNPACK #-} !Double,
    -- | κ = η + (λ − a)², the constant of the radial motion.
    rayKappa :: {-# UNPACK #-} !Double,
    -- | The frequency that the observer measures over that at infinity: the shift
    -- of light from the sky.
    rayObserved :: {-# UNPACK #-} !Double
  }
  deriving (Eq, Show)

-- | The ray that an observer sees in a direction. 'Nothing' where no such
-- observer can be (at rest inside the ergosphere, on an orbit faster than light,
-- on or inside the horizon unless in free fall), and where an observer inside
-- the horizon looks at darkness because no light from outside arrives.
lightRay :: Spin -> Place -> Motion -> Direction -> Maybe LightRay
lightRay hole place motion = raySeen (seer hole place motion)

-- | An observer, with everything that all rays share.
data Seer = Seer
  { _seerSpinLength :: {-# UNPACK #-} !Double,
    _seerRadius :: {-# UNPACK #-} !Double,
    _seerCosine :: {-# UNPACK #-} !Double,
    _seerSine :: {-# UNPACK #-} !Double,
    -- | √Σ, and √(A\/Σ), the circumferential radius over sin θ.
    _seerRootSigma :: {-# UNPACK #-} !Double,
    _seerCircumference :: {-# UNPACK #-} !Double,
    _seerMoving :: !Moving
  }

data Moving
  = -- | With the azimuthal speed @v@ and its γ, the lapse α, ωϖ and √(ΣΔ).
    Turning !Double !Double !Double !Double !Double
  | -- | With the coefficients of the energy and of the radial rate.
    Infalling !Double !Double !Double !Double
  | Impossible

-- | Prepares an observer for 'raySeen'.
seer :: Spin -> Place -> Motion -> Seer
seer hole (Place r polarAngle) motion =
  Seer a r c s (sqrt sigma) (sqrt (area / sigma)) $ case motion of
    AtRest
      | r > ergosphereRadius hole c -> turning (negate (omega * varpi) / alpha)
    ZeroAngularMomentum
      | outside -> turning 0
    OnOrbit handedness
      | outside, q2 > 0 -> turning (varpi * (orbitalRate handedness - omega) / alpha)
    InFreeFall
      | r > 0 ->
        let infall = sqrt (r * (r * r + a * a))
         in Infalling (infall / sqrt area) (a * r * s / sqrt (area * sigma)) infall (sqrt area)
    _ -> Impossible
  where
    a = spinLength hole
    -- Exactly 0 in the plane, whose angle is rounded.
    c = let cosine = cos polarAngle in if abs cosine < 1e-16 then 0 else cosine
    -- On the axis the directions e_θ and e_φ are limits. A sine too small to
    -- matter takes the limit without a special case.
    s = max 1e-100 (sin polarAngle)
    outside = r > horizonRadius hole
    sigma = r * r + a * a * c * c
    delta = kerrDelta hole r
    area = (r * r + a * a) * (r * r + a * a) - a * a * delta * s * s
    omega = a * r / area
    alpha = sqrt (sigma * delta / area)
    varpi = s * sqrt (area / sigma)
    q2 = (r * r - a * a * c * c) / (sigma * sigma)
    orbitalRate handedness = case handedness of
      RightHanded -> sqrt q2 / (s * (sqrt (2 * r) + a * sqrt q2 * s))
      LeftHanded -> negate (sqrt q2) / (s * (sqrt (2 * r) - a * sqrt q2 * s))
    turning v
      | v * v < 1 =
        Turning v (1 / sqrt ((1 - v) * (1 + v))) alpha (omega * varpi) (sqrt (sigma * delta))
      | otherwise = Impossible

-- | 'lightRay' of a prepared observer.
--
-- With @v@ the observer's azimuthal speed past the zero-angular-momentum observer
-- of the place (lapse α, frame dragging ω, circumferential radius ϖ), light of
-- frequency 1 has @E = γ[α(1 − v n_φ) − ωϖ(n_φ − v)]@ and
-- @λ = −ϖγ(n_φ − v)\/E@ (Bardeen, Press and Teukolsky 1972, section III).
raySeen :: Seer -> Direction -> Maybe LightRay
raySeen (Seer a r c s rootSigma circumference moving) (Direction nr ntheta nphi) = case moving of
  Turning v gamma alpha dragged radialScale ->
    let energy = gamma * (alpha * (1 - v * nphi) - dragged * (nphi - v))
     in scaled energy (nr * radialScale) (negate circumference * gamma * (nphi - v))
  Infalling inward around infall rootArea ->
    scaled (1 + inward * nr - around * nphi) (infall + nr * rootArea) (negate circumference * nphi)
  Impossible -> Nothing
  where
    -- The radial rate and λ / sin θ, both for unit frequency at the observer.
    scaled energy radialRate lambdaOverSine
      | energy > 0 =
        let thetaRate = ntheta * rootSigma / energy
            l = lambdaOverSine / energy
            eta = thetaRate * thetaRate + c * c * (l * l - a * a)
         in Just
              LightRay
                { rayRadius = r,
                  rayCosine = c,
                  raySine = s,
                  rayRadialRate = radialRate / energy,
                  rayPolarRate = thetaRate,
                  rayLambda = l * s,
                  rayEta = eta,
                  rayKappa = eta + (l * s - a) * (l * s - a),
                  rayObserved = 1 / energy
                }
      | otherwise = Nothing
