module BlackHole.Trace.GalaxySpec (spec) where

import BlackHole.Trace.Galaxy
import BlackHole.Vector.XYZ (XYZ (..))
import qualified BlackHole.Vector.XYZ as XYZ
import Support.Approx
import Support.Generators
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck

spec :: Spec
spec = do
  it "has its middle and its pole where they are said to be" $ do
    XYZ.distance (fromGalactic (XYZ 1 0 0)) galacticCentre `shouldBeWithin` (1e-12, 0)
    XYZ.distance (fromGalactic (XYZ 0 0 1)) galacticPole `shouldBeWithin` (1e-12, 0)
  it "is not mirrored: its longitude grows from the middle to the left with the pole above" $
    -- Right-handed: pole × middle is the direction of longitude 90°.
    XYZ.distance (fromGalactic (XYZ 0 1 0)) (XYZ.cross galacticPole galacticCentre)
      `shouldBeWithin` (1e-12, 0)
  prop "goes there and back" $ \(Direction d) ->
    nearXYZ 1e-12 d (toGalactic (fromGalactic d)) .&&. nearXYZ 1e-12 d (fromGalactic (toGalactic d))
  prop "keeps angles" $ \(Direction a) (Direction b) ->
    closeTo 1e-12 (XYZ.dot a b) (XYZ.dot (toGalactic a) (toGalactic b))
