module BlackHole.Trace.RayDifferentialSpec (spec) where

import BlackHole.Trace.RayDifferential
import BlackHole.Vector.XY (XY (..))
import BlackHole.Vector.XYZ (XYZ (..), (*^), (^+^))
import qualified BlackHole.Vector.XYZ as XYZ
import Support.Approx
import Support.Generators
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck

spec :: Spec
spec = do
  prop "the axes undo the Jacobian" $ \(Direction d) (Coordinates v) (Coordinates w) ->
    let differential = RayDifferential d (XYZ.cross d v) (XYZ.cross d w)
        (p, q) = differentialAxes differential
        offset =
          0.3 *^ differentialAlongX differential ^+^ (-1.7) *^ differentialAlongY differential
        roundness = abs (differentialSolidAngle differential) / differentialExtent differential ** 2
     in roundness > 1e-6
          ==> conjoin
            [ closeTo 1e-6 0.3 (XYZ.dot p (d ^+^ offset)),
              closeTo 1e-6 (-1.7) (XYZ.dot q (d ^+^ offset))
            ]
  prop
    "no pixel offset of length 1 ends farther out than the longer axis or nearer than the shorter"
    $ \(Direction d) (Coordinates v) (Coordinates w) ->
      forAll (inRange 0 6.3) $ \t ->
        let differential = RayDifferential d (XYZ.cross d v) (XYZ.cross d w)
            (major, minor) = differentialWidths differential
            reach =
              XYZ.norm
                ( cos t *^ differentialAlongX differential
                    ^+^ sin t *^ differentialAlongY differential
                )
         in counterexample (show (XYZ.norm major, minor, reach)) $
              reach <= XYZ.norm major * (1 + 1e-9) && reach >= minor * (1 - 1e-6)
                && abs (XYZ.norm major * minor - abs (differentialSolidAngle differential))
                  <= 1e-9 * XYZ.norm major ** 2
  it "differences of a pinhole's directions give its pixel's solid angle" $
    -- A flat picture plane at distance 1/s pixels: cos³ of the angle off axis.
    case differentialByDifferences (Just . pinhole) (XY 300 (-200)) of
      Nothing -> expectationFailure "no beam"
      Just differential ->
        differentialSolidAngle differential
          `shouldBeWithin` (1e-12, s * s * (1 + s * s * (300 * 300 + 200 * 200)) ** (-1.5))
  it "has no beam where no light arrives, and a wide one between two such places" $ do
    differentialByDifferences (const Nothing) (XY 0 0) `shouldBe` Nothing
    let lonely (XY x y) = if x == 0 && y == 0 then Just (XYZ 0 0 1) else Nothing
    fmap differentialExtent (differentialByDifferences lonely (XY 0 0))
      `shouldSatisfy` maybe False (> 0.5)
  where
    s = 1e-3
    pinhole (XY x y) = let v = XYZ (s * x) (-(s * y)) (-1) in (1 / XYZ.norm v) *^ v
