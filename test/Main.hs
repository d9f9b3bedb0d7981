-- | Runs every specification; the tree below mirrors @src@.
module Main (main) where

import qualified BlackHole.Image.AtomicFileSpec
import qualified BlackHole.Vector.XYZSpec
import Test.Hspec

main :: IO ()
main = hspec $ do
  describe "BlackHole.Image.AtomicFile" BlackHole.Image.AtomicFileSpec.spec
  describe "BlackHole.Vector.XYZ" BlackHole.Vector.XYZSpec.spec
