{-# LANGUAGE BangPatterns #-}

module BlackHole.Spacetime.Schwarzschild.OrbitSpec (spec) where

import BlackHole.Spacetime.Fate
import BlackHole.Spacetime.Schwarzschild.Deflection
import BlackHole.Spacetime.Schwarzschild.Orbit
import BlackHole.Spacetime.Schwarzschild.Radii
import BlackHole.Vector.XY (XY (..))
import Control.Monad (forM_)
import Data.Maybe (fromMaybe, isNothing)
import Support.Allocation (allocatedBytes, whenOptimised)
import Support.IndependentOrbit
import Support.Reference
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess, prop)
import Test.QuickCheck

-- | Starting radius and the two components of the pseudo-velocity.
data Launch = Launch Double Double Double deriving (Show)

launchOrbit :: Launch -> Orbit
launchOrbit (Launch r vr vt) = orbit r vr vt

-- | @u@ and @du\/dφ@ at the start, from the definition.
launchValues :: Launch -> (Double, Double)
launchValues (Launch r vr vt) = (1 / r, -vr / (r * vt))

-- | A photon as a static observer at the radius sees it, at an angle in
-- radians from the inward radial direction.
static :: Double -> Double -> Launch
static r psi = Launch r (-cos psi * sqrt (1 - 1 / r)) (sin psi)

-- | A photon at a radius inside the horizon; @excess ≥ 0@ beyond the smallest
-- radial component that light can have there.
swallowed :: Double -> Double -> Double -> Launch
swallowed direction r excess = Launch r (direction * sqrt (1 / r - 1) * (1 + excess)) 1

-- | Starts in every regime, a little away from the critical orbit, where the
-- independent integration amplifies its own rounding.
newtype Tame = Tame Launch deriving (Show)

instance Arbitrary Tame where
  arbitrary = Tame <$> launches `suchThat` away
    where
      away l = abs (orbitImpactParameter (launchOrbit l) - criticalImpactParameter) > 1e-2
      launches =
        oneof
          [ static <$> logarithmic 1.6 1e3 <*> choose (0.01, pi - 0.01),
            static <$> choose (1.02, 1.5) <*> choose (0.05, pi - 0.05),
            swallowed <$> elements [-1, 1] <*> choose (0.3, 0.98) <*> logarithmic 1e-5 3,
            static <$> logarithmic 2 1e3 <*> logarithmic 1e-7 1e-2,
            static <$> logarithmic 2 1e3 <*> ((pi -) <$> logarithmic 1e-7 1e-2)
          ]

logarithmic :: Double -> Double -> Gen Double
logarithmic low high = exp <$> choose (log low, log high)

sweptAngle :: Orbit -> Maybe Double
sweptAngle o
  | isInfinite (orbitSweep o) = Nothing
  | otherwise = Just (orbitSweep o)

ending :: Orbit -> (Fate XY, Double)
ending o = (orbitFate o, orbitSweep o)

isEscape, isCapture :: (Fate XY, Double) -> Bool
isEscape (fate, sweep) = fate == Escaped (XY (cos sweep) (sin sweep))
isCapture (fate, _) = fate == Captured

near :: Double -> Double -> Double -> Bool
near limit expected actual = abs (actual - expected) <= limit

-- | Relative to the expected value.
nearly :: Double -> Double -> Double -> Bool
nearly limit expected = near (limit * abs expected) expected

radians :: Double -> Double
radians degrees = degrees * pi / 180

spec :: Spec
spec = do
  referenceSpec
  deflectionSpec
  regimeSpec
  independentSpec
  equationSpec
  describe "orbitInverseRadius" $
    it "allocates nothing" . whenOptimised $
      forM_ [static 20 0.5, static 20 0.13, static 20 0.1, static 1.2 2, static 1.2 1] $ \l -> do
        let o = launchOrbit l
        _ <- allocatedBytes (sumOver o 1)
        few <- allocatedBytes (sumOver o 1000)
        many <- allocatedBytes (sumOver o 100000)
        (many - few) `shouldSatisfy` (< 100000)

-- | Sum of @u@ over so many angles.
sumOver :: Orbit -> Int -> Double
sumOver o count = go count 0 0
  where
    go :: Int -> Double -> Double -> Double
    go !n !phi !acc
      | n <= 0 = acc
      | otherwise = go (n - 1) (phi + 1e-6) (acc + orbitInverseRadius o phi)

