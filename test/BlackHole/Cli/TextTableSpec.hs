module BlackHole.Cli.TextTableSpec (spec) where

import BlackHole.Cli.TextTable
import Test.Hspec

spec :: Spec
spec = do
  it "aligns cells in columns as wide as the widest, without spaces at the ends" $
    tableLines
      [LeftAligned, RightAligned, LeftAligned]
      [Cells ["a", "12", "x"], Cells ["long", "3", ""], Cells ["b"]]
      `shouldBe` ["a     12  x", "long   3", "b"]
  it "lets texts cross the columns without widening them" $
    tableLines
      [LeftAligned, RightAligned]
      [Line "a line wider than all columns", Cells ["a", "1"], Across "bcd" "a remark"]
      `shouldBe` ["a line wider than all columns", "a    1", "bcd  a remark"]
  it "has no lines without rows" $ tableLines [] [] `shouldBe` []
