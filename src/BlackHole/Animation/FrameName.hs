-- | File names with a placeholder for the frame number, such as @frames\/%05d.png@.
module BlackHole.Animation.FrameName
  ( FrameName,
    parseFrameName,
    framePattern,
    frameFile,
    frameNumber,
  )
where

import Data.Char (isDigit)
import Data.List (stripPrefix)
import System.FilePath (takeDirectory, takeFileName)
import Text.Read (readMaybe)

-- | A pattern with one placeholder: the text before it, the minimum number of digits,
-- and the text after it.
data FrameName = FrameName !String !Int !String
  deriving (Eq, Show)

-- | Parses a pattern with one @%d@ or @%05d@ (any width up to 20) in the name of the
-- file, not of its folder; @%%@ is a per cent sign. 'Left' holds what a valid pattern
-- looks like.
parseFrameName :: String -> Either String FrameName
parseFrameName text = case go text of
  Just (before, Just (digits, after))
    | takeDirectory (before ++ "0") == takeDirectory (before ++ "0" ++ after) ->
      Right
        (FrameName before digits after)
  _ -> Left "a file name with one place for the frame's number, as in frames/%05d.png"
  where
    go :: String -> Maybe (String, Maybe (Int, String))
    go "" = Just ("", Nothing)
    go ('%' : '%' : rest) = plain '%' rest
    go ('%' : rest) = case span isDigit rest of
      (width, 'd' : after) | Just digits <- fieldWidth width -> do
        (text', further) <- go after
        case further of
          Nothing -> Just ("", Just (digits, text'))
          Just _ -> Nothing
      _ -> Nothing
    go (c : rest) = plain c rest
    plain c rest = do
      (before, place) <- go rest
      Just (c : before, place)
    fieldWidth "" = Just 0
    fieldWidth width@('0' : _) | Just n <- readMaybe width, n <= 20 = Just n
    fieldWidth _ = Nothing

-- | The pattern as a user writes it.
framePattern :: FrameName -> String
framePattern (FrameName before digits after) =
  escaped before ++ (if digits == 0 then "%d" else "%0" ++ show digits ++ "d") ++ escaped after
  where
    escaped = concatMap (\c -> if c == '%' then "%%" else [c])

-- | The file of a frame, counted from 0.
frameFile :: FrameName -> Int -> FilePath
frameFile (FrameName before digits after) n =
  before ++ replicate (digits - length number) '0' ++ number ++ after
  where
    number = show n

-- | The frame whose file has this name, given without its folder.
frameNumber :: FrameName -> FilePath -> Maybe Int
frameNumber name@(FrameName before _ after) file = do
  rest <- stripPrefix (takeFileName before) file
  n <- readMaybe (take (length rest - length after) rest)
  if n >= 0 && takeFileName (frameFile name n) == file then Just n else Nothing
