-- | Runs every specification; the tree below mirrors @src@.
module Main (main) where

import qualified BlackHole.Image.AtomicFileSpec
import qualified BlackHole.Render.PixelArraySpec
import qualified BlackHole.Render.PixelRowsSpec
import qualified BlackHole.Render.PixelShapeSpec
import qualified BlackHole.Render.WorkersSpec
import qualified BlackHole.Vector.XYZSpec
import Test.Hspec

main :: IO ()
main = hspec $ do
  describe "BlackHole.Image.AtomicFile" BlackHole.Image.AtomicFileSpec.spec
  describe "BlackHole.Render.PixelArray" BlackHole.Render.PixelArraySpec.spec
  describe "BlackHole.Render.PixelRows" BlackHole.Render.PixelRowsSpec.spec
  describe "BlackHole.Render.PixelShape" BlackHole.Render.PixelShapeSpec.spec
  describe "BlackHole.Render.Workers" BlackHole.Render.WorkersSpec.spec
  describe "BlackHole.Vector.XYZ" BlackHole.Vector.XYZSpec.spec
