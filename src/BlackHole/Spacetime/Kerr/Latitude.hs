-- | The motion of light in latitude around a Kerr hole, in closed form, for rays
-- that oscillate about the equatorial plane (η > 0).
--
-- With @cos θ = u₊ sin χ@ the phase χ never turns: it grows along the tracing with
-- @χ' = √(A₀² + a² cos² θ)@, a prime being the derivative in Mino time, and the ray
-- crosses the plane where χ is a multiple of π. Without spin χ is the angle that
-- the path sweeps in its plane, and @A₀@ the impact parameter.
--
-- In azimuth the ray is a great circle whose plane, inclined by ι, precesses:
-- @φ = atan2 (cos ι sin χ) (cos χ) + Φ_θ + Φ_r@, where @Φ_θ@, given here, grows by
-- less than half a radian per half turn even for the fastest hole. (The integral
-- of @λ\/sin² θ@ that textbooks give has a spike where a ray passes a pole; the
-- great circle takes it out.) Compare Gralla and Lupsasca 2020, section III.
module BlackHole.Spacetime.Kerr.Latitude
  ( Latitude,
    latitude,
    Phase (..),
    phaseAtStart,
    phaseAfter,
    planeCrossingTimes,
    timesNearPlane,
    phaseRate,
    phaseCosine,
    greatCircle,
    precession,
  )
where

import BlackHole.Numeric.Elliptic
import BlackHole.Spacetime.Kerr.Landmarks
import BlackHole.Spacetime.Kerr.Quadrature
import BlackHole.Spacetime.Kerr.Sight

