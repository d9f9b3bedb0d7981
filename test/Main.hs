-- | Runs every specification; the tree below mirrors @src@.
module Main (main) where

import qualified BlackHole.Light.RadianceSpec
import qualified BlackHole.Vector.XYZSpec
import Test.Hspec

main :: IO ()
main = hspec $ do
  describe "BlackHole.Light.Radiance" BlackHole.Light.RadianceSpec.spec
  describe "BlackHole.Vector.XYZ" BlackHole.Vector.XYZSpec.spec
