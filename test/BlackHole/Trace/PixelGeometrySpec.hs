module BlackHole.Trace.PixelGeometrySpec (spec) where

import BlackHole.Matter.GasFlow
import BlackHole.Matter.Redshift
import BlackHole.Numeric.Angle (Degrees (..))
import BlackHole.Scene.Camera
import BlackHole.Scene.Disk
import BlackHole.Scene.Preset
import BlackHole.Scene.Scene
import BlackHole.Spacetime.Follow
import BlackHole.Spacetime.Observer
import BlackHole.Spacetime.Photon
import BlackHole.Spacetime.PlaneCrossing
import BlackHole.Spacetime.Types
import BlackHole.Trace.PixelGeometry
import BlackHole.Trace.Tracer
import BlackHole.Vector.XY (XY (..))
import BlackHole.Vector.XYZ (XYZ (..))
import qualified BlackHole.Vector.XYZ as XYZ
import Control.Monad (forM_, void)
import Data.List (find)
import Support.Approx
import Support.IndependentOrbit
import Test.Hspec

spec :: Spec
spec = do
  it "has the redshift of circling gas by its radius alone, seen from the axis" $ do
    -- Of no angular momentum about the axis: ν_em is E∞ u^t.
    let hits =
          [ hit
            | Just look <- [pixelGeometry faceOn],
              (x, y) <- pixels faceOn,
              Just hit <- [geometryDiskHit (look x y)]
          ]
    length hits `shouldSatisfy` (> 1000)
    minimum (map crossingRadius hits) `shouldSatisfy` (\r -> r >= 3 && r < 3.3)
    maximum (map crossingRadius hits) `shouldSatisfy` (\r -> r <= 16 && r > 15.7)
    forM_ hits $ \(PlaneCrossing r _ g) ->
      g `shouldBeWithin` (1e-7, sqrt (1 - 1.5 / r) / sqrt (1 - 1 / 30))
  it "is the same on both sides of a picture from the axis" $
    case pixelGeometry faceOn of
      Nothing -> expectationFailure "no camera"
      Just look -> forM_ (pixels faceOn) $ \(x, y) ->
        forM_ [look (63 - x) y, look x (35 - y)] $ \mirrored -> do
          let here = look x y
          void (geometryDiskHit here) `shouldBe` void (geometryDiskHit mirrored)
          maybe 0 crossingRadius (geometryDiskHit here)
            `shouldBeWithin` (1e-6, maybe 0 crossingRadius (geometryDiskHit mirrored))
  it "is deflected as the orbit integrated by brute force" $ do
    angles <- concat <$> mapM compared [faceOn, tilted, ringClose]
    length angles `shouldSatisfy` (> 1500)
    -- Some of it all round the hole.
    maximum angles `shouldSatisfy` (> 5)
  it "meets the disk where the closed form does, with its redshift" $
    forM_ [tilted, tilted {sceneObserver = Orbiting}, tilted {sceneObserver = Falling}, flat] $
      \scene ->
        case (pixelGeometry scene, tracer scene) of
          (Just look, Just traced) -> do
            met <- concat <$> mapM (againstCrossings scene look traced) (pixels scene)
            length met `shouldSatisfy` (> 300)
          _ -> expectationFailure "no camera"
  it "is not bent where there is no gravity, and has no deflection in the shadow" $ do
    case pixelGeometry flat of
      Just look ->
        mapM_
          (\(x, y) -> forM_ (geometryDeflection (look x y)) (`shouldBeWithin` (1e-12, 0)))
          (pixels flat)
      Nothing -> expectationFailure "no camera"
    fmap (\look -> geometryDeflection (look 32 18)) (pixelGeometry faceOn) `shouldBe` Just Nothing
  it "has no disk where there is none" $
    fmap
      (\look -> map (geometryDiskHit . uncurry look) (pixels tilted))
      (pixelGeometry tilted {sceneDisk = Nothing})
      `shouldBe` Just (map (const Nothing) (pixels tilted))
  where
    tilted = defaultScene {scenePicture = Picture 64 36}
    flat = tilted {sceneSpacetime = Flat}
    faceOn = seen 0 70
    -- The photon ring fills the picture's middle row.
    ringClose = seen 60 11.2
    seen inclination width =
      tilted
        { sceneCamera =
            (sceneCamera tilted)
              { cameraPose = Around 30 (Degrees inclination) (Degrees 90),
                cameraFieldOfView = Degrees width
              }
        }
    pixels scene =
      let Picture w h = scenePicture scene in [(x, y) | y <- [0 .. h - 1], x <- [0 .. w - 1]]
    middle (x, y) = XY (fromIntegral x + 0.5) (fromIntegral y + 0.5)
    compared scene = case (pixelGeometry scene, tracer scene) of
      (Just look, Just traced) ->
        concat <$> mapM (againstBruteForce look traced) (filter (even . fst) (pixels scene))
      _ -> [] <$ expectationFailure "no camera"
    againstBruteForce look traced pixel =
      case (geometryDeflection (uncurry look pixel), tracedSight traced (middle pixel)) of
        (Just deflection, Just (SightLine (Photon place velocity) _)) -> do
          let r = XYZ.norm place
              radial = XYZ.dot velocity place / r
              tangential = XYZ.norm (XYZ.cross place velocity) / r
          case independentFate (1 / r) (negate radial / (r * tangential)) of
            LeavesAfter swept ->
              [deflection] <$ deflection `shouldBeWithin` (1e-5, swept - atan2 tangential radial)
            other -> [] <$ expectationFailure (show (pixel, deflection, other))
        _ -> pure []
    againstCrossings scene look traced pixel = do
      let inDisk crossing =
            maybe
              False
              ( \disk ->
                  crossingRadius crossing >= diskInnerRadius disk
                    && crossingRadius crossing <= diskOuterRadius disk
              )
              (sceneDisk scene)
          closed = tracing (sceneSpacetime scene) InClosedForm (XYZ 1 0 0)
          expected = tracedSight traced (middle pixel) >>= find inDisk . planeCrossings closed
      case (geometryDiskHit (uncurry look pixel), expected) of
        (Just (PlaneCrossing r _ g), Just crossing) -> do
          r `shouldBeWithin` (1e-4, crossingRadius crossing)
          forM_
            ( tracedSight traced (middle pixel) >>= \sight ->
                crossingRedshift (gasFlow (sceneSpacetime scene)) sight crossing
            )
            $ \shift -> g `shouldBeWithin` (1e-5, redshiftFactor shift)
          pure [r]
        (Nothing, Nothing) -> pure []
        other -> [] <$ expectationFailure (show (pixel, other))
