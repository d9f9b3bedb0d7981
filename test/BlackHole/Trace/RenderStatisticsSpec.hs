module BlackHole.Trace.RenderStatisticsSpec (spec) where

import BlackHole.Scene.Camera (Picture (..))
import BlackHole.Scene.Preset
import BlackHole.Scene.Scene
import BlackHole.Trace.Adaptive (Pixel (..), singlePixel)
import BlackHole.Trace.Explain
import BlackHole.Trace.RenderStatistics
import BlackHole.Trace.Tracer (tracer)
import Test.Hspec

spec :: Spec
spec = do
  let small = defaultScene {scenePicture = Picture 24 12, sceneSamples = 2}
  it "of a small picture is a count of all its pixels" $ do
    Just counted <- pure (renderStatistics Nothing small (0, 12))
    Just traced <- pure (tracer small)
    statisticsLines counted `shouldBe` 24 * 12
    let rays =
          [ fromIntegral (pixelRays (singlePixel traced column row))
            | row <- [0 .. 11],
              column <- [0 .. 23]
          ]
    mean (statisticsRays counted) `shouldSatisfy` near (sum rays / 288)
    let middles =
          [ maybe
              (0, 0)
              (\a -> (arrivalSteps a, arrivalGasSamples a))
              (sightingArrival (explainedMiddle e))
            | row <- [0 .. 11],
              column <- [0 .. 23],
              Just e <- [explainPixel traced column row]
          ]
    mean (statisticsSteps counted)
      `shouldSatisfy` near (sum (map (fromIntegral . fst) middles) / 288)
    mean (statisticsGasSamples counted)
      `shouldSatisfy` near (sum (map (fromIntegral . snd) middles) / 288)
  it "of a large picture is within five standard errors of that of its every line" $ do
    let large = small {scenePicture = Picture 80 45, sceneNoise = 0, sceneIntegrator = Exact}
    Just few <- pure (renderStatistics Nothing large (0, 45))
    statisticsLines few `shouldSatisfy` (\n -> n > 900 && n < 1100)
    let parts = [c | row <- [0, 9 .. 36], Just c <- [renderStatistics Nothing large (row, 9)]]
    map statisticsLines parts `shouldBe` replicate 5 720
    let whole = sum (map (mean . statisticsSteps) parts) / 5
        Mean estimate off = statisticsSteps few
    abs (estimate - whole) `shouldSatisfy` (< 5 * off)
  it "finds the leapfrog's error, which falls as its step squared, and none of the closed form" $ do
    let leaping step =
          reportScene
            { scenePicture = Picture 24 12,
              sceneIntegrator = Leapfrogging,
              sceneStep = step,
              sceneDisk = Nothing
            }
        worst scene = maybe 0 statisticsDirectionError (renderStatistics Nothing scene (0, 12))
    worst (leaping 0.1) / worst (leaping 0.05) `shouldSatisfy` (\ratio -> ratio > 2.5 && ratio < 6)
    worst small {sceneIntegrator = Exact} `shouldBe` 0
    worst small `shouldSatisfy` (\e -> e > 0 && e < 1e-6)
  it "has nothing to say of no rows" $
    renderStatistics Nothing small (3, 0) `shouldBe` Nothing
  where
    mean (Mean m _) = m
    near expected m = abs (m - expected) <= 1e-9 * (1 + expected)