referenceSpec :: Spec
referenceSpec = describe "reference values" $ do
  it "reproduces every deflection within 1e-10 and closest approach within 1e-12" $ do
    rows <- readDeflections
    length rows `shouldBe` 14
    forM_ rows $ \row -> do
      let b = deflectionImpactParameter row
      deflectionAngle b `shouldSatisfy` maybe False (near 1e-10 (deflectionValue row))
      closestApproach b `shouldSatisfy` maybe False (nearly 1e-12 (deflectionClosestApproach row))

  it "reproduces every ray: fate, swept angle, crossings of the disk's plane" $ do
    rays <- readRays
    length rays `shouldBe` 15
    forM_ rays $ \ray -> do
      let o = rayOrbit ray
      orbitImpactParameter o `shouldSatisfy` nearly 1e-13 (rayImpactParameter ray)
      case (rayFate ray, orbitFate o) of
        (RayEscapes expected, Escaped _) -> orbitSweep o `shouldSatisfy` near 1e-10 expected
        (RayCaptured, Captured) -> pure ()
        (known, fate) -> expectationFailure (show (known, fate))
      forM_ (rayCrossing ray) $ \crossing -> do
        let (angle, azimuth) = rayPlaneCrossing ray (crossingNumber crossing)
        1 / orbitInverseRadius o angle `shouldSatisfy` nearly 1e-9 (crossingRadius crossing)
        azimuth `shouldSatisfy` sameAngle 1e-9 (crossingAzimuth crossing)

  it "finds no other crossings before the end" $ do
    rays <- readRays
    let crossingsOf ray =
          length . takeWhile (< fromMaybe 0 (sweptAngle (rayOrbit ray))) $
            map (fst . rayPlaneCrossing ray) [1 ..]
        listed ray =
          length [() | other <- rays, samePixel ray other, Just _ <- [rayCrossing other]]
        samePixel a b = pixel a == pixel b
        pixel ray = map ($ ray) [rayCameraRadius, rayInclination, rayPsi, rayEta]
    map crossingsOf rays `shouldBe` map listed rays

rayOrbit :: Ray -> Orbit
rayOrbit ray = launchOrbit (static (rayCameraRadius ray) (radians (rayPsi ray)))

-- | Swept angle and azimuth of the n-th crossing of @y = 0@, from the plane of
-- the orbit alone: it contains the camera's direction @(0, cos i, sin i)@ and
-- the tangent @cos η (1, 0, 0) + sin η (0, sin i, −cos i)@.
rayPlaneCrossing :: Ray -> Int -> (Double, Double)
rayPlaneCrossing ray n = (angle, atan2 z x)
  where
    i = radians (rayInclination ray)
    eta = radians (rayEta ray)
    first = atan2 (cos i) (-sin eta * sin i)
    angle = (if first <= 0 then first + pi else first) + pi * fromIntegral (n - 1)
    x = sin angle * cos eta
    z = cos angle * sin i - sin angle * sin eta * cos i

sameAngle :: Double -> Double -> Double -> Bool
sameAngle limit a b = near limit 1 (cos (a - b)) && near limit 0 (sin (a - b))

