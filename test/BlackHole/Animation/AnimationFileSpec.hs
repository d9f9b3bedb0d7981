module BlackHole.Animation.AnimationFileSpec (spec) where

import BlackHole.Animation.Animation
import BlackHole.Animation.AnimationFile
import BlackHole.Animation.AnimationKeys
import BlackHole.Animation.CameraPath
import BlackHole.Animation.Interpolate
import BlackHole.Numeric.Angle
import BlackHole.Scene.Camera
import BlackHole.Scene.Field.Field (fieldPath)
import BlackHole.Scene.Field.Table (findField, sceneFields)
import BlackHole.Scene.File.Yaml
import BlackHole.Scene.Preset
import BlackHole.Scene.Problem
import BlackHole.Scene.Scene
import BlackHole.Vector.XYZ (XYZ (..))
import Control.Monad (void)
import qualified Data.ByteString.Char8 as Char8
import Data.Either (fromRight)
import Data.Foldable (toList)
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck

spec :: Spec
spec = do
  describe "readAnimation" $ do
    it "reads an animation" $ do
      let (animation, faults) =
            section
              [ "  duration: 4",
                "  fps: 12",
                "  shutter: 0.5",
                "  shutter-samples: 4",
                "  camera-path: {kind: orbit, turns: 2, axis: [0, -1, 0], interpolation: eased}"
              ]
      faults `shouldBe` []
      ( animationFrames animation,
        animationRate animation,
        animationShutter animation,
        animationPath animation
        )
        `shouldBe` (48, 12, Shutter 0.5 4, Just (Orbit (XYZ 0 (-1) 0) 2 Eased))
    it "reads every kind of camera path" $
      map
        (\text -> animationPath (fst (section ["  frames: 2", "  camera-path: " ++ text])))
        [ "{kind: orbit}",
          "{kind: dolly, to: [1, 2, 3], look-at: [0, 1, 0]}",
          "{kind: free-fall, end-distance: 0.5}",
          "{kind: free-fall, rate: 2}",
          "{kind: circular-orbit, rate: 7}"
        ]
        `shouldBe` map
          Just
          [ Orbit (XYZ 0 1 0) 1 Linear,
            Dolly (XYZ 1 2 3) (Just (XYZ 0 1 0)) Linear,
            FreeFall (FallsTo 0.5),
            FreeFall (ProperTimePerSecond 2),
            CircularOrbit 7
          ]
    it "lets fields follow their keys, whatever the order in which they stand" $ do
      let (animation, faults) =
            section
              [ "  frames: 48",
                "  keyframes:",
                "    camera.distance: {2: 20, 0: 30}",
                "    camera.azimuth: {shortest-turn: true, 0: 350, 2: 10}",
                "    disk.arms.count: {0: 1, 2: 4}"
              ]
          at n =
            [ (cameraPose (sceneCamera scene), sceneSeed scene)
              | Right scenes <- [frameScenes animation n],
                scene <- toList scenes
            ]
      faults `shouldBe` []
      at 24 `shouldBe` [(Around 25 (Degrees 77) (Degrees 360), 0)]
      at 47 `shouldSatisfy` (not . null)
    it "moves vectors" $ do
      let (animation, faults) =
            section
              ["  frames: 48", "  keyframes:", "    camera.look-at: {0: [0, 0, 0], 2: [0, 2, 0]}"]
      faults `shouldBe` []
      case frameScenes animation {animationScene = looking} 24 of
        Right scenes ->
          map (cameraPose . sceneCamera) (toList scenes)
            `shouldBe` [LookAt (XYZ 0 5 25) (XYZ 0 1 0)]
        Left problems -> expectationFailure (show problems)
    it "finds no section where there is none" $
      void (animationOf "image: {width: 3}") `shouldBe` Nothing
    it "names every fault with its line, all at once" $
      faultsOf
        [ "  frames: 4",
          "  duration: 3",
          "  fsp: 3",
          "  fps: -1",
          "  camera-path: {kind: dolly, turns: 3}",
          "  keyframes:",
          "    camera.azimut: {0: 1}",
          "    image.width: {0: 100}",
          "    camera.distance: 3",
          "    camera.roll: {interpolation: smoth, 0: 1, 0: 2}",
          "    camera.fov: {0: 1, 1: 390, x: 3}",
          "    disk.opacity: {shortest-turn: true, 0: 1}",
          "    disk.thickness: {}"
        ]
        `shouldMatchList` [ (3, "animation.duration"),
                            (4, "animation.fsp"),
                            (5, "animation.fps"),
                            (6, "animation.camera-path"),
                            (6, "animation.camera-path.turns"),
                            (8, "animation.keyframes.camera.azimut"),
                            (9, "animation.keyframes.image.width"),
                            (10, "animation.keyframes.camera.distance"),
                            (11, "animation.keyframes.camera.roll.interpolation"),
                            (11, "animation.keyframes.camera.roll.0"),
                            (12, "animation.keyframes.camera.fov.1"),
                            (12, "animation.keyframes.camera.fov.x"),
                            (13, "animation.keyframes.disk.opacity"),
                            (14, "animation.keyframes.disk.thickness")
                          ]
    it "asks for a length, and for one account of where a falling camera is" $ do
      faultsOf ["  fps: 24"] `shouldBe` [(2, "animation")]
      faultsOf
        [ "  frames: 3",
          "  camera-path: {kind: free-fall, rate: 1}",
          "  keyframes: {camera.distance: {0: 1}}"
        ]
        `shouldBe` [(2, "animation.keyframes.camera.distance")]
      faultsOf ["  frames: 3", "  camera-path: {kind: free-fall, rate: 1, end-distance: 1}"]
        `shouldBe` [(3, "animation.camera-path")]
    prop "takes any tree without an exception" $
      forAll (Mapping 1 . pure . (,,) 1 animationKey <$> tree 4) $ \root ->
        case readAnimation root of
          Nothing -> property False
          Just (animation, faults) ->
            wholly (show faults)
              .&&. wholly (show (either show show (frameScenes (animation defaultScene) 1)))
  it "can animate numbers and vectors, not the picture's size, names, switches and seeds" $ do
    map
      (fmap isTrackable . findField)
      [ "camera.distance",
        "camera.position",
        "disk.arms.count",
        "output.exposure",
        "image.width",
        "sky.kind",
        "physics.gravity",
        "sampling.seed"
      ]
      `shouldBe` map Just [True, True, True, True, False, False, False, False]
    length (filter isTrackable sceneFields) `shouldSatisfy` (> 20)
  where
    animationOf text = fromRight Nothing (parseYaml (Char8.pack text)) >>= readAnimation
    section lines' =
      maybe
        (stillAnimation defaultScene, [(0, Problem "no" "section" "there")])
        (\(animation, faults) -> (animation defaultScene, faults))
        (animationOf (unlines ("animation:" : lines')))
    faultsOf lines' = [(line, problemOption problem) | (line, problem) <- snd (section lines')]
    looking =
      defaultScene
        { sceneCamera = (sceneCamera defaultScene) {cameraPose = LookAt (XYZ 0 5 25) (XYZ 0 0 0)}
        }
    wholly text = property (sum (map fromEnum text) > 0 || null text)

-- | Trees that begin like a section and go wrong anywhere.
tree :: Int -> Gen Node
tree depth
  | depth <= 0 = scalar
  | otherwise =
    frequency
      [ (2, scalar),
        (1, Sequence 1 <$> resize 3 (listOf (tree (depth - 1)))),
        (6, Mapping 1 <$> resize 8 (listOf member))
      ]
  where
    scalar =
      Scalar 1
        <$> arbitrary <*> oneof [elements words', show <$> (arbitrary :: Gen Double), arbitrary]
    member =
      (,,) 2 <$> oneof [elements words', show <$> (arbitrary :: Gen Int)] <*> tree (depth - 1)
    words' =
      map keyName (animationKeys ++ cameraPathKeys ++ keyframeKeys)
        ++ map (\(kind, _, _) -> kind) pathKinds
        ++ ["camera-path", "keyframes", "smooth", "nan", ".inf", "1e400"]
        ++ map fieldPath sceneFields
