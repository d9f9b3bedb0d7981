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
-- and the azimuth is an integral over both. A segment is so short against the gas that
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
import BlackHole.Spacetime.March
import BlackHole.Spacetime.Momentum
import BlackHole.Vector.XYZ (XYZ (..))

-- | Follow the path of a ray to its end, which is given, and hand out the segments that
-- lie in a region. The phase, 0 to 1, is the fraction of a whole step that the first
-- segment of a passage is long: neighbours in a picture should have different ones.
followKerr :: Spin -> Region -> Double -> KerrPath -> Fate XYZ -> LightRay -> (a -> PathSegment -> Continue a) -> a -> Followed a
followKerr hole region phase path fate ray gather initial
  | reach <= 0 = finish 0 initial
  | otherwise = passages 0 windows initial
  where
    !reach = enclosingRadius region
    finish !n state = Followed fate state n
    !a = spinLength hole
    !a2 = a * a
    !lambda = rayLambda ray
    !eta = rayEta ray
    !kappa = rayKappa ray
    !c2 = a2 - lambda * lambda - eta
    !outer = horizonRadius hole
    !inner = innerHorizonRadius hole
    !wHorizon = 1 / outer
    -- The greatest |cos θ| of the gas.
    innermost = max outer (regionInnerRadius region)
    steepest = min 1 (regionHalfHeight region / innermost + regionFlare region)
    windows = kerrPassages path reach steepest

    passages !n [] state = finish n state
    passages !n ((from, to) : rest) state =
      march n phase (to - from) w w' u u' (pointAzimuth point) rest state
      where
        point = kerrPoint path from
        !w = 1 / pointRadius point
        !w' = (if pointGrows point then negate else id) (sqrt (max 0 (1 + w * w * (c2 + w * (kappa - a2 * eta * w)))))
        !u = pointCosine point
        !u' = kerrCosineRate path from

    turning !w !u = negate (lambda / (1 - u * u) + a * w * (1 - a * lambda * w) / (1 - w + a2 * w * w))
    {-# INLINE turning #-}

    march !n !lead !left !w !w' !u !u' !phi rest state
      | left <= 1e-14 || w >= 0.999999 * wHorizon = passages n rest state
      | insideRegion region middle = case gather state segment of
        Continue state' -> next (n + 1) state'
        Stop state' -> Followed Opaque state' (n + 1)
      | otherwise = next n state
      where
        !r = 1 / w
        !s2 = 1 - u * u
        !rate0 = turning w u
        !radial0 = negate w' * r * r
        !across0 = r * sqrt (u' * u' / s2 + s2 * rate0 * rate0)
        !speed0 = sqrt (radial0 * radial0 + across0 * across0)
        !climb0 = radial0 * u + r * u'
        !s0 = sqrt s2
        !wanted = lead * min (0.2 * r) (marchLength region (XYZ (r * s0) (r * u) 0) (climb0 / speed0)) / speed0
        !step = if left < 1.4 * wanted then left else wanted
        !half = 0.5 * step
        !(Two wM wM') = advanced half w w' (wForce w) (wForce1 w) (wForce2 w)
        !(Two w1 w1') = advanced step w w' (wForce w) (wForce1 w) (wForce2 w)
        !(Two uM uM') = advanced half u u' (uForce u) (uForce1 u) (uForce2 u)
        !(Two u1 u1') = advanced step u u' (uForce u) (uForce1 u) (uForce2 u)
        !rateM = turning wM uM
        !rate1 = turning w1 u1
        -- Simpson's rule, and the parabola's integral over its first half.
        !phiM = phi + step / 24 * (5 * rate0 + 8 * rateM - rate1)
        !phi1 = phi + step / 6 * (rate0 + 4 * rateM + rate1)
        !rM = 1 / wM
        !sM = sqrt (1 - uM * uM)
        !sine = sin phiM
        !cosine = cos phiM
        middle = XYZ (rM * sM * sine) (rM * uM) (rM * sM * cosine)
        -- Rates with respect to Mino time.
        radialRate = negate wM' * rM * rM
        vertical = radialRate * uM + rM * uM'
        horizontal = radialRate * sM - rM * uM * uM' / sM
        around = rM * sM * rateM
        p = rM * rM + a * (a - lambda)
        delta = (rM - outer) * (rM - inner)
        radialMomentum = sqrt (max 0 (p * p - delta * kappa)) / delta
        segment =
          PathSegment
            { segmentMiddle = middle,
              segmentRadius = rM,
              segmentAffineLength = step * (rM * rM + a2 * uM * uM),
              segmentLength = step * sqrt (horizontal * horizontal + vertical * vertical + around * around),
              segmentRadialStep = step * radialRate,
              segmentVerticalStep = step * vertical,
              segmentMomentum = Momentum (if radialRate > 0 then negate radialMomentum else radialMomentum) lambda
            }
        next !m = march m 1 (left - step) w1 w1' u1 u1' phi1 rest

    wForce w = w * (c2 + w * (1.5 * kappa - 2 * a2 * eta * w))
    wForce1 w = c2 + w * (3 * kappa - 6 * a2 * eta * w)
    wForce2 w = 3 * kappa - 12 * a2 * eta * w
    uForce u = u * (c2 - 2 * a2 * u * u)
    uForce1 u = c2 - 6 * a2 * u * u
    uForce2 u = -12 * a2 * u
{-# INLINE followKerr #-}

-- | A number and its rate.
data Two = Two {-# UNPACK #-} !Double {-# UNPACK #-} !Double

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
