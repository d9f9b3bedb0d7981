module BlackHole.Explore.PaceSpec (spec) where

import BlackHole.Explore.Pace
import BlackHole.Explore.Refinement (fitting)
import BlackHole.Scene.Camera (Picture (..))
import Test.Hspec
import Test.QuickCheck

spec :: Spec
spec = do
  it "finds the size that takes the time allowed, on machines of any speed" $
    forAll (choose (-7, -5)) $ \power ->
      let perPixel = 10 ** power
          fixed = 0.008 :: Double
          next pace =
            let Picture w h =
                  movingSize pace window
             in paced (w * h) (fixed + perPixel * fromIntegral (w * h)) pace
          settled = iterate next initialPace !! 40
          Picture width height = movingSize settled window
          seconds = fixed + perPixel * fromIntegral (width * height)
       in counterexample (show (width, height, seconds)) $
            if Picture width height == window
              then seconds < 1.3 * targetSeconds
              else seconds < 1.3 * targetSeconds && seconds > targetSeconds / 1.3
  it "keeps the shape, and a least size however slow the machine is" $ do
    let slow = iterate (paced 2304 5) initialPace !! 20
    movingSize slow window `shouldBe` Picture 64 36
    movingSize slow (Picture 20 10) `shouldBe` Picture 20 10
  it "fits a picture into a window" $ do
    fitting (Picture 1920 1080) (920, 548) `shouldBe` Picture 920 518
    fitting (Picture 100 100) (920, 548) `shouldBe` Picture 548 548
    fitting (Picture 65536 1) (100, 100) `shouldBe` Picture 100 1
  where
    window = Picture 960 540