deflectionSpec :: Spec
deflectionSpec = describe "deflectionAngle" $ do
  it "stays exact to the last digit of b near b_c and in the far field" $
    -- b as a Double, deflection and closest approach from 60-digit arithmetic.
    forM_
      [ (2.6240569734668493, 4.2296618118375520188, 1.6364727581823877661),
        (2.598336018974451, 8.8104863549962666276, 1.5123814508570061884),
        (2.5980788094295275, 13.415285557709470459, 1.5012260788738256349),
        (2.598076237334078, 18.020450769532161882, 1.5001224878210100555),
        (2.5980762116131237, 22.625620193245763596, 1.5000122475863205299),
        (2.598076211355914, 27.230822952348234145, 1.5000012247266847532),
        (2.598076211353316, 37.731118943931803386, 1.5000000064258177881),
        (15, 0.14824808727275542382, 14.472500617121184982),
        (20, 0.10810407654092045084, 19.479887064625556024),
        (20.5, 0.10525547332328004392, 19.98041293790901416),
        (1e3, 0.002002950587099009679, 999.49962449917818456),
        (1e6, 2.0000029452484460844e-6, 999999.4999996249995)
      ]
      $ \(b, value, r0) -> do
        deflectionAngle b `shouldSatisfy` maybe False (nearly 1e-14 value)
        closestApproach b `shouldSatisfy` maybe False (nearly 1e-15 r0)

  prop "is Darwin's closed form in terms of the closest approach" $
    forAll (logarithmic 1.51 30) $ \r0 ->
      let b = sqrt (r0 * r0 * r0 / (r0 - 1))
       in conjoin
            [ counterexample "deflection" (maybe False (near 1e-9 (darwin r0)) (deflectionAngle b)),
              counterexample "closest approach" (maybe False (nearly 1e-9 r0) (closestApproach b))
            ]

  prop "has the far field 2/b + 15π/16b² + 16/3b³ + 3465π/1024b⁴" $
    forAll (logarithmic 50 1e9) $ \b ->
      let x = 1 / b
          value = x * (2 + x * (15 * pi / 16 + x * (16 / 3 + x * 3465 * pi / 1024)))
       in -- The next coefficient is 22.4, and the ones after it grow 2.6-fold.
          maybe False (near (26 * x * x * x * x * x + 1e-15 * value) value) (deflectionAngle b)

  it "is continuous where the expansion takes over" $
    (subtract <$> deflectionAngle 20 <*> deflectionAngle (20 * (1 + 1e-12)))
      `shouldSatisfy` maybe False (near 4e-15 (-1.2e-13))

  it "has the strong-field limit −ln(b/b_c − 1) + ln(216 (7 − 4√3)) − π" $
    forM_ [1e-5, 1e-6, 1e-7, 1e-8] $ \e -> do
      let b = criticalImpactParameter * (1 + e)
          e' = (b - criticalImpactParameter) / criticalImpactParameter
          limit = -log e' + log (216 * (7 - 4 * sqrt 3)) - pi
      -- The next term is of the order e ln e.
      deflectionAngle b `shouldSatisfy` maybe False (near (e * 30 + 1e-15 / e) limit)

  it "has no value for captured light" $ do
    map deflectionAngle [0, 1, 2.598076211353315, -3, 0 / 0] `shouldSatisfy` all isNothing
    map closestApproach [0, 1, 2.598076211353315, -3, 0 / 0] `shouldSatisfy` all isNothing
    deflectionAngle (criticalImpactParameter * (1 - 1e-8)) `shouldBe` Nothing
    deflectionAngle (1 / 0) `shouldBe` Just 0

-- | Darwin 1959, with the incomplete integral by Gauss's rule, as a check that
-- shares nothing with the library.
darwin :: Double -> Double
darwin r0 = 4 * sqrt (r0 / q) * integral - pi
  where
    q = sqrt ((r0 - 1) * (r0 + 3))
    m1 = (q + r0 - 3) / (2 * q)
    zeta = asin (sqrt ((q - r0 + 1) / (q - r0 + 3)))
    n = 400
    h = (pi / 2 - zeta) / n
    integral = sum [piece (zeta + i * h) | i <- [0 .. n - 1]]
    piece left = 0.5 * h * sum [w * value (left + 0.5 * h * (1 + t)) | (t, w) <- rule]
    value t = 1 / sqrt (cos t * cos t + m1 * sin t * sin t)
    rule = [(0, 8 / 9), (sqrt 0.6, 5 / 9), (-(sqrt 0.6), 5 / 9)]

