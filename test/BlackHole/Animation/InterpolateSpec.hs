module BlackHole.Animation.InterpolateSpec (spec) where

import BlackHole.Animation.Interpolate
import Data.List (sort)
import Support.Approx
import Support.Generators
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck

spec :: Spec
spec = do
  describe "makeKeys" $ do
    it "names what is wrong" $ do
      makeKeys [] `shouldBe` Left NoKeys
      makeKeys [(0, [1]), (0, [2])] `shouldBe` Left (NotLater 1)
      makeKeys [(0, [1]), (1, [0 / 0])] `shouldBe` Left (NotFinite 1)
      makeKeys [(0, [1]), (1, [2, 3])] `shouldBe` Left (OtherDimension 1)
  describe "valueAt" $ do
    prop "is exactly the keys' values at the keys and constant outside" $
      forAll randomKeys $ \(kind, list) -> withKeys list $ \keys ->
        [valueAt kind keys t | (t, _) <- list] === map snd list
          .&&. valueAt kind keys (fst (headOf list) - 1) === snd (headOf list)
          .&&. valueAt kind keys (fst (lastOf list) + 1) === snd (lastOf list)
    prop "is the straight line for keys on a line, unless it rests at them" $
      forAll ((,) <$> times <*> inRange 0 1) $ \(ts, s) ->
        conjoin
          [ withKeys [(t, [3 * t - 2, 5 - t]) | t <- ts] $ \keys ->
              let t = minimum ts + s * (maximum ts - minimum ts)
               in conjoin (zipWith (closeTo 1e-9) [3 * t - 2, 5 - t] (valueAt kind keys t))
            | kind <- [Linear, Smooth]
          ]
    prop "keeps a parabola between inner keys at unequal times, where no limit applies" $
      forAll ((,) <$> times <*> inRange 0 1) $ \(ts, s) ->
        -- The vertex lies so far before the keys that no chord is five times
        -- as steep as its neighbour.
        let inner = drop 1 (take (length ts - 1) ts)
            t = minimum inner + s * (maximum inner - minimum inner)
            parabola x = (x - 3 * minimum ts + 2 * maximum ts) ^ (2 :: Int)
         in withKeys [(x, [parabola x]) | x <- ts] $ \keys ->
              case valueAt Smooth keys t of
                [v] -> closeTo (1e-9 * (1 + maximum (map (abs . parabola) ts))) (parabola t) v
                _ -> property False
    prop "has one slope on both sides of an inner key, from rest to rest where eased" $
      forAll randomKeys $ \(_, list) -> withKeys list $ \keys ->
        conjoin
          [ conjoin
              [ closeTo (1e-2 * (1 + steepest list)) (slope kind keys t (-h)) (slope kind keys t h)
                | kind <- [Eased, Smooth]
              ]
              .&&. closeTo (1e-2 * (1 + steepest list)) 0 (slope Eased keys t h)
            | (t, _) <- drop 1 (take (length list - 1) list)
          ]
    prop "does not swing back beyond the first key or the last one" $
      forAll randomKeys $ \(_, list) -> withKeys list $ \keys ->
        let inside (ta, a) (tb, b) =
              [ counterexample (show (a, b, v)) (and (zipWith3 sameSide a b v))
                | s <- [0, 0.02 .. 1],
                  let v = valueAt Smooth keys (ta + s * (tb - ta))
              ]
            sameSide a b v = (v - a) * signum (b - a) >= -1e-12
         in conjoin
              ( concat
                  ( zipWith inside (take 1 list) (drop 1 list)
                      ++ zipWith
                        (flip inside)
                        (drop (length list - 2) list)
                        (drop (length list - 1) list)
                  )
              )
    it "rests between equal keys at an end" $
      withKeysIO [(0, [3]), (1, [3]), (2, [9])] $ \keys ->
        map (valueAt Smooth keys) [0.25, 0.5, 0.75] `shouldBe` replicate 3 [3]
    it "passes three unequal keys as worked out by hand" $ do
      -- Keys (0,0), (1,1), (3,0): chords 1 and −1/2, slope at the middle
      -- (2·1 + 1·(−1/2))/3 = 1/2; cubic with slopes 1 and 1/2 at its middle:
      -- 1/2 + (1 − 1/2)/8 = 0.5625.
      withKeysIO [(0, [0]), (1, [1]), (3, [0])] $ \keys ->
        valueAt Smooth keys 0.5 `shouldBe` [0.5625]
      withKeysIO [(0, [0]), (4, [8])] $ \keys -> do
        valueAt Eased keys 1 `shouldBe` [8 * (3 / 16 - 2 / 64)]
        valueAt Held keys 3.9 `shouldBe` [0]
  prop "unwrapDegrees changes by whole turns and never leaps more than half of one" $
    forAll (listOf (inRange (-2000) 2000)) $ \angles ->
      let unwrapped = unwrapDegrees angles
          turns a b = abs (x - fromIntegral (round x :: Int)) < 1e-9 where x = (a - b) / 360
       in and (zipWith turns angles unwrapped)
            .&&. and (zipWith (\a b -> abs (b - a) <= 180 + 1e-9) unwrapped (drop 1 unwrapped))
  it "unwrapDegrees goes from 350 to 10 through 360" $
    unwrapDegrees [350, 10, 350] `shouldBe` [350, 370, 350]
  where
    h = 1e-5
    slope kind keys t d = case (valueAt kind keys (t + d), valueAt kind keys t) of
      (a : _, b : _) -> (a - b) / d
      _ -> 0 / 0
    steepest list = maximum (0 : zipWith chord list (drop 1 list))
    chord (t, v) (t', v') = sum (zipWith (\a b -> abs (b - a)) v v') / (t' - t)

withKeys :: Testable p => [(Double, [Double])] -> (Keys -> p) -> Property
withKeys list check =
  either (\e -> counterexample (show e) False) (property . check) (makeKeys list)

withKeysIO :: [(Double, [Double])] -> (Keys -> Expectation) -> Expectation
withKeysIO list check = either (expectationFailure . show) check (makeKeys list)

headOf, lastOf :: [(Double, [Double])] -> (Double, [Double])
headOf = foldr const (0, [])
lastOf = foldl (const id) (0, [])

-- | At least four times, no two closer than 0.1.
times :: Gen [Double]
times = do
  n <- choose (4, 8)
  gaps <- vectorOf n (inRange 0.1 3)
  start <- inRange (-5) 5
  pure (sort (scanl (+) start gaps))

randomKeys :: Gen (Interpolation, [(Double, [Double])])
randomKeys = do
  ts <- times
  values <- vectorOf (length ts) (vectorOf 2 (inRange (-10) 10))
  kind <- elements [minBound ..]
  pure (kind, zip ts values)
