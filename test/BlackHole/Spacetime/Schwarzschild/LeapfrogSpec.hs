{-# LANGUAGE BangPatterns #-}

module BlackHole.Spacetime.Schwarzschild.LeapfrogSpec (spec) where

import BlackHole.Spacetime.Fate
import BlackHole.Spacetime.LightPath
import BlackHole.Spacetime.Photon
import BlackHole.Spacetime.Schwarzschild.Leapfrog
import BlackHole.Spacetime.Schwarzschild.LeapfrogStep
import BlackHole.Spacetime.Schwarzschild.Orbit (orbit, orbitFate, orbitSweep)
import BlackHole.Spacetime.Schwarzschild.Radii (criticalImpactParameter)
import BlackHole.Spacetime.Schwarzschild.StepRule
import BlackHole.Spacetime.Types
import BlackHole.Vector.XYZ (XYZ (..))
import qualified BlackHole.Vector.XYZ as XYZ
import Support.Allocation (allocatedBytes, whenOptimised)
import Support.Approx
import Support.Generators
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess, prop)
import Test.QuickCheck

spec :: Spec
spec = do
  describe "the report's step rule" $ do
    it "is l0 · min(s_bh, s_ad), written out" $
      sequence_
        [ stepLength (ReportSteps l0 w) (XYZ x y z) `shouldBeWithin` (1e-15, l0 * min sbh sad)
          | l0 <- [0.1, 0.02],
            w <- [0.01, 0.1],
            (x, y, z) <-
              [(2, 0.1, 0), (1.05, 0.02, 0.3), (0, 3, -4), (10, 0.001, 20), (-0.2, 1.2, 0)],
            let r = sqrt (x * x + y * y + z * z)
                sbh = 1 / (1 + exp (10 * (1.4 - r)))
                sad = 1 / (1 + exp (10 * (0.4 - abs y / (20 * w))))
        ]
    it "is 10 beyond r = 40" $
      map (stepLength reportStepRule) [XYZ 0 0 40.001, XYZ 100 0 0] `shouldBe` [10, 10]
  describe "conserved quantities" $ do
    prop "h keeps to 1e-12 for random photons" $ \(Outside x) (Direction v) ->
      let path = take 400 (iterate (oneStep 0.02) (Photon x v))
          h0 = angularMomentum (Photon x v)
       in -- Down to the horizon: nothing is followed beyond it.
          conjoin
            [ nearXYZ (1e-12 * (1 + XYZ.norm h0)) h0 (angularMomentum p)
              | p <- takeWhile ((> 1) . XYZ.norm . photonPosition) path
            ]
    it "the energy error falls fourfold when the step is halved" $ do
      let errors = [energyError 3.2 l | l <- [0.1, 0.05, 0.025, 0.0125]]
      mapM_ (`shouldBeWithin` (0.4, 4)) (zipWith (/) errors (drop 1 errors))
    it "so does the error of the direction in which light leaves" $ do
      let errors =
            [XYZ.distance (directionBy (EqualSteps l)) (exactDirection 5) | l <- [0.2, 0.1, 0.05]]
      mapM_ (`shouldBeWithin` (0.4, 4)) (zipWith (/) errors (drop 1 errors))
  describe "time reversal" $
    prop "equal steps forwards, then backwards, lead home" $ \(Outside x) (Direction v) ->
      let Photon x1 v1 = fixedSteps 300 0.02 (Photon x v)
          Photon x2 v2 = fixedSteps 300 0.02 (Photon x1 (XYZ.negated v1))
          closest =
            minimum
              (map (XYZ.norm . photonPosition) (take 300 (iterate (oneStep 0.02) (Photon x v))))
       in -- Near the centre rounding errors are amplified without bound.
          closest > 1.2 ==> nearXYZ 1e-9 x x2 .&&. nearXYZ 1e-9 v (XYZ.negated v2)
  describe "fates" $ do
    modifyMaxSuccess (const 40) $
      prop "captured exactly below b_c" $
        forAll (inRange 0.05 12) $ \b ->
          abs (b - criticalImpactParameter) > 1e-2
            ==> case fateOf (aimedAt b) of
              Captured -> b < criticalImpactParameter
              Escaped _ -> b > criticalImpactParameter
              _ -> False
    it "a photon that never gets away runs out of steps" $
      fateAfter 50 (Photon (XYZ 0 0 1.5) (XYZ 1 0 0)) `shouldBe` StepLimit
    it "what hides everything ends the path" $
      followedFate
        (followLeapfrog defaultLeapfrog Schwarzschild everywhere (aimedAt 5) (\() _ -> Stop ()) ())
        `shouldBe` Opaque
    it "escapes in the direction of the closed form" $
      XYZ.distance (directionBy reportStepRule) (exactDirection 5) `shouldBeWithin` (2e-4, 0)
    prop "without gravity rays are straight" $ \(Outside x) (Direction v) ->
      case followedFate
        (followLeapfrog defaultLeapfrog Flat emptyRegion (Photon x v) (\() _ -> Continue ()) ()) of
        Escaped d -> nearXYZ 1e-12 d v
        Captured -> property (XYZ.norm (XYZ.cross x v) < 1 && XYZ.dot x v < 0)
        other -> counterexample (show other) False
  describe "the hot loop" $
    it "allocates nothing per step" . whenOptimised $ do
      let steps limit =
            followedSteps
              ( followLeapfrog
                  defaultLeapfrog {leapfrogSteps = EqualSteps 1e-4, leapfrogStepLimit = limit}
                  Schwarzschild
                  emptyRegion
                  (aimedAt 5)
                  (\() _ -> Continue ())
                  ()
              )
      few <- allocatedBytes (steps 1000)
      many <- allocatedBytes (steps 100000)
      (many - few) `shouldSatisfy` (< 100000)

