module BlackHole.Scene.CameraSpec (spec) where

import BlackHole.Numeric.Angle
import BlackHole.Scene.Camera
import BlackHole.Vector.XY (XY (..))
import BlackHole.Vector.XYZ (XYZ (..), (*^), (^-^))
import qualified BlackHole.Vector.XYZ as XYZ
import Data.Maybe (fromMaybe)
import Support.Approx
import Support.Generators
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck

spec :: Spec
spec = do
  it "stands at r·(0, cos i, sin i) at azimuth 90°" $
    XYZ.distance
      (posePosition (Around 20 (Degrees 80) (Degrees 90)))
      (XYZ 0 (20 * cos (80 * pi / 180)) (20 * sin (80 * pi / 180)))
      `shouldBeWithin` (1e-14, 0)
  it "has +x to its right there, and the axis up" $
    case cameraFrame (Camera (Around 20 (Degrees 90) (Degrees 90)) (Degrees 0) (Degrees 40)) of
      Just (Frame f r u) ->
        mapM_
          (\(a, b) -> XYZ.distance a b `shouldBeWithin` (1e-15, 0))
          [(f, XYZ 0 0 (-1)), (r, XYZ 1 0 0), (u, XYZ 0 1 0)]
      Nothing -> expectationFailure "no frame"
  prop "has perpendicular unit axes, over the poles too" $
    forAll ((,,) <$> elements [0, 30, 90, 180] <*> inRange 0 360 <*> inRange (-180) 180) $
      \(i, a, roll) ->
        case cameraFrame (Camera (Around 9 (Degrees i) (Degrees a)) (Degrees roll) (Degrees 40)) of
          Just (Frame f r u) ->
            nearXYZ 1e-12 (XYZ.cross r f) u
              .&&. conjoin [closeTo 1e-12 1 (XYZ.norm v) | v <- [f, r, u]]
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
            let sight =
                  fromMaybe XYZ.zero
                    . sightDirection (picturePlane Perspective camera (Picture 320 180) frame)
                angle = acos (XYZ.dot (sight (XY 0 90)) (sight (XY 320 90)))
             in angle `shouldBeWithin` (1e-12, 63 * pi / 180)
          Nothing -> expectationFailure "no frame"
  it "has square pixels and its first row on top" $
    let camera = Camera (Around 20 (Degrees 90) (Degrees 90)) (Degrees 0) (Degrees 63)
     in case cameraFrame camera of
          Just frame ->
            let sight =
                  fromMaybe XYZ.zero
                    . sightDirection (picturePlane Perspective camera (Picture 320 180) frame)
                XYZ _ above _ = sight (XY 160 0)
                XYZ right _ _ = sight (XY 250 90)
             in above `shouldBeWithin` (1e-12, right)
          Nothing -> expectationFailure "no frame"
  describe "the fisheye" $ do
    it "has angles in proportion to the distance from the middle, and none outside its circle" $
      do
        let sight = fisheye 360
            fromAxis x = maybe (-1) (acos . XYZ.dot (XYZ 0 0 (-1))) (sight (XY (100 + x) 100))
        map fromAxis [0, 25, 50, 100]
          `shouldSatisfy` near 1e-7 [0, pi / 4, pi / 2, pi]
        sight (XY 100 200.01) `shouldBe` Nothing
        sight (XY 20 20) `shouldBe` Nothing
    it "has right on the right and its first row on top" $ do
      fmap (\(XYZ x _ _) -> x > 0.5) (fisheye 180 (XY 150 100)) `shouldBe` Just True
      fmap (\(XYZ _ y _) -> y > 0.5) (fisheye 180 (XY 100 50)) `shouldBe` Just True
  describe "the equirectangular picture" $ do
    it "goes once around, with the poles above and below" $ do
      fmap (XYZ.distance (XYZ 0 0 (-1))) (sphere (XY 200 100)) `shouldSatisfy` maybe False (< 1e-12)
      fmap (XYZ.distance (XYZ 1 0 0)) (sphere (XY 300 100)) `shouldSatisfy` maybe False (< 1e-12)
      fmap (XYZ.distance (XYZ 0 1 0)) (sphere (XY 77 0)) `shouldSatisfy` maybe False (< 1e-12)
    prop "continues beyond its edges: around the sphere and over the poles" $
      forAll ((,) <$> inRange 0 400 <*> inRange 0 200) $ \(x, y) ->
        conjoin
          [ maybe (property False) (uncurry (nearXYZ 1e-12)) ((,) <$> sphere a <*> sphere b)
            | (a, b) <-
                [ (XY x y, XY (x + 400) y),
                  (XY x (-y), XY (x + 200) y),
                  (XY x (200 + y), XY (x + 200) (200 - y))
                ]
          ]
  prop "all projections agree around the line of sight, to the second order" $
    forAll ((,) <$> inRange (-1) 1 <*> inRange (-1) 1) $ \(x, y) ->
      -- Pixels of a milliradian.
      let middle projection fov = view projection fov (Picture 200 200) (XY (100 + x) (100 + y))
          flat = middle Perspective (2 * atan 0.1 * 180 / pi)
       in conjoin
            [ maybe
                (property False)
                (uncurry (nearXYZ 1e-8))
                ((,) <$> flat <*> middle p (0.2 * 180 / pi))
              | p <- [Fisheye, Equirectangular]
            ]
  prop "beside a direction a pixel has the same size and shape everywhere on a dome or sphere" $
    forAll
      ((,,) <$> elements [(Fisheye, 200), (Equirectangular, 400)] <*> inRange 1 99 <*> inRange 1 99)
      $ \((projection, width), x, y) ->
        let at dx dy =
              planeOf projection 360 (Picture width 200) >>= \plane ->
                sightBeside plane (XY (fromIntegral width / 2 + 0.6 * x) (100 + 0.6 * y)) (XY dx dy)
         in case (at 0 0, at 0.01 0, at 0 0.01) of
              (Just d, Just right, Just below) ->
                let a = 100 *^ (right ^-^ d)
                    b = 100 *^ (below ^-^ d)
                    size = 2 * pi / fromIntegral width
                 in conjoin
                      [ closeTo 1e-4 size (XYZ.norm a),
                        closeTo 1e-4 size (XYZ.norm b),
                        property (abs (XYZ.dot a b) < 1e-5 * size),
                        closeTo 1e-4 (size * size) (XYZ.dot d (XYZ.cross a b))
                      ]
              _ -> property False
  where
    fisheye fov = view Fisheye fov (Picture 200 200)
    sphere = view Equirectangular 360 (Picture 400 200)
    view projection fov picture point = planeOf projection fov picture >>= (`sightDirection` point)
    planeOf projection fov picture =
      let camera = Camera (Around 20 (Degrees 90) (Degrees 90)) (Degrees 0) (Degrees fov)
       in picturePlane projection camera picture <$> cameraFrame camera
    near bound expected actual =
      length expected == length actual
        && and (zipWith (\a b -> abs (a - b) < bound) expected (actual :: [Double]))
