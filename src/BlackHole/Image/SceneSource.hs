-- | The bytes of scene files.
module BlackHole.Image.SceneSource (readSceneFile) where

import BlackHole.Scene.File.Yaml (maximumYamlBytes)
import BlackHole.Scene.Preset (presetNames)
import Control.Exception (try)
import Data.Bifunctor (first)
import qualified Data.ByteString as Bytes
import System.IO (IOMode (ReadMode), withBinaryFile)
import System.IO.Error (ioeGetErrorString, isDoesNotExistError)

-- | A scene file's bytes, or one line that says why it cannot be read. Stops reading
-- when the file exceeds the limit for scene files.
readSceneFile :: FilePath -> IO (Either String Bytes.ByteString)
readSceneFile file = first complaint <$> try (withBinaryFile file ReadMode (`Bytes.hGet` limit))
  where
    limit = maximumYamlBytes + 1
    complaint failure
      | not (isDoesNotExistError failure) =
        file ++ ": cannot be read: " ++ ioeGetErrorString failure
      | file `elem` presetNames =
        file ++ ": there is no such file; for the preset, write --preset " ++ file
      | otherwise = file ++ ": there is no such file"
