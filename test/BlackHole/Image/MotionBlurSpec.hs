module BlackHole.Image.MotionBlurSpec (spec) where

import BlackHole.Image.MotionBlur
import Control.Exception (evaluate)
import Control.Monad (forM_)
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Char8 as Characters
import Data.Either (isLeft)
import Data.List.NonEmpty (NonEmpty (..))
import System.Mem (getAllocationCounter)
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck

spec :: Spec
spec = do
  it "is the text itself for a single scene" $
    joinBlurredScenes (Characters.pack "a: 1\n" :| []) `shouldBe` Characters.pack "a: 1\n"
  it "tells the lines that differ" $
    lines
      ( Characters.unpack
          (joinBlurredScenes (Characters.pack "a: 1\nb: 2\n" :| [Characters.pack "a: 1\nb: 3\n"]))
      )
      `shouldSatisfy` \told ->
        take 2 told == ["a: 1", "b: 2"] && drop 5 told == ["# moment with lines 2", "# 2:b: 3"]
  prop "gives all texts back" $
    forAll ((:|) <$> text <*> listOf text) $ \texts ->
      splitBlurredScenes (joinBlurredScenes texts) === Right texts
  it "takes as many scenes as a frame may have shutter samples, and no more" $ do
    let scenes n =
          Characters.pack "a: 0\n" :| [Characters.pack ("a: " ++ show k ++ "\n") | k <- [2 .. n]]
    splitBlurredScenes (joinBlurredScenes (scenes maximumBlurredScenes))
      `shouldBe` Right (scenes maximumBlurredScenes)
    splitBlurredScenes (joinBlurredScenes (scenes (maximumBlurredScenes + 1)))
      `shouldSatisfy` isLeft
  describe "refuses forged lists:" $
    forM_
      [ ("lines that are nowhere", "# moments 2\n# moment with lines 2\n"),
        ("a number of lines beyond all bounds", "# moments 2\n# moment with lines 1000000\n"),
        ( "more scenes than announced",
          "# moments 2\n# moment with lines 1\n# moment with lines 1\n"
        ),
        ("fewer scenes than announced", "# moments 3\n# moment with lines 1\n"),
        ("one scene", "# moments 1\n"),
        ("no number", "# moments x\n# moment with lines 1\n")
      ]
      $ \(name, forged) ->
        it name $ splitBlurredScenes (Characters.pack ("a: 1\n" ++ forged)) `shouldSatisfy` isLeft
  it "refuses scenes of more than 16 MiB together" $ do
    let scene = Characters.unlines (replicate 20 (Characters.replicate 1023 'x'))
    splitBlurredScenes
      ( scene
          <> Characters.pack
            ("# moments 1000\n" ++ concat (replicate 999 "# moment with lines 20\n"))
      )
      `shouldSatisfy` isLeft
  -- Bytes that are allocated are the same on any machine.
  prop "takes memory in proportion to the text and 16 MiB" $
    forAll (Characters.unlines <$> listOf (elements junk)) $ \bytes -> ioProperty $ do
      allowance <- getAllocationCounter
      size <- evaluate (either length (sum . fmap Bytes.length) (splitBlurredScenes bytes))
      left <- getAllocationCounter
      pure
        (size <= 16777216 .&&. allowance - left < 1000 * fromIntegral (Bytes.length bytes) + 100000)
  where
    text =
      Characters.unlines . map Characters.pack
        <$> listOf (elements ["a: 1", "a: 2", "", "# comment", "  c: -3", "# 3:x", "# lines"])
    junk =
      map
        Characters.pack
        [ "# moments 3",
          "# moment with lines 2",
          "# moment with lines -4",
          "# moment with lines 1000000",
          "# moment with lines 99999999999999999999",
          "# 1:",
          "# 1",
          "a"
        ]
