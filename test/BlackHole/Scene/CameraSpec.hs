module BlackHole.Scene.CameraSpec (spec) where

import BlackHole.Physics.Angle
import BlackHole.Scene.Camera
import BlackHole.Vector.XY (XY (..))
import BlackHole.Vector.XYZ (XYZ (..))
import qualified BlackHole.Vector.XYZ as XYZ
import Support.Approx
import Support.Generators
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck

spec :: Spec
spec = do
  it "stands at r·(0, cos i, sin i) at azimuth 90°" $
    XYZ.distance (posePosition (Around 20 (Degrees 80) (Degrees 90))) (XYZ 0 (20 * cos (80 * pi / 180)) (20 * sin (80 * pi / 180)))
      `shouldBeWithin` (1e-14, 0)
  it "has +x to its right there, and the axis up" $
    case cameraFrame (Camera (Around 20 (Degrees 90) (Degrees 90)) (Degrees 0) (Degrees 40)) of
      Just (Frame f r u) -> mapM_ (\(a, b) -> XYZ.distance a b `shouldBeWithin` (1e-15, 0)) [(f, XYZ 0 0 (-1)), (r, XYZ 1 0 0), (u, XYZ 0 1 0)]
      Nothing -> expectationFailure "no frame"
  prop "has perpendicular unit axes, over the poles too" $
    forAll ((,,) <$> elements [0, 30, 90, 180] <*> inRange 0 360 <*> inRange (-180) 180) $ \(i, a, roll) ->
      case cameraFrame (Camera (Around 9 (Degrees i) (Degrees a)) (Degrees roll) (Degrees 40)) of
        Just (Frame f r u) ->
          nearXYZ 1e-12 (XYZ.cross r f) u .&&. conjoin [closeTo 1e-12 1 (XYZ.norm v) | v <- [f, r, u]]
        Nothing -> property False
  prop "looking at the hole from a place agrees with standing around it" $
    forAll ((,) <$> inRange 5 175 <*> inRange 0 360) $ \(i, a) ->
      let pose = Around 7 (Degrees i) (Degrees a)
          frame p = cameraFrame (Camera p (Degrees 17) (Degrees 40))
       in case (frame pose, frame (LookAt (posePosition pose) XYZ.zero)) of
            (Just (Frame f r u), Just (Frame f' r' u')) ->
              conjoin [nearXYZ 1e-9 p q | (p, q) <- [(f, f'), (r, r'), (u, u')]]
            _ -> property False
  it "turns clockwise with positive roll: its up vector leans to the right" $
    case cameraFrame (Camera (Around 20 (Degrees 90) (Degrees 90)) (Degrees 90) (Degrees 40)) of
      Just (Frame _ _ u) -> XYZ.distance u (XYZ 1 0 0) `shouldBeWithin` (1e-15, 0)
      Nothing -> expectationFailure "no frame"
  it "looks nowhere along its own up vector or at its own place" $
    map
      (\target -> cameraFrame (Camera (LookAt (XYZ 0 5 0) target) (Degrees 0) (Degrees 40)))
      [XYZ 0 0 0, XYZ 0 9 0, XYZ 0 5 0]
      `shouldBe` [Nothing, Nothing, Nothing]
  it "spans the field of view between the picture's left and right edge" $
    let camera = Camera (Around 20 (Degrees 70) (Degrees 30)) (Degrees 5) (Degrees 63)
     in case cameraFrame camera of
          Just frame ->
            let sight = sightDirection (picturePlane camera (Picture 320 180) frame)
                angle = acos (XYZ.dot (sight (XY 0 90)) (sight (XY 320 90)))
             in angle `shouldBeWithin` (1e-12, 63 * pi / 180)
          Nothing -> expectationFailure "no frame"
  it "has square pixels and its first row on top" $
    let camera = Camera (Around 20 (Degrees 90) (Degrees 90)) (Degrees 0) (Degrees 63)
     in case cameraFrame camera of
          Just frame ->
            let sight = sightDirection (picturePlane camera (Picture 320 180) frame)
                XYZ _ above _ = sight (XY 160 0)
                XYZ right _ _ = sight (XY 250 90)
             in above `shouldBeWithin` (1e-12, right)
          Nothing -> expectationFailure "no frame"
