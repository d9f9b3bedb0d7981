-- | Files that appear only when they are complete.
--
-- The bytes go to a temporary file in the target's folder, which is then renamed to the
-- target. A reader of the target sees either the former file or the complete new one,
-- even if the program is interrupted or the disk is full. Only a program that is killed
-- while it writes leaves its temporary file behind, named @.blackhole-….part@, until
-- the next run that writes to the folder ('checkWritable'). The bytes are not forced
-- out of the system's cache: a picture lost in a power cut can be rendered again, and
-- waiting for the disk would require a library for each platform.
module BlackHole.Image.AtomicFile
  ( writeFileAtomically,
    writeAtomically,
    checkWritable,
    finalTarget,
    WriteProblem (..),
    renderWriteProblem,
    printable,
  )
where

import BlackHole.Image.PartFile
import Control.Exception (catch, mask, mask_, onException, try)
import Data.Bits ((.|.))
import qualified Data.ByteString.Lazy as Lazy
import Data.Char (isControl)
import Data.List (isPrefixOf)
import Foreign.C (Errno (..), eNXIO, throwErrnoIfMinus1Retry_, withCString)
import GHC.IO.Device (IODeviceType (..))
import GHC.IO.Exception (IOException (..))
import System.Directory
  ( copyPermissions,
    doesDirectoryExist,
    getPermissions,
    getSymbolicLinkTarget,
    pathIsSymbolicLink,
    writable,
  )
import System.FilePath (takeDirectory, (</>))
import System.IO
  ( Handle,
    IOMode (AppendMode),
    hClose,
    withBinaryFile,
  )
import System.IO.Error (isDoesNotExistError)
import System.Posix.Files (getFileStatus, isNamedPipe)
import System.Posix.Internals (c_open, fileType, o_NONBLOCK, o_WRONLY)

-- | The reason why a file cannot be written. The first path is the requested one.
data WriteProblem
  = -- | The path is empty.
    EmptyPath
  | -- | The path names a folder.
    TargetIsFolder FilePath
  | -- | The file exists and this user may not write to it.
    TargetIsProtected FilePath
  | -- | The file's folder, the second path, does not exist.
    FolderMissing FilePath FilePath
  | -- | No file can be created in the folder, which is the second path, for the reason
    -- given by the system.
    FolderNotWritable FilePath FilePath String
  | -- | Any other problem, with the reason given by the system: disk full, name too
    -- long, …
    SystemRefused FilePath String
  deriving (Eq, Show)

-- | The problem as one line without a final period.
renderWriteProblem :: WriteProblem -> String
renderWriteProblem problem = printable $ case problem of
  EmptyPath -> "cannot write a file with an empty name"
  TargetIsFolder path -> cannot path "it is a folder"
  TargetIsProtected path -> cannot path "the file is write-protected"
  FolderMissing path folder -> cannot path $ "there is no folder " ++ folder
  FolderNotWritable path folder reason ->
    cannot path $ "no file can be made in the folder " ++ folder ++ " (" ++ reason ++ ")"
  SystemRefused path reason -> cannot path reason
  where
    cannot path reason = "cannot write " ++ path ++ ": " ++ reason

-- | A text that may contain names of foreign origin, as a single line: control
-- characters, including newlines, become question marks.
printable :: String -> String
printable = map (\c -> if isControl c then '?' else c)

-- | Writes a file completely or not at all.
--
-- An existing file is replaced and keeps its permissions; a new file gets those of the
-- user's file mask. A symbolic link stays, and the file to which it leads is replaced
-- or created. Devices, pipes and @\/dev\/stdout@ cannot be replaced, so the bytes are
-- written to them directly.
--
-- Problems of the file system are returned, and the target is then unchanged. Any other
-- exception, whether from evaluating the bytes or thrown to this thread, removes the
-- temporary file and is rethrown.
writeFileAtomically :: FilePath -> Lazy.ByteString -> IO (Either WriteProblem ())
writeFileAtomically path bytes = writeAtomically path (`Lazy.hPut` bytes)

-- | 'writeFileAtomically' for an action that writes to a handle.
writeAtomically :: FilePath -> (Handle -> IO ()) -> IO (Either WriteProblem ())
writeAtomically path content = locate path >>= either (pure . Left) write
  where
    write (Direct device) =
      refusalOf path $ withBinaryFile device AppendMode content
    write (Replaced target) = mask $ \restore -> do
      opened <- openTemporary path target
      either (pure . Left) (refusalOf path . fill restore target) opened
    fill :: (IO () -> IO ()) -> FilePath -> (FilePath, Handle) -> IO ()
    fill restore target (temporary, handle) =
      replace `onException` discard temporary handle
      where
        replace = do
          -- Set before the first byte, to protect a private file. Some file systems
          -- have no permissions to set, which is no reason to lose a picture.
          ignoringRefusal $ copyPermissions target temporary
          restore (content handle)
          hClose handle
          placePartFile temporary target

