-- | A reader for JSON (RFC 8259) that takes nothing else: written for tests, by
-- the grammar.
module Support.Json
  ( Json (..),
    readJson,
    member,
    numberAt,
  )
where

import Data.Char (chr, digitToInt, isDigit, isHexDigit)
import Text.Read (readMaybe)

data Json
  = Null
  | Bool Bool
  | Number Double
  | Text String
  | List [Json]
  | Object [(String, Json)]
  deriving (Eq, Show)

-- | The value of a whole text; 'Nothing' for anything that is not JSON.
readJson :: String -> Maybe Json
readJson s = case value (blank s) of
  Just (json, rest) | null (blank rest) -> Just json
  _ -> Nothing

blank :: String -> String
blank = dropWhile (`elem` " \t\r\n")

value :: String -> Maybe (Json, String)
value s = case s of
  'n' : 'u' : 'l' : 'l' : rest -> Just (Null, rest)
  't' : 'r' : 'u' : 'e' : rest -> Just (Bool True, rest)
  'f' : 'a' : 'l' : 's' : 'e' : rest -> Just (Bool False, rest)
  '"' : rest -> do
    (text, after) <- string rest
    Just (Text text, after)
  '[' : rest -> list rest
  '{' : rest -> object rest
  _ -> number s

list :: String -> Maybe (Json, String)
list s = case blank s of
  ']' : rest -> Just (List [], rest)
  rest -> items [] rest
  where
    items done rest = do
      (item, after) <- value (blank rest)
      case blank after of
        ',' : more -> items (item : done) more
        ']' : more -> Just (List (reverse (item : done)), more)
        _ -> Nothing

object :: String -> Maybe (Json, String)
object s = case blank s of
  '}' : rest -> Just (Object [], rest)
  rest -> members [] rest
  where
    members done rest = case blank rest of
      '"' : inside -> do
        (name, after) <- string inside
        colon <- case blank after of
          ':' : more -> Just more
          _ -> Nothing
        (item, end) <- value (blank colon)
        let done' = (name, item) : done
        case blank end of
          ',' : more -> members done' more
          '}' : more -> Just (Object (reverse done'), more)
          _ -> Nothing
      _ -> Nothing

string :: String -> Maybe (String, String)
string = go ""
  where
    go done s = case s of
      '"' : rest -> Just (reverse done, rest)
      '\\' : 'u' : a : b : c : d : rest
        | all isHexDigit [a, b, c, d] ->
          go (chr (foldl (\n h -> 16 * n + digitToInt h) 0 [a, b, c, d]) : done) rest
      '\\' : c : rest -> do
        meant <- lookup c (zip "\"\\/bfnrt" "\"\\/\b\f\n\r\t")
        go (meant : done) rest
      c : rest | c >= ' ' -> go (c : done) rest
      _ -> Nothing

number :: String -> Maybe (Json, String)
number s = do
  (whole, afterWhole) <- case unsigned of
    '0' : rest -> Just ("0", rest)
    _ -> digits unsigned
  (part, afterPart) <- case afterWhole of
    '.' : rest -> digits rest
    _ -> Just ("0", afterWhole)
  (power, end) <- case afterPart of
    e : '-' : rest | e `elem` "eE" -> signedPower '-' rest
    e : '+' : rest | e `elem` "eE" -> digits rest
    e : rest | e `elem` "eE" -> digits rest
    _ -> Just ("0", afterPart)
  d <- readMaybe (whole ++ "." ++ part ++ "e" ++ power)
  Just (Number (if negative then negate d else d), end)
  where
    negative = take 1 s == "-"
    unsigned = if negative then drop 1 s else s
    signedPower sign rest = do
      (power, end) <- digits rest
      Just (sign : power, end)
    digits t = case span isDigit t of
      ("", _) -> Nothing
      found -> Just found

-- | A member of an object.
member :: String -> Json -> Maybe Json
member name json = case json of
  Object members -> lookup name members
  _ -> Nothing

-- | The number at a path of members.
numberAt :: [String] -> Json -> Maybe Double
numberAt path json = case (path, json) of
  ([], Number d) -> Just d
  (name : rest, _) -> member name json >>= numberAt rest
  _ -> Nothing
