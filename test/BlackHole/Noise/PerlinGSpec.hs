module BlackHole.Noise.PerlinGSpec (spec) where

import BlackHole.Noise.Gradient
import BlackHole.Noise.Lattice
import BlackHole.Noise.PerlinG
import BlackHole.Noise.Profile (Profile, layers, normalised, octaves, profile, profileBound)
import BlackHole.Vector.XY (XY (..))
import qualified BlackHole.Vector.XY as XY
import BlackHole.Vector.XYZ (XYZ (..))
import qualified BlackHole.Vector.XYZ as XYZ
import Data.Bits (shiftL)
import Data.Foldable (for_)
import Data.List (nub)
import qualified Data.List as List
import Data.Word (Word64)
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck (Arbitrary (..), choose, forAll, property, vectorOf, (===))

spec :: Spec
spec = do
  describe "gradients" gradients
  describe "lattice hashes" latticeHashes
  describe "one level" oneLevel
  describe "statistics" statistics
  describe "smoothness across borders" smoothness
  describe "profiles" profiles
  describe "cached hashes" cached
  describe "golden values" golden

gradients :: Spec
gradients = do
  it "are 16 and 48 different unit vectors" $ do
    length (nub allGradients2) `shouldBe` 16
    length (nub allGradients3) `shouldBe` 48
    map XY.norm allGradients2 `shouldSatisfy` all (within 1.0e-15 1)
    map XYZ.norm allGradients3 `shouldSatisfy` all (within 1.0e-15 1)

  it "have the circle's moments up to order 15" $
    for_ [(i, j) | i <- [0 .. 15], j <- [0 .. 15 - i]] $ \(i, j) ->
      mean [x ^ i * y ^ j | XY x y <- allGradients2]
        `shouldSatisfy` within 1.0e-15 (sphereMoment 2 [i, j])

  it "have the sphere's moments up to order 7" $
    for_ [(i, j, k) | i <- [0 .. 7], j <- [0 .. 7 - i], k <- [0 .. 7 - i - j]] $ \(i, j, k) ->
      mean [x ^ i * y ^ j * z ^ k | XYZ x y z <- allGradients3]
        `shouldSatisfy` within 1.0e-15 (sphereMoment 3 [i, j, k])

  it "are equally likely" $ do
    let hashes = [latticeHash3 (Seed 6) (latticePoint3 unitLevel i 5 9) | i <- [1 .. 4800]]
        chiSquared gs =
          let counts = [fromIntegral (length (filter (== g) gs)) | g <- nub gs] :: [Double]
              expected = 4800 / fromIntegral (length counts)
           in sum [(c - expected) ^ (2 :: Int) / expected | c <- counts]
    -- 47 and 15 degrees of freedom: mean plus four standard deviations.
    chiSquared (map gradientOf3 hashes) `shouldSatisfy` (< 86)
    chiSquared (map gradientOf2 hashes) `shouldSatisfy` (< 37)