-- | Checks whether 'writeFileAtomically' can write this file, as far as that can be
-- known in advance (a disk may fill up later). Leaves no file behind and does not touch
-- an existing one, but removes temporary files in the folder that belong to dead
-- processes of this machine.
checkWritable :: FilePath -> IO (Either WriteProblem ())
checkWritable path = locate path >>= either (pure . Left) probe
  where
    probe (Direct device) = do
      pipe <- refusalOf path (isNamedPipe <$> getFileStatus device)
      if pipe == Right True then holdPipe device else pure (Right ())
    probe (Replaced target) = do
      sweepPartFiles (takeDirectory target)
      mask_ $ openTemporary path target >>= traverse (uncurry discard)
    -- A pipe cannot be opened for writing without waiting until another program reads
    -- from it. It stays open until the process ends, because closing it would signal
    -- the reader that nothing follows.
    holdPipe device = do
      opened <-
        try
          ( withCString
              device
              (\name -> throwErrnoIfMinus1Retry_ "open" (c_open name (o_WRONLY .|. o_NONBLOCK) 0))
          )
      pure $ case opened of
        Left refusal
          | ioe_errno refusal == Just enxio ->
            Left
              (SystemRefused path "no program reads from this pipe")
          | otherwise -> Left (SystemRefused path (reasonOf refusal))
        Right () -> Right ()
    Errno enxio = eNXIO

data Destination
  = Replaced FilePath
  | Direct FilePath

locate :: FilePath -> IO (Either WriteProblem Destination)
locate path
  | null path = pure (Left EmptyPath)
  | '\0' `elem` path = pure (Left (SystemRefused path "the name contains a NUL character"))
  | otherwise = do
    found <- try (fileType path)
    case found of
      Right Directory -> pure (Left (TargetIsFolder path))
      Right RegularFile -> followLinks path >>= existing
      Right _ -> existing (Right (Direct path))
      Left refusal
        | isDoesNotExistError refusal -> followLinks path >>= either (pure . Left) new
        | otherwise -> pure (Left (SystemRefused path (reasonOf refusal)))
  where
    existing (Left problem) = pure (Left problem)
    existing (Right destination) = do
      permitted <- refusalOf path $ writable <$> getPermissions path
      pure $ permitted >>= \yes -> if yes then Right destination else Left (TargetIsProtected path)
    new destination@(Replaced target) = do
      exists <- doesDirectoryExist (takeDirectory target)
      pure $ if exists then Right destination else Left (FolderMissing path (takeDirectory target))
    new destination = pure (Right destination)

-- | The target of a path after following symbolic links; the path itself if it is not a
-- link, or if the links form a cycle.
finalTarget :: FilePath -> IO FilePath
finalTarget path = destination <$> followLinks path
  where
    destination (Right (Replaced target)) = target
    destination _ = path

-- If the shell has redirected them, a process's own open files look like links to a
-- regular file, but replacing that file would disconnect the shell's end.
followLinks :: FilePath -> IO (Either WriteProblem Destination)
followLinks path = go (40 :: Int) path
  where
    go hops at
      | any (`isPrefixOf` at) ["/proc/", "/dev/fd/"] = pure (Right (Direct path))
      | hops == 0 = pure (Left (SystemRefused path "too many symbolic links"))
      | otherwise = do
        next <- try (isLink at) :: IO (Either IOException (Maybe FilePath))
        case next of
          Right (Just target) -> go (hops - 1) (takeDirectory at </> target)
          _ -> pure (Right (Replaced at))
    isLink at = do
      link <- pathIsSymbolicLink at
      if link then Just <$> getSymbolicLinkTarget at else pure Nothing

openTemporary :: FilePath -> FilePath -> IO (Either WriteProblem (FilePath, Handle))
openTemporary path target = do
  opened <- try (openPartFile folder ".part")
  pure $ case opened of
    Left refusal -> Left (FolderNotWritable path folder (reasonOf refusal))
    Right temporary -> Right temporary
  where
    folder = takeDirectory target

discard :: FilePath -> Handle -> IO ()
discard temporary handle =
  ignoringRefusal (hClose handle) >> removePartFile temporary

ignoringRefusal :: IO () -> IO ()
ignoringRefusal action = action `catch` ignored
  where
    ignored :: IOException -> IO ()
    ignored _ = pure ()

refusalOf :: FilePath -> IO a -> IO (Either WriteProblem a)
refusalOf path action = either (Left . SystemRefused path . reasonOf) Right <$> try action

reasonOf :: IOException -> String
reasonOf refusal
  | null (ioe_description refusal) = show (ioe_type refusal)
  | otherwise = ioe_description refusal
