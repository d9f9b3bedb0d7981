module BlackHole.Vector.XYZSpec (spec) where

import BlackHole.Vector.XYZ (XYZ (..), (*^), (^+^), (^-^))
import qualified BlackHole.Vector.XYZ as XYZ
import Test.Hspec
import Test.Hspec.QuickCheck (prop)

spec :: Spec
spec = pure ()
