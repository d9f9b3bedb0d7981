-- | Runs every specification; the tree below mirrors @src@.
module Main (main) where

import qualified BlackHole.Cli.OptionsSpec
import qualified BlackHole.Cli.RunSpec
import qualified BlackHole.Cli.SelfTestSpec
import qualified BlackHole.Image.AtomicFileSpec
import qualified BlackHole.Image.GoldenSpec
import qualified BlackHole.Light.BlackBodySpec
import qualified BlackHole.Light.BlackBodyTableSpec
import qualified BlackHole.Light.CieSpec
import qualified BlackHole.Light.DisplaySpec
import qualified BlackHole.Light.RadianceSpec
import qualified BlackHole.Noise.LatticeSpec
import qualified BlackHole.Noise.PerlinGSpec
import qualified BlackHole.Noise.ProfileSpec
import qualified BlackHole.Noise.RememberedSpec
import qualified BlackHole.Noise.SipHashSpec
import qualified BlackHole.Physics.EllipticSpec
import qualified BlackHole.Physics.ExactPathSpec
import qualified BlackHole.Physics.GasMotionSpec
import qualified BlackHole.Physics.LeapfrogSpec
import qualified BlackHole.Physics.ObserverSpec
import qualified BlackHole.Physics.OrbitSpec
import qualified BlackHole.Physics.RedshiftSpec
import qualified BlackHole.Physics.ThinDiskSpec
import qualified BlackHole.Render.FilmSpec
import qualified BlackHole.Render.PixelArraySpec
import qualified BlackHole.Render.PixelRowsSpec
import qualified BlackHole.Render.PixelShapeSpec
import qualified BlackHole.Render.WorkersSpec
import qualified BlackHole.Scene.CameraSpec
import qualified BlackHole.Scene.ValidateSpec
import qualified BlackHole.SelfTest.CheckSpec
import qualified BlackHole.SelfTest.SuiteSpec
import qualified BlackHole.SelfTest.TableSpec
import qualified BlackHole.Trace.GasSpec
import qualified BlackHole.Trace.PixelSpec
import qualified BlackHole.Trace.SkySpec
import qualified BlackHole.Vector.XYSpec
import qualified BlackHole.Vector.XYZSpec
import qualified ProgramSpec
import Test.Hspec

main :: IO ()
main = hspec $ do
  describe "BlackHole.Cli.Options" BlackHole.Cli.OptionsSpec.spec
  describe "BlackHole.Cli.Run" BlackHole.Cli.RunSpec.spec
  describe "BlackHole.Cli.SelfTest" BlackHole.Cli.SelfTestSpec.spec
  describe "BlackHole.Image.AtomicFile" BlackHole.Image.AtomicFileSpec.spec
  describe "BlackHole.Image.Golden" BlackHole.Image.GoldenSpec.spec
  describe "BlackHole.Light.BlackBody" BlackHole.Light.BlackBodySpec.spec
  describe "BlackHole.Light.BlackBodyTable" BlackHole.Light.BlackBodyTableSpec.spec
  describe "BlackHole.Light.Cie" BlackHole.Light.CieSpec.spec
  describe "BlackHole.Light.Display" BlackHole.Light.DisplaySpec.spec
  describe "BlackHole.Light.Radiance" BlackHole.Light.RadianceSpec.spec
  describe "BlackHole.Noise.Lattice" BlackHole.Noise.LatticeSpec.spec
  describe "BlackHole.Noise.PerlinG" BlackHole.Noise.PerlinGSpec.spec
  describe "BlackHole.Noise.Profile" BlackHole.Noise.ProfileSpec.spec
  describe "BlackHole.Noise.Remembered" BlackHole.Noise.RememberedSpec.spec
  describe "BlackHole.Noise.SipHash" BlackHole.Noise.SipHashSpec.spec
  describe "BlackHole.Physics.Elliptic" BlackHole.Physics.EllipticSpec.spec
  describe "BlackHole.Physics.ExactPath" BlackHole.Physics.ExactPathSpec.spec
  describe "BlackHole.Physics.GasMotion" BlackHole.Physics.GasMotionSpec.spec
  describe "BlackHole.Physics.Leapfrog" BlackHole.Physics.LeapfrogSpec.spec
  describe "BlackHole.Physics.Observer" BlackHole.Physics.ObserverSpec.spec
  describe "BlackHole.Physics.Orbit" BlackHole.Physics.OrbitSpec.spec
  describe "BlackHole.Physics.Redshift" BlackHole.Physics.RedshiftSpec.spec
  describe "BlackHole.Physics.ThinDisk" BlackHole.Physics.ThinDiskSpec.spec
  describe "BlackHole.Render.Film" BlackHole.Render.FilmSpec.spec
  describe "BlackHole.Render.PixelArray" BlackHole.Render.PixelArraySpec.spec
  describe "BlackHole.Render.PixelRows" BlackHole.Render.PixelRowsSpec.spec
  describe "BlackHole.Render.PixelShape" BlackHole.Render.PixelShapeSpec.spec
  describe "BlackHole.Render.Workers" BlackHole.Render.WorkersSpec.spec
  describe "BlackHole.Scene.Camera" BlackHole.Scene.CameraSpec.spec
  describe "BlackHole.Scene.Validate" BlackHole.Scene.ValidateSpec.spec
  describe "BlackHole.SelfTest.Check" BlackHole.SelfTest.CheckSpec.spec
  describe "BlackHole.SelfTest.Suite" BlackHole.SelfTest.SuiteSpec.spec
  describe "BlackHole.SelfTest.Table" BlackHole.SelfTest.TableSpec.spec
  describe "BlackHole.Trace.Gas" BlackHole.Trace.GasSpec.spec
  describe "BlackHole.Trace.Pixel" BlackHole.Trace.PixelSpec.spec
  describe "BlackHole.Trace.Sky" BlackHole.Trace.SkySpec.spec
  describe "BlackHole.Vector.XY" BlackHole.Vector.XYSpec.spec
  describe "BlackHole.Vector.XYZ" BlackHole.Vector.XYZSpec.spec
  describe "The program" ProgramSpec.spec
