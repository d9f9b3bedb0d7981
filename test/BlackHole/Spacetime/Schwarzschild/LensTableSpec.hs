module BlackHole.Spacetime.Schwarzschild.LensTableSpec (spec) where

import BlackHole.Spacetime.Fate
import BlackHole.Spacetime.Schwarzschild.LensTable
import BlackHole.Spacetime.Schwarzschild.Orbit
import BlackHole.Spacetime.Schwarzschild.OrbitSeries
import BlackHole.Spacetime.Schwarzschild.Radii (criticalImpactParameter)
import qualified BlackHole.Vector.XY as XY
import Support.Allocation
import Support.Approx
import Support.Generators
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess, prop)
import Test.QuickCheck hiding (total)

spec :: Spec
spec = do
  describe "the paths from r = " $
    sequence_
      [ modifyMaxSuccess (const 1000) . beforeAll (pure (lensTable r)) $
          it (show r) $ \table -> forAll (inRange 0 1) (agrees table r)
        | r <- [0.3, 0.7, 1, 1.0001, 1.2, 1.5, 2, 3, 10, 30, 1000, 1e6]
      ]
  modifyMaxSuccess (const 15) $
    prop "the paths from anywhere" $
      forAll (oneof [inRange 0.3 1, inRange 1 3, (10 **) <$> inRange 0 4]) $ \r ->
        let table = lensTable r
         in forAll (vectorOf 20 (inRange 0 1)) $ \parts -> conjoin (map (agrees table r) parts)
  describe "near the critical direction" $ do
    prop "the fates are those of the closed form" $
      forAll ((,) <$> inRange (-12) (-2) <*> elements [-1, 1]) $ \(e, side) ->
        let (r, radial, tangential) = criticalPhoton (side * 10 ** e)
         in case ( seriesFate (lensSeries ten radial tangential),
                   orbitFate (orbit r radial tangential)
                 ) of
              (Escaped _, Escaped _) -> property True
              (fate, exactly) -> fate === exactly
    prop "the error grows as slowly as the angle" $
      forAll ((,) <$> inRange (-7) (-2) <*> elements [-1, 1]) $ \(e, side) ->
        let (r, radial, tangential) = criticalPhoton (side * 10 ** e)
            path = orbit r radial tangential
         in closeTo 1e-6 (orbitSweep path) (seriesAngle (lensSeries ten radial tangential))
    prop "nearest to it the closed form itself answers" $
      forAll ((,) <$> inRange (-12) (-8) <*> elements [-1, 1]) $ \(e, side) ->
        let (r, radial, tangential) = criticalPhoton (side * 10 ** e)
         in seriesAngle (lensSeries ten radial tangential)
              === orbitSweep (orbit r radial tangential)
  it "fits into four megabytes" $
    map (lensTableSize . lensTable) [0.3, 1.0001, 2, 30, 1e6]
      `shouldSatisfy` all (\n -> n > 10000 && n < 500000)
  it "knows its place" $ lensTableRadius ten `shouldBe` 10
  it "is looked up without leaving much behind" $
    whenOptimised $ do
      let total :: Int -> Double
          total n = go n 0
            where
              go :: Int -> Double -> Double
              go 0 acc = acc
              go k acc =
                let psi = 1 + fromIntegral k * 1e-4
                 in acc
                      `seq` go
                        (k - 1)
                        (acc + seriesAngle (lensSeries ten (cos psi) (sin psi / sqrt 0.9)))
      few <- total 10 `seq` allocatedBytes (total 100)
      many <- allocatedBytes (total 10100)
      (many - few) `div` 10000 `shouldSatisfy` (<= 200)
  where
    ten = lensTable 10
    -- Light that is seen so far from the critical direction at r = 10.
    criticalPhoton away =
      let psi = pi - asin (criticalImpactParameter * sqrt 0.9 / 10) - away
       in (10, cos psi, sin psi / sqrt 0.9)

-- | The stated error for the direction of sight at a part of the way from
-- outwards to inwards: the sky to 1e-6 radians and crossings of the disk's plane
-- to 1e-5 Schwarzschild radii, wherever on the path they are. Light of a b below
-- 1e-3 moves along the radius, and where it crosses a plane with that radius in
-- it is not well determined.
agrees :: LensTable -> Double -> Double -> Property
agrees table r part =
  abs (b - criticalImpactParameter) > 1e-4 && b > 0 ==> case (seriesFate series, orbitFate path) of
    (Escaped found, Escaped known) -> closeTo 1e-6 0 (XY.norm (found XY.^-^ known)) .&&. crossings
    (Captured, Captured) -> crossings
    (Circles, Circles) -> property True
    (_, fate) -> counterexample ("another fate than " ++ show fate) False
  where
    path = orbit r radial tangential
    series = lensSeries table radial tangential
    spacing = seriesSpacing series
    b = r * tangential
    (radial, tangential)
      | r > 1 = (cos (pi * part), sin (pi * part) / sqrt (1 - 1 / r))
      | otherwise =
        let t = tan (0.5 * pi * part) / r
         in (sqrt (1 + (1 / r - 1) * t * t), t)
    crossings =
      conjoin
        [ counterexample
            ("at " ++ show phi)
            ( closeTo
                (1e-5 * max 1 (1e-3 / b))
                (1 / exactly)
                (1 / expansionValue (expand 1.5 u slope) (phi - middle))
            )
          | k <- [0 .. 10 :: Int],
            let phi = seriesAngle series * (fromIntegral k + 0.37) / 11
                exactly = orbitInverseRadius path phi
                cell = max 0 (min (seriesCells series - 1) (truncate (phi / spacing)))
                middle = (fromIntegral cell + 0.5) * spacing
                (u, slope) = waypoint (seriesWaypoints series) spacing cell,
            exactly > 1 / 30
        ]
