-- | Temporary files whose names identify the process that writes them, so that a later
-- run can remove those of a killed process.
module BlackHole.Image.PartFile
  ( openPartFile,
    placePartFile,
    removePartFile,
    sweepPartFiles,
    machine,
  )
where

import BlackHole.Image.Exhaustion (keepIfExhausted, removeIfExhausted)
import Control.Exception (IOException, mask_, try)
import Control.Monad (unless)
import qualified Crypto.Hash.SHA256 as SHA256
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Char8 as Characters
import Data.Char (isAlphaNum, isAscii, isDigit)
import Data.Foldable (for_)
import Data.List (stripPrefix)
import Numeric (showHex)
import System.Directory (listDirectory, removeFile, renameFile)
import System.FilePath ((</>))
import System.IO (Handle, openBinaryTempFileWithDefaultPermissions)
import System.IO.Error (isDoesNotExistError)
import System.Posix.Files (readSymbolicLink)
import System.Posix.Process (getProcessID)
import System.Posix.Signals (nullSignal, signalProcess)
import System.Posix.Unistd (getSystemID, nodeName)
import Text.Read (readMaybe)

-- | @openPartFile folder extension@ creates a new file in a folder and opens it for
-- writing. Its name is short and independent of the finished file's name, which may be
-- as long as the file system allows. It is removed if memory runs out. Throws the
-- exceptions of the file system.
openPartFile :: FilePath -> String -> IO (FilePath, Handle)
openPartFile folder extension = mask_ $ do
  prefix <- partPrefix
  process <- getProcessID
  opened <-
    openBinaryTempFileWithDefaultPermissions folder (prefix ++ show process ++ "-" ++ extension)
  opened <$ removeIfExhausted (fst opened)

-- | @placePartFile part target@ gives a complete file its name. Throws the exceptions of
-- the file system.
placePartFile :: FilePath -> FilePath -> IO ()
placePartFile part target = renameFile part target >> keepIfExhausted part

-- | Removes an unfinished file, if the file system permits.
removePartFile :: FilePath -> IO ()
removePartFile part = quietly () (removeFile part) >> keepIfExhausted part

-- | Removes the files that dead processes of this machine have left in a folder. Skips
-- files that cannot be listed or removed.
sweepPartFiles :: FilePath -> IO ()
sweepPartFiles folder = quietly () $ do
  prefix <- partPrefix
  names <- listDirectory folder
  for_ names $ \name -> case span isDigit <$> stripPrefix prefix name of
    Just (digits, '-' : _) | Just process <- readMaybe digits -> do
      alive <- isAlive process
      unless alive $ quietly () (removeFile (folder </> name))
    _ -> pure ()
  where
    isAlive process = do
      answer <- try (signalProcess nullSignal (fromInteger process))
      pure (either (not . isDoesNotExistError) (const True) answer)

-- Process numbers are comparable only on one machine, since its last start, and within
-- one container.
partPrefix :: IO String
partPrefix = do
  (host, boot) <- machine
  pure (".blackhole-" ++ filter plain host ++ "-" ++ fingerprint boot ++ "-")
  where
    plain c = isAscii c && (isAlphaNum c || c `elem` ".-")
    fingerprint = concatMap twoDigits . Bytes.unpack . Bytes.take 4 . SHA256.hash . Characters.pack
    twoDigits b = (if b < 16 then "0" else "") ++ showHex b ""

-- | The machine's name, and what else makes process numbers comparable: its last start
-- and, in a container, its own numbering.
machine :: IO (String, String)
machine = do
  host <- nodeName <$> getSystemID
  boot <-
    quietly
      ""
      (concat . lines . Characters.unpack <$> Bytes.readFile "/proc/sys/kernel/random/boot_id")
  space <- quietly "" (readSymbolicLink "/proc/self/ns/pid")
  pure (host, boot ++ space)

quietly :: a -> IO a -> IO a
quietly otherwise' action = either (ignoring otherwise') id <$> try action
  where
    ignoring :: a -> IOException -> a
    ignoring = const
