-- | Lines of help, wrapped at 80 columns.
module BlackHole.Cli.HelpLines
  ( row,
    wrapped,
  )
where

-- | @row column name text@: a name with its explanation, which starts at a column, or on
-- the next line after a long name.
row :: Int -> String -> String -> [String]
row column name text
  | length name + 4 > column = ("  " ++ name) : map (replicate column ' ' ++) texts
  | otherwise =
    zipWith
      (++)
      (("  " ++ name ++ replicate (column - 2 - length name) ' ') : repeat (replicate column ' '))
      texts
  where
    texts = wrap (80 - column) text

-- | A paragraph, indented by this many spaces.
wrapped :: Int -> String -> [String]
wrapped indent = map (replicate indent ' ' ++) . wrap (80 - indent)

-- | Lines of at most that many characters, except for longer words; at least one line.
wrap :: Int -> String -> [String]
wrap width = go [] . words
  where
    go line [] = [unwords (reverse line)]
    go line (w : rest)
      | null line || length (unwords (w : line)) <= width = go (w : line) rest
      | otherwise = unwords (reverse line) : go [w] rest
