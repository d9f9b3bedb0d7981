{-# LANGUAGE BangPatterns #-}

-- | The shapes of light paths around a hole without spin: the roots of the orbit equation,
-- and the forms of its solution. "BlackHole.Spacetime.Schwarzschild.Orbit" chooses among
-- them.
module BlackHole.Spacetime.Schwarzschild.OrbitShape
  ( Roots (..),
    roots,
    Path (..),
    inverseRadiusOn,
  )
where

import BlackHole.Numeric.Elliptic

-- | The three real roots of @u³ − u² + 1\/b²@, and the differences that the closed
-- forms need.
data Roots = Roots
  { -- | @u₁@.
    rootLow :: {-# UNPACK #-} !Double,
    -- | @u₂@.
    rootMiddle :: {-# UNPACK #-} !Double,
    -- | @u₃@.
    -- | @u₃@.
    rootHigh :: {-# UNPACK #-} !Double,
    -- | @2\/3 − u₂@.
    rootMiddleGap :: {-# UNPACK #-} !Double,
    -- | @u₃ − 2\/3@.
    rootHighGap :: {-# UNPACK #-} !Double,
    -- | @1 − u₃@.
    rootHorizonGap :: {-# UNPACK #-} !Double,
    -- | @u₃ − u₂@.
    rootUpperSpan :: {-# UNPACK #-} !Double,
    -- | @u₂ − u₁@.
    rootLowerSpan :: {-# UNPACK #-} !Double,
    -- | @u₃ − u₁@.
    rootFullSpan :: {-# UNPACK #-} !Double
  }

-- | The roots for @1\/b²@ and @4\/27 − 1\/b²@, both at least 0.
--
-- Viète's angle of the cubic is computed from both ends: @s + t = π\/3@, where @s@
-- vanishes with @4\/27 − 1\/b²@ and @t@ with @1\/b²@. Each difference of roots is then
-- a multiple of one sine and has full relative accuracy.
roots :: Double -> Double -> Roots
roots invariant excess =
  Roots
    { rootLow = bend - sinT,
      rootMiddle = bend + sinT,
      rootHigh = 1 - horizonGap,
      rootMiddleGap = sinS + sag,
      rootHighGap = sinS - sag,
      rootHorizonGap = horizonGap,
      rootUpperSpan = 2 * sinS,
      rootLowerSpan = 2 * sinT,
      rootFullSpan = sinT + cos t
    }
  where
    p = sqrt invariant
    q = sqrt excess
    s = 2 / 3 * atan2 q p
    t = 2 / 3 * atan2 p q
    sinS = sin s / sqrt 3
    sinT = sin t / sqrt 3
    sag = twoThirdsSineSquared (0.5 * s)
    bend = twoThirdsSineSquared (0.5 * t)
    horizonGap = 2 * bend
    twoThirdsSineSquared x = let y = sin x in 2 / 3 * y * y

-- | The forms of the solution. Phases are arguments of the elliptic functions, measured
-- from @u₁@ or from the centre, and negative while moving towards it.
data Path
  = -- | Between @u₁@ and @u₂@: @u = u₁ + (u₂ − u₁) sn²@.
    Outside
      {-# UNPACK #-} !Double -- u₁
      {-# UNPACK #-} !Double -- u₂ − u₁
      {-# UNPACK #-} !Double -- phase at the start
      {-# UNPACK #-} !Double -- phase per radian
      !Modulus
  | -- | Beyond @u₃@: @u = u₁ + (u₃ − u₁) \/ sn²@.
    Inside
      {-# UNPACK #-} !Double -- u₁
      {-# UNPACK #-} !Double -- u₃ − u₁
      {-# UNPACK #-} !Double -- phase at the start
      {-# UNPACK #-} !Double -- phase per radian
      !Modulus
  | -- | One real root: @u = u₁ + A tan² (am\/2)@.
    Phased
      {-# UNPACK #-} !Double -- u₁
      {-# UNPACK #-} !Double -- A
      {-# UNPACK #-} !Double -- phase at the start
      {-# UNPACK #-} !Double -- phase per radian, √A
      !Modulus
  | -- | One real root, in terms of the values at the start.
    Plunging
      {-# UNPACK #-} !Double -- u at the start
      {-# UNPACK #-} !Double -- du/dφ at the start
      {-# UNPACK #-} !Double -- A
      {-# UNPACK #-} !Double -- u − u₁ at the start
      {-# UNPACK #-} !Double -- m₁
      {-# UNPACK #-} !Double -- phase per radian, √A
      !Modulus
  | -- | Constant @u@: a circling or a radial photon.
    Constant {-# UNPACK #-} !Double

-- | The inverse radius on a path after a swept angle.
inverseRadiusOn :: Path -> Double -> Double
inverseRadiusOn path !phi = case path of
  Outside u1 span21 phase rate md -> u1 + span21 * snSquared md (phase + rate * phi)
  Inside u1 span31 phase rate md -> u1 + span31 / snSquared md (phase + rate * phi)
  Phased u1 a phase rate md ->
    let t = tanHalfAmplitude md (phase + rate * phi)
     in u1 + a * t * t
  Plunging u0 slope a height m1 rate md ->
    -- Whittaker and Watson 20.6 with 4℘(φ) + 1/3 = u₁ + A/t², without the poles at φ =
    -- 0.
    let t = tanHalfAmplitude md (rate * phi)
        t2 = t * t
        g = a - height * t2
        curl = a * rate * sqrt ((1 - t2) * (1 - t2) + 4 * m1 * t2)
        halfForce = u0 * (3 * u0 - 2)
     in u0 + (2 * slope * (slope * t2 * t2 + curl * t) + halfForce * t2 * g) / (g * g)
  Constant u -> u
