-- | Depth of field.
module BlackHole.Trace.LensSpec (spec) where

import BlackHole.Light.Radiance
import BlackHole.Numeric.Angle
import BlackHole.Scene.Camera
import BlackHole.Scene.Field.Kind (Value (..))
import BlackHole.Scene.Preset
import BlackHole.Scene.Scene
import BlackHole.Scene.Setting
import BlackHole.Scene.Sky
import BlackHole.Scene.Validate
import BlackHole.Spacetime.Observer
import BlackHole.Spacetime.Photon
import BlackHole.Spacetime.Types
import BlackHole.Trace.Ray
import BlackHole.Trace.Tracer
import BlackHole.Vector.XY (XY (..))
import BlackHole.Vector.XYZ ((*^), (^+^), (^-^))
import qualified BlackHole.Vector.XYZ as XYZ
import Support.Approx
import Support.Generators
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck

spec :: Spec
spec = do
  prop "draws the rays through every part of the lens to one point at the distance of focus" $
    forAll point $ \at@(XY x y) ->
      case (rayThrough flat at, cameraFrame (sceneCamera flat)) of
        (Just (Photon start direction), Just (Frame forward right up)) ->
          -- 160 pixels are 40 degrees.
          let perPixel = 2 * tan (20 * pi / 180) / 160
              target =
                place flat ^+^ 30
                  *^ (forward ^+^ ((x - 80) * perPixel) *^ right ^+^ ((45 - y) * perPixel) *^ up)
              toTarget = target ^-^ start
              miss =
                toTarget ^-^ (XYZ.dot toTarget direction / XYZ.dot direction direction) *^ direction
           in counterexample (show miss) (XYZ.norm miss < 0.02)
        _ -> property False
  it "spreads the rays evenly over the lens, on the sphere through its middle" $ do
    let starts =
          [ photonPosition' p
            | x <- [0.5 .. 39.5],
              y <- [0.5 .. 39.5],
              Just p <- [rayThrough flat (XY (x + 60) (y + 25))]
          ]
        squares = [XYZ.dot d d | start <- starts, let d = start ^-^ place flat]
    length starts `shouldBe` 1600
    maximum squares `shouldSatisfy` \m -> m > 0.9 && m < 1.02
    (sum squares / 1600) `shouldBeWithin` (0.03, 0.5)
    mapM_ (\start -> XYZ.norm start `shouldBeWithin` (1e-9, 50)) starts
  prop "leaves the sky sharp when it is focused on infinity" $
    forAll point $ \at ->
      let far =
            curved
              { sceneFocus = 1e9,
                sceneSpacetime = Flat,
                sceneDisk = Nothing,
                sceneSky = SkyGrid
              }
          -- The ball of the hole is near, and so are its edges.
          XY x y = at
       in (x - 80) ^ (2 :: Int) + (y - 45) ^ (2 :: Int) > 400
            ==> lightAt far at === lightAt far {sceneAperture = 0} at
  prop "sees the light of exact paths from wherever it is in the lens" $
    forAll point $ \at ->
      case ( lightAt curved {sceneDisk = Nothing, sceneSky = SkyUniform 1} at,
             lightAt
               curved
                 { sceneDisk = Nothing,
                   sceneSky = SkyUniform 1,
                   sceneIntegrator = Exact
                 }
               at
           ) of
        (Just (Radiance r _ _), Just (Radiance r' _ _)) -> closeTo 1e-6 r' r
        _ -> property False
  it "blurs what is out of focus, and not what is in focus" $ do
    -- The edge of the hole's ball, 50 away, under rays through the whole lens.
    let edge distance =
          let shown =
                [ r < 0.5 | y <- [0, 0.01 .. 20 :: Double], Just (Radiance r _ _) <-
                                                              [ lightAt
                                                                  flat
                                                                    { sceneFocus =
                                                                        distance,
                                                                      sceneDisk = Nothing,
                                                                      sceneSky = SkyUniform 1
                                                                    }
                                                                  (XY 80 (25 + y))
                                                              ]
                ]
           in length (filter id (zipWith (/=) shown (drop 1 shown)))
    edge 50 `shouldSatisfy` \n -> n > 0 && n < 20
    edge 15 `shouldSatisfy` (> 100)
  it "focuses on the hole unless told otherwise, and refuses what has no effect" $ do
    let focused settings =
          sceneFocus $
            applySettings [Setting path (NumberValue v) | (path, v) <- settings] defaultScene
    focused [("camera.aperture", 2), ("camera.distance", 20)] `shouldBeWithin` (1e-9, 20)
    focused [("camera.focus", 7), ("camera.aperture", 2)] `shouldBe` 7
    map problemOption (validateScene flat {sceneAperture = 60}) `shouldBe` ["--aperture"]
  where
    point = XY <$> inRange 0 160 <*> inRange 0 90
    curved =
      defaultScene
        { scenePicture = Picture 160 90,
          sceneCamera = Camera (Around 50 (Degrees 70) (Degrees 90)) (Degrees 0) (Degrees 40),
          sceneAperture = 2,
          sceneFocus = 30
        }
    flat = curved {sceneSpacetime = Flat}
    place scene = posePosition (cameraPose (sceneCamera scene))
    rayThrough scene at =
      tracer scene >>= \traced -> tracedSight (throughLens traced at) at >>= sightPhoton
    photonPosition' (Photon start _) = start
    lightAt scene at = (`sightRadiance` at) <$> tracer scene
