module BlackHole.Trace.LayersSpec (spec) where

import BlackHole.Light.Radiance
import BlackHole.Scene.Camera (Camera (..), Picture (..), Pose (..))
import BlackHole.Scene.Disk (Disk (..))
import BlackHole.Scene.Filter
import BlackHole.Scene.Preset
import BlackHole.Scene.Scene
import BlackHole.Trace.Layers
import BlackHole.Trace.SkyLight
import BlackHole.Trace.SkySpan
import BlackHole.Trace.Tracer
import BlackHole.Vector.XYZ (XYZ (..))
import Control.Monad (forM_)
import Data.Maybe (isJust, isNothing)
import Support.Approx
import Support.Generators
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck

spec :: Spec
spec = do
  describe "the light of nine pixels" $ do
    it "is the middle's with the box filter" $
      fst (shared Box black (\x y -> if (x, y) == (0, 0) then shining 0.7 else shining 0.1))
        `shouldSatisfy` near 1e-12 0.7
    it "is weighted by the Gaussian" $ do
      let only c r x y = if (x, y) == (c, r) then shining 1 else shining 0
          weight c r = luminance (fst (shared Gaussian black (only c r)))
      (weight 1 0 / weight 0 0) `shouldBeWithin` (1e-12, exp (-2))
      (weight 1 1 / weight 0 0) `shouldBeWithin` (1e-12, exp (-4))
      sum [weight c r | c <- [-1, 0, 1], r <- [-1, 0, 1]] `shouldBeWithin` (1e-12, 1)
    it "lets the sky behind the middle through by the share of the nine" $
      forM_ [minBound .. maxBound] $ \kind ->
        fst (shared kind (grey 2) (\x _ -> Layers black (0.5 + 0.1 * fromIntegral x) 1))
          `shouldSatisfy` near 1e-12 1
    prop "is the even mean where the scatter is small against the noise" $
      forAll (vectorOf 9 (inRange 0.49 0.51)) $ \values ->
        let at x y = shining (values !! (4 + 3 * y + x))
         in near 5e-4 (sum values / 9) (fst (sharedLight (kernel Gaussian) 1 0.1 black at))
    prop "is certain where what is seen lies on a plane" $
      forAll ((,,) <$> inRange 0.5 1 <*> inRange (-0.2) 0.2 <*> inRange (-0.2) 0.2) $
        \(v, vx, vy) ->
          let plane x y = v + vx * fromIntegral x + vy * fromIntegral y
           in snd (shared Gaussian black (\x y -> shining (plane x y ^ (2 :: Int)))) < 1e-7
    prop "has the standard error of independent pixels" $
      forAll (vectorOf 200 (vectorOf 9 (inRange 0.4 0.6))) $ \pictures ->
        -- The noise has a variance of 0.2² / 12; the weights reduce it.
        let squares = [e * e | vs <- pictures, let (_, e) = shared Gaussian black (at vs)]
            at vs x y = shining ((vs !! (4 + 3 * y + x)) ^ (2 :: Int))
            weights = [exp (-2 * d) | d <- [0, 1, 1, 1, 1, 2, 2, 2, 2 :: Double]]
            reduced = sum (map (^ (2 :: Int)) weights) / sum weights ^ (2 :: Int)
         in counterexample (show (sum squares / 200)) $
              abs (sum squares / 200 / (0.04 / 12 * reduced) - 1) < 0.25
    it "tells the least and the greatest share of the sky" $
      clearness (\x y -> Layers black (0.5 + 0.1 * fromIntegral x - 0.05 * fromIntegral y) 1)
        `shouldSatisfy` \(low, high) -> abs (low - 0.35) < 1e-12 && abs (high - 0.65) < 1e-12
  describe "between pixels" $ do
    prop "cubic light is interpolated exactly" $
      forAll (vectorOf 4 (inRange (-0.002) 0.002)) $ \cs -> do
        let cubic x = 0.5 + sum (zipWith (*) cs [1, x, x * x, x * x * x])
        case between (map (shining . cubic) [-1.5, -0.5, 0.5, 1.5]) of
          Nothing -> counterexample "traced" False
          Just layers -> counterexample "differs" (near 1e-12 (cubic 0) (layersGas layers))
    it "a ray is traced where an edge or a crease is" $ do
      between (map shining [0.2, 0.2, 0.5, 0.5]) `shouldSatisfy` isNothing
      between (map shining [0.2, 0.5, 0.5, 0.2]) `shouldSatisfy` isNothing
      between (map shining [0.5, 0.5, 0.5, 0.5]) `shouldSatisfy` isJust
    it "a ray is traced where the share of the sky changes" $ do
      let clear shares = between [Layers (grey 0.5) share 1 | share <- shares]
      clear [0, 0, 0.6, 0.6] `shouldSatisfy` isNothing
      clear [0.2, 0.2, 0.21, 0.21] `shouldSatisfy` isJust
    it "open sky needs no ray" $
      between (replicate 4 (Layers black 1 1)) `shouldBe` Just (Layers black 1 0)
    it "rays are traced everywhere near the photon ring, and where the disk is thin" $ do
      let throughout shown column row = fmap (\t -> tracedThroughout t column row) (tracer shown)
          scene = defaultScene {scenePicture = Picture 960 540}
          thinner disk = disk {diskThickness = 1e-3}
          ahead = (sceneCamera scene) {cameraPose = LookAt (XYZ 0 0 (-28)) (XYZ 0 0 0)}
          level = scene {sceneCamera = ahead}
      throughout scene 0 270 `shouldBe` Just False
      [column | column <- [0, 8 .. 952], throughout scene column 270 == Just True]
        `shouldSatisfy` \near' -> length near' > 4 && length near' < 20
      throughout level 0 270 `shouldBe` Just False
      throughout level {sceneDisk = thinner <$> sceneDisk scene} 0 270 `shouldBe` Just True
    it "behind a lens every ray finds the sky for itself" $ do
      let scene = defaultScene {scenePicture = Picture 480 270}
          found t = (layersClear (storedLayers t 8 4), tracedThroughout t 8 4)
      fmap found (tracer scene) `shouldBe` Just (1, False)
      fmap found (tracer scene {sceneAperture = 1}) `shouldBe` Just (0, True)
    it "columns of every coarseness lie between coarser ones, shifted from row to row" $ do
      Just traced <- pure (tracer defaultScene)
      forM_ [(c, r) | c <- [6 .. 60], r <- [0 .. 3]] $ \(c, r) -> do
        let apart = coarseness traced False c r
        apart `shouldSatisfy` (`elem` [1, 2, 4])
        if apart == 4
          then coarseness traced False c (r + 1) `shouldBe` 2
          else forM_ [-3, -1, 1, 3] $ \k ->
            coarseness traced False (c + k * apart) r `shouldSatisfy` (> apart)
  it "the sky in a span is the sky behind each of its pixels" $
    -- The second picture's spans are longer than a field of the Milky Way's map.
    forM_ [(640, 360), (400, 225)] $ \(width, height) -> do
      let scene = defaultScene {scenePicture = Picture width height, sceneDisk = Nothing}
      Just traced <- pure (tracer scene)
      let differences =
            [ abs (luminance found - luminance alone) / (0.01 + luminance alone)
              | row <- [3, 14 .. height - 1],
                let node column = skyNode traced column row,
                start <- [0, 24 .. width - 16],
                let between' = skySpan traced (node start) (node (start + spanLength)),
                column <- [start .. start + spanLength - 1],
                let found = skyInSpan traced between' column row,
                let alone = patchLight (pixelSky traced column row)
            ]
      -- Stars of 20 times white are in it.
      maximum differences `shouldSatisfy` (< 0.05)
      sum differences / fromIntegral (length differences) `shouldSatisfy` (< 0.001)
  where
    -- Every scatter is much larger than this noise.
    shared kind = sharedLight (kernel kind) 1 1e-30
    shining v = Layers (grey v) 0 1
    near error' v light = abs (luminance light - v) < error'
    between layers = case (tracer defaultScene, layers) of
      (Just traced, [a, b, c, d]) -> layersBetween traced a b c d
      _ -> Nothing
