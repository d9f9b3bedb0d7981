module BlackHole.Spacetime.Schwarzschild.OrbitSeriesSpec (spec) where

import BlackHole.Spacetime.Fate
import BlackHole.Spacetime.Schwarzschild.Orbit
import BlackHole.Spacetime.Schwarzschild.OrbitSeries
import BlackHole.Spacetime.Schwarzschild.Radii (criticalImpactParameter)
import BlackHole.Vector.XY (XY (..))
import Support.Approx
import Support.Generators
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck

spec :: Spec
spec = do
  describe "the expansion" $ do
    prop "follows the closed form through its whole cell" $
      forAll outsidePhoton $ \(r, radial, tangential) ->
        forAll (inRange 0 1) $ \along -> forAll (inRange (-0.5) 0.5) $ \offset ->
          let path = orbit r radial tangential
              series = orbitSeries path
              spacing = seriesSpacing series
              cell =
                min (seriesCells series - 1) (truncate (along * fromIntegral (seriesCells series)))
              (u, slope) = waypoint (seriesWaypoints series) spacing cell
              expansion = expand 1.5 u slope
              middle = (fromIntegral cell + 0.5) * spacing
              at = offset * spacing
              (u', slope') = orbitInverseRadiusAndSlope path (middle + at)
           in abs (r * tangential - criticalImpactParameter) > 1e-4
                ==> closeTo (1e-8 * (1 + abs slope')) u' (expansionValue expansion at)
                  .&&. closeTo
                    (1e-6 * (1 + abs slope'))
                    slope'
                    (expansionSlope expansion at)
    prop "is the start and its slope at the waypoint" $
      forAll ((,) <$> inRange 0 1 <*> inRange (-1) 1) $ \(u, slope) ->
        (expansionValue (expand 1.5 u slope) 0, expansionSlope (expand 1.5 u slope) 0)
          === (u, slope)
    prop "is a straight line without a pull" $
      forAll ((,,) <$> inRange 0 1 <*> inRange (-1) 1 <*> inRange (-0.2) 0.2) $ \(u, slope, t) ->
        closeTo 1e-10 (u * cos t + slope * sin t) (expansionValue (expand 0 u slope) t)
    it "errs with the ninth power of the angle" $ do
      let path = orbit 6 (-0.9) 0.5
          (u, slope) = orbitInverseRadiusAndSlope path 0.7
          fault t = abs (expansionValue (expand 1.5 u slope) t - orbitInverseRadius path (0.7 + t))
      logBase 2 (fault 0.8 / fault 0.4) `shouldBeWithin` (1, 9)
  describe "a path's cells" $ do
    prop "are at most 0.4 radians wide" $
      forAll outsidePhoton $ \(r, radial, tangential) ->
        let series = orbitSeries (orbit r radial tangential)
         in seriesSpacing series <= 0.4000001 .&&. seriesCells series >= 2
    prop "end with the path" $
      forAll outsidePhoton $ \(r, radial, tangential) ->
        let path = orbit r radial tangential
            series = orbitSeries path
         in seriesFate series === orbitFate path
              .&&. (orbitFate path == Circles || seriesAngle series == orbitSweep path)
  describe "a straight line" $ do
    prop "leaves in its own direction" $
      forAll straight $ \(r, psi) ->
        r * sin psi > 1.001
          || psi < pi / 2
          ==> case seriesFate (line r psi) of
            -- Its direction has the components cos ψ and sin ψ at the start.
            Escaped (XY c s) -> closeTo 1e-12 (cos psi) c .&&. closeTo 1e-12 (sin psi) s
            _ -> counterexample "does not leave" False
    prop "or ends on the black ball" $
      forAll
        ((\r part -> (r, pi - part * asin (1 / r))) <$> inRange 1.01 50 <*> inRange 0.001 0.999)
        $ \(r, psi) ->
          case seriesFate (line r psi) of
            -- The angle from the outward radius shrinks by the angle swept, and
            -- its sine times the radius stays.
            Captured -> closeTo 1e-9 (psi - (pi - asin (r * sin psi))) (seriesAngle (line r psi))
            _ -> counterexample "does not fall in" False
    prop "lies where geometry says" $
      forAll ((,) <$> straight <*> inRange 0 1) $ \((r, psi), along) ->
        let series = line r psi
            spacing = seriesSpacing series
            cell =
              min (seriesCells series - 1) (truncate (along * fromIntegral (seriesCells series)))
            phi = (fromIntegral cell + 0.5) * spacing
            (u, slope) = waypoint (seriesWaypoints series) spacing cell
         in abs (r * sin psi - 1) > 1e-3
              ==> closeTo 1e-10 (sin (psi - phi) / (r * sin psi)) u
                .&&. closeTo 1e-9 (negate (cos (psi - phi)) / (r * sin psi)) slope
  where
    straight = (,) <$> inRange 1.01 50 <*> inRange 0.01 3.13
    line r psi = lineSeries (1 / r) (negate (cos psi) / (r * sin psi))

-- | Radius and velocity of light that an observer at rest sees at an angle from
-- the outward radius.
outsidePhoton :: Gen (Double, Double, Double)
outsidePhoton = do
  r <- oneof [inRange 1.01 3, inRange 3 100]
  psi <- inRange 0.01 3.13
  pure (r, cos psi, sin psi / sqrt (1 - 1 / r))
