module BlackHole.Cli.ExplainSpec (spec) where

import BlackHole.Cli.Explain
import BlackHole.Cli.Options
import BlackHole.Cli.Render.Options
import BlackHole.Scene.Camera (Picture (..))
import BlackHole.Scene.Preset
import BlackHole.Scene.Scene
import BlackHole.Scene.Validate (renderProblem)
import BlackHole.Trace.Explain
import BlackHole.Trace.Tracer (tracer)
import Data.Foldable (for_)
import Data.List (isInfixOf)
import Test.Hspec

spec :: Spec
spec = do
  it "--pixel takes a column and a row" $
    case parseArguments "v1" ["render", "--pixel", "12,7"] of
      Run (Render options) -> renderPixel options `shouldBe` Just (12, 7)
      other -> expectationFailure (show other)
  it "and nothing else" $
    for_ ["12", "12,", "1.5,2", "1,2,3", "a,b"] $ \text ->
      case parseArguments "v1" ["render", "--pixel", text] of
        Misused line -> for_ ["--pixel", text, "X,Y"] $ \part -> line `shouldSatisfy` isInfixOf part
        other -> expectationFailure (show other)
  it "a pixel outside the picture is one problem that names option, value and range" $
    for_ [(16, 0), (0, 9), (-1, 3), (3, -1)] $ \(x, y) ->
      map renderProblem (pixelProblems (Picture 16 9) (x, y))
        `shouldBe` [ "--pixel: " ++ show x ++ "," ++ show y
                       ++ " is not a pixel of this picture: X \
                          \from 0 to 15, Y from 0 to 8, counted from the top left"
                   ]
  it "a pixel inside is none" $
    concatMap (pixelProblems (Picture 16 9)) [(0, 0), (15, 8)] `shouldBe` []
  it "says everything that was asked for" $ do
    let text = explained defaultScene 4 5
    for_
      [ "pixel 4,5 of 16 x 9",
        "direction",
        "impact parameter b",
        "angular momentum h",
        "static observer",
        "fate",
        "steps",
        "crossings",
        "optical depth",
        "transmittance",
        "from the gas",
        "from the sky",
        "first rays of this pixel and its neighbours",
        "filtered light",
        "samples",
        "exposed by 0 stops",
        "tone map film",
        "sRGB codes"
      ]
      $ \part -> text `shouldSatisfy` isInfixOf part
  it "lists several samples, and does not speak of samples where there is one" $
    for_ [(1, False), (4, True)] $ \(count, several) ->
      isInfixOf "\nsamples " (explained defaultScene {sceneSamples = count, sceneNoise = 0} 4 5)
        `shouldBe` several
  where
    explained scene x y =
      let small = scene {scenePicture = Picture 16 9}
       in maybe
            ""
            (unlines . explanationLines small)
            (tracer small >>= \traced -> explainPixel traced x y)
