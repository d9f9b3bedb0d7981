module BlackHole.Noise.ProfileSpec (spec) where

import BlackHole.Noise.Lattice (Level, clampedLevel, levelNumber, unitLevel)
import BlackHole.Noise.Profile
import Data.Functor.Identity (Identity (..))
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck (Arbitrary (..), choose, listOf, (===))

spec :: Spec
spec = do
  it "keeps the amplitudes, coarse to fine" $
    layers (profile [at 40 2, at 3 (-1), at 64 0.5, at 0 7])
      `shouldBe` [at 0 7, at 3 (-1), at 40 2, at 64 0.5]

  it "adds the amplitudes of a level named twice" $
    layers (profile [at 5 1, at 9 1, at 5 2]) `shouldBe` [at 5 3, at 9 1]

  it "makes octaves from coarse to fine" $
    layers (octaves unitLevel 3 0.5) `shouldBe` [at 32 1, at 33 0.5, at 34 0.25]

  it "leaves out octaves that do not exist" $ do
    layers (octaves (clampedLevel 63) 5 0.5) `shouldBe` [at 63 1, at 64 0.5]
    octaves unitLevel 0 0.5 `shouldBe` mempty
    octaves unitLevel (-1) 0.5 `shouldBe` mempty

  it "normalises to the bound 1" $
    layers (normalised (profile [at 1 3, at 2 (-1)])) `shouldBe` [at 1 0.75, at 2 (-0.25)]

  it "leaves alone what has no shape" $ do
    normalised mempty `shouldBe` mempty
    normalised (profile [at 1 0]) `shouldBe` mempty
    profileBound (normalised (profile [at 1 (1 / 0)])) `shouldBe` 1 / 0

  prop "adds level by level" $ \(Pairs a) (Pairs b) ->
    profile a <> profile b === profile (a <> b)

  prop "sums amplitude times value" $ \(Pairs pairs) ->
    let value = fromIntegral . (+ 1) . levelNumber
        expected = sum [a * value l | (l, a) <- pairs]
     in abs (runIdentity (sumLayers (Identity . value) (profile pairs)) - expected) <= 1.0e-9

at :: Int -> Double -> (Level, Double)
at n a = (clampedLevel n, a)

newtype Pairs = Pairs [(Level, Double)]
  deriving (Show)

instance Arbitrary Pairs where
  -- Multiples of 1/8, so that sums do not depend on their order.
  arbitrary =
    Pairs
      <$> listOf
        ( (,) . clampedLevel
            <$> choose (0, 64) <*> ((/ 8) . fromIntegral <$> choose (-80, 80 :: Int))
        )
