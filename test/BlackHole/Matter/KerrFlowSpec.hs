module BlackHole.Matter.KerrFlowSpec (spec) where

import BlackHole.Matter.KerrFlow
import BlackHole.Spacetime.Kerr.Landmarks
import BlackHole.Spacetime.Kerr.Sight
import BlackHole.Spacetime.Momentum
import Support.KerrReference (spinOf)
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck

spec :: Spec
spec = do
  prop "in the plane, both ways to the frequency in the gas agree" $
    forAll places $ \(hole, r) ->
      forAll ((,,) <$> choose (-3, 3) <*> choose (0, 8) <*> elements [-1, 1]) $
        \(lambda, eta, side) ->
          let a = spinLength hole
              kappa = eta + (lambda - a) * (lambda - a)
              p = r * r + a * (a - lambda)
              radial = p * p - kerrDelta hole r * kappa
              momentum = Momentum (side * sqrt radial / kerrDelta hole r) lambda
              ray = LightRay r 0 1 (negate side * sqrt radial) 0 lambda eta kappa 1
              flow = kerrFlow hole
           in radial > 0
                ==> nearRelative
                  1e-6
                  (kerrPlaneFrequency flow ray r momentum)
                  (frequencyInGas (kerrFrequencies flow r 0 momentum))
  -- The contraction of the light's momentum with the gas's four-velocity in
  -- Boyer–Lindquist's coordinates.
  prop "off the plane the gas has the plane's angular rate and radial speed" $
    forAll places $ \(hole, r) ->
      forAll ((,,) <$> choose (-0.8, 0.8) <*> choose (-2, 2) <*> choose (-3, 3)) $
        \(c, kr, lambda) ->
          let flow = kerrFlow hole
              (rate, speed) = gasInPlane hole r
              Metric lapse dragging girth stretch = metric hole r c
              past = girth * (rate - dragging) / lapse
              gamma = 1 / sqrt (1 - past * past - speed * speed)
              timeRate = gamma / lapse
              expected = timeRate * (1 - lambda * rate) - kr * gamma * speed / stretch
           in counterexample (show (rate, speed)) $
                nearRelative
                  1e-9
                  expected
                  (frequencyInGas (kerrFrequencies flow r c (Momentum kr lambda)))
  where
    places = do
      hole <- spinOf <$> choose (-0.99, 0.99)
      r <- (horizonRadius hole *) <$> oneof [choose (1.05, 3), choose (1.05, 20)]
      pure (hole, r)
    nearRelative part known value =
      counterexample (show (known, value)) (abs (value - known) <= part * (1 + abs known))

-- | Lapse, frame dragging, circumferential radius and √g_rr at a radius and cos θ.
data Metric = Metric Double Double Double Double

metric :: Spin -> Double -> Double -> Metric
metric hole r c =
  Metric
    (sqrt (sigma * delta / area))
    (a * r / area)
    (sqrt ((1 - c * c) * area / sigma))
    (sqrt (sigma / delta))
  where
    a = spinLength hole
    sigma = r * r + a * a * c * c
    delta = r * r - r + a * a
    area = (r * r + a * a) * (r * r + a * a) - a * a * delta * (1 - c * c)

-- | dφ\/dt of the gas in the plane, and its radial speed past the observer without angular
-- momentum: from its energy and angular momentum, and from the length of its four-velocity.
gasInPlane :: Spin -> Double -> (Double, Double)
gasInPlane hole r
  | r >= isco = (circular r, 0)
  | otherwise = (rate, negate (sqrt (max 0 (1 - past * past - slow / (lapse * lapse)))))
  where
    a = spinLength hole
    isco = iscoRadius RightHanded hole
    circular q = 1 / (sqrt 2 * q * sqrt q + a)
    Metric lapse dragging girth _ = metric hole r 0
    past = girth * (rate - dragging) / lapse
    slow = 1 / (timeRate * timeRate)
    -- u^t and dφ/dt for the energy and angular momentum of the innermost orbit.
    timeRate = (energy - dragging * momentum) / (lapse * lapse)
    rate = dragging + momentum / (girth * girth * timeRate)
    (energy, momentum) =
      let Metric lapse' dragging' girth' _ = metric hole isco 0
          past' = girth' * (circular isco - dragging') / lapse'
          gamma = 1 / sqrt (1 - past' * past')
       in ( gamma * (lapse' + dragging' * girth' * past'),
            gamma * girth' * past'
          )
