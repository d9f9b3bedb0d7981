module BlackHole.Trace.AdaptiveSpec (spec) where

import BlackHole.Light.Radiance
import BlackHole.Scene.Camera (Picture (..))
import BlackHole.Scene.Preset
import BlackHole.Scene.Scene
import BlackHole.Scene.Sky
import BlackHole.Spacetime.Types (Spacetime (..))
import BlackHole.Trace.Adaptive
import BlackHole.Trace.Layers
import BlackHole.Trace.PhotonRing
import BlackHole.Trace.SkyLight (skyBeam)
import BlackHole.Trace.Tracer
import BlackHole.Vector.XY (XY (..))
import Control.Monad (forM_)
import Data.Maybe (isJust)
import Test.Hspec

spec :: Spec
spec = do
  describe "an uncertain pixel gets at least four rays of its own, and twice as many again," $ do
    it "until it is certain" $
      forM_ [0.3, 0.2, 0.1, 0.05, 0.02, 0.01] $ \noise ->
        (noise, raysAt even' {sceneNoise = noise, sceneMostSamples = 1000} (onlyAt 1 3) 1 3)
          `shouldBe` (noise, 1 + (if firstError > noise then expected noise 4 else 0))
    it "or has the most" $
      forM_ [4, 5, 30, 64] $ \most ->
        raysAt even' {sceneNoise = 1e-9, sceneMostSamples = most} (onlyAt 1 3) 1 3 `shouldBe` most
  it "a pixel is uncertain if it differs from its eight neighbours or one of them does" $
    forM_ [(c, r) | c <- [0 .. 7], r <- [0 .. 4]] $ \(c, r) ->
      (c, r, raysAt even' {sceneNoise = 0.02} (onlyAt c r) 3 2 > 1)
        `shouldBe` (c, r, abs (c - 3) <= 1 && abs (r - 2) <= 1)
  it "a pixel is certain where what is seen changes evenly" $
    forM_ [(3, 2), (0, 0), (7, 4)] $ \(c, r) ->
      let ramp column = shining ((0.3 + 0.01 * fromIntegral column) ^ (2 :: Int))
       in raysAt even' {sceneNoise = 0.02} (\column _ -> ramp column) c r `shouldBe` 1
  it "asks for no pixel outside the picture" $
    forM_ [(0, 0), (7, 0), (0, 4), (7, 4)] $ \(c, r) -> do
      let outside column row = column < 0 || row < 0 || column > 7 || row > 4
          light column row = shining (if outside column row then 0 / 0 else 0.25)
      raysAt even' light c r `shouldBe` 1
  it "a pixel on the edge of the shadow gets the most samples, beside it half, certain or not" $ do
    Just traced <- pure (tracer ringed)
    let pixels = [(c, r) | c <- [0 .. 31], r <- [0 .. 17]]
        middle (c, r) = XY (fromIntegral c + 0.5) (fromIntegral r + 0.5)
        -- A face of the edge: on its two sides light escapes and does not.
        escapes = isJust . skyBeam traced
        onEdge pixel@(c, r) =
          or
            [ escapes (middle pixel) /= escapes (middle (c + x, r + y))
              | (x, y) <- [(-1, 0), (1, 0), (0, -1), (0, 1)]
            ]
        near pixel = isJust (photonRing traced (middle pixel))
        count (c, r) = pixelRays (singlePixel traced c r)
        edge = filter onEdge pixels
        beside = filter (\pixel -> near pixel && not (onEdge pixel)) pixels
        others = filter (not . near) pixels
    length edge `shouldSatisfy` (> 10)
    map count edge `shouldBe` map (const 16) edge
    map count beside `shouldSatisfy` all (`elem` [8, 16])
    map count beside `shouldContain` [8]
    map count (take 50 others) `shouldBe` replicate 50 2
  it "open sky ends beside a pixel with gas, in all directions and across spans" $ do
    Just traced <- pure (tracer even' {scenePicture = Picture 32 9})
    forM_ [(10, 4), (8, 4), (15, 4)] $ \(c, r) -> do
      let layersAt x y = if (x, y) == (c, r) then shining 1 else Layers black 1 1
          rays x y =
            let start = x - x `rem` 8
                within = pixelSpan traced Nothing Nothing layersAt start y
             in pixelRays (refinedPixel traced (kernel (sceneFilter even')) within layersAt x y)
      [rays (c + x) (r + y) | x <- [-1 .. 1], y <- [-1 .. 1]] `shouldSatisfy` all (> 1)
  it "the span that finds the photon ring misses no pixel on it" $
    forM_ [ringed, ringed {scenePicture = Picture 320 180}] $ \scene -> do
      Just traced <- pure (tracer scene {sceneNoise = 1})
      let Picture width height = scenePicture scene
          onEdge (c, r) =
            isJust (photonRing traced (XY (fromIntegral c + 0.5) (fromIntegral r + 0.5)))
          pixels = [(c, r) | c <- [0 .. width - 1], r <- [0, 5 .. height - 1]]
      forM_ (filter onEdge pixels) $ \(c, r) ->
        (c, r, pixelRays (singlePixel traced c r)) `shouldSatisfy` \(_, _, n) -> n >= 8
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
          sceneNoise = 1,
          sceneMostSamples = 16
        }
    raysAt scene layersAt column row = case tracer scene of
      Nothing -> -1
      Just traced ->
        pixelRays $
          refinedPixel
            traced
            (kernel (sceneFilter scene))
            (pixelSpan traced Nothing Nothing layersAt 0 row)
            layersAt
            column
            row
    shining v = Layers (grey v) 0 1
    -- One pixel as bright as white among darker ones.
    onlyAt c r column row = shining (if (column, row) == (c, r) then 1 else 0.25)
    -- The light and the standard error of that pixel by its neighbours: of nine things
    -- seen, 1 once and 1/2 eight times.
    firstLight = let w = middleWeight in w + 0.25 * (1 - w)
    firstError = sqrt ((1 + 8 * 0.25 - (1 + 8 * 0.5) ^ (2 :: Int) / 9) / 6 * squaredWeights)
    middleWeight = 1 / (1 + 4 * exp (-2) + 4 * exp (-4)) :: Double
    squaredWeights =
      middleWeight * middleWeight * (1 + 4 * exp (-4) + 4 * exp (-8)) :: Double
    -- The number of samples by the rule: the nine count as four, and every other sees 1/2.
    expected :: Double -> Int -> Int
    expected noise count
      | count >= 1000 = 1000
      | errorOf count <= noise = count
      | otherwise = expected noise (2 * count)
    errorOf count =
      let m = fromIntegral (sharedWorth + count)
          seen = sqrt firstLight
          total = fromIntegral sharedWorth * seen + 0.5 * fromIntegral count
          squares = fromIntegral sharedWorth * firstLight + 0.25 * fromIntegral count
       in sqrt ((squares - total * total / m) / (m * (m - 1)))
