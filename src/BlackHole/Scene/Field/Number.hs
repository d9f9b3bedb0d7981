-- | Numbers on the command line and in scene files.
module BlackHole.Scene.Field.Number
  ( readNumber,
    readWhole,
    readVector,
    splitOn,
    showNumber,
    exactNumber,
  )
where

import BlackHole.Vector.XYZ (XYZ (..))
import Data.Char (isDigit, toLower)
import Numeric (showFFloat)
import Text.Read (readMaybe)

-- | A decimal number such as @40@, @.5@, @-1e3@ or @+2.@. Also @nan@ and @inf@, so
-- that the checks of ranges can report them. 'Nothing' for exponents of more than
-- four digits, which would take long to compute.
readNumber :: String -> Maybe Double
readNumber s = case dropPlus s of
  '-' : rest | noSign rest -> negate <$> unsigned rest
  rest | noSign rest -> unsigned rest
  _ -> Nothing
  where
    noSign rest = take 1 rest `notElem` ["-", "+"]
    unsigned t = case map toLower t of
      "nan" -> Just (0 / 0)
      "inf" -> Just (1 / 0)
      "infinity" -> Just (1 / 0)
      lower | decimal lower -> readMaybe (completed lower)
      _ -> Nothing
    decimal t =
      length t <= 400 && all (`elem` "0123456789.e+-") t && length (dropWhile (/= 'e') t) <= 6
    -- Haskell's own grammar wants digits on both sides of the point.
    completed t = case span isDigit t of
      (whole, '.' : rest) ->
        let (part, tl) = span isDigit rest
         in if null whole && null part then t else orZero whole ++ "." ++ orZero part ++ tl
      _ -> t
    orZero digits = if null digits then "0" else digits

-- | A whole number in decimal notation with at most 40 digits.
readWhole :: String -> Maybe Integer
readWhole s = case dropPlus s of
  '-' : digits -> negate <$> unsigned digits
  digits -> unsigned digits
  where
    unsigned digits
      | not (null digits) && all isDigit digits && length digits <= 40 = readMaybe digits
      | otherwise = Nothing

-- | Three numbers separated by commas.
readVector :: String -> Maybe XYZ
readVector s = case traverse readNumber (splitOn ',' s) of
  Just [x, y, z] -> Just (XYZ x y z)
  _ -> Nothing

dropPlus :: String -> String
dropPlus ('+' : rest@(c : _)) | c /= '-' = rest
dropPlus s = s

-- | The parts of a text between the occurrences of a character.
splitOn :: Char -> String -> [String]
splitOn c s = case break (== c) s of
  (a, _ : rest) -> a : splitOn c rest
  (a, []) -> [a]

-- | A number for messages: 'exactNumber', except @NaN@ and @Infinity@.
showNumber :: Double -> String
showNumber v = if isNaN v || isInfinite v then show v else exactNumber v

-- | The shortest decimal that reads back as the same number, including negative zero.
-- With an exponent, it has the point and the sign that YAML 1.1 requires of numbers.
exactNumber :: Double -> String
exactNumber d
  | isNaN d = ".nan"
  | isInfinite d = if d > 0 then ".inf" else "-.inf"
  | isNegativeZero d = "-0.0"
  | d == 0 = "0"
  | abs d >= 1e-4 && abs d < 1e7 = withoutPoint (showFFloat Nothing d "")
  | otherwise = case break (== 'e') (show d) of
    (digits, 'e' : power) -> digits ++ "e" ++ (if take 1 power == "-" then power else '+' : power)
    (digits, _) -> digits
  where
    withoutPoint s = case reverse s of
      '0' : '.' : rest -> reverse rest
      _ -> s
