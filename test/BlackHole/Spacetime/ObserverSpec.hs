module BlackHole.Spacetime.ObserverSpec (spec) where

import BlackHole.Spacetime.Kerr.Landmarks
import BlackHole.Spacetime.Observer
import BlackHole.Spacetime.Photon
import BlackHole.Spacetime.Schwarzschild.Radii (criticalImpactParameter)
import BlackHole.Spacetime.Types
import BlackHole.Vector.XYZ (XYZ (..), (*^), (^+^))
import qualified BlackHole.Vector.XYZ as XYZ
import Data.Maybe (fromMaybe)
import Support.Approx
import Support.Generators
import Support.KerrReference
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck

spec :: Spec
spec = do
  describe "static" $ do
    it "sees the shadow's edge where Synge does" $
      -- sin²ψ = (27/4)(1 − 1/r)/r²; 45° at r = 3, 14.2690273° at r = 10.
      sequence_
        [ impactAt Static r (psi * pi / 180) `shouldBeWithin` (1e-6, criticalImpactParameter)
          | (r, psi) <- [(3, 45), (10, 14.2690273), (1.5, 90)]
        ]
    prop "b = r sin ψ / √(1 − 1/r)" $
      forAll ((,) <$> inRange 1.01 50 <*> inRange 0 pi) $ \(r, psi) ->
        closeTo (1e-12 * (1 + r)) (r * sin psi / sqrt (1 - 1 / r)) (impactAt Static r psi)
    it "sees the sky blue-shifted" $
      fmap sightFrequency (sightLine Schwarzschild Static (XYZ 0 0 4) (XYZ 0 1 0))
        `shouldSatisfy` maybe False ((< 1e-15) . abs . subtract (1 / sqrt 0.75))
  describe "coordinate" $
    prop "takes the direction for a coordinate direction" $ \(Outside x) (Direction d) ->
      case sightLine Schwarzschild Coordinate x d of
        Just (SightLine (Photon _ v) 1) -> nearXYZ 1e-12 (XYZ.norm v *^ d) v
        other -> counterexample (show other) False
  describe "orbiting" $ do
    it "sees the sky brighter ahead and darker behind" $ do
      -- Speed 1/2 at r = 3: Doppler factors √3 and 1/√3 on the static √(3/2).
      frequencyAt Orbiting (XYZ 0 0 3) (XYZ 1 0 0) `shouldBeWithin` (1e-12, sqrt 1.5 * sqrt 3)
      frequencyAt Orbiting (XYZ 0 0 3) (XYZ (-1) 0 0) `shouldBeWithin` (1e-12, sqrt 1.5 / sqrt 3)
    prop "agrees with his four-velocity on the frequency" $ \(Outside x) (Direction d) ->
      -- ν = −k·u = u^t (E − Ω L), with u^t = 1/√(1 − 3/(2r)), Ω = 1/√(2r³).
      let r = XYZ.norm x
       in case sightLine Schwarzschild Orbiting x d of
            Just (SightLine (Photon _ v) shift) ->
              let n = fromMaybe (XYZ 1 0 0) (XYZ.normalize (XYZ.cross x (XYZ.cross (XYZ 0 1 0) x)))
                  -- The light's angular momentum is the reverse of the photon's.
                  l = negate (XYZ.dot n (XYZ.cross x v))
                  expected = (1 - l / sqrt (2 * r * r * r)) / sqrt (1 - 1.5 / r)
               in closeTo (1e-9 * expected) expected shift
            other -> counterexample (show other) False
    it "cannot be inside the photon sphere" $
      sightLine Schwarzschild Orbiting (XYZ 0 0 1.5) (XYZ 0 1 0) `shouldBe` Nothing
    it "can be down to the photon orbit of a rotating hole" $
      sequence_
        [ observerRange (Kerr hole) observer (pi / 2)
            `shouldBeWithin` (1e-6, photonOrbitRadius handedness hole)
          | (observer, handedness) <- [(Orbiting, RightHanded), (CounterOrbiting, LeftHanded)],
            hole <- map spinOf [0.9, -0.4]
        ]
  describe "falling" $ do
    it "sees the light that follows him red-shifted" $
      frequencyAt Falling (XYZ 0 0 4) (XYZ 0 0 1) `shouldBeWithin` (1e-12, 1 / 1.5)
    it "sees through the horizon outwards" $
      frequencyAt Falling (XYZ 0 0 0.25) (XYZ 0 0 1) `shouldBeWithin` (1e-12, 1 / 3)
    it "sees nothing towards the centre from inside" $
      sightLine Schwarzschild Falling (XYZ 0 0 0.25) (XYZ 0 0 (-1)) `shouldBe` Nothing
    prop "agrees with the static observer through aberration" $ \(Outside x) ->
      -- Boost by β = √(1/r): cos ψ' = (cos ψ + β)/(1 + β cos ψ) for inward ψ.
      forAll (inRange 0.01 3.1) $ \psi ->
        let r = XYZ.norm x
            beta = sqrt (1 / r)
            psi' = acos ((cos psi + beta) / (1 + beta * cos psi))
         in closeTo (1e-7 * r) (impactAt Static r psi) (impactAt Falling r psi')
  describe "every observer" $
    prop "gets photons of unit energy" $ \(Outside x) (Direction d) ->
      conjoin
        [ case sightLine Schwarzschild observer x d of
            Just (SightLine p _) -> closeTo 1e-9 0.5 (pseudoEnergy p)
            _ -> counterexample (show observer) False
          | observer <- [minBound ..]
        ]

-- | The impact parameter an observer at r sees at the angle ψ from inward.
impactAt :: Observer -> Double -> Double -> Double
impactAt observer r psi =
  case sightLine
    Schwarzschild
    observer
    (XYZ 0 0 r)
    (XYZ 0 (sin psi) 0 ^+^ XYZ 0 0 (negate (cos psi))) of
    Just (SightLine p _) -> XYZ.norm (angularMomentum p)
    _ -> 0 / 0

frequencyAt :: Observer -> XYZ -> XYZ -> Double
frequencyAt observer place direction =
  maybe (0 / 0) sightFrequency (sightLine Schwarzschild observer place direction)
