module BlackHole.Animation.CameraPathSpec (spec) where

import BlackHole.Animation.CameraPath
import BlackHole.Animation.Interpolate (Interpolation (..))
import BlackHole.Numeric.Angle
import BlackHole.Scene.Camera
import BlackHole.Scene.Preset
import BlackHole.Scene.Scene
import BlackHole.Spacetime.Observer (Observer (..))
import BlackHole.Vector.XYZ (XYZ (..), (^-^))
import qualified BlackHole.Vector.XYZ as XYZ
import Support.Approx
import Support.Generators
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck

spec :: Spec
spec = do
  describe "Orbit" $ do
    it "is right-handed about its axis: a quarter turn about +y leads from +z to +x" $
      place (Orbit (XYZ 0 2 0) 1 Linear) 4 1 (onSphere 20 90 90) `isNear` XYZ 20 0 0
    it "changes the azimuth alone about the disk's axis, and closes" $
      poseAt (Orbit (XYZ 0 (-1) 0) 1 Linear) 2 2 (onSphere 20 80 90)
        `shouldBe` Right (Around 20 (Degrees 80) (Degrees 450))
    prop "keeps the distance to the hole and the angle with any axis, and is periodic" $
      forAll ((,,) <$> direction <*> direction <*> inRange 0 1) $ \(axis, at, s) ->
        let scene = looking (10 `times` at) (XYZ 0 0 0)
            path = Orbit axis 3 Linear
         in case (placeOf <$> poseAt path 1 s scene, placeOf <$> poseAt path 1 (s + 1 / 3) scene) of
              (Right p, Right p') ->
                closeTo 1e-9 10 (XYZ.norm p)
                  .&&. closeTo 1e-9 (10 * XYZ.dot axis at) (XYZ.dot axis p)
                  .&&. nearXYZ 1e-8 p p'
              _ -> property False
    it "is half-way at half-time when eased, and slower at first" $ do
      place (Orbit (XYZ 0 1 0) 1 Eased) 2 1 (onSphere 20 90 90) `isNear` XYZ 0 0 (-20)
      case place (Orbit (XYZ 0 1 0) 1 Eased) 2 0.1 (onSphere 20 90 90) of
        Right (XYZ x _ _) -> x `shouldSatisfy` \v -> v > 0 && v < 20 * sin (2 * pi / 20)
        Left e -> expectationFailure e
  describe "Dolly" $
    it "goes straight from the camera's place to another, and its target too" $ do
      let scene = looking (XYZ 0 5 25) (XYZ 0 0 0)
          path = Dolly (XYZ 10 5 5) (Just (XYZ 0 2 0)) Linear
      poseAt path 8 0 scene `shouldBe` Right (LookAt (XYZ 0 5 25) (XYZ 0 0 0))
      poseAt path 8 2 scene `shouldBe` Right (LookAt (XYZ 2.5 5 20) (XYZ 0 0.5 0))
      poseAt path 8 8 scene `shouldBe` Right (LookAt (XYZ 10 5 5) (XYZ 0 2 0))
  describe "FreeFall" $ do
    it "follows r^{3/2} = r₀^{3/2} − 3τ/2 through the horizon, with the falling observer" $ do
      let fall = alongPath (FreeFall (ProperTimePerSecond 2)) 100
      fmap sceneObserver (fall 1 (onSphere 9 80 90)) `shouldBe` Right Falling
      case fall (26 / 3) (onSphere 9 80 90) of
        Right scene
          | Around r i a <- cameraPose (sceneCamera scene) ->
            (r `shouldBeWithin` (1e-13, 1)) >> ((i, a) `shouldBe` (Degrees 80, Degrees 90))
        _ -> expectationFailure "no such scene"
      either (const True) (const False) (fall 9 (onSphere 9 80 90)) `shouldBe` True
    it "ends where it is told to" $
      case place (FreeFall (FallsTo 0.5)) 10 10 (onSphere 9 90 90) of
        Right p -> XYZ.norm p `shouldBeWithin` (1e-12, 0.5)
        Left e -> expectationFailure e
    it "keeps the direction of sight" $
      case poseAt (FreeFall (FallsTo 2)) 10 5 (looking (XYZ 0 0 16) (XYZ 3 4 16)) of
        Right (LookAt p t) -> (t ^-^ p) `shouldBe` XYZ 3 4 0
        other -> expectationFailure (show other)
  describe "CircularOrbit" $ do
    it "takes the gas's direction at the geodesic's pace" $ do
      let r = 20
          omega = sqrt (1 / (2 * r * r * r)) / sqrt (1 - 1.5 / r)
      place (CircularOrbit 3) 10 2 (onSphere r 90 90)
        `isNear` XYZ (r * sin (6 * omega)) 0 (r * cos (6 * omega))
      fmap sceneObserver (alongPath (CircularOrbit 1) 10 2 (onSphere r 90 90))
        `shouldBe` Right Orbiting
    it "is refused off the disk's plane and within the photon sphere" $
      map
        (either (const False) (const True) . poseAt (CircularOrbit 1) 10 0)
        [onSphere 20 80 90, onSphere 1.4 90 90]
        `shouldBe` [False, False]
  where
    onSphere r i a = posed (Around r (Degrees i) (Degrees a))
    looking p t = posed (LookAt p t)
    posed p = defaultScene {sceneCamera = (sceneCamera defaultScene) {cameraPose = p}}
    poseAt path duration seconds scene =
      cameraPose . sceneCamera <$> alongPath path duration seconds scene
    placeOf = posePosition
    place path duration seconds scene = placeOf <$> poseAt path duration seconds scene
    isNear found expected = case found of
      Right p -> XYZ.distance p expected `shouldBeWithin` (1e-9, 0)
      Left e -> expectationFailure e
    times k (XYZ x y z) = XYZ (k * x) (k * y) (k * z)
    direction = (\(Direction d) -> d) <$> arbitrary
