{-# LANGUAGE BangPatterns #-}

-- | Light paths around a Schwarzschild black hole, in closed form.
--
-- In its orbital plane a photon obeys (lengths in Schwarzschild radii, @u = 1\/r@, φ
-- the angle swept about the hole)
--
-- > (du/dφ)² = 1/b² − u² + u³        u'' = (3/2) u² − u
--
-- with the impact parameter @b@. The cubic on the right has three real roots @u₁ < 0 <
-- u₂ < 2\/3 < u₃@ for @b > b_c = 3√3\/2@, and only @u₁@ for @b < b_c@. The roots decide
-- which of the forms below applies.
--
-- /Accuracy./ No result is the difference of nearly equal numbers. The distance @4\/27
-- − 1\/b²@ from the critical orbit is a product of differences from the photon sphere,
-- and differences of roots come from sines rather than from the roots. What remains is
-- the rounding of the start itself: near @b_c@ angles are uncertain by 1e-16 \/ |b −
-- b_c|, and at a large radius @u@ has a relative error of about 1e-16·r.
--
-- Sources: Darwin 1959 (Proc. R. Soc. A 249, 180) for the orbits; Byrd and Friedman
-- 1971, 233, 236 and 239, for the reductions; Whittaker and Watson 1927, 20.6, for the
-- solution by initial values.
module BlackHole.Spacetime.Schwarzschild.Orbit
  ( -- * Orbits
    Orbit,
    orbit,
    orbitInverseRadius,
    orbitInverseRadiusAndSlope,

    -- * Their properties
    orbitFate,
    orbitSweep,
    TurningPoint (..),
    orbitTurningPoint,
    orbitClosestApproach,
    orbitImpactParameter,
    orbitInvariant,
  )
where

import BlackHole.Numeric.Elliptic
import BlackHole.Spacetime.Fate
import BlackHole.Spacetime.Schwarzschild.OrbitShape
import BlackHole.Spacetime.Schwarzschild.Radii (photonSphereRadius)
import BlackHole.Vector.XY (XY (..))

-- | The path of one photon from its start onwards.
data Orbit = Orbit
  { -- | @1\/b²@ in the orbit equation @(du\/dφ)² = 1\/b² − u² + u³@. Infinite for a
    -- radial photon.
    orbitInvariant :: {-# UNPACK #-} !Double,
    -- | How the path ends: at infinity, at the horizon, or never, for a photon that
    -- approaches the photon sphere or circles on it.
    orbitFate :: !(Fate XY),
    -- | The angle in radians that the path sweeps from its start to its end: infinite for
    -- one that never ends, 0 for a photon that starts inside the horizon and moves inward.
    orbitSweep :: {-# UNPACK #-} !Double,
    -- | Where the photon, /after/ its start, turns from inward to outward or from
    -- outward to inward. A photon turns at most once. A start exactly at such a point
    -- counts, with the angle 0.
    orbitTurningPoint :: !(Maybe TurningPoint),
    -- | The swept angle at which the formula would begin to retrace the path (beyond
    -- infinity, or at the centre).
    orbitLastAngle :: {-# UNPACK #-} !Double,
    -- | @4\/27 − 1\/b²@.
    orbitExcess :: {-# UNPACK #-} !Double,
    orbitPath :: !Path
  }

-- | The fate of a path and the angle that it sweeps.
data End = End !(Fate XY) {-# UNPACK #-} !Double

escapesAfter, capturedAfter :: Double -> End
escapesAfter angle = End (Escaped (XY (cos angle) (sin angle))) angle
capturedAfter = End Captured

endless :: End
endless = End Circles (1 / 0)

-- | The closest or farthest point of a path.
data TurningPoint = TurningPoint
  { -- | Radians swept from the start up to this point.
    turningAngle :: {-# UNPACK #-} !Double,
    -- | Distance from the centre in Schwarzschild radii: greater than 3\/2 for a
    -- closest point, smaller for a farthest one.
    turningRadius :: {-# UNPACK #-} !Double
  }
  deriving (Eq, Show)

-- | The orbit of a photon from its starting radius @r > 0@ (in Schwarzschild radii; the
-- start may lie inside the horizon) and the components of its pseudo-velocity: radial
-- (positive outwards) and tangential (@h\/r@; the sign is ignored). Only their ratio
-- matters:
--
-- > du/dφ = −v_r / (r v_t)
--
-- For a static observer who sees the photon's path at the angle ψ from the inward
-- radial direction, @v_r : v_t = −cos ψ √(1−1\/r) : sin ψ@.
--
-- A photon without tangential motion (or with @b@ below 1e-150) is /radial/: it sweeps
-- no angle. 'orbitInverseRadius' is then constant, and the fate, with the angle 0,
-- follows from the sign of @v_r@.
--
-- Values that no photon can have (@1\/b² < 0@, possible only inside the horizon) arise
-- from rounding and count as @1\/b² = 0@.
--
-- Costs about twenty evaluations of 'orbitInverseRadius'.
orbit :: Double -> Double -> Double -> Orbit
orbit r vr vt
  | vt == 0 || invariant >= 1e300 = radialOrbit u0 vr
  | epsilon == 0 && excess == 0 = circularOrbit u0 invariant
  | excess < 0 = plungingOrbit start
  | epsilon < 0 = outsideOrbit start
  | otherwise = insideOrbit start
  where
    u0 = 1 / r
    slope = -vr / (r * abs vt)
    invariant = max 0 (slope * slope + u0 * u0 * ((r - 1) / r))
    -- 3 − 2r is exact near the photon sphere.
    epsilon = (3 - 2 * r) / (3 * r)
    -- 4/27 − 1/b² as a difference of squares, so that light aimed at the photon sphere
    -- from nearby keeps all its digits.
    reach = abs epsilon * sqrt (u0 + 1 / 3)
    excess = (reach - abs slope) * (reach + abs slope)
    start = Start u0 epsilon slope invariant excess

-- | The starting values of an orbit.
data Start
  = Start
      {-# UNPACK #-} !Double -- u
      {-# UNPACK #-} !Double -- u − 2/3
      {-# UNPACK #-} !Double -- du/dφ
      {-# UNPACK #-} !Double -- 1/b²
      {-# UNPACK #-} !Double -- 4/27 − 1/b²

radialOrbit :: Double -> Double -> Orbit
radialOrbit u0 vr =
  Orbit
    { orbitInvariant = 1 / 0,
      orbitFate = if vr > 0 then Escaped (XY 1 0) else Captured,
      orbitSweep = 0,
      orbitTurningPoint = Nothing,
      orbitLastAngle = 0,
      orbitExcess = -1 / 0,
      orbitPath = Constant u0
    }

circularOrbit :: Double -> Double -> Orbit
circularOrbit u0 invariant =
  Orbit
    { orbitInvariant = invariant,
      orbitFate = Circles,
      orbitSweep = 1 / 0,
      orbitTurningPoint = Nothing,
      orbitLastAngle = 1 / 0,
      orbitExcess = 0,
      orbitPath = Constant u0
    }

-- | From outside the photon sphere with @b ≥ b_c@: inwards to the closest point and out
-- again, or straight outwards.
outsideOrbit :: Start -> Orbit
outsideOrbit (Start u0 epsilon slope invariant excess) =
  Orbit
    { orbitInvariant = invariant,
      orbitFate = fate,
      orbitSweep = sweep,
      orbitTurningPoint = turning,
      orbitLastAngle = (if inward then 2 * k - phase else phase) / rate,
      orbitExcess = excess,
      orbitPath =
        Outside u1 (rootLowerSpan rt) (if inward then phase else -phase) rate md
    }
  where
    rt = roots invariant excess
    u1 = rootLow rt
    inward = slope >= 0
    m1 = rootUpperSpan rt / rootFullSpan rt
    md = modulus m1
    k = quarterPeriod md
    rate = 0.5 * sqrt (rootFullSpan rt)
    -- u₂ − u from the slope; the direct difference would lose all digits close to the
    -- turning point.
    phase =
      firstQuadrantF
        m1
        (u0 - u1)
        (slope * slope / ((u0 - u1) * (rootHighGap rt - epsilon)))
    phaseAtInfinity = firstQuadrantF m1 (-u1) (rootMiddle rt)
    End fate sweep
      | not inward = escapesAfter ((phase - phaseAtInfinity) / rate)
      | m1 <= 0 = endless
      | otherwise = escapesAfter ((2 * k - phaseAtInfinity - phase) / rate)
    turning
      | inward && m1 > 0 =
        Just $! TurningPoint (max 0 ((k - phase) / rate)) (1 / rootMiddle rt)
      | otherwise = Nothing

-- | From inside the photon sphere with @b ≥ b_c@: outwards to the farthest point and
-- back into the hole, or straight inwards.
insideOrbit :: Start -> Orbit
insideOrbit (Start u0 epsilon slope invariant excess) =
  Orbit
    { orbitInvariant = invariant,
      orbitFate = fate,
      orbitSweep = sweep,
      orbitTurningPoint = turning,
      orbitLastAngle = (if inward then phase else 2 * k - phase) / rate,
      orbitExcess = excess,
      orbitPath =
        Inside u1 (rootFullSpan rt) (if inward then -phase else phase) rate md
    }
  where
    rt = roots invariant excess
    u1 = rootLow rt
    inward = slope >= 0
    m1 = rootUpperSpan rt / rootFullSpan rt
    md = modulus m1
    k = quarterPeriod md
    rate = 0.5 * sqrt (rootFullSpan rt)
    phase =
      firstQuadrantF
        m1
        (rootFullSpan rt)
        (slope * slope / ((u0 - u1) * (epsilon + rootMiddleGap rt)))
    phaseAtHorizon = firstQuadrantF m1 (rootFullSpan rt) (rootHorizonGap rt)
    End fate sweep
      | inward = capturedAfter (max 0 ((phase - phaseAtHorizon) / rate))
      | m1 <= 0 = endless
      | otherwise = capturedAfter ((2 * k - phaseAtHorizon - phase) / rate)
    turning
      | not inward && m1 > 0 =
        Just $! TurningPoint (max 0 ((k - phase) / rate)) (1 / rootHigh rt)
      | otherwise = Nothing

-- | With @b < b_c@: inwards or outwards without a turning point.
plungingOrbit :: Start -> Orbit
plungingOrbit (Start u0 epsilon slope invariant excess) =
  Orbit
    { orbitInvariant = invariant,
      orbitFate = fate,
      orbitSweep = sweep,
      orbitTurningPoint = Nothing,
      orbitLastAngle = (if inward then 2 * k - phase else phase) / rate,
      orbitExcess = excess,
      orbitPath = path
    }
  where
    -- The real root is 1/3 − (2/3) cosh η, the others 1/3 + (1/3) cosh η ± (i/√3) sinh
    -- η.
    eta = 2 / 3 * asinh (0.5 * sqrt (-27 * excess))
    sinhEta = sinh eta
    coshEta = cosh eta
    sinhHalf = sinh (0.5 * eta)
    u1 = (1 - 2 * coshEta) / 3
    a = sqrt (coshEta * coshEta + sinhEta * sinhEta / 3)
    -- A − 1, without the subtraction.
    aMinusOne = 4 / 3 * sinhEta * sinhEta / (a + 1)
    m1 = sinhEta * sinhEta / (6 * a * (a + coshEta))
    md = modulus m1
    k = quarterPeriod md
    rate = sqrt a
    inward = slope >= 0
    height = u0 - u1
    -- tan²(am/2) = (u − u₁)/A. The cosine of the amplitude is proportional to A − (u −
    -- u₁), computed here from the distance between u and the photon sphere.
    phaseOf h eps =
      let cosine = aMinusOne - eps - 4 / 3 * sinhHalf * sinhHalf
          f = firstQuadrantF m1 (4 * a * h) (cosine * cosine)
       in if cosine >= 0 then f else 2 * k - f
    phase = phaseOf height epsilon
    path
      -- The solution by initial values does not use the position of the real root, so
      -- it loses no accuracy when the root is far away (|u₁| ~ b^(−2/3) for small b).
      -- It has a removable singularity where u takes its starting value a second time,
      -- and paths from near or inside the photon sphere come close to that point. At
      -- height 0.7 A both effects are harmless.
      | height <= 0.7 * a = Plunging u0 slope a height m1 rate md
      | otherwise = Phased u1 a (if inward then phase else -phase) rate md
    -- One Newton step makes the angle at the end accurate relative to itself, which a
    -- nearly radial photon needs. At infinity and at the horizon the slope is exactly
    -- 1/b.
    refined target angle = angle + (target - inverseRadiusOn path angle) / endSlope
    endSlope = if inward then sqrt invariant else -(sqrt invariant)
    End fate sweep
      | inward && u0 >= 1 = capturedAfter 0
      | inward = capturedAfter (max 0 (refined 1 ((phaseOf (1 - u1) (1 / 3) - phase) / rate)))
      | otherwise = escapesAfter (refined 0 ((phase - phaseOf (-u1) (-2 / 3)) / rate))

-- | The inverse radius @u = 1\/r@ after the photon has swept an angle in radians, at
-- least 0. Angles beyond the end of the path are safe: from the angle of escape on the
-- result is at most 0, from the angle of capture on at least 1 (both up to rounding).
--
-- Costs one exponential or sine (and a square root for a plunging photon) and about
-- forty multiplications for any angle; allocates nothing.
orbitInverseRadius :: Orbit -> Double -> Double
orbitInverseRadius o angle = inverseRadiusOn (orbitPath o) (min angle (orbitLastAngle o))

-- | The inverse radius @u@ and the slope @du\/dφ@, under the conditions of
-- 'orbitInverseRadius' and in twice its time.
orbitInverseRadiusAndSlope :: Orbit -> Double -> (Double, Double)
orbitInverseRadiusAndSlope o angle = case orbitPath o of
  Outside u1 span21 phase rate md ->
    let !(Jacobi sn cn dn) = jacobi md (phase + rate * phi)
     in strictPair (u1 + span21 * sn * sn) (2 * rate * span21 * sn * cn * dn)
  Inside u1 span31 phase rate md ->
    let !(Jacobi sn cn dn) = jacobi md (phase + rate * phi)
        excursion = span31 / (sn * sn)
     in strictPair (u1 + excursion) (-2 * rate * excursion * cn * dn / sn)
  path@(Phased _ _ phase _ _) -> withSlope (signum phase) (inverseRadiusOn path phi)
  path@(Plunging _ slope _ _ _ _ _) -> withSlope (signum slope) (inverseRadiusOn path phi)
  Constant u -> (u, 0)
  where
    phi = min angle (orbitLastAngle o)
    -- Below b_c both terms are positive while u > −1/3, so there is no cancellation and
    -- no change of sign along the way.
    withSlope direction u =
      strictPair
        u
        (direction * sqrt (max 0 ((u - 2 / 3) * (u - 2 / 3) * (u + 1 / 3) - orbitExcess o)))
    -- A lazy pair would keep the whole orbit alive in two thunks.
    strictPair !u !w = (u, w)

-- | The radius of the point closest to the hole, if the photon passes it after its
-- start or starts there. 'Nothing' for photons that move outwards, fall in, or turn at
-- a farthest point.
orbitClosestApproach :: Orbit -> Maybe Double
orbitClosestApproach o = case orbitTurningPoint o of
  Just (TurningPoint _ r) | r > photonSphereRadius -> Just r
  _ -> Nothing

-- | The impact parameter @b@ in Schwarzschild radii: 0 for a radial photon, infinite
-- for one of zero energy (inside the horizon).
orbitImpactParameter :: Orbit -> Double
orbitImpactParameter o = 1 / sqrt (orbitInvariant o)
