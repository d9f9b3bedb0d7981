module BlackHole.Trace.CensusSpec (spec) where

import BlackHole.Scene.Camera (Picture (..))
import BlackHole.Scene.Preset
import BlackHole.Scene.Scene
import BlackHole.Trace.Adaptive (pixelEstimate)
import BlackHole.Trace.Census
import BlackHole.Trace.Estimate (estimateCount)
import BlackHole.Trace.Explain
import BlackHole.Trace.Pixel (tracer)
import Test.Hspec

spec :: Spec
spec = do
  let small = defaultScene {scenePicture = Picture 24 12, sceneSamples = 2}
  it "of a small picture is a count of all its pixels" $ do
    Just counted <- pure (census Nothing small (0, 12))
    Just traced <- pure (tracer small)
    censusLines counted `shouldBe` 24 * 12
    let rays = [fromIntegral (estimateCount (pixelEstimate traced column row)) | row <- [0 .. 11], column <- [0 .. 23]]
    mean (censusRays counted) `shouldSatisfy` near (sum rays / 288)
    let middles = [maybe (0, 0) (\a -> (arrivalSteps a, arrivalGasSamples a)) (sightingArrival (explainedMiddle e)) | row <- [0 .. 11], column <- [0 .. 23], Just e <- [explainPixel traced column row]]
    mean (censusSteps counted) `shouldSatisfy` near (sum (map (fromIntegral . fst) middles) / 288)
    mean (censusGasSamples counted) `shouldSatisfy` near (sum (map (fromIntegral . snd) middles) / 288)
  it "of a large picture is within five standard errors of that of its every line" $ do
    let large = small {scenePicture = Picture 80 45, sceneNoise = 0, sceneIntegrator = Exact}
    Just few <- pure (census Nothing large (0, 45))
    censusLines few `shouldSatisfy` (\n -> n > 900 && n < 1100)
    let parts = [c | row <- [0, 9 .. 36], Just c <- [census Nothing large (row, 9)]]
    map censusLines parts `shouldBe` replicate 5 720
    let whole = sum (map (mean . censusSteps) parts) / 5
        Mean estimate off = censusSteps few
    abs (estimate - whole) `shouldSatisfy` (< 5 * off)
  it "finds the leapfrog's error, which falls with the square of its step, and none of the closed form" $ do
    let leaping step = reportScene {scenePicture = Picture 24 12, sceneIntegrator = Leapfrogging, sceneStep = step, sceneDisk = Nothing}
        worst scene = maybe 0 censusDirectionError (census Nothing scene (0, 12))
    worst (leaping 0.1) / worst (leaping 0.05) `shouldSatisfy` (\ratio -> ratio > 2.5 && ratio < 6)
    worst small {sceneIntegrator = Exact} `shouldBe` 0
    worst small `shouldSatisfy` (\e -> e > 0 && e < 1e-6)
  it "has nothing to say of no rows" $
    census Nothing small (3, 0) `shouldBe` Nothing
  where
    mean (Mean m _) = m
    near expected m = abs (m - expected) <= 1e-9 * (1 + expected)
