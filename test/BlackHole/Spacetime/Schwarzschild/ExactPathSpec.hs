module BlackHole.Spacetime.Schwarzschild.ExactPathSpec (spec) where

import BlackHole.Spacetime.Fate
import BlackHole.Spacetime.LightPath
import BlackHole.Spacetime.Observer
import BlackHole.Spacetime.Photon
import BlackHole.Spacetime.Schwarzschild.ExactPath
import BlackHole.Spacetime.Schwarzschild.Leapfrog
import BlackHole.Spacetime.Schwarzschild.Radii (criticalImpactParameter)
import BlackHole.Spacetime.Schwarzschild.StepRule
import BlackHole.Spacetime.Types
import BlackHole.Vector.XYZ (XYZ (..))
import qualified BlackHole.Vector.XYZ as XYZ
import Support.Approx
import Support.Generators
import Support.Segments
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess, prop)
import Test.QuickCheck

spec :: Spec
spec = do
  modifyMaxSuccess (const 60) $ do
    prop "shares its fates with a fine leapfrog" $ \(Outside x) (Direction d) ->
      withSight x d $ \photon ->
        let b = XYZ.norm (angularMomentum photon)
         in abs (b - criticalImpactParameter) > 0.05
              ==> case ( followedFate (exact emptyRegion photon),
                         followedFate (leapfrog 0.02 emptyRegion photon)
                       ) of
                (Escaped a, Escaped c) -> nearXYZ 1e-3 a c
                (a, c) -> a === c
    prop "passes through as much gas as a fine leapfrog" $ \(Outside x) (Direction d) ->
      -- Uniform gas in the region: the total affine length. A segment counts
      -- as a whole or not at all, so each edge may cost half a segment.
      withSight x d $ \photon ->
        let b = XYZ.norm (angularMomentum photon)
         in abs (b - criticalImpactParameter) > 0.05
              ==> let a = followedState (exact slab photon)
                      c = followedState (leapfrog 0.01 slab photon)
                   in closeTo (0.06 + 0.02 * c) c a
    prop "hands out segments with the photon's own h and energy" $ \(Outside x) (Direction d) ->
      withSight x d $ \photon ->
        let segments =
              followedState (followExact Schwarzschild slab photon (\s t -> Continue (t : s)) [])
         in conjoin
              [ belongsTo 1e-8 Schwarzschild photon segment
                | segment <- segments,
                  segmentRadius segment > 1
              ]
  it "follows a photon aimed straight at the hole" $
    followedFate (exact slab (Photon (XYZ 0 5 5) (XYZ 0 (-sqrt 0.5) (-sqrt 0.5))))
      `shouldBe` Captured
  it "and one aimed straight away, by its neighbour within 1e-9 radians" $
    case followedFate (exact slab (Photon (XYZ 0 5 5) (XYZ 0 (sqrt 0.5) (sqrt 0.5)))) of
      Escaped d -> XYZ.distance d (XYZ 0 (sqrt 0.5) (sqrt 0.5)) `shouldBeWithin` (1.1e-9, 0)
      other -> expectationFailure (show other)
  prop
    "without gravity rays are straight, and the gas passed is what geometry says"
    $ \(Outside x) (Direction d) ->
      XYZ.norm (XYZ.cross x d) > 1.01
        ==> case followExact
          Flat
          slab
          (Photon x d)
          (\s t -> Continue (s + segmentAffineLength t))
          0 of
          Followed (Escaped e) len _ -> e === d .&&. closeTo 0.2 (chord x d) len
          Followed other _ _ -> counterexample (show other) False

-- | Length of a ray in the slab |y| ≤ 1 within 12 of the axis.
chord :: XYZ -> XYZ -> Double
chord (XYZ x y z) (XYZ dx dy dz) = max 0 (min t1 s1 - maximum [0, t0, s0])
  where
    (t0, t1) = interval ((-1 - y) / dy) ((1 - y) / dy)
    a = dx * dx + dz * dz
    b = (x * dx + z * dz) / a
    c = (x * x + z * z - 144) / a
    root = sqrt (max 0 (b * b - c))
    (s0, s1) = if b * b < c then (0, 0) else (-b - root, -b + root)
    interval p q = (min p q, max p q)

withSight :: XYZ -> XYZ -> (Photon -> Property) -> Property
withSight x d f = maybe (property Discard) f (sightLine Schwarzschild Static x d >>= sightPhoton)

exact :: Region -> Photon -> Followed Double
exact region photon =
  followExact Schwarzschild region photon (\s t -> Continue (s + segmentAffineLength t)) 0

leapfrog :: Double -> Region -> Photon -> Followed Double
leapfrog l region photon =
  followLeapfrog
    (Leapfrog (EqualSteps l) 100 100000)
    Schwarzschild
    region
    photon
    (\s t -> Continue (s + segmentAffineLength t))
    0

slab :: Region
slab = Region 12 0 1 0 0.004 0.002 1