regimeSpec :: Spec
regimeSpec = describe "regimes" $ do
  it "far field: the swept angle is π plus the deflection, less the missing legs" $
    forM_ [5, 50, 1e3, 1e4] $ \b -> do
      let r = 1e6
          o = orbit r (-(sqrt (1 - (b / r) ^ (2 :: Int) * (1 - 1 / r)))) (b / r)
      -- From infinity in to r the photon would have swept asin(b/r) and a little.
      orbitImpactParameter o `shouldSatisfy` nearly 1e-12 b
      (+ asin (b / r)) <$> sweptAngle o
        `shouldSatisfy` maybe False (near 1e-10 (pi + fromMaybe 0 (deflectionAngle b)))

  it "grazing: b_c (1 ± 1e-8) decides between escape and capture" $
    forM_ [1.6, 3, 20, 1000] $ \r -> do
      let aimed b = orbit r (-(sqrt (1 - b * b / (r * r) * (1 - 1 / r)))) (b / r)
          above = aimed (criticalImpactParameter * (1 + 1e-8))
          below = aimed (criticalImpactParameter * (1 - 1e-8))
      ending above `shouldSatisfy` isEscape
      ending below `shouldSatisfy` isCapture
      -- Light stays near the photon sphere for about −ln 1e-8 = 18 radians.
      sweptAngle above `shouldSatisfy` maybe False (> 17)
      sweptAngle below `shouldSatisfy` maybe False (> 9)

  it "nearly critical: nothing breaks down to the last bit" $
    forM_
      [(r, k) | r <- [1.01, 1.3, 1.4999999, 1.5, 1.5000001, 1.6, 3, 20, 1e6], k <- [-8 .. 8 :: Int]]
      $ \(r, k) -> do
        let b = criticalImpactParameter * (1 + fromIntegral k * 2.220446049250313e-16)
            radial = sqrt (max 0 (1 - b * b / (r * r) * (1 - 1 / r)))
        forM_ [orbit r (-radial) (b / r), orbit r radial (b / r)] $ \o -> do
          sweptAngle o `shouldSatisfy` maybe True (\a -> a >= 0 && a < 100)
          map (orbitInverseRadius o) [0, 0.1 .. 50] `shouldSatisfy` all (>= -1)
          orbitInverseRadius o 0 `shouldSatisfy` nearly 1e-9 (1 / r)

  it "from the photon sphere itself: no digit of the start is lost" $ do
    -- Radius, outward component, swept angle from 60-digit arithmetic.
    forM_
      [ (1.5, 1e-9, 21.89121458914292802),
        (1.5, 1e-17, 40.311895333761960152),
        (1.500000000001, 0, 29.204346080269866731),
        (1.50000001, 0, 19.994094619890073583)
      ]
      $ \(r, vr, expected) -> do
        ending (orbit r vr 1) `shouldSatisfy` isEscape
        orbitSweep (orbit r vr 1) `shouldSatisfy` near 1e-13 expected
    forM_
      [ (1.5, -1e-9, 20.574256693551444645),
        (1.5, -1e-17, 38.994937436837143456),
        (1.499999999999, 0, 27.887388183343272086)
      ]
      $ \(r, vr, expected) -> do
        ending (orbit r vr 1) `shouldSatisfy` isCapture
        orbitSweep (orbit r vr 1) `shouldSatisfy` near 1e-13 expected

  it "critical in every bit: circles" $ do
    let o = orbit photonSphereRadius 0 1
    orbitFate o `shouldBe` Circles
    sweptAngle o `shouldBe` Nothing
    orbitInvariant o `shouldSatisfy` nearly 1e-15 (4 / 27)
    map (orbitInverseRadius o) [0, 1, 100] `shouldBe` replicate 3 (1 / photonSphereRadius)

  it "tangential start outside: the start is the closest point, half the path remains" $
    forM_ [1.6, 3, 10, 1e5] $ \r -> do
      let o = orbit r 0 1
          b = sqrt (r * r * r / (r - 1))
      orbitClosestApproach o `shouldSatisfy` maybe False (nearly 1e-12 r)
      sweptAngle o
        `shouldSatisfy` maybe False (near 1e-10 (0.5 * (pi + fromMaybe 0 (deflectionAngle b))))

  it "outward: escapes without a closest approach, and retraces the inward leg" $
    forM_ [1.6, 3, 10, 1e4] $ \r -> do
      let psi = 0.5 * (pi / 2 + asin (criticalImpactParameter * sqrt (1 - 1 / r) / r))
          inward = launchOrbit (static r psi)
          outward = launchOrbit (static r (pi - psi))
      ending inward `shouldSatisfy` isEscape
      orbitClosestApproach outward `shouldBe` Nothing
      case (sweptAngle inward, sweptAngle outward, orbitTurningPoint inward) of
        (Just long, Just short, Just (TurningPoint half _)) ->
          long `shouldSatisfy` near 1e-12 (short + 2 * half)
        other -> expectationFailure (show other)

  it "captured: falls in without a turning point" $ do
    let o = orbit 20 (-(sqrt (1 - 19 / 8000))) 0.05
    orbitImpactParameter o `shouldSatisfy` nearly 1e-14 1
    ending o `shouldSatisfy` isCapture
    orbitTurningPoint o `shouldBe` Nothing

  it "between horizon and photon sphere: out to the farthest point and back, beyond b_c" $ do
    forM_ [1.05, 1.2, 1.4, 1.49] $ \r -> do
      -- Synge: light leaves if it is aimed closer to the outward direction
      -- than the angle whose sine is b_c √(1−1/r) / r.
      let edge = asin (criticalImpactParameter * sqrt (1 - 1 / r) / r)
          inside = launchOrbit (static r (pi - edge + 1e-6))
          outside = launchOrbit (static r (pi - edge - 1e-6))
      ending inside `shouldSatisfy` isEscape
      ending outside `shouldSatisfy` isCapture
      orbitClosestApproach outside `shouldBe` Nothing
      case orbitTurningPoint outside of
        Just (TurningPoint angle radius) -> do
          radius `shouldSatisfy` (\x -> x > r && x < photonSphereRadius)
          orbitInverseRadius outside angle `shouldSatisfy` nearly 1e-12 (1 / radius)
        Nothing -> expectationFailure "no farthest point"

  it "inside the horizon: outward light leaves or falls back, inward light is captured" $ do
    ending (orbit 0.5 1.5 1) `shouldSatisfy` isEscape
    ending (orbit 0.5 1.01 1) `shouldSatisfy` isCapture
    ending (orbit 0.5 (-1.5) 1) `shouldBe` (Captured, 0)
    -- Zero energy: r = sin² (φ/2), up to the horizon and down again.
    let o = orbit 0.5 1 1
    orbitTurningPoint o `shouldBe` Just (TurningPoint (pi / 2) 1)
    forM_ [0, 0.3, 1.5, 3] $ \phi ->
      orbitInverseRadius o phi
        `shouldSatisfy` nearly 1e-13 (1 / sin ((pi / 2 + phi) / 2) ^ (2 :: Int))

  it "radial: sweeps no angle" $ do
    ending (orbit 10 1 0) `shouldBe` (Escaped (XY 1 0), 0)
    ending (orbit 10 (-1) 0) `shouldBe` (Captured, 0)
    orbitImpactParameter (orbit 10 (-1) 0) `shouldBe` 0
    ending (orbit 10 0 0) `shouldBe` (Captured, 0)
    ending (orbit 10 1 1e-320) `shouldBe` (Escaped (XY 1 0), 0)
    orbitInverseRadius (orbit 10 (-1) 0) 1 `shouldBe` 0.1

  it "nearly radial: a straight line u = u₀ ± φ/b, to full relative accuracy" $
    forM_ [1e-12, 1e-14, 1e-80] $ \vt -> do
      let inward = orbit 1e6 (-1) vt
          outward = orbit 10 1 vt
      sweptAngle inward `shouldSatisfy` maybe False (nearly 1e-9 ((1 - 1e-6) * 1e6 * vt))
      sweptAngle outward `shouldSatisfy` maybe False (nearly 1e-9 vt)
      orbitInverseRadius outward (vt / 2) `shouldSatisfy` nearly 1e-9 0.05
      orbitInverseRadius inward (vt / 1e6) `shouldSatisfy` nearly 1e-9 (1e-6 + 1e-12)

  prop "nothing positive beyond escape, nothing outside beyond capture" $ \(Tame l) ->
    forAll (logarithmic 1e-9 1e3) $ \further ->
      let o = launchOrbit l
          beyond = orbitInverseRadius o (orbitSweep o + further)
       in (isEscape (ending o) && beyond <= 0) || (isCapture (ending o) && beyond >= 1)

