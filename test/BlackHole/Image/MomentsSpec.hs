module BlackHole.Image.MomentsSpec (spec) where

import BlackHole.Image.Moments
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Char8 as Characters
import Data.Foldable (fold)
import Data.List.NonEmpty (NonEmpty (..))
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck

spec :: Spec
spec = do
  it "is the text itself for a single scene" $
    joinMoments (Characters.pack "a: 1\n" :| []) `shouldBe` Characters.pack "a: 1\n"
  it "tells the lines that differ" $
    lines (Characters.unpack (joinMoments (Characters.pack "a: 1\nb: 2\n" :| [Characters.pack "a: 1\nb: 3\n"])))
      `shouldSatisfy` \told -> take 2 told == ["a: 1", "b: 2"] && drop 5 told == ["# moment with lines 2", "# 2:b: 3"]
  prop "gives all texts back" $
    forAll ((:|) <$> text <*> listOf text) $ \texts -> splitMoments (joinMoments texts) === texts
  prop "never fails on other texts" $
    forAll (Characters.unlines <$> listOf (elements junk)) $ \bytes -> Bytes.length (fold (splitMoments bytes)) >= 0
  where
    text = Characters.unlines . map Characters.pack <$> listOf (elements ["a: 1", "a: 2", "", "# comment", "  c: -3", "# 3:x", "# lines"])
    junk = map Characters.pack ["# moments 3", "# moment with lines 2", "# moment with lines -4", "# moment with lines 99999999999999999999", "# 1:", "# 1", "a"]
