module BlackHole.Cli.JsonSpec (spec) where

import BlackHole.Cli.Json
import qualified Support.Json as Read
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck
import Text.Read (readMaybe)

spec :: Spec
spec = do
  describe "numbers" $ do
    prop "read back as the same double" $ \d ->
      Read.readJson (showDouble d) === Just (Read.Number d)
    prop "also when they are large or small" $ \d (Small e) ->
      let v = d * 10 ^^ (e :: Int) :: Double
       in not (isInfinite v) ==> Read.readJson (showDouble v) === Just (Read.Number v)
    it "look like what people write" $
      map showDouble [0, -0.0, 40, 2.65, -1.5, 1e-3, 1e-9, 1.25e20]
        `shouldBe` ["0", "0", "40", "2.65", "-1.5", "0.001", "1e-9", "1.25e20"]
    it "keep seventeen digits where they are needed" $
      (readMaybe (showDouble 3.5579380424596536) :: Maybe Double) `shouldBe` Just 3.5579380424596536
  describe "values" $ do
    it "what is not finite is null" $
      map (Read.readJson . renderJson . Number) [0 / 0, 1 / 0, -1 / 0]
        `shouldBe` replicate 3 (Just Read.Null)
    prop "text reads back, whatever is in it" $ \s ->
      all (`notElem` s) ['\xd800' .. '\xdfff']
        ==> Read.readJson (renderJson (Text s)) === Just (Read.Text s)
    it "structures read back" $
      Read.readJson
        ( renderJson
            (Object [("a", List [Null, Whole 3, Object []]), ("b\"", List []), ("c", Text "\n\\")])
        )
        `shouldBe` Just
          ( Read.Object
              [ ("a", Read.List [Read.Null, Read.Number 3, Read.Object []]),
                ("b\"", Read.List []),
                ("c", Read.Text "\n\\")
              ]
          )
