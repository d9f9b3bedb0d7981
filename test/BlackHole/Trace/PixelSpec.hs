module BlackHole.Trace.PixelSpec (spec) where

import BlackHole.Light.Radiance
import BlackHole.Numeric.Angle
import BlackHole.Scene.Camera
import BlackHole.Scene.Disk
import BlackHole.Scene.Preset
import BlackHole.Scene.Scene
import BlackHole.Scene.Sky
import BlackHole.Spacetime.LightPath
import BlackHole.Spacetime.Observer
import BlackHole.Spacetime.Types
import BlackHole.Trace.PhotonRing
import BlackHole.Trace.Ray
import BlackHole.Trace.Tracer
import BlackHole.Vector.XY (XY (..))
import Control.Exception (evaluate)
import Data.Int (Int64)
import Data.Maybe (isJust)
import Support.Allocation (allocatedBytes, whenOptimised)
import Support.Approx
import Support.Generators
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess, prop)
import Test.QuickCheck

spec :: Spec
spec = do
  describe "a uniform sky" $ do
    prop "is uniform everywhere outside the shadow (Liouville)" $
      forAll
        ((,,) <$> inRange 1.8 60 <*> inRange 1 179 <*> elements [Static, Falling, Coordinate])
        $ \(r, i, observer) ->
          forAll ((,) <$> inRange 0 64 <*> inRange 0 36) $ \(x, y) ->
            let bare = (uniform 0.7) {sceneObserver = observer, sceneCamera = looking r i}
                shift = case observer of
                  -- For an observer who falls the sky's shift depends on the
                  -- direction; this test is about its intensity.
                  Falling -> Nothing
                  Static -> Just ((1 - 1 / r) ** (-2))
                  _ -> Just 1
             in case (shift, light bare (XY x y)) of
                  (_, Radiance 0 0 0) -> property True
                  (Just g4, Radiance v _ _) -> closeTo (1e-9 * g4) (0.7 * g4) v
                  (Nothing, Radiance v _ _) -> property (v > 0 && not (isInfinite v))
    it "shows a shadow of the size Synge computed" $
      sequence_
        [ shadowAngle r `shouldBeWithin` (1e-4, asin (sqrt (6.75 * (1 - 1 / r)) / r))
          | r <- [6, 20]
        ]
    it "has no shadow but a ball without gravity" $ do
      let bare = (uniform 1) {sceneSpacetime = Flat, sceneCamera = looking 10 90}
      light bare (XY 32 18) `shouldBe` black
      light bare (XY 1 1) `shouldBe` grey 1
  describe "both integrators" $
    modifyMaxSuccess (const 25) $
      prop "agree on smooth thin gas" $
        forAll ((,) <$> inRange 8 30 <*> inRange 20 85) $ \(r, i) ->
          forAll ((,) <$> inRange 0 64 <*> inRange 0 36) $ \(x, y) ->
            let smooth = (uniform 0.3) {sceneCamera = looking r i, sceneDisk = Just gas}
                gas = reportDisk {diskArms = 0, diskThickness = 0.1, diskBrightness = 1}
                a = luminance (light smooth (XY x y))
                b =
                  luminance
                    (light smooth {sceneIntegrator = Leapfrogging, sceneStep = 0.02} (XY x y))
             in -- At the edge of the shadow the smallest error decides all.
                a > 0.25 && b > 0.25 ==> closeTo 0.02 b a
  prop "no ray of the presets has a radiance that is not finite or negative" $
    forAll ((,) <$> inRange 0 64 <*> inRange 0 36) $ \(x, y) ->
      conjoin
        [ counterexample (name ++ " " ++ show l) (isFiniteRadiance l && luminance l >= 0)
          | (name, seen) <- lights,
            let l = seen (XY x y)
        ]

  it "shows the same light with the tables of an earlier scene" $ do
    let first = defaultScene {scenePicture = Picture 64 36, sceneSamples = 1}
        changed how =
          ( first
              { sceneCamera =
                  (sceneCamera first) {cameraPose = Around 54 (Degrees 60) (Degrees 200)}
              }
          )
            { sceneSamples = how
            }
        others =
          [ changed 1,
            (changed 4) {scenePicture = Picture 32 18},
            (changed 1)
              { sceneCamera =
                  (sceneCamera first) {cameraPose = Around 20 (Degrees 60) (Degrees 200)}
              },
            (changed 1) {sceneSeed = 7},
            (changed 1) {sceneSky = SkyGrid},
            (changed 1) {sceneDisk = Nothing},
            (changed 1) {sceneDisk = Just reportDisk},
            (changed 1) {sceneDebugTextures = True},
            (changed 1) {sceneSpacetime = Flat}
          ]
        points = [XY x y | x <- [3, 9 .. 32], y <- [2, 5 .. 18]]
    sequence_
      [ case (tracer first, tracer scene) of
          (Just earlier, Just fresh)
            -- Its tables have been made.
            | luminance (sightRadiance earlier (XY 30 20)) >= 0,
              Just taken <- tracerAfter earlier Nothing scene ->
              sequence_
                [ luminance (sightRadiance taken point)
                    `shouldBeWithin` (1e-9, luminance (sightRadiance fresh point))
                  | point <- points
                ]
          _ -> expectationFailure "no tracer"
        | scene <- others
      ]
  it "knows the pixels on the edge of the shadow" $
    sequence_
      [ do
          let traced =
                tracer
                  defaultScene
                    { scenePicture = Picture 640 360,
                      sceneCamera = looking r 80,
                      sceneObserver = observer
                    }
              alpha = case observer of
                -- What an observer at rest sees, by aberration.
                Falling -> 2 * atan (tan (0.5 * atRest) * sqrt ((1 - beta) / (1 + beta)))
                _ -> atRest
              atRest = asin (sqrt (6.75 * (1 - 1 / r)) / r)
              beta = sqrt (1 / r)
              edge = 320 + 320 * tan alpha / tan (30 * pi / 180)
              found offset =
                maybe False (\t -> isJust (photonRing t (XY (edge + offset) 180))) traced
          map found [-20, -4, -0.5, 0, 0.5, 4, 20]
            `shouldBe` [False, False, True, True, True, False, False]
        | r <- [6, 20, 80],
          observer <- [Static, Falling]
      ]
  it "leaves nothing behind for a segment of gas" . whenOptimised $
    case tracer defaultScene {sceneSky = SkyNone} of
      Nothing -> expectationFailure "no scene"
      Just traced -> do
        let segments point =
              maybe
                0
                (\sight -> followedSteps (followSight traced point sight (\() _ -> Continue ()) ()))
                (tracedSight traced point)
            points = [XY x y | x <- [100, 200 .. 1800], y <- [250, 270 .. 830]]
        bytes <- bytesOfRays traced points
        let long = [b | (b, point) <- zip bytes points, segments point >= 16]
        length long `shouldSatisfy` (> 10)
        -- What a ray needs for itself; a segment once took a hundred bytes.
        maximum long `shouldSatisfy` (< 3300)
  it "leaves little on the heap of a ray through empty space" . whenOptimised $
    case tracer defaultScene {sceneDisk = Nothing, sceneSky = SkyGrid} of
      Nothing -> expectationFailure "no scene"
      Just traced -> do
        let points = [XY x y | x <- [100, 300 .. 1200], y <- [50, 90 .. 700]]
        bytes <- bytesOfRays traced points
        -- Its photon, its end and its light. It once was twice as much, and took a
        -- tenth more time.
        maximum bytes `shouldSatisfy` (< 360)

