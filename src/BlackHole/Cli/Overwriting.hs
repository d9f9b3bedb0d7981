{-# LANGUAGE TupleSections #-}

-- | Files that a command would overwrite although it reads them, or writes them
-- twice.
module BlackHole.Cli.Overwriting (overwritten) where

import BlackHole.Image.AtomicFile (finalTarget)
import Control.Exception (IOException, try)
import qualified Data.Map.Strict as Map
import Data.Maybe (catMaybes)
import System.FilePath (takeDirectory, takeFileName)
import System.Posix.Files
import System.Posix.Types (DeviceID, FileID)

-- | @overwritten read written@: a line for each file to be written that is read too,
-- or written twice, whatever the names or links by which it is reached. Each path
-- comes with the option that names it. Devices such as @\/dev\/null@ may occur
-- repeatedly; @-@ is standard output.
overwritten :: [(String, FilePath)] -> [(String, FilePath)] -> IO [String]
overwritten inputs outputs = do
  known <- Map.fromListWith (const id) . catMaybes <$> mapM identified inputs
  found <- mapM identified outputs
  pure (go known (catMaybes found))
  where
    identified named@(_, path) = fmap (,named) <$> identify path
    go _ [] = []
    go known ((identity, (option, path)) : rest) =
      [ option ++ ": '" ++ path ++ "' is the file of " ++ other
          ++ (if path == otherPath then "" else " ('" ++ otherPath ++ "')")
          ++ "; choose another"
        | Just (other, otherPath) <- [Map.lookup identity known]
      ]
        ++ go (Map.insert identity (option, path) known) rest

-- | A file, or the place of one that does not exist yet.
data Identity
  = Existing !DeviceID !FileID
  | Missing !DeviceID !FileID !FilePath
  deriving (Eq, Ord)

-- | 'Nothing' for devices, and where the system does not tell.
identify :: FilePath -> IO (Maybe Identity)
identify path = do
  found <- attempt (if path == "-" then getFdStatus 1 else getFileStatus path)
  case found of
    Just status
      | isCharacterDevice status -> pure Nothing
      | otherwise -> pure (Just (Existing (deviceID status) (fileID status)))
    Nothing -> do
      target <- finalTarget path
      folder <- attempt (getFileStatus (takeDirectory target))
      pure ((\status -> Missing (deviceID status) (fileID status) (takeFileName target)) <$> folder)
  where
    attempt action = either ignoring Just <$> try action
    ignoring :: IOException -> Maybe a
    ignoring _ = Nothing
