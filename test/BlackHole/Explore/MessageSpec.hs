{-# LANGUAGE OverloadedStrings #-}

module BlackHole.Explore.MessageSpec (spec) where

import BlackHole.Animation.Interpolate
import BlackHole.Explore.Message
import BlackHole.Explore.Steer
import BlackHole.Explore.Timeline
import BlackHole.Scene.Field.Field
import BlackHole.Scene.Field.Kind
import BlackHole.Scene.Field.Table
import BlackHole.Scene.Setting
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Builder as Builder
import qualified Data.ByteString.Char8 as Char8
import qualified Data.ByteString.Lazy as Lazy
import Support.Generators
import Test.Hspec
import Test.QuickCheck

spec :: Spec
spec = do
  it "reads every message" $
    sequence_
      [ parseMessage text `shouldBe` Right message
        | (text, message) <-
            [ ("window 920 518", Window 920 518),
              ("drawn 7", Drawn 7),
              ( "change 3\ncamera.fov 30\noutput.dither off",
                Change
                  3
                  [ Setting "camera.fov" (NumberValue 30),
                    Setting "output.dither" (SwitchValue False)
                  ]
              ),
              ( "restore 4 kerr\nhole.spin 0.5",
                Restore 4 "kerr" [Setting "hole.spin" (NumberValue 0.5)]
              ),
              ("preset 5 luminet", LoadPreset 5 "luminet"),
              ("orbit 6 1.5 -2", Steer 6 (OrbitHole 1.5 (-2))),
              ("approach 7 0.9", Steer 7 (Approach 0.9)),
              ("look 8 1 2", Steer 8 (LookAround 1 2)),
              ("roll 9 -3", Steer 9 (RollBy (-3))),
              ("face 10", Steer 10 FaceHole),
              ("inspect 0.25 1", Inspect 0.25 1),
              ("command", AskCommand),
              ("save-scene keep my scene.yaml", SaveScene KeepFile "my scene.yaml"),
              ( "animation 5 24 smooth\nkey 0\ncamera.fov 30\nkey 2.5\ncamera.fov 20",
                DefineAnimation
                  ( Timeline
                      5
                      24
                      Smooth
                      [ Key 0 [Setting "camera.fov" (NumberValue 30)],
                        Key 2.5 [Setting "camera.fov" (NumberValue 20)]
                      ]
                  )
              ),
              ("save-animation replace animation.yaml", SaveAnimation ReplaceFile "animation.yaml"),
              ("scrub 11 2.5", Scrub 11 2.5),
              ("render keep hole.png", RenderFile KeepFile "hole.png"),
              ("cancel", CancelRender)
            ]
      ]
  it "says what is wrong, and with which input" $
    sequence_
      [ parseMessage text `shouldBe` Left fault
        | (text, fault) <-
            [ ("", (Nothing, "an empty message")),
              ("dance 1", (Nothing, "no message: 'dance'")),
              ("window 0 10", (Nothing, "'0' is not a whole number from 1 to 7680")),
              ("orbit 6 nan 0", (Just 6, "'nan' is not a number from -3600 to 3600")),
              ("change 3\ncamera.fav 30", (Just 3, "no setting: 'camera.fav'")),
              ( "change 3\ncamera.fov 30 degrees",
                (Just 3, "camera.fov: '30 degrees' is not a number")
              ),
              ( "change 3\ncamera.fov 400",
                (Just 3, "camera.fov: '400' is not an angle above 0 and up to 360 (degrees)")
              ),
              ("scrub 11 -1", (Just 11, "'-1' is not a number from 0 to 3600")),
              ("save-scene keep", (Nothing, "a file needs a name")),
              ("cancel\nnow", (Nothing, "a message with too many lines"))
            ]
      ]
  it "answers any bytes" $
    withMaxSuccess 1000 . property $ \bytes ->
      let outcome = parseMessage (Bytes.pack bytes) in answered (length (show outcome))
  it "answers any mixture of words, numbers and settings" $
    withMaxSuccess 1000 . forAll mixture $ \text ->
      let outcome = parseMessage (Char8.pack text) in answered (length (show outcome))
  it "reads back the values that it shows" $
    forAll validScene $ \scene ->
      conjoin
        [ counterexample (fieldPath f) (readValue (fieldKind f) (valueText v) === Right v)
          | f <- sceneFields,
            Just v <- [fieldGet f scene]
        ]
  it "reads back a whole scene" $
    forAll validScene $ \scene ->
      let settings = sceneSettings scene
          text =
            unlines
              ( "restore 1 default" :
                  [path ++ " " ++ valueText value | Setting path value <- settings]
              )
       in parseMessage (Lazy.toStrict (Builder.toLazyByteString (Builder.stringUtf8 text)))
            === Right (Restore 1 "default" settings)

answered :: Int -> Property
answered size = property (size > 0)

mixture :: Gen String
mixture = do
  first <- listOf word
  rest <- resize 5 (listOf (listOf word))
  pure (unlines (unwords (take 6 first) : map (unwords . take 3) rest))
  where
    word =
      oneof
        [ elements
            [ "window",
              "drawn",
              "change",
              "restore",
              "preset",
              "orbit",
              "approach",
              "look",
              "roll",
              "face",
              "inspect",
              "save-scene",
              "animation",
              "key",
              "scrub",
              "render",
              "keep",
              "replace",
              "smooth"
            ],
          elements (map fieldPath sceneFields),
          elements
            [ "0",
              "1",
              "-1",
              "1e9",
              "1e9999",
              "1e99999999",
              "nan",
              "inf",
              "",
              "-",
              "99999999999999999999999",
              "0x10",
              "1,2,3"
            ],
          show <$> (arbitrary :: Gen Double),
          arbitrary
        ]
