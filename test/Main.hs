-- | Runs every specification; the tree below mirrors @src@.
module Main (main) where

import qualified BlackHole.Noise.LatticeSpec
import qualified BlackHole.Noise.PerlinGSpec
import qualified BlackHole.Noise.ProfileSpec
import qualified BlackHole.Noise.SipHashSpec
import qualified BlackHole.Vector.XYZSpec
import Test.Hspec

main :: IO ()
main = hspec $ do
  describe "BlackHole.Noise.Lattice" BlackHole.Noise.LatticeSpec.spec
  describe "BlackHole.Noise.PerlinG" BlackHole.Noise.PerlinGSpec.spec
  describe "BlackHole.Noise.Profile" BlackHole.Noise.ProfileSpec.spec
  describe "BlackHole.Noise.SipHash" BlackHole.Noise.SipHashSpec.spec
  describe "BlackHole.Vector.XYZ" BlackHole.Vector.XYZSpec.spec
