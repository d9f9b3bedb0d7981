module BlackHole.Explore.TimelineSpec (spec) where

import BlackHole.Animation.Animation
import BlackHole.Animation.Interpolate
import BlackHole.Cli.AnimationScene (resolveAnimation)
import BlackHole.Cli.SceneOptions
import BlackHole.Explore.Timeline
import BlackHole.Numeric.Angle
import BlackHole.Scene.Camera
import BlackHole.Scene.Field.Kind
import BlackHole.Scene.Preset
import BlackHole.Scene.Scene
import BlackHole.Scene.Setting
import qualified Data.ByteString.Char8 as Char8
import Data.Either (fromLeft)
import Test.Hspec

spec :: Spec
spec = do
  it "shows the keys at their times, and the middle between them" $ do
    let made = sequenceAnimation <$> sequenceOf (timeline Linear [key 0 defaultScene, key 2 nearer])
        at seconds = fmap (cameraPose . sceneCamera) <$> ((`sceneAt` seconds) <$> made)
    at 0 `shouldBe` Right (Right (Around 54 (Degrees 77) (Degrees 90)))
    at 2 `shouldBe` Right (Right (Around 20 (Degrees 77) (Degrees 110)))
    at 1 `shouldBe` Right (Right (Around 37 (Degrees 77) (Degrees 100)))
  it "takes the shorter way round" $ do
    let turnedTo a = change [("camera.azimuth", NumberValue a)]
        made =
          sequenceAnimation
            <$> sequenceOf (timeline Linear [key 0 (turnedTo 350), key 1 (turnedTo 10)])
    (fmap (cameraPose . sceneCamera) <$> ((`sceneAt` 0.5) <$> made))
      `shouldBe` Right (Right (Around 54 (Degrees 77) (Degrees 360)))
  it "writes a file that the program reads as the same animation" $
    case sequenceOf
      ( timeline
          Smooth
          [key 2 nearer, key 0 defaultScene, key 1.5 (change [("disk.time", NumberValue 40)])]
      ) of
      Left faults -> expectationFailure (unlines faults)
      Right made -> case resolveAnimation
        (SceneOptions (Just "animation.yaml") Nothing [])
        (Just (Char8.pack (sequenceText made))) of
        Right (Just animation) -> do
          (animationFrames animation, animationRate animation) `shouldBe` (72, 24)
          sequence_
            [sceneAt animation t `shouldBe` sceneAt (sequenceAnimation made) t | t <- [0, 0.3 .. 3]]
        _ -> expectationFailure "this is not an animation"
  it "says what cannot change" $
    ( sequenceFixed
        <$> sequenceOf
          ( timeline
              Linear
              [ key 0 defaultScene,
                key 1 (change [("sky.kind", NameValue "grid"), ("camera.fov", NumberValue 20)])
              ]
          )
    )
      `shouldBe` Right ["sky.kind", "sky.rotation", "sky.brightness", "sky.milky-way"]
  it "needs a key, and one for each time" $ do
    problems (sequenceOf (timeline Linear [])) `shouldBe` ["an animation needs a keyframe"]
    problems (sequenceOf (timeline Linear [key 1 defaultScene, key 1 nearer]))
      `shouldBe` ["two keyframes have the same time"]
  where
    timeline = Timeline 3 24
    key seconds scene = Key seconds (sceneSettings scene)
    change settings = applySettings [Setting path value | (path, value) <- settings] defaultScene
    nearer = change [("camera.distance", NumberValue 20), ("camera.azimuth", NumberValue 110)]
    problems = fromLeft []
