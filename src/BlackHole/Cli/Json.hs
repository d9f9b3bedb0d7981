-- | JSON (RFC 8259), and numbers as text without loss.
module BlackHole.Cli.Json
  ( Json (..),
    renderJson,
    jsonLine,
    showDouble,
  )
where

import Data.Char (isControl, ord)
import Data.List (intercalate, stripPrefix)
import Numeric (showFFloat, showHex)

-- | A JSON value.
data Json
  = Null
  | -- | Printed as @null@ if it is not finite.
    Number !Double
  | Whole !Int
  | -- | @true@ or @false@.
    Truth !Bool
  | Text !String
  | List ![Json]
  | Object ![(String, Json)]
  deriving (Eq, Show)

-- | Indented text that ends with a newline. Takes time linear in its length.
renderJson :: Json -> String
renderJson json = go "" json ++ "\n"
  where
    go indent value = case value of
      List items -> block indent '[' ']' [(`go` item) | item <- items]
      Object members ->
        block indent '{' '}' [\i -> quoted name ++ ": " ++ go i item | (name, item) <- members]
      _ -> jsonLine value
    block :: String -> Char -> Char -> [String -> String] -> String
    block _ open close [] = [open, close]
    block indent open close parts =
      let inner = "  " ++ indent
       in [open] ++ "\n" ++ intercalate ",\n" [inner ++ part inner | part <- parts]
            ++ "\n"
            ++ indent
            ++ [close]

-- | Text on one line, without a newline at its end.
jsonLine :: Json -> String
jsonLine value = case value of
  Null -> "null"
  Number d
    | isNaN d || isInfinite d -> "null"
    | otherwise -> showDouble d
  Whole n -> show n
  Truth b -> if b then "true" else "false"
  Text s -> quoted s
  List items -> "[" ++ intercalate ", " (map jsonLine items) ++ "]"
  Object members ->
    "{"
      ++ intercalate ", " [quoted name ++ ": " ++ jsonLine item | (name, item) <- members]
      ++ "}"

quoted :: String -> String
quoted s = "\"" ++ concatMap escaped s ++ "\""
  where
    escaped c
      | c == '"' || c == '\\' = ['\\', c]
      | isControl c && ord c < 0x20 =
        "\\u"
          ++ reverse (take 4 (reverse ("0000" ++ showHex (ord c) "")))
      | otherwise = [c]

-- | The shortest decimal that reads back as the same number, with at most 17
-- significant digits; whole numbers without a point. @NaN@ and @Infinity@ for the
-- others.
showDouble :: Double -> String
showDouble d
  | isNaN d || isInfinite d = show d
  | d == 0 = "0"
  | abs d >= 1e-4 && abs d < 1e16 = withoutPoint (showFFloat Nothing d "")
  | otherwise = case break (== 'e') (show d) of
    (digits, power) -> withoutPoint digits ++ power
  where
    withoutPoint s = maybe s reverse (stripPrefix "0." (reverse s))
