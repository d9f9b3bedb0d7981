-- | The label of a picture file: everything needed to render the picture again.
module BlackHole.Image.Metadata
  ( Label (..),
    labelText,
    parseLabel,
  )
where

import BlackHole.Image.Coding
import Data.ByteString (ByteString)
import qualified Data.ByteString.Char8 as Characters
import Data.List (intercalate, stripPrefix)
import Text.Read (readMaybe)

-- | The program that made the file, the coding of the pixels, and the scene as the text
-- of a scene file (UTF-8, ending with a newline).
data Label = Label
  { labelSoftware :: !String,
    labelCoding :: !Coding,
    labelScene :: !ByteString
  }
  deriving (Eq, Show)

-- | The label as one text for all file formats: a comment line, then the scene. The
-- whole text is itself a valid scene file.
labelText :: Label -> ByteString
labelText label = Characters.pack (firstLine ++ "\n") <> labelScene label
  where
    firstLine =
      intercalate "; " $
        (mark ++ labelSoftware label) :
        ["bits " ++ show bits | Just bits <- [codingBits coding]]
          ++ ["quality " ++ show quality | Just quality <- [codingQuality coding]]
    coding = labelCoding label

-- | The inverse of 'labelText'; 'Nothing' for a text of other origin.
parseLabel :: ByteString -> Maybe Label
parseLabel text = do
  let (firstLine, rest) = Characters.break (== '\n') text
  software : settings <- splitOn ';' <$> stripPrefix mark (Characters.unpack firstLine)
  pure
    Label
      { labelSoftware = software,
        labelCoding = Coding (setting "bits " settings) (setting "quality " settings),
        labelScene = Characters.drop 1 rest
      }
  where
    setting name settings = case [n | Just digits <- map (stripPrefix name) settings, Just n <- [readMaybe digits]] of
      n : _ -> Just n
      [] -> Nothing

mark :: String
mark = "# made by "

-- | The parts between separators, without leading spaces.
splitOn :: Char -> String -> [String]
splitOn separator text = case break (== separator) text of
  (part, []) -> [trimmed part]
  (part, _ : rest) -> trimmed part : splitOn separator rest
  where
    trimmed = dropWhile (== ' ')
