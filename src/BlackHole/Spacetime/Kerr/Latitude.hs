{-# LANGUAGE BangPatterns #-}

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

import BlackHole.Numeric.Angle (arcTangent2)
import BlackHole.Numeric.Periodic
import BlackHole.Spacetime.Kerr.Landmarks
import BlackHole.Spacetime.Kerr.Precision
import BlackHole.Spacetime.Kerr.Sight

-- | The motion in latitude of one ray.
data Latitude = Latitude
  { -- | A₀² and a².
    _latitudeBase2 :: {-# UNPACK #-} !Double,
    _latitudeSpin2 :: {-# UNPACK #-} !Double,
    -- | u₊, the greatest cos θ.
    _latitudeReach :: {-# UNPACK #-} !Double,
    -- | cos ι = λ/B with B = √(A₀² + a²).
    _latitudeCosIota :: {-# UNPACK #-} !Double,
    -- | The Mino time and Φ_θ as functions of the phase, from the phase 0 on.
    _latitudeTime :: !Periodic,
    _latitudePrecession :: Periodic,
    _latitudeStart :: !Phase,
    -- | The Mino time since the phase 0 at the start.
    _latitudeStartTime :: {-# UNPACK #-} !Double
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
-- beyond ½) that the Fourier series would lose digits; light that escapes the hole has a
-- parameter below 0.07.
latitude :: Precision -> Spin -> LightRay -> Maybe Latitude
latitude precision hole ray
  | parameter <= 0.5 =
    Just
      $! Latitude
        { _latitudeBase2 = base2,
          _latitudeSpin2 = a2,
          _latitudeReach = reach,
          _latitudeCosIota = rayLambda ray / b,
          _latitudeTime = times,
          _latitudePrecession = periodicIntegral terms precessing,
          _latitudeStart = start,
          _latitudeStartTime = timeOf times start
        }
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
    swing = a2 * reach2
    parameter = swing / (base2 + swing)
    -- The coefficients fall by the factor 0.003 at least for a parameter of 0.01, by 0.03
    -- for one of 0.1, and by 0.17 for one of ½.
    terms = case precision of
      _ | parameter > 0.1 -> resolution20
      FullPrecision -> resolution10
      PicturePrecision
        | parameter > 0.01 -> resolution6
        | otherwise -> resolution4
    times = periodicIntegral terms (\sine2 -> 1 / sqrt (base2 + swing * sine2))
    precessing sine2 =
      let speed = sqrt (base2 + swing * sine2)
       in a2 * rayLambda ray / (b * (b + speed) * speed)
    u = rayCosine ray
    rise = negate (raySine ray * rayPolarRate ray) / sqrt (base2 + a2 * u * u)
    size = sqrt (u * u + rise * rise)
    start
      | size > 0 = Phase (arcTangent2 u rise) (u / size) (rise / size)
      | otherwise = Phase 0 0 1

resolution4, resolution6, resolution10, resolution20 :: Resolution
resolution4 = resolution 4
resolution6 = resolution 6
resolution10 = resolution 10
resolution20 = resolution 20
{-# NOINLINE resolution4 #-}
{-# NOINLINE resolution6 #-}
{-# NOINLINE resolution10 #-}
{-# NOINLINE resolution20 #-}

timeOf :: Periodic -> Phase -> Double
timeOf times (Phase angle s c) = integralTo times angle s c

-- | Where the ray starts, at the observer; its angle is in [−π, π].
phaseAtStart :: Latitude -> Phase
phaseAtStart = _latitudeStart

-- | The phase after a Mino time, by Newton's method.
phaseAfter :: Latitude -> Double -> Phase
phaseAfter l time = go (8 :: Int) (phaseAt (target / integralPerRadian times))
  where
    times = _latitudeTime l
    target = _latitudeStartTime l + time
    phaseAt angle = Phase angle (sin angle) (cos angle)
    go rounds phase@(Phase angle s c)
      | rounds <= 0 || abs change <= 1e-9 = changed
      | otherwise = go (rounds - 1) changed
      where
        change = (target - timeOf times phase) * phaseSpeed l phase
        -- A small change turns the sine and the cosine.
        changed
          | abs change < 0.01 =
            let change2 = change * change
                s1 = change * (1 - change2 * (1 / 6 - change2 * (1 / 120 - change2 / 5040)))
                c1 = 1 - change2 * (0.5 - change2 * (1 / 24 - change2 / 720))
             in Phase (angle + change) (s * c1 + c * s1) (c * c1 - s * s1)
          | otherwise = phaseAt (angle + change)

-- | χ' at a phase.
phaseSpeed :: Latitude -> Phase -> Double
phaseSpeed l phase = sqrt (_latitudeBase2 l + _latitudeSpin2 l * u * u)
  where
    u = phaseCosine l phase

-- | The Mino times at which the ray crosses the plane, from the first after the
-- start on: an infinite list with equal steps. A start in the plane does not
-- count, and a ray that lies in the plane does not cross it.
planeCrossingTimes :: Latitude -> [(Double, Phase)]
planeCrossingTimes l
  | _latitudeReach l < 1e-12 = []
  | otherwise = [(time k, Phase (pi * k) 0 (sign k)) | k <- iterate (+ 1) first]
  where
    sign k = if even (round k :: Int) then 1 else -1
    first = fromIntegral (floor (phaseAngle (_latitudeStart l) / pi + 1e-12) + 1 :: Int) :: Double
    time k = pi * k * integralPerRadian (_latitudeTime l) - _latitudeStartTime l

-- | @timesNearPlane latitude c from to@: the Mino times between which @|cos θ| ≤ c@, as far
-- as they lie between two times, in order. At most a thousand such intervals are examined.
timesNearPlane :: Latitude -> Double -> Double -> Double -> [(Double, Double)]
timesNearPlane l limit !from !to
  | _latitudeReach l <= limit = [(from, to)]
  | otherwise = go (1000 :: Int) (fromIntegral first * period - _latitudeStartTime l)
  where
    sine = limit / _latitudeReach l
    width = asin sine
    !half = timeOf (_latitudeTime l) (Phase width sine (sqrt ((1 - sine) * (1 + sine))))
    !period = pi * integralPerRadian (_latitudeTime l)
    first = ceiling ((phaseAngle (_latitudeStart l) - width) / pi) :: Int
    -- By the time of the crossing in the middle.
    go !count !crossing
      | count <= 0 || begin >= to = []
      | close > from = (max from begin, min to close) : rest
      | otherwise = rest
      where
        !begin = crossing - half
        !close = crossing + half
        rest = go (count - 1) (crossing + period)

-- | d(cos θ)\/dτ at a phase.
phaseRate :: Latitude -> Phase -> Double
phaseRate l phase = _latitudeReach l * phaseCosineOf phase * phaseSpeed l phase

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
  | otherwise = at phase - at (_latitudeStart l)
  where
    at (Phase angle s c) = integralTo (_latitudePrecession l) angle s c
