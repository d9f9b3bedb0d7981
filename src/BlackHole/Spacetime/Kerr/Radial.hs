{-# LANGUAGE BangPatterns #-}

-- | The radial motion of light around a Kerr hole, in closed form.
--
-- In Mino time @(dr\/dτ)² = R(r) = r⁴ + c₂r² + κr − a²η@, with
-- @c₂ = a² − λ² − η@ and @κ = η + (λ − a)²@. The four roots decide what kind of
-- motion it is, and the radius is a Möbius function of @sn²@ or of @cn@ of a
-- linear function of τ (Gralla and Lupsasca 2020, appendices A and B; their
-- roots, which are real expressions of Ferrari's). Differences that would lose
-- digits for light close to a photon orbit are factored instead.
--
-- The azimuth that depends on the radius, @Φ_r@, is an integral over @v@ with
-- @sn = tanh v@ (for @cn@, over the like variable about its quarter period): the
-- integrand has no structure near a photon orbit, where @v@ runs evenly through
-- the windings, and 16 nodes serve for two units of @v@.
module BlackHole.Spacetime.Kerr.Radial
  ( Radial,
    radial,
    RadialEnd (..),
    radialEnd,
    RadialState (..),
    stateAfter,
    timeWithin,
    stateAtEnd,
    dragging,
    regularDragging,
  )
where

import BlackHole.Numeric.Elliptic
import BlackHole.Spacetime.Kerr.Landmarks
import BlackHole.Spacetime.Kerr.Precision
import BlackHole.Spacetime.Kerr.Quadrature
import BlackHole.Spacetime.Kerr.RadialPotential
import BlackHole.Spacetime.Kerr.Sight

-- | The radial motion of one ray.
data Radial = Radial
  { _radialShape :: !Shape,
    _radialRate :: {-# UNPACK #-} !Double,
    _radialComplement :: {-# UNPACK #-} !Double,
    -- | Computed at its first use, like the end.
    _radialModulus :: Modulus,
    -- | The elliptic argument at the start: negative on the way to the turning
    -- point (or towards where one would be).
    _radialStart :: {-# UNPACK #-} !Double,
    -- | The elliptic argument at the end.
    _radialStop :: Double,
    _radialEnd :: !RadialEnd,
    -- | The variable @v@ at the start, at the end, and at the horizon on the way
    -- outwards (infinite if the ray keeps away from it).
    _radialStartV :: Double,
    _radialStopV :: Double,
    _radialPole :: Double,
    _radialStartRadius :: {-# UNPACK #-} !Double,
    _radialPrecision :: !Precision
  }

-- | How the radius depends on the elliptic argument.
data Shape
  = -- | Outside the greatest of four real roots @r₁ r₂ r₃ r₄@; at @r₄@ at the
    -- argument 0.
    Outer !Double !Double !Double !Double
  | -- | Between @r₂@ and @r₃@ of four real roots; at @r₃@ at the argument 0.
    Inner !Double !Double !Double !Double
  | -- | Outside the greater of two real roots @r₁ r₂@, with the distances @a₁@ of
    -- @r₂@ and @b₁@ of @r₁@ from the complex ones, and the square root of the
    -- complementary parameter; at @r₂@ at the argument 0.
    Single !Double !Double !Double !Double !Double

-- | Where the radial motion ends, going backwards along the light.
data RadialEnd = AtInfinity | AtHorizon
  deriving (Eq, Show)

-- | A radius on the way.
data RadialState = RadialState
  { stateRadius :: {-# UNPACK #-} !Double,
    -- | Whether the radius grows along the tracing (the real photon approaches
    -- the hole).
    stateGrows :: !Bool,
    stateV :: {-# UNPACK #-} !Double
  }

-- | The radial motion of a ray, and the Mino time until it ends (infinite for a
-- ray that approaches a photon orbit for ever, in every bit). 'Nothing' if no
-- root is real, which needs η < 0.
radial :: Precision -> Spin -> LightRay -> Maybe Radial
radial precision hole ray
  | upper >= 0 && lower >= 0 =
    let half = sqrt upper
        other = sqrt lower
        (r1, r2, r3, r4) = (negate z - other, other - z, z - half, z + half)
        complement = 2 * half * 2 * other / ((r3 - r1) * (r4 - r2))
        rate = 0.5 * sqrt ((r3 - r1) * (r4 - r2))
     in if r0 >= r4 || r4 <= horizon
          then
            let shape = Outer r1 r2 r3 r4
             in Just $! motion shape rate complement (r4 > horizon)
          else Just $! motion (inner r1 r2 r3 r4) rate complement True
  | lower >= 0 =
    let other = sqrt lower
        (r1, r2) = (negate z - other, other - z)
        p = z - r1
        q = z - r2
        imaginary2 = negate upper
        a1 = sqrt (q * q + imaginary2)
        b1 = sqrt (p * p + imaginary2)
        -- a₁b₁ − pq without its cancellation, and with it the complement of
        -- ((a₁+b₁)² − r₂₁²)/(4a₁b₁).
        gap
          | p * q > 0 = imaginary2 * (p * p + q * q + imaginary2) / (a1 * b1 + p * q)
          | otherwise = a1 * b1 - p * q
        complement = other * other * 2 * (imaginary2 + gap) / (a1 * b1 * (a1 + b1) * (a1 + b1))
     in Just $! motion (Single r1 r2 a1 b1 (sqrt complement)) (sqrt (a1 * b1)) complement False
  | otherwise = Nothing
  where
    horizon = horizonRadius hole
    r0 = rayRadius ray
    Roots z upper lower = rootsOf hole ray
    grows = rayRadialRate ray > 0
    -- The two middle roots, if the others are so large that their difference loses digits, as
    -- beside the ergosphere: from the products and sums of the roots.
    inner r1 r2 r3 r4
      | r3 < 0.01 * r4 = Inner r1 (product23 / upper3) upper3 r4
      | otherwise = Inner r1 r2 r3 r4
      where
        upper3 = 0.5 * (sum23 + sqrt (max 0 (sum23 * sum23 - 4 * product23)))
        sum23 = rayKappa ray / (product23 - r1 * r4)
        product23 = negate (spinLength hole * spinLength hole * rayEta ray) / (r1 * r4)
    motion shape rate complement turns =
      Radial
        { _radialShape = shape,
          _radialRate = rate,
          _radialComplement = complement,
          _radialModulus = modulus complement,
          _radialStart = startSide * argument precision complement shape start,
          _radialStop = stopSide * argument precision complement shape stop,
          _radialEnd = end,
          _radialStartV = startSide * variable shape start,
          _radialStopV = stopSide * variable shape stop,
          _radialPole = case shape of
            Outer {} | turns -> 1 / 0
            _ -> variable shape (amplitudeAt shape horizon),
          _radialStartRadius = r0,
          _radialPrecision = precision
        }
      where
        start = amplitudeAt shape r0
        -- The turning point of 'Inner' is the farthest, that of the others the nearest.
        startSide = case shape of
          Inner {} -> if grows then -1 else 1
          _ -> if grows then 1 else -1
        end = case shape of
          Inner {} -> AtHorizon
          _ -> if grows || turns then AtInfinity else AtHorizon
        stop = case end of
          AtHorizon -> amplitudeAt shape horizon
          AtInfinity -> amplitudeAtInfinity shape
        stopSide = case shape of
          Single {} | AtHorizon <- end -> -1
          Outer {} | AtHorizon <- end -> -1
          _ -> 1

-- | The amplitude at a radius, as if on the way outwards: numbers in proportion to the
-- squares of its sine and cosine in the first quadrant, but for 'Single' to these
-- themselves in the first half turn.
data Amplitude = Amplitude {-# UNPACK #-} !Double {-# UNPACK #-} !Double

amplitudeAt :: Shape -> Double -> Amplitude
amplitudeAt shape r = case shape of
  Outer r1 _ r3 r4 -> Amplitude (max 0 ((r3 - r1) * (r - r4))) (max 0 ((r4 - r3) * (r - r1)))
  Inner _ r2 r3 r4 -> Amplitude (max 0 ((r4 - r2) * (r3 - r))) (max 0 ((r4 - r3) * (r - r2)))
  Single r1 r2 a1 b1 _ ->
    Amplitude (2 * sqrt (a1 * b1 * (r - r1) * (r - r2))) (a1 * (r - r1) - b1 * (r - r2))
{-# INLINE amplitudeAt #-}

-- | 'amplitudeAt' infinity.
amplitudeAtInfinity :: Shape -> Amplitude
amplitudeAtInfinity shape = case shape of
  Outer r1 _ r3 r4 -> Amplitude (r3 - r1) (r4 - r3)
  -- Never asked for: such light does not escape.
  Inner {} -> Amplitude 1 0
  Single _ _ a1 b1 _ -> Amplitude (2 * sqrt (a1 * b1)) (a1 - b1)
{-# INLINE amplitudeAtInfinity #-}

-- | The elliptic argument: the integral of the first kind of an amplitude.
argument :: Precision -> Double -> Shape -> Amplitude -> Double
argument precision complement shape (Amplitude sine cosine) = case shape of
  Single {}
    | cosine >= 0 -> first (sine * sine) (cosine * cosine)
    | otherwise -> 2 * completeK complement - first (sine * sine) (cosine * cosine)
  _ -> first sine cosine
  where
    first = firstQuadrantFWithin radius complement
    radius = case precision of
      FullPrecision -> seriesRadius
      PicturePrecision -> 0.1

-- | The variable @v@ of an amplitude: @asinh (tan φ)@, and for 'Single'
-- @−asinh (cot φ \/ √m₁)@.
variable :: Shape -> Amplitude -> Double
variable shape (Amplitude sine cosine) = case shape of
  Single _ _ _ _ root -> negate (asinh (cosine / (sine * root)))
  _ -> asinh (sqrt (sine / cosine))

-- | Where the motion ends, and after what Mino time.
radialEnd :: Radial -> (RadialEnd, Double)
radialEnd radius =
  (_radialEnd radius, (_radialStop radius - _radialStart radius) / _radialRate radius)

-- | The Mino times between which the ray is within a radius; 'Nothing' if it never is.
timeWithin :: Radial -> Double -> Maybe (Double, Double)
timeWithin radius limit
  | from < to = Just (from, to)
  | otherwise = Nothing
  where
    (end, total) = radialEnd radius
    start = _radialStart radius
    starts = _radialStartRadius radius <= limit
    timeAt x = (x - start) / _radialRate radius
    shape = _radialShape radius
    -- At the limit on the way outwards.
    outwards =
      argument (_radialPrecision radius) (_radialComplement radius) shape (amplitudeAt shape limit)
    (from, to) = case shape of
      Outer _ _ _ r4 | r4 >= limit -> (1, 0)
      -- The turning point is the farthest.
      Inner _ _ r3 _
        | starts -> (0, if r3 <= limit || start > 0 then total else timeAt (negate outwards))
        | otherwise -> (max 0 (timeAt outwards), total)
      _ ->
        ( if starts then 0 else if start < 0 then timeAt (negate outwards) else 1 / 0,
          case end of
            AtInfinity -> timeAt outwards
            AtHorizon -> total
        )

-- | The radius after a Mino time within the motion.
stateAfter :: Radial -> Double -> RadialState
stateAfter radius time = case shape of
  Single _ _ _ _ root ->
    let sine = negate (cn / (abs sn * root))
     in RadialState (radiusAt shape sine) (x > 0) (signum x * asinh sine)
  Inner {} -> RadialState (radiusAt shape (sn / cn)) (x < 0) (asinh (sn / cn))
  Outer {} -> RadialState (radiusAt shape (sn / cn)) (x > 0) (asinh (sn / cn))
  where
    shape = _radialShape radius
    x = _radialStart radius + _radialRate radius * time
    Jacobi sn cn _ = jacobi (_radialModulus radius) x

-- | The state in which the motion ends; its radius is infinite at infinity.
stateAtEnd :: Radial -> RadialState
stateAtEnd radius = RadialState (1 / 0) True (_radialStopV radius)

-- | The radius as a function of the hyperbolic sine of the outward variable @v@.
radiusAt :: Shape -> Double -> Double
radiusAt shape s = case shape of
  Outer r1 _ r3 r4 -> r4 + (r4 - r1) * (r4 - r3) * s2 / ((r3 - r1) - (r4 - r3) * s2)
  Inner _ r2 r3 r4 -> ((r4 - r2) * r3 + s2 * (r4 - r3) * r2) / ((r4 - r2) + s2 * (r4 - r3))
  Single r1 r2 a1 b1 root ->
    let h = root * s
        t = if h < 0 then 1 / (sqrt (1 + h * h) - h) else sqrt (1 + h * h) + h
     in (b1 * r2 - a1 * t * t * r1) / (b1 - a1 * t * t)
  where
    s2 = s * s
{-# INLINE radiusAt #-}

-- | Φ_r: the integral over Mino time of @a (r − aλ) \/ Δ@ from the start to a state, for a
-- ray with this λ that starts outside the horizon.
dragging :: Spin -> Double -> Radial -> RadialState -> Double
dragging hole lambda radius = alongRadius toHorizon rate radius
  where
    !a = spinLength hole
    !outer = horizonRadius hole
    !inner = innerHorizonRadius hole
    rate r = a * (r - a * lambda) / ((r - outer) * (r - inner))
    toHorizon v = case _radialShape radius of
      Single {} | _radialStart radius < 0 -> abs (v + _radialPole radius)
      Single {} -> abs (v - _radialPole radius)
      _ -> abs (abs v - _radialPole radius)

-- | The integral of a function of the radius without a pole, for a ray that may start
-- inside the horizon.
regularDragging :: (Double -> Double) -> Radial -> RadialState -> Double
regularDragging = alongRadius (const (1 / 0))

alongRadius :: (Double -> Double) -> (Double -> Double) -> Radial -> RadialState -> Double
alongRadius toPole rate radius state =
  integrateBeside (_radialPrecision radius) toPole integrand (_radialStartV radius) (stateV state)
    / _radialRate radius
  where
    !shape = _radialShape radius
    !complement = _radialComplement radius
    -- Where there is no turning point, v runs backwards on the way in.
    !outward = case shape of
      Single {} | _radialStart radius < 0 -> -0.5
      _ -> 0.5
    integrand e =
      let s = outward * (e - 1 / e)
       in rate (radiusAt shape s) / sqrt (1 + complement * s * s)
    {-# INLINE integrand #-}
{-# INLINE alongRadius #-}
