-- | Runs every specification; the tree below mirrors @src@.
module Main (main) where

import qualified BlackHole.Light.BlackBodySpec
import qualified BlackHole.Light.BlackBodyTableSpec
import qualified BlackHole.Light.CieSpec
import qualified BlackHole.Light.RadianceSpec
import qualified BlackHole.Noise.LatticeSpec
import qualified BlackHole.Noise.PerlinGSpec
import qualified BlackHole.Noise.ProfileSpec
import qualified BlackHole.Noise.SipHashSpec
import qualified BlackHole.Physics.GasMotionSpec
import qualified BlackHole.Physics.RedshiftSpec
import qualified BlackHole.Physics.ThinDiskSpec
import qualified BlackHole.Vector.XYZSpec
import Test.Hspec

main :: IO ()
main = hspec $ do
  describe "BlackHole.Light.BlackBody" BlackHole.Light.BlackBodySpec.spec
  describe "BlackHole.Light.BlackBodyTable" BlackHole.Light.BlackBodyTableSpec.spec
  describe "BlackHole.Light.Cie" BlackHole.Light.CieSpec.spec
  describe "BlackHole.Light.Radiance" BlackHole.Light.RadianceSpec.spec
  describe "BlackHole.Noise.Lattice" BlackHole.Noise.LatticeSpec.spec
  describe "BlackHole.Noise.PerlinG" BlackHole.Noise.PerlinGSpec.spec
  describe "BlackHole.Noise.Profile" BlackHole.Noise.ProfileSpec.spec
  describe "BlackHole.Noise.SipHash" BlackHole.Noise.SipHashSpec.spec
  describe "BlackHole.Physics.GasMotion" BlackHole.Physics.GasMotionSpec.spec
  describe "BlackHole.Physics.Redshift" BlackHole.Physics.RedshiftSpec.spec
  describe "BlackHole.Physics.ThinDisk" BlackHole.Physics.ThinDiskSpec.spec
  describe "BlackHole.Vector.XYZ" BlackHole.Vector.XYZSpec.spec
