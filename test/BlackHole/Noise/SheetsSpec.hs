module BlackHole.Noise.SheetsSpec (spec) where

import BlackHole.Noise.Gradient
import BlackHole.Noise.Lattice
import BlackHole.Noise.PerlinG
import BlackHole.Noise.Sheets
import BlackHole.Vector.XY (XY (..))
import Support.Allocation
import Support.Approx
import Support.Generators
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck

spec :: Spec
spec = do
  describe "the octaves" $ do
    it "have amplitudes that fall by the gain and add up to 1" $ do
      sum (sheetsAmplitudes noise) `shouldBeWithin` (1e-15, 1)
      zipWith (/) (drop 1 (sheetsAmplitudes noise)) (sheetsAmplitudes noise)
        `shouldSatisfy` all (\q -> abs (q - 0.6) < 1e-15)
    it "are eight at most and none at least" $
      map
        (length . sheetsAmplitudes)
        [sheets seed (-1) 0.5, sheets seed 0 0.5, sheets seed 3 0.5, sheets seed 9 0.5]
        `shouldBe` [0, 0, 3, 8]
    prop "are plane noise on slanted sheets, bit for bit, each hash worked out anew" $
      forAll place $ \(turns, v, height) ->
        sheetsValue noise 64 turns v height
          === hashed 4 (zip (sheetsAmplitudes noise) tilts) turns v height
  describe "the whole" $ do
    prop "stays within −1 … 1" $
      forAll place $ \(turns, v, height) -> abs (sheetsValue noise 64 turns v height) <= 1
    prop "closes round the first coordinate" $
      forAll place $ \(turns, v, height) ->
        closeTo
          1e-11
          (sheetsValue noise 64 turns v height)
          (sheetsValue noise 64 (turns - signum turns) v height)
    prop "repeats in the second one" $
      forAll place $ \(turns, v, height) ->
        closeTo
          1e-11
          (sheetsValue noise 64 turns v height)
          (sheetsValue noise 64 turns (v + sheetsHeight) height)
    prop "has no steps at the borders of its cells" $
      forAll ((,,) <$> choose (-64, 64 :: Int) <*> choose (-64, 64 :: Int) <*> place) $
        \(i, j, (turns, v, _)) ->
          let border = fromIntegral i / 64
              border' = fromIntegral j / 8
           in conjoin
                [ -- The steepest slope of the noise is some 8 · 8 · 3 a turn.
                  closeTo
                    1e-6
                    (sheetsValue noise 64 (border - 1e-9) v 0)
                    (sheetsValue noise 64 (border + 1e-9) v 0),
                  closeTo
                    1e-6
                    (sheetsValue noise 64 turns (border' - 1e-9) 0)
                    (sheetsValue noise 64 turns (border' + 1e-9) 0)
                ]
    prop "and is as steep on both sides of them" $
      forAll ((,) <$> choose (-64, 64 :: Int) <*> place) $ \(i, (_, v, _)) ->
        let at t = sheetsValue noise 64 (fromIntegral i / 64 + t) v 0
         in closeTo 1e-2 ((at 1e-6 - at 0) / 1e-6) ((at 0 - at (-1e-6)) / 1e-6)
    prop "changes with the height" $
      forAll place $ \(turns, v, height) ->
        abs height > 0.01 ==> sheetsValue noise 64 turns v height =/= sheetsValue noise 64 turns v 0
    it "has the mean and the variance of independent octaves" $ do
      let values =
            [ sheetsValue
                (sheets (Seed s) 4 0.6)
                64
                (spread 0.618 i - 0.5)
                (32 * spread 0.7549 i)
                (spread 0.5698 i)
              | s <- [1 .. 8],
                i <- [1 .. 4000 :: Int]
            ]
          count = fromIntegral (length values)
          mean = sum values / count
      mean `shouldBeWithin` (0.01, 0)
      (sum (map (^ (2 :: Int)) values) / count)
        `shouldBeWithin` (0.003, 0.0962 * sum (map (^ (2 :: Int)) (sheetsAmplitudes noise)))
  describe "a count of octaves" $ do
    prop "leaves out those beyond it" $
      forAll ((,) <$> choose (0, 4) <*> place) $ \(n, (turns, v, height)) ->
        sheetsValue noise (fromIntegral n) turns v height
          === hashed n (zip (sheetsAmplitudes noise) tilts) turns v height
    prop "counts the last one by its fraction" $
      forAll ((,) <$> inRange 0 4 <*> place) $ \(count, (turns, v, height)) ->
        let below = fromIntegral (floor count :: Int)
            at n = sheetsValue noise n turns v height
         in closeTo 1e-14 (at below + (count - below) * (at (below + 1) - at below)) (at count)
    prop "of none is nothing" $
      forAll place $ \(turns, v, height) -> sheetsValue noise (-1) turns v height === 0
  it "allocates nothing" $
    whenOptimised $ do
      let summed :: Int -> Double
          summed n = go n 0
            where
              go :: Int -> Double -> Double
              go 0 acc = acc
              go k acc =
                let t =
                      fromIntegral k
                 in acc `seq` go (k - 1) (acc + sheetsValue noise 4 (t * 1e-5) (t * 0.01) 0.3)
      few <- allocatedBytes (summed 100)
      many <- allocatedBytes (summed 10100)
      -- A boxed result for each value.
      (many - few) `div` 10000 `shouldSatisfy` (<= 16)
  where
    seed = Seed 42
    noise = sheets seed 4 0.6
    place = (,,) <$> inRange (-1) 1 <*> inRange (-40) 40 <*> inRange (-3) 3
    spread :: Double -> Int -> Double
    spread step i = let x = step * fromIntegral i in x - fromIntegral (floor x :: Int)
    tilts = iterate (+ 2.399963229728653) 0.7

-- | The same noise by 'interpolate2': the hash of a lattice point is that of the
-- point a whole number of turns and heights away.
hashed :: Int -> [(Double, Double)] -> Double -> Double -> Double -> Double
hashed count octaves turns v height =
  foldl (\summed (i, octave) -> summed + layer i octave) 0 (zip [0 ..] (take count octaves))
  where
    layer :: Int -> (Double, Double) -> Double
    layer i (amplitude, tilt) =
      let l = clampedLevel (5 + i)
          cells = cellsPerUnit l
          size = 2 ^ i
          x = size * (8 * turns + cos tilt * height)
          y = size * (v + sin tilt * height)
          wrapped p =
            latticePoint2
              l
              ((pointX2 p - middleIndex l) `mod` (8 * 2 ^ i))
              ((pointY2 p - middleIndex l) `mod` (32 * 2 ^ i))
          inCell cell = interpolate2 cell (cornerHashes2 (latticeHash2 (Seed 42) . wrapped) cell)
       in amplitude * maybe 0 (inCell . cellAround2 l) (onGrid2 (XY (x / cells) (y / cells)))
