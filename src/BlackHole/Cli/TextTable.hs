-- | Text in columns.
module BlackHole.Cli.TextTable
  ( Align (..),
    Row (..),
    tableLines,
  )
where

import Data.List (dropWhileEnd, intercalate)

-- | The alignment of a column.
data Align = LeftAligned | RightAligned
  deriving (Eq, Show)

-- | A row of a table.
data Row
  = -- | A cell for each column, from the left; there may be fewer than columns.
    Cells ![String]
  | -- | A cell of the first column, and a text across all others.
    Across !String !String
  | -- | A text across all columns.
    Line !String
  deriving (Eq, Show)

-- | The lines of a table, given the alignments of its columns from the left. Columns are
-- as wide as their widest cell, with two spaces between them. No line ends with spaces.
tableLines :: [Align] -> [Row] -> [String]
tableLines aligns rows = map (dropWhileEnd (== ' ') . line) rows
  where
    widths = foldr (longest . map length . measured) [] rows
    longest (a : as) (b : bs) = max a b : longest as bs
    longest as bs = as ++ bs
    measured row = case row of
      Cells cells -> cells
      Across name _ -> [name]
      Line _ -> []
    line row = case row of
      Cells cells -> intercalate "  " (zipWith3 padded aligns widths cells)
      Across name text -> intercalate "  " (zipWith3 padded aligns widths [name] ++ [text])
      Line text -> text
    padded align width cell = case align of
      LeftAligned -> cell ++ space
      RightAligned -> space ++ cell
      where
        space = replicate (width - length cell) ' '
