module BlackHole.Noise.CachedNoiseSpec (spec) where

import BlackHole.Noise.CachedNoise
import BlackHole.Noise.Lattice
import BlackHole.Noise.PerlinG
import BlackHole.Noise.Profile
import BlackHole.Vector.XYZ (XYZ (..))
import Support.Generators
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck

spec :: Spec
spec = do
  prop "is the plain noise bit for bit, inside the box and out of it" $
    forAll (XYZ <$> inRange (-6) 6 <*> inRange (-3) 3 <*> inRange (-6) 6) $ \place ->
      cachedPerlin3 table 64 place === perlin3 seed waves place
  prop "also around the torus" $
    forAll ((,) <$> inRange (-3e9) 3e9 <*> inRange (-1e9) 1e9) $ \(x, y) ->
      cachedPerlin3 ring 64 (XYZ x y 0) === perlin3 seed rings (XYZ x y 0)
  it "keeps to its budget, coarse levels first" $ do
    cachedPoints table `shouldSatisfy` (\n -> n > 1000 && n <= 20000)
    cachedPoints (cacheNoise 0 seed waves (XYZ 0 0 0) (XYZ 1 1 1)) `shouldBe` 0
  it "survives boxes that make no sense" $ do
    let odd' = cacheNoise 1000 seed waves (XYZ (0 / 0) 0 0) (XYZ (-1) (1 / 0) 2)
    cachedPerlin3 odd' 64 (XYZ 0.3 0.4 0.5) `shouldBe` perlin3 seed waves (XYZ 0.3 0.4 0.5)
  where
    seed = Seed 42
    waves = octaves unitLevel 4 0.5
    table = cacheNoise 20000 seed waves (XYZ (-4) (-1) (-4)) (XYZ 4 1 4)
    rings = octaves (clampedLevel 3) 3 0.5
    ring = cacheNoise 100000 seed rings (XYZ (-2147483648) (-5e8) (-1e8)) (XYZ 2147483648 5e8 1e8)