latticeHashes :: Spec
latticeHashes = do
  prop "are those of the points on a line, around the torus" $ \s (AnyLevel l) x y z z' ->
    lineHash3 (latticeLine3 (Seed s) (latticePoint3 l x y z)) z'
      === latticeHash3 (Seed s) (latticePoint3 l x y z')
  it "differ by seed, level, dimension, coordinate and order of coordinates" $ do
    let values =
          [ latticeHash3 (Seed s) (latticePoint3 (clampedLevel l) x y z)
            | s <- [0, 1],
              l <- [10, 11],
              (x, y, z) <- [(1, 2, 3), (2, 1, 3), (1, 3, 2), (3, 2, 1), (1, 2, 4), (0, 0, 0)]
          ]
            <> [ latticeHash2 (Seed s) (latticePoint2 (clampedLevel l) x y)
                 | s <- [0, 1],
                   l <- [10, 11],
                   (x, y) <- [(1, 2), (2, 1), (0, 0)]
               ]
    length (nub values) `shouldBe` length values

oneLevel :: Spec
oneLevel = do
  prop "keeps within -1 ... 1" $ \seed (AnyLevel l) (Place v@(XYZ x y _)) ->
    abs (noise3 (Seed seed) l v) <= 1 && abs (noise2 (Seed seed) l (XY x y)) <= 1

  it "cannot leave -1 ... 1 whatever the hashes, and the bound is tight" $ do
    let grid = [i / 10 | i <- [0 .. 10]]
        top2 = maximum (map worst2 ([(x, y) | x <- grid, y <- grid] <> [(0.47337784, 0.5)]))
        top3 =
          maximum
            ( map
                worst3
                ( [(x, y, z) | x <- grid, y <- take 6 grid, z <- take 6 grid]
                    <> [(0.57448389, 0.5, 0.45735096)]
                )
            )
    top2 `shouldSatisfy` \t -> t > 0.99998 && t < 1
    top3 `shouldSatisfy` \t -> t > 0.99992 && t < 1

  prop "is 0 at lattice points" $ \seed (AnyLevel l) ->
    forAll (vectorOf 3 (choose (-1000, 1000 :: Int))) $ \cells ->
      case map ((/ cellsPerUnit l) . fromIntegral) cells of
        [x, y, z]
          -- The corners of the one cell of level 0 are half a cell off.
          | levelNumber l > 0 ->
            (noise3 (Seed seed) l (XYZ x y z), noise2 (Seed seed) l (XY x y)) === (0, 0)
        _ -> property True

  it "is 0 at the one lattice point of level 0, the corner of space" $
    noise3 (Seed 5) minBound (XYZ 2147483648 (-2147483648) 6442450944) `shouldBe` 0

  it "is 0 where there is no place" $
    for_ [0 / 0, 1 / 0, -1 / 0] $ \bad -> do
      noise2 (Seed 1) unitLevel (XY 0.5 bad) `shouldBe` 0
      noise3 (Seed 1) unitLevel (XYZ bad 0.5 0.5) `shouldBe` 0
      perlin2 (Seed 1) (octaves unitLevel 3 0.5) (XY bad 0.5) `shouldBe` 0
      perlin3 (Seed 1) (octaves unitLevel 3 0.5) (XYZ 0.5 0.5 bad) `shouldBe` 0

  it "is finite for the largest coordinates" $
    noise3 (Seed 1) maxBound (XYZ 1.7e308 (-1.7e308) 0.1) `shouldSatisfy` \n -> abs n <= 1

  prop "has the circumference as its period, so an angle closes without a seam" $ \seed ->
    forAll (choose (0, 5)) $ \n ->
      forAll ((/ 4096) . fromIntegral <$> choose (0, 4095 :: Int)) $ \turns ->
        let l = clampedLevel n
            around2 t = noise2 (Seed seed) l (XY (t * circumference) 1.0e8)
            around3 t = noise3 (Seed seed) l (XYZ 1.0e8 (t * circumference) (-3.0e8))
         in (around2 (turns + 1), around3 (turns + 1), around2 (turns - 3), around3 (turns - 3))
              === (around2 turns, around3 turns, around2 turns, around3 turns)

  it "has no shorter period" $ do
    let around3 t = noise3 (Seed 8) (clampedLevel 3) (XYZ (t * circumference) 1.0e8 3.0e8)
        differences turns =
          sum [abs (around3 (t / 64 + turns) - around3 (t / 64)) | t <- [0 .. 63]] / 64
    for_ [1 / 8, 1 / 4, 1 / 2] $ \turns -> differences turns `shouldSatisfy` (> 0.05)

statistics :: Spec
statistics = do
  it "has mean 0 and the variance that follows from the weights" $ do
    let values3 = map (noise3 (Seed 11) unitLevel) (places 8000)
        values2 = map (noise2 (Seed 11) unitLevel) (places2 8000)
    -- Standard errors: the deviation over sqrt 8000 for the mean, 1.6 % or
    -- less for the variance.
    mean values3 `shouldSatisfy` within 0.0115 0
    mean values2 `shouldSatisfy` within 0.0145 0
    variance values3 / (1.2625 ^ (2 :: Int) * 17527135 / 480729249) `shouldSatisfy` within 0.07 1
    variance values2 / (1.4381 ^ (2 :: Int) * 96835 / 2081079) `shouldSatisfy` within 0.07 1

  it "has a slope of the same variance in every direction of space" $ do
    let slopes = map (slope3 (Seed 12)) (places 6000)
        directions =
          [ XYZ a b c
            | a <- [-1, 0, 1],
              b <- [-1, 0, 1],
              c <- [-1, 0, 1],
              (a, b, c) > (0, 0, 0)
          ]
    for_ directions $ \d ->
      -- The mean square of the slope of the weighted sum, in closed form.
      mean [XYZ.dot d s ^ (2 :: Int) / XYZ.normSquared d | s <- slopes]
        / (1.2625 ^ (2 :: Int) * 119268140 / 480729249)
        `shouldSatisfy` within 0.1 1

  it "has a slope of the same variance in every direction of the plane" $ do
    let slopes = map (slope2 (Seed 12)) (places2 6000)
    for_ [XY (cos a) (sin a) | a <- map (* (pi / 8)) [0 .. 7]] $ \d ->
      mean [XY.dot d s ^ (2 :: Int) | s <- slopes]
        / (1.4381 ^ (2 :: Int) * 38660 / 99099)
        `shouldSatisfy` within 0.1 1

  it "is independent for different seeds, levels and coordinates" $ do
    let sample3 s n = map (noise3 (Seed s) (clampedLevel n)) (places 4000)
        base3 = sample3 1 32
        sample2 s n = map (noise2 (Seed s) (clampedLevel n)) (places2 4000)
        base2 = sample2 1 32
    -- The standard error is 1 / sqrt 4000 = 0.016.
    for_
      [sample3 2 32, sample3 (1 + 2 ^ (63 :: Int)) 32, sample3 1 33, sample3 1 31, sample3 1 36]
      $ \other ->
        correlation base3 other `shouldSatisfy` within 0.08 0
    for_ [sample2 2 32, sample2 1 33, map (noise2 (Seed 1) unitLevel . swap) (places2 4000)] $
      \other ->
        correlation base2 other `shouldSatisfy` within 0.08 0
    correlation base3 base3 `shouldSatisfy` within 1.0e-12 1
  where
    swap (XY x y) = XY y x

smoothness :: Spec
smoothness =
  for_ borders $ \(n, name, border) ->
    it ("level " <> show n <> ", " <> name) $ do
      let l = clampedLevel n
          cell = 1 / cellsPerUnit l
          off k = k * cell
      for_ [Seed 1, Seed 2, Seed 3] $ \seed -> do
        smooth cell $ \d -> noise2 seed l (XY (border + d) (off 0.3))
        smooth cell $ \d -> noise2 seed l (XY (off 0.6) (border + d))
        smooth cell $ \d -> noise3 seed l (XYZ (border + d) (off 0.3) (off 0.7))
        smooth cell $ \d -> noise3 seed l (XYZ (off 0.2) (border + d) (off (-0.6)))
        smooth cell $ \d -> noise3 seed l (XYZ (off 0.4) (off 0.3) (border + d))
        -- Through an edge, and through the lattice point itself.
        smooth cell $ \d -> noise3 seed l (XYZ (border + d) (border - d) (off 0.3))
        smooth cell $ \d -> noise3 seed l (XYZ (border + d) (border - d) (border + d))
  where
    borders =
      [ (32, "zero", 0),
        (32, "a cell border", 3),
        (32, "a negative cell border", -5),
        (32, "a power of two", 65536),
        (32, "a negative power of two", -1024),
        (32, "the edge of the torus", 2147483648),
        (32, "the other edge of the torus", -2147483648),
        (38, "the edge of the torus", 2147483648),
        (20, "zero", 0),
        (20, "a power of two", 1048576),
        (50, "a power of two", 1),
        (64, "zero", 0),
        (64, "a cell border", 7 / 4294967296),
        (64, "a power of two", 1 / 128),
        (1, "zero", 0),
        (1, "the edge of the torus", 2147483648),
        (0, "the edge of the torus", -2147483648)
      ] ::
        [(Int, String, Double)]

-- | Value, slope and curvature have one limit from both sides. The steps are
-- 2^-10 of a cell: the one-sided differences err by less than 1e-4 (slope) and
-- 2e-2 (curvature), while a cubic weight would make the curvature jump by
-- several units, and a wrong neighbour the slope by hundreds.
smooth :: Double -> (Double -> Double) -> Expectation
smooth cell f = do
  abs (g 1 - g (-1)) `shouldSatisfy` (< 16 * h)
  slopeTo 1 + slopeTo (-1) `shouldSatisfy` within 2.0e-3 0
  curvatureTo 1 - curvatureTo (-1) `shouldSatisfy` within 0.05 0
  where
    h = 1 / 1024
    g k = f (k * h * cell)
    slopeTo s = (4 * g s - 3 * g 0 - g (2 * s)) / (2 * h)
    curvatureTo s = (2 * g 0 - 5 * g s + 4 * g (2 * s) - g (3 * s)) / (h * h)

profiles :: Spec
profiles = do
  prop "are sums of amplitude times noise" $ \seed (Place v@(XYZ x y _)) -> do
    let s = Seed seed
        total one = List.foldl' (\acc (l, a) -> acc + a * one l) 0 (layers someProfile)
    perlin3 s someProfile v `shouldSatisfy` within 1.0e-14 (total (\l -> noise3 s l v))
    perlin2 s someProfile (XY x y)
      `shouldSatisfy` within 1.0e-14 (total (\l -> noise2 s l (XY x y)))

  prop "are linear" $ \seed (Place v) ->
    let s = Seed seed
        other = octaves (clampedLevel 33) 4 0.7
     in perlin3 s (someProfile <> other) v
          `shouldSatisfy` within 1.0e-13 (perlin3 s someProfile v + perlin3 s other v)

  prop "keep within their bound" $ \seed (Place v@(XYZ x y _)) -> do
    abs (perlin3 (Seed seed) someProfile v) `shouldSatisfy` (<= profileBound someProfile)
    abs (perlin3 (Seed seed) (normalised someProfile) v) `shouldSatisfy` (<= 1)
    abs (perlin2 (Seed seed) (normalised someProfile) (XY x y)) `shouldSatisfy` (<= 1)

  it "give 0 for silence" $
    perlin3 (Seed 1) mempty (XYZ 0.3 0.4 0.5) `shouldBe` 0

cached :: Spec
cached = do
  prop "give the same bits from the parts" $ \seed (AnyLevel l) (Place v@(XYZ x y _)) -> do
    let s = Seed seed
    fmap (\c -> interpolate3 c (cornerHashes3 (latticeHash3 s) c)) (cellAround3 l <$> onGrid3 v)
      `shouldBe` Just (noise3 s l v)
    fmap
      (\c -> interpolate2 c (cornerHashes2 (latticeHash2 s) c))
      (cellAround2 l <$> onGrid2 (XY x y))
      `shouldBe` Just (noise2 s l (XY x y))

-- | Values of an independent implementation in exact rational arithmetic. If
-- they change, so does every picture.
golden :: Spec
golden = do
  for_ plane $ \(seed, n, x, y, expected) ->
    it (unwords ["noise2", show seed, show n, show x, show y]) $
      noise2 (Seed seed) (clampedLevel n) (XY x y) `shouldSatisfy` within 1.0e-14 expected
  for_ space $ \(seed, n, (x, y, z), expected) ->
    it (unwords ["noise3", show seed, show n, show x, show y, show z]) $
      noise3 (Seed seed) (clampedLevel n) (XYZ x y z) `shouldSatisfy` within 1.0e-14 expected
  it "perlin2 and perlin3" $ do
    perlin2 (Seed 3) someProfile (XY 12.34 (-0.056))
      `shouldSatisfy` within 1.0e-13 0.051396522643931644
    perlin3 (Seed 3) someProfile (XYZ 12.34 (-0.056) 7)
      `shouldSatisfy` within 1.0e-13 (-0.2065322215102099)
  where
    plane =
      [ (0, 32, 0.5, 0.25, -0.42244936851506054),
        (42, 32, 1.3, -2.7, 0.14348344241436828),
        (42, 0, 1.0e9, -3.0e8, -0.1874555104141377),
        (maxBound, 64, 1.0000000001, -3.0e-11, 0.08979995870140098),
        (7, 1, -2.1e9, 2147483647.5, 0.006325133572582396),
        (7, 35, 2147483647.96875, -2147483647.90625, -0.2826387965164735)
      ]
    space =
      [ (0, 32, (0.5, 0.25, 0.75), 0.2566458159136451),
        (42, 32, (1.3, -2.7, 0.4), 0.0010906997028006004),
        (42, 0, (1.0e9, -3.0e8, 12345), 0.17827981001584592),
        (maxBound, 64, (1.0000000001, -3.0e-11, 0.1), 0.06355404512772882),
        (7, 1, (-2.1e9, 2147483647.5, 5.0e8), 0.3125471450090517),
        (9, 36, (-0.01, 7.77, -1000000.03), 0.10674998581967778)
      ]

someProfile :: Profile
someProfile =
  profile
    [ (clampedLevel 30, 0.5),
      (clampedLevel 32, 1),
      (clampedLevel 33, 0.25),
      (clampedLevel 40, -0.125)
    ]

-- | A hash for every gradient of the plane.
hashes2 :: [Word64]
hashes2 = [i `shiftL` 60 | i <- [0 .. 15]]

-- | A hash for every gradient of space.
hashes3 :: [Word64]
hashes3 = [((i * 4294967296 + 2147483648) `div` 48) `shiftL` 32 | i <- [0 .. 47]]

allGradients2 :: [XY]
allGradients2 = map gradientOf2 hashes2

allGradients3 :: [XYZ]
allGradients3 = map gradientOf3 hashes3

-- | The mean over the unit sphere in n dimensions of the product of powers of
-- the coordinates: 0 if one is odd, else the product of (e − 1)!! over
-- n (n + 2) … (n + total − 2).
sphereMoment :: Int -> [Int] -> Double
sphereMoment n powers
  | any odd powers = 0
  | otherwise =
    product [fromIntegral k | e <- powers, k <- [e - 1, e - 3 .. 1]]
      / product [fromIntegral k | k <- [n, n + 2 .. n + sum powers - 2]]

-- | The largest noise at these fractions over all choices of hashes.
worst2 :: (Double, Double) -> Double
worst2 (x, y) = interpolate2 (Cell2 (latticePoint2 unitLevel 0 0) x y) (Corners2 a b c d)
  where
    a = best x y
    b = best (x - 1) y
    c = best x (y - 1)
    d = best (x - 1) (y - 1)
    best u v = argMax (XY.dot (XY u v) . gradientOf2) hashes2

-- | The largest noise at these fractions over all choices of hashes.
worst3 :: (Double, Double, Double) -> Double
worst3 (x, y, z) =
  interpolate3
    (Cell3 (latticePoint3 unitLevel 0 0 0) x y z)
    ( Corners3
        (best x y z)
        (best (x - 1) y z)
        (best x (y - 1) z)
        (best (x - 1) (y - 1) z)
        (best x y (z - 1))
        (best (x - 1) y (z - 1))
        (best x (y - 1) (z - 1))
        (best (x - 1) (y - 1) (z - 1))
    )
  where
    best u v w = argMax (XYZ.dot (XYZ u v w) . gradientOf3) hashes3

argMax :: (Word64 -> Double) -> [Word64] -> Word64
argMax f = snd . List.foldl' larger (-1 / 0, 0)
  where
    larger (m, w) v
      | f v > m = (f v, v)
      | otherwise = (m, w)

slope2 :: Seed -> XY -> XY
slope2 seed v = XY (along (XY 1 0)) (along (XY 0 1))
  where
    along d = (f (v XY.^+^ (h XY.*^ d)) - f (v XY.^-^ (h XY.*^ d))) / (2 * h)
    f = noise2 seed unitLevel
    h = 1 / 4096

slope3 :: Seed -> XYZ -> XYZ
slope3 seed v = XYZ (along (XYZ 1 0 0)) (along (XYZ 0 1 0)) (along (XYZ 0 0 1))
  where
    along d = (f (v XYZ.^+^ (h XYZ.*^ d)) - f (v XYZ.^-^ (h XYZ.*^ d))) / (2 * h)
    f = noise3 seed unitLevel
    h = 1 / 4096

-- | Evenly spread places in a cube of 1000 units around the origin: multiples
-- of three independent irrationals, modulo 1.
places :: Int -> [XYZ]
places count =
  [ XYZ (spread i 0.8191725133961645) (spread i 0.6710436067037893) (spread i 0.5497004779019703)
    | i <- [1 .. count]
  ]

-- | Evenly spread places in a square of 1000 units around the origin.
places2 :: Int -> [XY]
places2 count = [XY x y | XYZ x y _ <- places count]

spread :: Int -> Double -> Double
spread i a = 1000 * (t - fromIntegral (floor t :: Int)) - 500
  where
    t = fromIntegral i * a

mean :: [Double] -> Double
mean xs = sum xs / fromIntegral (length xs)

variance :: [Double] -> Double
variance xs = mean [(x - m) * (x - m) | x <- xs]
  where
    m = mean xs

correlation :: [Double] -> [Double] -> Double
correlation xs ys =
  mean (zipWith (\x y -> (x - mx) * (y - my)) xs ys) / sqrt (variance xs * variance ys)
  where
    mx = mean xs
    my = mean ys

within :: Double -> Double -> Double -> Bool
within tolerance expected x = abs (x - expected) <= tolerance

newtype AnyLevel = AnyLevel Level
  deriving (Show)

instance Arbitrary AnyLevel where
  arbitrary = AnyLevel . clampedLevel <$> choose (0, 64)

-- | Places of many magnitudes on both sides of zero.
newtype Place = Place XYZ
  deriving (Show)

instance Arbitrary Place where
  arbitrary = Place <$> (XYZ <$> coordinate <*> coordinate <*> coordinate)
    where
      coordinate = (\m e -> m * 2 ^^ (e :: Int)) <$> choose (-1, 1) <*> choose (-40, 33)

gradientOf2 :: Word64 -> XY
gradientOf2 = numberedGradient2 . gradientNumber2

gradientOf3 :: Word64 -> XYZ
gradientOf3 = numberedGradient3 . gradientNumber3
