module BlackHole.Trace.AdaptiveSpec (spec) where

import BlackHole.Light.Radiance
import BlackHole.Scene.Camera (Picture (..))
import BlackHole.Scene.Preset
import BlackHole.Scene.Scene
import BlackHole.Scene.Sky
import BlackHole.Spacetime.Types (Spacetime (..))
import BlackHole.Trace.Adaptive
import BlackHole.Trace.Estimate
import BlackHole.Trace.PhotonRing
import BlackHole.Trace.Tracer
import BlackHole.Vector.XY (XY (..))
import Control.Monad (forM_)
import Data.Maybe (isJust)
import Test.Hspec

spec :: Spec
spec = do
  describe "an uncertain pixel gets twice as many samples, at least four more, repeatedly," $ do
    it "until it is certain" $
      forM_ [(n, noise) | n <- [2, 3, 4, 8], noise <- [0.3, 0.2, 0.1, 0.05, 0.02]] $ \(n, noise) ->
        ( n,
          noise,
          refinedCount
            even' {sceneSamples = n, sceneNoise = noise, sceneMostSamples = 1000}
            (const (const True))
            3
            3
        )
          `shouldBe` (n, noise, expected n noise (max (n + 4) (2 * n)))
    it "or has the most" $
      forM_ [4, 5, 30, 64] $ \most ->
        refinedCount
          even' {sceneSamples = 4, sceneNoise = 1e-9, sceneMostSamples = most}
          (const (const True))
          3
          3
          `shouldBe` most
  it "a pixel is refined if it or one of its eight neighbours is uncertain" $
    forM_ [(c, r) | c <- [0 .. 7], r <- [0 .. 4]] $ \(c, r) ->
      ( c,
        r,
        refinedCount
          even' {sceneSamples = 4, sceneNoise = 1, sceneMostSamples = 64}
          (\column row -> (column, row) == (c, r))
          3
          2
          > 4
      )
        `shouldBe` (c, r, abs (c - 3) <= 1 && abs (r - 2) <= 1)
  it "asks for no pixel outside the picture" $
    forM_ [(0, 0), (7, 0), (0, 4), (7, 4)] $ \(c, r) ->
      refinedCount
        even' {sceneSamples = 4, sceneNoise = 1, sceneMostSamples = 64}
        ( \column row ->
            column < 0 || row < 0 || column > 7 || row > 4
        )
        c
        r
        `shouldBe` 4
  it "a pixel on the edge of the shadow gets the most samples, certain or not" $ do
    Just traced <- pure (tracer ringed)
    let pixels = [(c, r) | c <- [0 .. 31], r <- [0 .. 17]]
        onEdge (c, r) =
          isJust (photonRing traced (XY (fromIntegral c + 0.5) (fromIntegral r + 0.5)))
        count (c, r) =
          estimateCount
            (refinedEstimate traced (const (const False)) (firstEstimate traced c r) c r)
        (edge, others) = (filter onEdge pixels, filter (not . onEdge) pixels)
    length edge `shouldSatisfy` (> 10)
    map count (take 5 edge) `shouldBe` replicate 5 16
    map count (take 50 others) `shouldBe` replicate 50 2
  where
    -- Every ray sees 0.25, in straight lines, so that nothing is uncertain by itself.
    even' =
      defaultScene
        { scenePicture = Picture 8 5,
          sceneSpacetime = Flat,
          sceneDisk = Nothing,
          sceneSky = SkyUniform 0.25
        }
    ringed =
      defaultScene
        { scenePicture = Picture 32 18,
          sceneSamples = 2,
          sceneNoise = 0.5,
          sceneMostSamples = 16
        }
    -- One sample is as bright as white, the others are dark: 'first' is uncertain.
    refinedCount scene uncertain column row = case tracer scene of
      Nothing -> -1
      Just traced ->
        estimateCount (refinedEstimate traced uncertain (first (sceneSamples scene)) column row)
    first n = addSample 1 1 (grey 1) (iterate (addSample 1 1 black) noSamples !! (n - 1))
    -- The number of samples by the rule: what is seen of them is 1 once, 0 for the
    -- rest of the first n, and 1/2 for all further ones.
    expected n noise count
      | count >= 1000 = 1000
      | errorOf n count <= noise = count
      | otherwise = expected n noise (max (count + 4) (2 * count))
    errorOf :: Int -> Int -> Double
    errorOf n count =
      let m = fromIntegral count
          more = fromIntegral (count - n)
          total = 1 + 0.5 * more
          squares = 1 + 0.25 * more
       in sqrt ((squares - total * total / m) / (m * (m - 1)))
