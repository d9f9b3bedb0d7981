-- | The metadata of a picture file: everything that is needed to render the picture again.
module BlackHole.Image.Metadata
  ( software,
    Metadata (..),
    metadataText,
    parseMetadata,
  )
where

import BlackHole.Image.Coding
import Data.ByteString (ByteString)
import qualified Data.ByteString.Char8 as Characters
import Data.List (intercalate, stripPrefix)
import Data.Version (showVersion)
import qualified Paths_blackhole as Package
import Text.Read (readMaybe)

-- | Name and version of this program, which picture files record.
software :: String
software = "blackhole " ++ showVersion Package.version

-- | The program that made the file, the coding of the pixels, and the scene as the text
-- of a scene file (UTF-8, ending with a newline).
data Metadata = Metadata
  { metadataSoftware :: !String,
    metadataCoding :: !Coding,
    metadataScene :: !ByteString
  }
  deriving (Eq, Show)

-- | The metadata as one text for all file formats: a comment line, then the scene. The
-- whole text is itself a valid scene file.
metadataText :: Metadata -> ByteString
metadataText metadata = Characters.pack (firstLine ++ "\n") <> metadataScene metadata
  where
    firstLine =
      intercalate "; " $
        (mark ++ metadataSoftware metadata) :
        ["bits " ++ show bits | Just bits <- [codingBits coding]]
          ++ ["quality " ++ show quality | Just quality <- [codingQuality coding]]
    coding = metadataCoding metadata

-- | The inverse of 'metadataText'; 'Nothing' for a text of other origin.
parseMetadata :: ByteString -> Maybe Metadata
parseMetadata text = do
  let (firstLine, rest) = Characters.break (== '\n') text
  maker : settings <- splitOn ';' <$> stripPrefix mark (Characters.unpack firstLine)
  pure
    Metadata
      { metadataSoftware = maker,
        metadataCoding = Coding (setting "bits " settings) (setting "quality " settings),
        metadataScene = Characters.drop 1 rest
      }
  where
    setting name settings =
      case [n | Just digits <- map (stripPrefix name) settings, Just n <- [readMaybe digits]] of
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
