-- | What is wrong with a value or a combination of values that the user gave.
module BlackHole.Scene.Problem
  ( Problem (..),
    problemOption,
    problemValue,
    renderProblem,
    nearest,
    suggestion,
  )
where

import Data.Char (toLower)
import Data.List (sortOn)

-- | A mistake in the input. The first argument says where it is: the option, or the
-- setting's path.
data Problem
  = -- | A value outside its range: where it was given, the value, and what is
    -- allowed, as a noun phrase.
    Problem !String !String !String
  | -- | Anything else, such as two options that exclude each other: where, and one
    -- clause that says what is wrong.
    Mistake !String !String
  deriving (Eq, Show)

-- | The option or setting that the problem is about.
problemOption :: Problem -> String
problemOption problem = case problem of
  Problem option _ _ -> option
  Mistake option _ -> option

-- | The value that is out of range; for a 'Mistake', its clause.
problemValue :: Problem -> String
problemValue problem = case problem of
  Problem _ value _ -> value
  Mistake _ clause -> clause

-- | The problem as one line.
renderProblem :: Problem -> String
renderProblem problem = case problem of
  Problem option value range -> option ++ ": " ++ value ++ " is not " ++ range
  Mistake option clause -> option ++ ": " ++ clause

-- | The candidate closest to a mistyped word, if their edit distance is at most about
-- a third of the candidate's length, and is not 0. Only the first 64 letters of the
-- word count. Takes time proportional to the product of the two lengths.
nearest :: String -> [String] -> Maybe String
nearest word candidates =
  case sortOn fst [(editDistance (map toLower (take 64 word)) c, c) | c <- candidates] of
    (d, best) : _ | d > 0 && 3 * d <= length best + 1 -> Just best
    _ -> Nothing

-- | @\" (did you mean width?)\"@ if there is a 'nearest' candidate, otherwise empty.
suggestion :: String -> [String] -> String
suggestion word = maybe "" (\n -> " (did you mean " ++ n ++ "?)") . nearest word

-- | The number of insertions, deletions and replacements from one word to the other
-- (Levenshtein 1966).
editDistance :: String -> String -> Int
editDistance a b = lastOr 0 (foldl row [0 .. length b] a)
  where
    row previous c = case previous of
      [] -> []
      p : rest -> scanl step (p + 1) (zip3 b previous rest)
        where
          step left (d, diagonal, above) =
            minimum [left + 1, above + 1, if c == d then diagonal else diagonal + 1]
    lastOr = foldl (\_ x -> x)