-- | A photon of unit energy at r = 30 with the impact parameter @b@, on its
-- way in, in the plane y = 0.
aimedAt :: Double -> Photon
aimedAt b = Photon (XYZ p 0 (sqrt (900 - p * p))) (XYZ 0 0 (negate speed))
  where
    -- v|² = 1 + h²/r³ and h = b.
    speed = sqrt (1 + b * b / 27000)
    p = b / speed

-- | Where that photon escapes to at b = 5, by leapfrog.
directionBy :: StepRule -> XYZ
directionBy rule =
  case followedFate
    ( followLeapfrog
        defaultLeapfrog {leapfrogSteps = rule, leapfrogSkyRadius = 400}
        Schwarzschild
        emptyRegion
        (aimedAt 5)
        (\() _ -> Continue ())
        ()
    ) of
    Escaped d -> d
    _ -> XYZ.zero

-- | Where it escapes to by the closed form.
exactDirection :: Double -> XYZ
exactDirection b = case orbitFate path of
  Escaped _ -> XYZ (sin (alpha + orbitSweep path)) 0 (cos (alpha + orbitSweep path))
  _ -> XYZ.zero
  where
    path = orbit 30 radial b'
    Photon x@(XYZ px _ pz) v = aimedAt b
    alpha = atan2 px pz
    radial = XYZ.dot x v / 30
    b' = b / 30

fateOf :: Photon -> Fate XYZ
fateOf = fateAfter 200000

fateAfter :: Int -> Photon -> Fate XYZ
fateAfter limit photon =
  followedFate
    ( followLeapfrog
        defaultLeapfrog {leapfrogStepLimit = limit}
        Schwarzschild
        emptyRegion
        photon
        (\() _ -> Continue ())
        ()
    )

everywhere :: Region
everywhere = Region 1e9 0 1e9 0 1 1 1

oneStep :: Double -> Photon -> Photon
oneStep dt p = leapfrogStep Schwarzschild (XYZ.normSquared (angularMomentum p)) dt p

fixedSteps :: Int -> Double -> Photon -> Photon
fixedSteps count dt start = go count start
  where
    h2 = XYZ.normSquared (angularMomentum start)
    go :: Int -> Photon -> Photon
    go 0 !p = p
    go n !p = go (n - 1) (leapfrogStep Schwarzschild h2 dt p)

-- | Greatest energy error along a path past the hole, by the report's rule.
energyError :: Double -> Double -> Double
energyError b l = go start 0
  where
    start = aimedAt b
    e0 = pseudoEnergy start
    h2 = XYZ.normSquared (angularMomentum start)
    go :: Photon -> Double -> Double
    go !p !worst
      | XYZ.norm (photonPosition p) > 31 = worst
      | otherwise =
        let dt = stepLength (ReportSteps l 0.01) (photonPosition p) / XYZ.norm (photonVelocity p)
            p' = leapfrogStep Schwarzschild h2 dt p
         in go p' (max worst (abs (pseudoEnergy p' - e0)))