-- | What each preset shows at a point. The tracers are made once for all cases.
lights :: [(String, XY -> Radiance)]
lights = [(name, light preset {scenePicture = Picture 64 36}) | (name, preset) <- presets]

-- | What the rays through some points leave on the heap, when what they share is made.
bytesOfRays :: Tracer -> [XY] -> IO [Int64]
bytesOfRays traced points = do
  _ <- evaluate (sum [luminance (sightRadiance traced point) | point <- points])
  mapM (allocatedBytes . sightRadiance traced) points

light :: Scene -> XY -> Radiance
light scene = maybe (const (Radiance (0 / 0) 0 0)) sightRadiance (tracer scene)

uniform :: Double -> Scene
uniform v =
  defaultScene
    { scenePicture = Picture 64 36,
      sceneDisk = Nothing,
      sceneSky = SkyUniform v
    }

looking :: Double -> Double -> Camera
looking r i = Camera (Around r (Degrees i) (Degrees 90)) (Degrees 0) (Degrees 60)

-- | Half the angle of the shadow in the picture, by bisection along a row.
shadowAngle :: Double -> Double
shadowAngle r = atan (go 32 64 / 32 * tan (30 * pi / 180))
  where
    bare = (uniform 1) {sceneCamera = looking r 90}
    go :: Double -> Double -> Double
    go dark bright
      | bright - dark < 1e-6 = bright - 32
      | light bare (XY middle 18) == black = go middle bright
      | otherwise = go dark middle
      where
        middle = 0.5 * (dark + bright)
