-- | Options and readers for their values: strict about what they take, and with
-- messages that name the value.
module BlackHole.Cli.Read
  ( setting,
    settingOr,
    toggle,
    number,
    wholeNumber,
    seedNumber,
    vector,
    pixelPlace,
    named,
    readNumber,
    readVector,
    nearest,
  )
where

import BlackHole.Scene.Field.Number (readNumber, readVector, splitOn)
import BlackHole.Scene.Problem (nearest)
import BlackHole.Vector.XYZ (XYZ)
import Data.Char (toLower)
import Data.List (intercalate)
import Data.Maybe (fromMaybe)
import Data.Word (Word64)
import Options.Applicative
import Text.Read (readMaybe)

-- | An option that need not be given; if it is given repeatedly, the last one
-- counts, so that scripts can set defaults and let their arguments follow.
setting :: Parser a -> Parser (Maybe a)
setting = fmap (foldl (const Just) Nothing) . many

-- | The same with a value for when it is not given.
settingOr :: a -> Parser a -> Parser a
settingOr standard = fmap (fromMaybe standard) . setting

-- | A switch, off unless it is given, however often.
toggle :: Mod FlagFields () -> Parser Bool
toggle = fmap (not . null) . many . flag' ()

-- | A decimal number: @40@, @.5@, @-1e3@, @+2.@; also @nan@ and @inf@, which
-- the scene's own checks then refuse with the range that is allowed.
number :: ReadM Double
number = eitherReader $ \s ->
  maybe (Left (notA s "a number")) Right (readNumber s)

-- | A whole number in decimal.
wholeNumber :: Num a => ReadM a
wholeNumber = eitherReader $ \s -> case readMaybe (dropPlus s) of
  Just n | abs n < 10 ^ (18 :: Int) -> Right (fromInteger n)
  _ -> Left (notA s "a whole number")

-- | A seed: a whole number that fits into 64 bits.
seedNumber :: ReadM Word64
seedNumber = eitherReader $ \s -> case readMaybe (dropPlus s) of
  Just n | n >= 0 && n <= toInteger (maxBound :: Word64) -> Right (fromInteger n)
  _ -> Left (notA s ("a whole number from 0 to " ++ show (maxBound :: Word64)))

-- | Three numbers with commas between them.
vector :: ReadM XYZ
vector = eitherReader $ \s ->
  maybe (Left (notA s "X,Y,Z, three numbers with commas between them")) Right (readVector s)

-- | Column and row of a pixel: two whole numbers with a comma between them.
pixelPlace :: ReadM (Int, Int)
pixelPlace = eitherReader $ \s -> case map (readMaybe . dropPlus) (splitOn ',' s) of
  [Just x, Just y] | all ((< 10 ^ (18 :: Int)) . abs) [x, y] -> Right (fromInteger x, fromInteger y)
  _ -> Left (notA s "X,Y, the column and row of a pixel")

-- | One of some names, whatever its case.
named :: String -> [(String, a)] -> ReadM a
named what choices = eitherReader $ \s ->
  case lookup (map toLower s) choices of
    Just a -> Right a
    Nothing -> Left (notA s (what ++ didYouMean s ++ "; there are: " ++ intercalate ", " (map fst choices)))
  where
    didYouMean s = maybe "" (\n -> " (did you mean " ++ n ++ "?)") (nearest s (map fst choices))

notA :: String -> String -> String
notA given what = "'" ++ given ++ "' is not " ++ what

dropPlus :: String -> String
dropPlus ('+' : rest@(c : _)) | c /= '-' = rest
dropPlus s = s
