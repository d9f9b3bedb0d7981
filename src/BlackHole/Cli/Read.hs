-- | Kinds of options, and strict readers for their values, whose messages quote the
-- value.
module BlackHole.Cli.Read
  ( setting,
    settingOr,
    toggle,
    number,
    wholeNumber,
    pixelPlace,
    named,
    readNumber,
    nearest,
    filesEnding,
  )
where

import BlackHole.Scene.Field.Number (readNumber, splitOn)
import BlackHole.Scene.Problem (nearest, suggestion)
import Data.Char (toLower)
import Data.List (intercalate, isPrefixOf)
import Data.Maybe (fromMaybe)
import Options.Applicative
import System.Directory (doesDirectoryExist, listDirectory)
import System.FilePath (takeDirectory, takeExtension, takeFileName, (</>))
import Text.Read (readMaybe)

-- | An optional option. If it is given more than once, the last one counts, so that
-- scripts can put their arguments after their defaults.
setting :: Parser a -> Parser (Maybe a)
setting = fmap (foldl (const Just) Nothing) . many

-- | An optional option with its default.
settingOr :: a -> Parser a -> Parser a
settingOr standard = fmap (fromMaybe standard) . setting

-- | A flag, which may be given more than once.
toggle :: Mod FlagFields () -> Parser Bool
toggle = fmap (not . null) . many . flag' ()

-- | A decimal number, as 'readNumber' reads it.
number :: ReadM Double
number = eitherReader $ \s ->
  maybe (Left (notA s "a number")) Right (readNumber s)

-- | A whole number of at most 18 digits in decimal notation.
wholeNumber :: Num a => ReadM a
wholeNumber = eitherReader $ \s -> case readMaybe (dropPlus s) of
  Just n | abs n < 10 ^ (18 :: Int) -> Right (fromInteger n)
  _ -> Left (notA s "a whole number")

-- | Column and row of a pixel: two whole numbers separated by a comma.
pixelPlace :: ReadM (Int, Int)
pixelPlace = eitherReader $ \s -> case map (readMaybe . dropPlus) (splitOn ',' s) of
  [Just x, Just y] | all ((< 10 ^ (18 :: Int)) . abs) [x, y] -> Right (fromInteger x, fromInteger y)
  _ -> Left (notA s "X,Y: the column and row of a pixel")

-- | One of several names, in any case. The first argument is a noun with its article.
named :: String -> [(String, a)] -> ReadM a
named what choices = eitherReader $ \s ->
  case lookup (map toLower s) choices of
    Just a -> Right a
    Nothing ->
      Left
        ( notA
            s
            (what ++ didYouMean s ++ "; the choices are: " ++ intercalate ", " (map fst choices))
        )
  where
    didYouMean s = suggestion s (map fst choices)

-- | Completion with the files that have one of these extensions, and folders.
filesEnding :: HasCompleter f => [String] -> Mod f a
filesEnding extensions = completer . mkCompleter $ \word -> do
  let place = takeDirectory word
      start = takeFileName word
  exists <- doesDirectoryExist place
  names <- if exists then listDirectory place else pure []
  concat
    <$> mapM
      (offered place)
      [name | name <- names, start `isPrefixOf` name, take 1 name /= "." || take 1 start == "."]
  where
    offered place name = do
      let path = if place == "." then name else place </> name
      folder <- doesDirectoryExist path
      pure
        [ if folder then path ++ "/" else path
          | folder || map toLower (takeExtension name) `elem` extensions
        ]

notA :: String -> String -> String
notA given what = "'" ++ given ++ "' is not " ++ what

dropPlus :: String -> String
dropPlus ('+' : rest@(c : _)) | c /= '-' = rest
dropPlus s = s
