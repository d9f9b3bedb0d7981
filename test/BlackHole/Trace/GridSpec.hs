module BlackHole.Trace.GridSpec (spec) where

import BlackHole.Light.Radiance
import BlackHole.Trace.Grid
import BlackHole.Vector.XYZ (XYZ (..))
import Support.Generators
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck

spec :: Spec
spec = do
  prop
    "is light where longitude and latitude have passed an even number of tens of degrees"
    $ \(Direction d@(XYZ x y z)) ->
      let longitude = atan2 z x * 18 / pi
          latitude = asin (max (-1) (min 1 y)) * 18 / pi
          fields = floor longitude + floor latitude :: Int
          clear v = abs (v - fromIntegral (round v :: Int)) > 1e-9
          light = if even fields then 0.8 else 0.15
       in clear longitude && clear latitude
            ==> counterexample
              (show (longitude, latitude))
              (0.6 * light === greenOf (gridRadiance d))
  it "is warm above the disk's plane and cool below" $
    [r > b | Radiance r _ b <- [gridRadiance (XYZ 0.6 0.8 0), gridRadiance (XYZ 0.6 (-0.8) 0)]]
      `shouldBe` [True, False]
  where
    greenOf (Radiance _ g _) = g
