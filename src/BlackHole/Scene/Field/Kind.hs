-- | The kinds of values that settings have: how to read, print and check them.
module BlackHole.Scene.Field.Kind
  ( Value (..),
    Kind (..),
    Quantity (..),
    Least (..),
    Most (..),
    readValue,
    showValue,
    expectation,
    rangeFault,
  )
where

import BlackHole.Scene.Field.Number
import BlackHole.Scene.Problem (suggestion)
import BlackHole.Vector.XYZ (XYZ (..))
import qualified BlackHole.Vector.XYZ as XYZ
import Data.Char (isControl, toLower)
import Data.List (intercalate)
import Data.Word (Word64)

-- | The value of a setting of any kind.
data Value
  = NumberValue !Double
  | WholeValue !Int
  | SeedValue !Word64
  | SwitchValue !Bool
  | -- | One of the names of a choice.
    NameValue !String
  | -- | A file's name.
    FileValue !FilePath
  | VectorValue !XYZ
  deriving (Eq, Show)

-- | A kind of value with its range.
data Kind
  = NumberKind !Quantity
  | -- | Least and greatest value, and the unit, which is empty for a pure number.
    WholeKind !Int !Int !String
  | -- | A whole number of 64 bits.
    SeedKind
  | SwitchKind
  | -- | A noun with its article, and the names of the choices with their meanings.
    ChoiceKind !String ![(String, String)]
  | -- | The same, and a noun with its article for the kind of file that can be given
    -- instead.
    ChoiceOrFileKind !String ![(String, String)] !String
  | -- | Three finite numbers.
    VectorKind
  deriving (Eq, Show)

-- | A number with its range: a noun with its article, and the unit, which is empty for
-- a pure number.
data Quantity = Quantity
  { quantityNoun :: !String,
    quantityLeast :: !Least,
    quantityMost :: !Most,
    quantityUnit :: !String
  }
  deriving (Eq, Show)

-- | The lower end of a range.
data Least = Anything | From !Double | Above !Double
  deriving (Eq, Show)

-- | The upper end of a range.
data Most = Endless | UpTo !Double | Below !Double
  deriving (Eq, Show)

-- | The value of a text, or what it should have been, as a noun phrase. Does not check
-- the range, except that a whole number must fit into its type. Ignores the case of
-- names and switches.
readValue :: Kind -> String -> Either String Value
readValue kind text = maybe (Left (expectation kind text)) Right $ case kind of
  NumberKind _ -> NumberValue <$> readNumber text
  WholeKind {} -> do
    n <- readWhole text
    if abs n < 10 ^ (18 :: Int) then Just (WholeValue (fromInteger n)) else Nothing
  SeedKind -> do
    n <- readWhole text
    if n >= 0 && n <= toInteger (maxBound :: Word64)
      then Just (SeedValue (fromInteger n))
      else Nothing
  SwitchKind -> SwitchValue <$> lookup lower switches
  ChoiceKind _ choices | lower `elem` map fst choices -> Just (NameValue lower)
  ChoiceKind _ _ -> Nothing
  ChoiceOrFileKind _ choices _
    | lower `elem` map fst choices -> Just (NameValue lower)
    | isFileName text -> Just (FileValue text)
    | otherwise -> Nothing
  VectorKind -> VectorValue <$> readVector text
  where
    lower = map toLower text
    switches =
      [("on", True), ("off", False), ("true", True), ("false", False), ("yes", True), ("no", False)]

-- | Whether a text that is not one of the choices is taken for a file name. It must
-- contain a slash or a period, so that a misspelt choice is not, and consist of at
-- most 1024 characters without control characters.
isFileName :: String -> Bool
isFileName text = any (`elem` text) "./" && null (drop 1024 text) && not (any isControl text)

-- | What a text that cannot be read should have been, as a noun phrase.
expectation :: Kind -> String -> String
expectation kind text = case kind of
  NumberKind _ -> "a number"
  WholeKind {} -> "a whole number"
  SeedKind -> "a whole number from 0 to " ++ show (maxBound :: Word64)
  SwitchKind -> "on or off"
  ChoiceKind what choices ->
    what ++ suggestion text (map fst choices) ++ "; the choices are: "
      ++ intercalate ", " (map fst choices)
  ChoiceOrFileKind what choices file ->
    what ++ suggestion text (map fst choices) ++ "; the choices are: "
      ++ intercalate ", " (map fst choices)
      ++ ", or "
      ++ file
      ++ " (a name with an extension or a folder, such as ./sky)"
  VectorKind -> "X,Y,Z: three numbers separated by commas"

-- | The value as messages print it.
showValue :: Value -> String
showValue value = case value of
  NumberValue v -> showNumber v
  WholeValue n -> show n
  SeedValue n -> show n
  SwitchValue b -> if b then "on" else "off"
  NameValue name -> name
  FileValue file -> file
  VectorValue (XYZ x y z) -> intercalate "," (map showNumber [x, y, z])

-- | The range of a kind as a noun phrase, if the value is outside it.
rangeFault :: Kind -> Value -> Maybe String
rangeFault kind value = case (kind, value) of
  (NumberKind quantity, NumberValue v)
    | isNaN v || isInfinite v || not (within quantity v) -> Just (quantityText quantity)
  (WholeKind low high unit, WholeValue n)
    | n < low || n > high ->
      Just ("a whole number from " ++ show low ++ " to " ++ show high ++ inBrackets unit)
  (VectorKind, VectorValue v)
    | not (XYZ.isFinite v) -> Just "X,Y,Z: three finite numbers"
  _ -> Nothing

within :: Quantity -> Double -> Bool
within quantity v = lower && upper
  where
    lower = case quantityLeast quantity of
      Anything -> True
      From l -> v >= l
      Above l -> v > l
    upper = case quantityMost quantity of
      Endless -> True
      UpTo h -> v <= h
      Below h -> v < h

-- | The range in words: @\"a radius above 1 and up to 10000 (Schwarzschild radii)\"@.
quantityText :: Quantity -> String
quantityText (Quantity noun least most unit) = noun ++ range ++ inBrackets unit
  where
    range = case (least, most) of
      (Anything, Endless) -> ""
      (Anything, UpTo h) -> " up to " ++ plain h
      (Anything, Below h) -> " below " ++ plain h
      (From l, Endless) -> " of at least " ++ plain l
      (From l, UpTo h) -> " from " ++ plain l ++ " to " ++ plain h
      (From l, Below h) -> " from " ++ plain l ++ " to below " ++ plain h
      (Above l, Endless) -> " above " ++ plain l
      (Above l, UpTo h) -> " above " ++ plain l ++ " and up to " ++ plain h
      (Above l, Below h) -> " above " ++ plain l ++ " and below " ++ plain h
    plain = exactNumber

inBrackets :: String -> String
inBrackets unit = if null unit then "" else " (" ++ unit ++ ")"
