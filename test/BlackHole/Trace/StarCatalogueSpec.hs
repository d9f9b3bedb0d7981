module BlackHole.Trace.StarCatalogueSpec (spec) where

import BlackHole.Light.Radiance
import BlackHole.Noise.PerlinG (Seed (..))
import BlackHole.Trace.EnvironmentMap
import BlackHole.Trace.Galaxy
import BlackHole.Trace.MilkyWay
import BlackHole.Trace.RayDifferential
import BlackHole.Trace.StarCatalogue
import BlackHole.Vector.XYZ (XYZ (..), (^+^), (^-^))
import qualified BlackHole.Vector.XYZ as XYZ
import Support.Approx
import Support.Generators
import Test.Hspec
import Test.Hspec.QuickCheck (prop)

spec :: Spec
spec = do
  it "has as many stars up to each magnitude as our sky" $
    -- Allen's Astrophysical Quantities: some 50, 500 and 9000 up to 2, 4 and 6.5.
    sequence_
      [ ( fromIntegral (length [() | i <- [0 .. starCount stars - 1], starMagnitude stars i <= m])
            / expected
        )
          `shouldBeWithin` (0.05, 1 :: Double)
        | (m, expected) <- [(2, 50.6), (4, 506), (6.5, 8995)]
      ]
  it "is in order of brightness, and a longer one only goes on" $ do
    let magnitudes = map (starMagnitude stars) [0 .. 4999]
    and (zipWith (<=) magnitudes (drop 1 magnitudes)) `shouldBe` True
    let short = starCatalogue (Seed 1) 100
    map (starDirection short) [0 .. 99] `shouldBe` map (starDirection stars) [0 .. 99]
  it "five magnitudes are a factor of 100" $
    (fluxOfMagnitude 0 / fluxOfMagnitude 5) `shouldBeWithin` (1e-9, 100)
  it "another seed is another sky" $
    starDirection (starCatalogue (Seed 2) 1) 0 `shouldNotBe` starDirection stars 0
  it "bright stars lie all over the sky, faint ones closer to the galaxy's plane" $ do
    let height i = let XYZ _ _ p = toGalactic (starDirection stars i) in abs p
        near from to =
          fromIntegral (length (filter (< 0.2) (map height [from .. to - 1])))
            / fromIntegral (to - from) ::
            Double
    near 0 500 `shouldBeWithin` (0.07, 0.24)
    near 6000 12000 `shouldBeWithin` (0.03, 0.43)
  it "whichever side of the plane and whatever longitude, there are as many" $ do
    let mean = foldr ((^+^) . starDirection stars) (XYZ 0 0 0) [0 .. 11999]
    (XYZ.norm mean / 12000) `shouldSatisfy` (< 0.02)
  it "temperatures are those of stars, half of them between 5000 and 10000 K" $ do
    let temperatures = map (starTemperature stars) [0 .. 11999]
    minimum temperatures `shouldSatisfy` (>= 3000)
    maximum temperatures `shouldSatisfy` (<= 20000)
    (fromIntegral (length (filter (\t -> t > 5200 && t < 10000) temperatures)) / 12000)
      `shouldBeWithin` (0.02, 0.5 :: Double)
  prop "galactic coordinates turn and turn back" $ \(Direction d) ->
    closeTo 1e-12 0 (XYZ.norm (fromGalactic (toGalactic d) ^-^ d))
  it "the Milky Way is brighter in its plane than at its poles, and brightest about the middle" $ do
    let lights =
          [ luminance (foldMap (environmentMapRadianceAt . fromGalactic) places)
            | places <- [ring 1, ring (-1), [XYZ 0 0 1, XYZ 0 0 (-1)]]
          ]
        ring c = [XYZ (c * cos t) (sin t) 0 | t <- [-0.5, -0.25 .. 0.5]]
    case lights of
      [middle, far, poles] -> do
        middle `shouldSatisfy` (> far)
        (far / 5) `shouldSatisfy` (> 3 * poles / 2)
      _ -> expectationFailure "three sums"
  where
    stars = starCatalogue (Seed 1) 12000
    band = milkyWay (Seed 3)
    environmentMapRadianceAt d =
      environmentMapRadiance band (RayDifferential d (XYZ 0 0 0) (XYZ 0 0 0))
