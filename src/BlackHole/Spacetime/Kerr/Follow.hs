{-# LANGUAGE BangPatterns #-}

-- | Light followed around a rotating hole from one passage through the gas to the next.
--
-- The closed form says when a ray is near the plane and within the gas's radius, and
-- where it is then; in between nothing needs to be looked at. Within a passage the ray is
-- continued from segment to segment by Taylor series in Mino time: @w = 1\/r@ and
-- @u = cos θ@ obey equations of their own,
--
-- > w'' = (a² − λ² − η) w + (3/2) κ w² − 2a²η w³
-- > u'' = (a² − λ² − η − 2a²u²) u
--
-- and the azimuth is an integral over both, by Simpson's rule. A segment is so short that
-- the series of order 5 is exact to 1e-9.
module BlackHole.Spacetime.Kerr.Follow
  ( followKerr,
  )
where

import BlackHole.Spacetime.Fate
import BlackHole.Spacetime.Kerr.Landmarks
import BlackHole.Spacetime.Kerr.Path
import BlackHole.Spacetime.Kerr.Sight
import BlackHole.Spacetime.LightPath
import BlackHole.Spacetime.March (enclosingRadius)
import BlackHole.Spacetime.Momentum
import BlackHole.Vector.XYZ (XYZ (..))

-- | Follow the path of a ray to its end, which is given, and hand out the segments that
-- lie in a region. The phase, 0 to 1, is the fraction of a whole step that the first
-- segment of a passage is long: neighbours in a picture should have different ones.
followKerr ::
  Spin ->
  Region ->
  Double ->
  KerrPath ->
  Fate XYZ ->
  LightRay ->
  (a -> PathSegment -> Continue a) ->
  a ->
  Followed a
followKerr hole region phase path fate ray gather initial
  | reach <= 0 = finish 0 initial
  | otherwise = passages 0 (kerrPassages path reach steepest) initial
  where
    !reach = enclosingRadius region
    finish !n state = Followed fate state n
    !motion = motionOf hole ray
    !nearHorizon = 0.999999 * wHorizon motion
    fallsIn = case fate of
      Captured -> True
      _ -> False
    !radius = regionRadius region
    !inner = regionInnerRadius region
    -- The greatest |cos θ| of the gas.
    steepest = min 1 (regionHalfHeight region / max (horizonRadius hole) inner + regionFlare region)

    passages !n [] state = finish n state
    -- The bound is for light that circles for ever, in every bit.
    passages !n ((from, to) : rest) state = begin n phase from (min to (from + 200)) rest state

    -- Gathers between two Mino times, from the closed form's point.
    begin !n !lead !from !to rest !state =
      march n lead to (to - from) w w' u (pointCosineRate point) rate sine cosine rest state
      where
        !point = kerrPoint path from
        !(Two sine cosine) = direction point
        !w = 1 / pointRadius point
        !w' = (if pointGrows point then negate else id) (radialSpeed motion w)
        !u = pointCosine point
        !rate = turning motion w u

    direction point = let azimuth = pointAzimuth point in Two (sin azimuth) (cos azimuth)

    march !n !lead !to !left !w !w' !u !u' !rate0 !sine !cosine rest !state
      -- Light that has circled near a photon orbit may leave the gas, or reach the hole, long
      -- before the closed form's time: the orbit multiplies the error of every step. Without
      -- this, its steps towards infinity would shrink for ever. Also ends if a number is lost.
      | not (left > 1e-14 && w < nearHorizon && (w' > 0 || w * reach > 1)) =
        passages n rest state
      -- Inside of the gas on the way into the hole.
      | w * inner > 1 && w' > 0 && fallsIn = finish n state
      | rho <= radius && abs (rM * uM) <= halfHeightAt region rho && rM >= inner =
        case gather state segment of
          Continue state' -> next (n + 1) state'
          Stop state' -> Followed Opaque state' (n + 1)
      | otherwise = next n state
      where
        !wanted = lead * stepLength motion region w w' u u'
        !step = if left < 1.4 * wanted then left else wanted
        !half = 0.5 * step
        !(Two wM wM') = radiusAfter motion half w w'
        !(Two w1 w1') = radiusAfter motion step w w'
        !(Two uM uM') = cosineAfter motion half u u'
        !(Two u1 u1') = cosineAfter motion step u u'
        !rateM = turning motion wM uM
        !rate1 = turning motion w1 u1
        -- Simpson's rule, and the parabola's integral over its first half.
        !(Two sineM cosineM)
          | besidePole = direction (kerrPoint path (to - left + half))
          | otherwise = turnedBy (step / 24 * (5 * rate0 + 8 * rateM - rate1)) sine cosine
        !(Two sine1 cosine1) = turnedBy (step / 6 * (rate0 + 4 * rateM + rate1)) sine cosine
        !rM = 1 / wM
        !rho = rM * sqrt (1 - uM * uM)
        segment = segmentAt motion step wM wM' uM uM' rateM sineM cosineM
        -- The azimuth turns too fast for Simpson's rule there.
        !besidePole = max (u * u) (u1 * u1) > 0.9
        next !m
          | besidePole = begin m 1 (to - left + step) to rest
          | otherwise = march m 1 to (left - step) w1 w1' u1 u1' rate1 sine1 cosine1 rest
{-# INLINE followKerr #-}

-- | The constants of the motion of one ray.
data RayMotion = RayMotion
  { -- | a and a².
    spinOf :: {-# UNPACK #-} !Double,
    spin2 :: {-# UNPACK #-} !Double,
    lambdaOf :: {-# UNPACK #-} !Double,
    etaOf :: {-# UNPACK #-} !Double,
    kappaOf :: {-# UNPACK #-} !Double,
    -- | @a² − λ² − η@.
    square :: {-# UNPACK #-} !Double,
    -- | The radii of both horizons, and @w@ at the outer one.
    outerHorizon :: {-# UNPACK #-} !Double,
    innerHorizon :: {-# UNPACK #-} !Double,
    wHorizon :: {-# UNPACK #-} !Double
  }

motionOf :: Spin -> LightRay -> RayMotion
motionOf hole ray =
  RayMotion
    { spinOf = a,
      spin2 = a * a,
      lambdaOf = lambda,
      etaOf = rayEta ray,
      kappaOf = rayKappa ray,
      square = a * a - lambda * lambda - rayEta ray,
      outerHorizon = horizonRadius hole,
      innerHorizon = innerHorizonRadius hole,
      wHorizon = 1 / horizonRadius hole
    }
  where
    a = spinLength hole
    lambda = rayLambda ray
{-# INLINE motionOf #-}

-- | @|w'|@ at a radius.
radialSpeed :: RayMotion -> Double -> Double
radialSpeed (RayMotion _ a2 _ eta kappa c2 _ _ _) w =
  sqrt (max 0 (1 + w * w * (c2 + w * (kappa - a2 * eta * w))))
{-# INLINE radialSpeed #-}

-- | dφ\/dτ along the tracing.
turning :: RayMotion -> Double -> Double -> Double
turning (RayMotion a a2 lambda _ _ _ _ _ _) !w !u =
  negate (lambda / (1 - u * u) + a * w * (1 - a * lambda * w) / (1 - w + a2 * w * w))
{-# INLINE turning #-}

-- | The length of a whole step in Mino time, as without spin
-- ("BlackHole.Spacetime.Schwarzschild.GasLayer"), but for gaps: on the way to the gas it
-- may take most of the distance.
stepLength :: RayMotion -> Region -> Double -> Double -> Double -> Double -> Double
stepLength motion region !w !w' !u !u' = min (min (0.2 / pace) beside) approach
  where
    !height = regionHalfHeight region
    !core = 1 / regionCore region
    -- The squared angle that the ray turns per Mino time, roughly.
    !turns2 = max 0 (etaOf motion + lambdaOf motion * lambdaOf motion)
    !room = max 1e-9 (height * w + regionFlare region)
    !aside = abs u
    !pace = sqrt (w' * w' / (w * w) + turns2)
    !climb = abs (u' * room - u * height * w')
    !steep = climb / (regionVerticalStep region * room * room)
    !within = max 1 (min core (aside * core / room)) / max (pace / regionLongestStep region) steep
    !approach = if aside > room then max within (0.8 * (aside - room) / abs u') else within
    -- Beside the horizon the azimuth grows as the logarithm of the distance.
    !beside = max (1e-3 * wHorizon motion) (0.1 * (wHorizon motion - w)) / abs w'
{-# INLINE stepLength #-}

-- | The segment of this length in Mino time about a point: @w@ and @u@ with their rates,
-- the rate of the azimuth, and the azimuth's sine and cosine.
segmentAt ::
  RayMotion ->
  Double ->
  Double ->
  Double ->
  Double ->
  Double ->
  Double ->
  Double ->
  Double ->
  PathSegment
segmentAt motion step w w' u u' rate sine cosine =
  PathSegment
    { segmentMiddle = XYZ (rho * sine) (r * u) (rho * cosine),
      segmentRadius = r,
      segmentAffineLength = step * (r * r + spin2 motion * u * u),
      segmentLength =
        step * sqrt (horizontal * horizontal + climbing * climbing + around * around),
      segmentRadialStep = step * radialRate,
      segmentVerticalStep = step * climbing,
      segmentMomentum = Momentum (negate radialRate / delta) (lambdaOf motion)
    }
  where
    r = 1 / w
    s = sqrt (1 - u * u)
    rho = r * s
    delta = (r - outerHorizon motion) * (r - innerHorizon motion)
    -- Rates with respect to Mino time.
    radialRate = negate w' * r * r
    climbing = radialRate * u + r * u'
    horizontal = radialRate * s - r * u * u' / s
    around = rho * rate
{-# INLINE segmentAt #-}

-- | @w@ and its rate after a time in which it changes little.
radiusAfter :: RayMotion -> Double -> Double -> Double -> Two
radiusAfter (RayMotion _ a2 _ eta kappa c2 _ _ _) h w w' =
  advanced
    h
    w
    w'
    (w * (c2 + w * (1.5 * kappa - 2 * a2 * eta * w)))
    (c2 + w * (3 * kappa - 6 * a2 * eta * w))
    (3 * kappa - 12 * a2 * eta * w)
{-# INLINE radiusAfter #-}

-- | @u@ and its rate after a time in which it changes little.
cosineAfter :: RayMotion -> Double -> Double -> Double -> Two
cosineAfter (RayMotion _ a2 _ _ _ c2 _ _ _) h u u' =
  advanced h u u' (u * (c2 - 2 * a2 * u * u)) (c2 - 6 * a2 * u * u) (-12 * a2 * u)
{-# INLINE cosineAfter #-}

-- | A number and its rate.
data Two = Two {-# UNPACK #-} !Double {-# UNPACK #-} !Double

-- | The sine and cosine of an angle that has grown, from those before.
turnedBy :: Double -> Double -> Double -> Two
turnedBy angle s c
  | abs angle < 0.25 =
    let angle2 = angle * angle
     in turned
          (angle * (1 - angle2 * (1 / 6 - angle2 * (1 / 120 - angle2 / 5040))))
          (1 - angle2 * (0.5 - angle2 * (1 / 24 - angle2 * (1 / 720 - angle2 / 40320))))
  | otherwise = turned (sin angle) (cos angle)
  where
    turned s1 c1 = Two (s * c1 + c * s1) (c * c1 - s * s1)
    {-# INLINE turned #-}

-- | @advanced h y y' f f₁ f₂@: the solution of @y'' = f(y)@ after a step, from the force
-- and its first two derivatives at the start.
advanced :: Double -> Double -> Double -> Double -> Double -> Double -> Two
advanced h y y' f f1 f2 =
  Two
    (y + h * (y' + h * (0.5 * f + h * (third / 6 + h * (fourth / 24 + h * fifth / 120)))))
    (y' + h * (f + h * (0.5 * third + h * (fourth / 6 + h * fifth / 24))))
  where
    third = f1 * y'
    fourth = f2 * y' * y' + f1 * f
    fifth = 3 * f2 * y' * f + f1 * third
{-# INLINE advanced #-}
