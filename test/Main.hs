-- | Runs every specification; the tree below mirrors @src@.
module Main (main) where

import qualified BlackHole.Physics.EllipticSpec
import qualified BlackHole.Physics.OrbitSpec
import qualified BlackHole.Vector.XYZSpec
import Test.Hspec

main :: IO ()
main = hspec $ do
  describe "BlackHole.Physics.Elliptic" BlackHole.Physics.EllipticSpec.spec
  describe "BlackHole.Physics.Orbit" BlackHole.Physics.OrbitSpec.spec
  describe "BlackHole.Vector.XYZ" BlackHole.Vector.XYZSpec.spec