independentSpec :: Spec
independentSpec = describe "against the independent integration" . modifyMaxSuccess (const 150) $ do
  it "deflects alike" $
    forM_ [2.6, 2.7, 3, 5, 20, 300] $ \b ->
      deflectionAngle b
        `shouldSatisfy` maybe
          False
          ( near
              (1e-15 / (b - criticalImpactParameter) + 1e-12)
              (fromMaybe 0 (independentDeflection b))
          )

  prop "ends alike, with the same swept angle" $ \(Tame l) ->
    let (u, w) = launchValues l
        expected = independentFate u w
        o = launchOrbit l
     in counterexample (show (expected, ending o)) $ case expected of
          LeavesAfter a -> isEscape (ending o) && near 1e-11 a (orbitSweep o)
          FallsAfter a -> isCapture (ending o) && near 1e-11 a (orbitSweep o)
          Unfinished -> False

  prop "passes through the same radii with the same slope" $ \(Tame l) ->
    forAll (choose (0, 0.999)) $ \fraction ->
      let (u, w) = launchValues l
          o = launchOrbit l
          angle = maybe 1 (* fraction) (sweptAngle o)
          (u1, w1) = independentOrbitAt u w angle
          (u2, w2) = orbitInverseRadiusAndSlope o angle
       in counterexample (show ((u1, w1), (u2, w2), orbitInverseRadius o angle)) $
            nearly 1e-10 u1 (orbitInverseRadius o angle)
              && nearly 1e-10 u1 u2
              && near (1e-10 * (abs w1 + u1)) w1 w2

