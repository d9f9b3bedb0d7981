module BlackHole.Noise.LatticeSpec (spec) where

import BlackHole.Noise.Lattice
import BlackHole.Vector.XY (XY (..))
import BlackHole.Vector.XYZ (XYZ (..))
import Data.Bits (shiftL, shiftR)
import Data.Foldable (for_)
import Data.Word (Word64)
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck
  ( Arbitrary (..),
    Property,
    choose,
    counterexample,
    forAll,
    oneof,
    property,
    vectorOf,
    (.&&.),
    (===),
    (==>),
  )

spec :: Spec
spec = do
  describe "levels" $ do
    it "are 0 to 64" $ do
      map (fmap levelNumber . level) [-1, 0, 64, 65] `shouldBe` [Nothing, Just 0, Just 64, Nothing]
      map (levelNumber . clampedLevel) [minBound, -1, 7, 65, maxBound] `shouldBe` [0, 0, 7, 64, 64]
      (minBound, maxBound) `shouldBe` (clampedLevel 0, clampedLevel 64)

    it "have 2^(level - 32) cells to the unit, exactly" $
      for_ [0 .. 64] $ \n ->
        toRational (cellsPerUnit (clampedLevel n)) `shouldBe` 2 ^^ (n - 32)

    it "have 2^level cells around the torus" $
      for_ [0 .. 64] $ \n ->
        toRational (cellsPerUnit (clampedLevel n)) * toRational circumference `shouldBe` 2 ^ n

  describe "lattice points" $ do
    prop "go around the torus" $ \(AnyLevel l) x y z -> do
      let p = latticePoint3 l x y z
          q = latticePoint2 l x y
          size = 2 ^ levelNumber l
      map toInteger [pointX3 p, pointY3 p, pointZ3 p, pointX2 q, pointY2 q]
        `shouldBe` map ((`mod` size) . toInteger) [x, y, z, x, y]
      (pointLevel3 p, pointLevel2 q) `shouldBe` (l, l)

  describe "the cell around a place" $ do
    it "has the origin of space in the middle of the grid" $
      for_ [1 .. 64] $ \n ->
        cellAt3 (clampedLevel n) (XYZ 0 0 0)
          `shouldBe` Just
            (Cell3 (latticePoint3 (clampedLevel n) (half n) (half n) (half n)) 0 0 0)

    it "has all of space in the one cell of level 0" $
      cellAt3 minBound (XYZ 0 (2 ^ (30 :: Int)) (-2147483648))
        `shouldBe` Just (Cell3 (latticePoint3 minBound 0 0 0) 0.5 0.75 0)

    prop
      "agrees with exact arithmetic"
      $ \(AnyLevel l) (Coordinate x) (Coordinate y) (Coordinate z) ->
        agrees3 l (XYZ x y z)

    prop
      "agrees with exact arithmetic in the plane"
      $ \(AnyLevel l) (Coordinate x) (Coordinate y) ->
        agrees2 l (XY x y)

    it "keeps the fraction at the deepest level" $
      -- 2^-32 (5 + 2^-45): a cast to fixed point would lose the fraction.
      cellAt2 maxBound (XY (5 / 2 ^ (32 :: Int) + 1 / 2 ^ (77 :: Int)) (-1 / 2 ^ (72 :: Int)))
        `shouldBe` Just
          ( Cell2
              (latticePoint2 maxBound (half 64 + 5) (half 64 - 1))
              (1 / 2 ^ (45 :: Int))
              (1 - 1 / 2 ^ (40 :: Int))
          )

    prop "is half the cell of the next level" $ \(Coordinate x) (Coordinate y) (Coordinate z) ->
      forAll (choose (0, 63)) $ \n ->
        case (cellAt3 (clampedLevel n) (XYZ x y z), cellAt3 (clampedLevel (n + 1)) (XYZ x y z)) of
          (Just (Cell3 p u v w), Just (Cell3 q _ _ _)) ->
            -- A fraction rounded up to 1 belongs to the cell below, or was
            -- counted with the cell above.
            all (< 1) [u, v, w]
              ==> map (`shiftR` 1) [pointX3 q, pointY3 q, pointZ3 q]
              === [pointX3 p, pointY3 p, pointZ3 p]
          _ -> property False

    prop "is the same after a turn around the torus" $ \(AnyLevel l) ->
      forAll
        (vectorOf 3 ((/ 1024) . fromIntegral <$> choose (-2199023255552, 2199023255551 :: Int)))
        $ \place -> forAll (vectorOf 3 (choose (-3, 3 :: Int))) $ \turns ->
          case (place, zipWith (\x n -> x + fromIntegral n * circumference) place turns) of
            ([x, y, z], [x', y', z']) ->
              cellAt3 l (XYZ x y z) === cellAt3 l (XYZ x' y' z')
            _ -> property False

    it "exists for the largest coordinates, and only for finite ones" $ do
      cellAt3 maxBound (XYZ 1.7e308 (-1.7e308) 1.0e30)
        `shouldBe` cellAt3 maxBound (XYZ 0 0 0)
      for_ [0 / 0, 1 / 0, -1 / 0] $ \bad -> do
        for_ [XYZ bad 0 0, XYZ 0 bad 0, XYZ 0 0 bad] $ \v ->
          cellAt3 unitLevel v `shouldBe` Nothing
        for_ [XY bad 0, XY 0 bad] $ \v ->
          cellAt2 unitLevel v `shouldBe` Nothing

cellAt2 :: Level -> XY -> Maybe Cell2
cellAt2 l = fmap (cellAround2 l) . onGrid2

cellAt3 :: Level -> XYZ -> Maybe Cell3
cellAt3 l = fmap (cellAround3 l) . onGrid3

half :: Int -> Word64
half n = 1 `shiftL` (n - 1)

agrees2 :: Level -> XY -> Property
agrees2 l v@(XY x y) = case cellAt2 l v of
  Nothing -> property False
  Just (Cell2 p u w) -> agrees l x (pointX2 p) u .&&. agrees l y (pointY2 p) w

agrees3 :: Level -> XYZ -> Property
agrees3 l v@(XYZ x y z) = case cellAt3 l v of
  Nothing -> property False
  Just (Cell3 p u w t) ->
    agrees l x (pointX3 p) u .&&. agrees l y (pointY3 p) w .&&. agrees l z (pointZ3 p) t

-- | The distance on the torus between the exact place, in cells from the edge
-- of the grid, and index plus fraction is at most one rounding.
agrees :: Level -> Double -> Word64 -> Double -> Property
agrees l x index fraction =
  counterexample (show (levelNumber l, x, index, fraction)) $
    fraction >= 0 && fraction <= 1 && toInteger index < 2 ^ levelNumber l
      && min gap (size - gap) <= 2 ^^ (-53 :: Int)
  where
    size = 2 ^ levelNumber l :: Rational
    exact = (toRational x + 2 ^ (31 :: Int)) * 2 ^^ (levelNumber l - 32)
    difference = exact - (fromIntegral index + toRational fraction)
    gap = difference - size * fromInteger (floor (difference / size))

newtype AnyLevel = AnyLevel Level
  deriving (Show)

instance Arbitrary AnyLevel where
  arbitrary = AnyLevel . clampedLevel <$> choose (0, 64)

-- | Coordinates of every magnitude, among them cell borders, places just
-- beside them, and places beyond the torus' edge.
newtype Coordinate = Coordinate Double
  deriving (Show)

instance Arbitrary Coordinate where
  arbitrary =
    Coordinate
      <$> oneof
        [ scaled <$> choose (-1, 1) <*> choose (-60, 40),
          border <$> choose (-8, 8) <*> choose (-34, 34) <*> choose (-1, 1),
          choose (-100, 100)
        ]
    where
      scaled m e = m * 2 ^^ (e :: Int) :: Double
      border n e nudge =
        fromIntegral (n :: Int) * 2 ^^ (e :: Int) * (1 + fromIntegral (nudge :: Int) * 2.3e-16)