-- | The motion in latitude of one ray.
data Latitude = Latitude
  { -- | A₀² and a².
    _latitudeBase2 :: {-# UNPACK #-} !Double,
    _latitudeSpin2 :: {-# UNPACK #-} !Double,
    -- | u₊, the greatest cos θ.
    _latitudeReach :: {-# UNPACK #-} !Double,
    -- | B = √(A₀² + a²) and cos ι = λ/B.
    _latitudeB :: {-# UNPACK #-} !Double,
    _latitudeCosIota :: {-# UNPACK #-} !Double,
    -- | √(A₀² + a² u₊²), the rate of the elliptic argument.
    _latitudeRate :: {-# UNPACK #-} !Double,
    _latitudeModulus :: !Modulus,
    _latitudeComplement :: {-# UNPACK #-} !Double,
    _latitudeStart :: !Phase,
    -- | The elliptic argument at the start.
    _latitudeArgument :: {-# UNPACK #-} !Double
  }

-- | χ, with its sine and cosine: near a pole χ itself would not keep the digits
-- of its cosine.
data Phase = Phase
  { phaseAngle :: {-# UNPACK #-} !Double,
    phaseSine :: {-# UNPACK #-} !Double,
    phaseCosineOf :: {-# UNPACK #-} !Double
  }
  deriving (Eq, Show)

-- | The motion in latitude of a ray. 'Nothing' if it does not oscillate about the
-- plane (η < 0), or so close to the boundary of that case (elliptic parameter
-- beyond ½) that the quadrature of 'precession' would lose digits; light that
-- escapes the hole has a parameter below 0.07.
latitude :: Spin -> LightRay -> Maybe Latitude
latitude hole ray
  | parameter <= 0.5 =
    Just (Latitude base2 a2 reach b (rayLambda ray / b) rate prepared complement start argument)
  | otherwise = Nothing
  where
    a2 = spinLength hole * spinLength hole
    lambda2 = rayLambda ray * rayLambda ray
    -- Beyond |λ| = |a| the constant cannot be negative but by rounding.
    eta
      | lambda2 > a2 = max 0 (rayEta ray)
      | otherwise = rayEta ray
    s = eta + lambda2 - a2
    root = sqrt (s * s + 4 * a2 * eta)
    base2
      | s >= 0 = 0.5 * (s + root)
      | otherwise = 2 * a2 * eta / (root - s)
    reach2 = eta / base2
    reach = sqrt reach2
    b = sqrt (base2 + a2)
    rate = sqrt (base2 + a2 * reach2)
    parameter = a2 * reach2 / (base2 + a2 * reach2)
    complement = base2 / (base2 + a2 * reach2)
    prepared = modulus complement
    u = rayCosine ray
    rise = negate (raySine ray * rayPolarRate ray) / sqrt (base2 + a2 * u * u)
    size = sqrt (u * u + rise * rise)
    start
      | size > 0 = Phase (atan2 u rise) (u / size) (rise / size)
      | otherwise = Phase 0 0 1
    argument = incompleteF complement (phaseAngle start + 0.5 * pi)

-- | Where the ray starts, at the observer; its angle is in (−π, π].
phaseAtStart :: Latitude -> Phase
phaseAtStart = _latitudeStart

-- | The phase after a Mino time.
phaseAfter :: Latitude -> Double -> Phase
phaseAfter l time = Phase angle (negate cn) sn
  where
    argument = _latitudeArgument l + _latitudeRate l * time
    Jacobi sn cn _ = jacobi (_latitudeModulus l) argument
    -- The amplitude, of which sine and cosine are sn and cn: on its half turn.
    halfTurns = fromIntegral (round (argument / (2 * quarterPeriod (_latitudeModulus l))) :: Int)
    sign = if even (round halfTurns :: Int) then 1 else -1
    angle = pi * halfTurns + atan2 (sign * sn) (sign * cn) - 0.5 * pi

-- | The Mino times at which the ray crosses the plane, from the first after the
-- start on: an infinite list with equal steps. A start in the plane does not
-- count, and a ray that lies in the plane does not cross it.
planeCrossingTimes :: Latitude -> [(Double, Phase)]
planeCrossingTimes l
  | _latitudeReach l < 1e-12 = []
  | otherwise = [(time k, Phase (pi * k) 0 (if even (round k :: Int) then 1 else -1)) | k <- iterate (+ 1) first]
  where
    first = fromIntegral (floor (phaseAngle (_latitudeStart l) / pi + 1e-12) + 1 :: Int) :: Double
    time k =
      (incompleteF (_latitudeComplement l) (pi * k + 0.5 * pi) - _latitudeArgument l) / _latitudeRate l

-- | @timesNearPlane latitude c@: the Mino times between which @|cos θ| ≤ c@, from the
-- first such interval that ends after the start, in order and without end.
timesNearPlane :: Latitude -> Double -> [(Double, Double)]
timesNearPlane l limit
  | _latitudeReach l <= limit = [(0, 1 / 0)]
  | otherwise = [(max 0 (timeAt (pi * k - width)), timeAt (pi * k + width)) | k <- iterate (+ 1) first]
  where
    width = asin (limit / _latitudeReach l)
    first = fromIntegral (ceiling ((phaseAngle (_latitudeStart l) - width) / pi) :: Int) :: Double
    timeAt chi =
      (incompleteF (_latitudeComplement l) (chi + 0.5 * pi) - _latitudeArgument l) / _latitudeRate l

-- | d(cos θ)\/dτ at a phase.
phaseRate :: Latitude -> Phase -> Double
phaseRate l phase = _latitudeReach l * phaseCosineOf phase * sqrt (_latitudeBase2 l + _latitudeSpin2 l * u * u)
  where
    u = phaseCosine l phase

-- | cos θ at a phase.
phaseCosine :: Latitude -> Phase -> Double
phaseCosine l phase = _latitudeReach l * phaseSine phase

-- | The horizontal part of the place on the great circle, of length sin θ: cosine
-- and sine of its azimuth in the precessing plane.
greatCircle :: Latitude -> Phase -> (Double, Double)
greatCircle l phase = (phaseCosineOf phase, _latitudeCosIota l * phaseSine phase)

-- | Φ_θ between the start and a phase ahead of it, in radians: the integral of
-- @a² cos ι \/ ((B + χ') χ')@ over χ.
precession :: Latitude -> Phase -> Double
precession l phase
  | _latitudeSpin2 l == 0 = 0
  | otherwise = integrate panels rate (phaseAngle (_latitudeStart l)) (phaseAngle phase)
  where
    panels = 1 + floor ((phaseAngle phase - phaseAngle (_latitudeStart l)) / width)
    a2 = _latitudeSpin2 l
    -- The integrand's nearest singularity has an imaginary part of
    -- asinh (A₀ / (a u₊)): 2 for light that escapes a fast hole, 0.9 at the bound.
    width
      | a2 * _latitudeReach l * _latitudeReach l < 0.1 * _latitudeBase2 l = pi
      | otherwise = 0.5 * pi
    rate chi =
      let u = _latitudeReach l * sin chi
          speed = sqrt (_latitudeBase2 l + a2 * u * u)
       in a2 * _latitudeCosIota l / ((_latitudeB l + speed) * speed)
