-- | What is wrong with a value that somebody gave.
module BlackHole.Scene.Problem
  ( Problem (..),
    renderProblem,
    nearest,
    suggestion,
  )
where

import Data.Char (toLower)
import Data.List (sortOn)

-- | A bad value: where it was given, what it is, and what is allowed there.
data Problem = Problem
  { -- | The option, or the scene file, its line and the setting's path.
    problemOption :: !String,
    problemValue :: !String,
    problemRange :: !String
  }
  deriving (Eq, Show)

-- | One line for people.
renderProblem :: Problem -> String
renderProblem (Problem option value range) =
  option ++ ": " ++ value ++ " is not " ++ range

-- | The candidate most like a mistyped word, if one is near enough for the
-- difference to be a slip: at most a third of its letters. Quadratic in the
-- words' lengths, of which no more than 64 letters count.
nearest :: String -> [String] -> Maybe String
nearest word candidates =
  case sortOn fst [(editDistance (map toLower (take 64 word)) c, c) | c <- candidates] of
    (d, best) : _ | d > 0 && 3 * d <= length best + 1 -> Just best
    _ -> Nothing

-- | @\" (did you mean width?)\"@ for a slip, nothing for anything else.
suggestion :: String -> [String] -> String
suggestion word = maybe "" (\n -> " (did you mean " ++ n ++ "?)") . nearest word

-- | Insertions, deletions and replacements between two words.
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
