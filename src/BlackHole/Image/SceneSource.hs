-- | The bytes of scene files.
module BlackHole.Image.SceneSource (readSceneFile) where

import BlackHole.Scene.File.Yaml (maximumYamlBytes)
import Control.Exception (IOException, try)
import qualified Data.ByteString as Bytes
import System.IO (IOMode (ReadMode), withBinaryFile)
import System.IO.Error (ioeGetErrorString)

-- | A scene file's bytes, or one line that says why it cannot be read. Stops reading
-- when the file exceeds the limit for scene files.
readSceneFile :: FilePath -> IO (Either String Bytes.ByteString)
readSceneFile file = do
  outcome <- try (withBinaryFile file ReadMode (`Bytes.hGet` (maximumYamlBytes + 1)))
  pure $ case outcome of
    Left failure ->
      Left
        (file ++ ": cannot be read: " ++ ioeGetErrorString (failure :: IOException))
    Right bytes -> Right bytes
