-- | File names with a place for the frame's number, as in @frames\/%05d.png@.
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

-- | A pattern with one place for a number: what goes before, its least number
-- of digits, what follows.
data FrameName = FrameName !String !Int !String
  deriving (Eq, Show)

-- | Read a pattern: one of @%d@ and @%05d@ (any width to 20) in the file's name, not in its
-- folder's; @%%@ is a per cent sign. On the left, what would be right.
parseFrameName :: String -> Either String FrameName
parseFrameName text = case go text of
  Just (before, Just (digits, after))
    | takeDirectory (before ++ "0") == takeDirectory (before ++ "0" ++ after) -> Right (FrameName before digits after)
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

-- | The pattern as it would be written.
framePattern :: FrameName -> String
framePattern (FrameName before digits after) =
  escaped before ++ (if digits == 0 then "%d" else "%0" ++ show digits ++ "d") ++ escaped after
  where
    escaped = concatMap (\c -> if c == '%' then "%%" else [c])

-- | The file of a frame (from 0).
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