equationSpec :: Spec
equationSpec = describe "the closed form's own equation" $ do
  prop "starts at the given radius and slope" $ \(Tame l) ->
    let (u, w) = launchValues l
        (u0, w0) = orbitInverseRadiusAndSlope (launchOrbit l) 0
     in nearly 1e-11 u u0 && near (1e-11 * (abs w + u)) w w0

  prop "has (du/dφ)² = 1/b² − u² + u³" $ \(Tame l) ->
    forAll (choose (0, 1)) $ \fraction ->
      let o = launchOrbit l
          angle = maybe 1 (* fraction) (sweptAngle o)
          (u, w) = orbitInverseRadiusAndSlope o angle
       in nearly 1e-12 (w * w + u * u + orbitInvariant o) (2 * orbitInvariant o + u * u * u)

  prop "has u'' = (3/2) u² − u" $ \(Tame l) ->
    forAll (choose (0.1, 0.9)) $ \fraction ->
      let o = launchOrbit l
          end = fromMaybe 0 (sweptAngle o)
          angle = end * fraction
          slopeAt = snd . orbitInverseRadiusAndSlope o
          central h = (slopeAt (angle + h) - slopeAt (angle - h)) / (2 * h)
          h0 = 2e-3 * min 1 end
          second = (4 * central (0.5 * h0) - central h0) / 3
          (u, w) = orbitInverseRadiusAndSlope o angle
          size = u + u * u + (abs w * 1e-3) / min 1 end
       in end > 0 ==> near (1e-8 * size) (1.5 * u * u - u) second

  prop "the slope is the derivative" $ \(Tame l) ->
    forAll (choose (0.1, 0.9)) $ \fraction ->
      let o = launchOrbit l
          end = fromMaybe 0 (sweptAngle o)
          angle = end * fraction
          central h =
            (orbitInverseRadius o (angle + h) - orbitInverseRadius o (angle - h)) / (2 * h)
          h0 = 2e-3 * min 1 end
          first = (4 * central (0.5 * h0) - central h0) / 3
          (u, w) = orbitInverseRadiusAndSlope o angle
       in end > 0 ==> near (1e-9 * (abs w + u / min 1 end)) w first

  prop "does not depend on the length of the pseudo-velocity" $ \(Tame l@(Launch r vr vt)) ->
    forAll (logarithmic 1e-3 1e3) $ \factor ->
      let o = launchOrbit l
          o' = orbit r (factor * vr) (factor * vt)
       in case (sweptAngle o, sweptAngle o') of
            (Just a, Just a') -> near 1e-11 a a'
            _ -> False

  prop "continues: an orbit restarted on its way ends at the same place" $ \(Tame l) ->
    forAll (choose (0, 0.95)) $ \fraction ->
      let o = launchOrbit l
          end = fromMaybe 0 (sweptAngle o)
          angle = end * fraction
          (u, w) = orbitInverseRadiusAndSlope o angle
          rest = orbit (1 / u) (-w) u
       in counterexample (show (ending o, ending rest)) $
            maybe False (near 1e-10 (end - angle)) (sweptAngle rest)
