module BlackHole.Matter.GasMotionSpec (spec) where

import BlackHole.Matter.GasMotion
import BlackHole.Spacetime.Momentum
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck

spec :: Spec
spec = do
  describe "gasVelocity" $ do
    prop "has the norm −1 everywhere outside the horizon" $
      forAll outside $ \(r, y) ->
        fmap (norm2 r y) (gasVelocity r y)
          `shouldSatisfy` maybe False (\(n, size) -> abs (n + 1) < 1e-14 * size)
    prop "is slower off the plane than in it, on the same sphere" $
      forAll outside $ \(r, y) ->
        (velocityTime <$> gasVelocity r y) <= (velocityTime <$> gasVelocity r 0)
    prop "keeps the rates of the equatorial orbit on the whole sphere" $
      forAll outside $ \(r, y) ->
        case (gasVelocity r y, gasVelocity r 0) of
          (Just (FourVelocity t' r' p'), Just (FourVelocity t0 r0 p0)) ->
            abs (p' / t' - p0 / t0) < 1e-14 * p0 / t0
              && abs (r' / t' - r0 / t0) <= 1e-14 * abs (r0 / t0)
          _ -> False
    it "is the textbook circular orbit in the plane from r = 3 up" $
      mapM_
        ( \r -> do
            let timeRate = 1 / sqrt (1 - 3 / (2 * r))
            gasVelocity r 0
              `shouldSatisfy` matches
                1e-14
                (FourVelocity timeRate 0 (timeRate / sqrt (2 * r ** 3)))
        )
        [3, 3.5, 4, 6, 20, 1e4]
    it "is the textbook plunge in the plane inside r = 3" $
      mapM_
        ( \r -> do
            let e2 = 8 / 9
                l2 = 3
                lapse2 = 1 - 1 / r
            gasVelocity r 0
              `shouldSatisfy` matches
                1e-11
                ( FourVelocity
                    (sqrt e2 / lapse2)
                    (negate (sqrt (e2 - lapse2 * (1 + l2 / (r * r)))))
                    (sqrt l2 / (r * r))
                )
        )
        [1.01, 1.2, 1.5, 2, 2.5, 2.8]
    prop "is continuous across the innermost stable orbit" $
      forAll (choose (0, 3)) $ \y ->
        case (gasVelocity 3 y, gasVelocity (3 - 1e-8) y) of
          (Just (FourVelocity a b c), Just (FourVelocity a' b' c')) ->
            maximum [abs (a - a'), abs (b - b'), abs (c - c')] < 1e-8
          _ -> False
    it "falls inwards only below r = 3" $
      map (fmap (signum . velocityRadial) . (`gasVelocity` 0)) [2.999, 3, 3.001]
        `shouldBe` [Just (-1), Just 0, Just 0]
    it "takes heights beyond r for the axis" $
      gasVelocity 2 (-2.0000001) `shouldBe` gasVelocity 2 2
    it "has no gas in the horizon, nor anywhere that is no place" $
      map (`gasVelocity` 0) [1, 0.5, 0, -3, 0 / 0, 1 / 0]
        `shouldBe` replicate 6 Nothing

  prop "the frequency of light is that in the frame of the gas" $
    forAll ((,,) <$> outside <*> choose (-2, 2) <*> choose (-1, 1)) $ \((r, y), radial, turning) ->
      let momentum = Momentum (radial / (1 - 1 / r)) (turning * r)
       in fmap (`frequencyIn` momentum) (gasVelocity r y)
            `shouldSatisfy` maybe
              False
              (\nu -> abs (nu - motionFrequency r y momentum) < 1e-13 * (1 + abs nu) / (1 - 1 / r))
  where
    matches limit (FourVelocity a b c) =
      maybe False $ \(FourVelocity a' b' c') ->
        and
          [ abs (v - v') <= limit * abs v
            | (v, v') <- [(a, a'), (b, b'), (c, c')]
          ]

-- | A distance from 1.0001 to 1e4 and a height up to it, on either side.
outside :: Gen (Double, Double)
outside = do
  r <- (\e -> 1 + 10 ** e) <$> choose (-4, 4)
  latitude <- choose (-pi / 2, pi / 2)
  pure (r, r * sin latitude)

-- | The squared norm in the metric of Schwarzschild, and the size of its
-- terms, which sets the rounding error of their sum.
norm2 :: Double -> Double -> FourVelocity -> (Double, Double)
norm2 r y (FourVelocity ut ur uphi) = (b + c - a, a + b + c)
  where
    lapse2 = (r - 1) / r
    a = lapse2 * ut * ut
    b = ur * ur / lapse2
    c = (r - y) * (r + y) * uphi * uphi
