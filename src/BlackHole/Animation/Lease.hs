{-# LANGUAGE ScopedTypeVariables #-}
{-# LANGUAGE TupleSections #-}

-- | Leases: the files that say which process is rendering a frame.
--
-- A lease is a small file that names its holder. It is written completely under another
-- name and then linked to its own, which succeeds for one process only, even on network
-- file systems. The holder touches it regularly.
--
-- A lease whose holder is gone may be taken over in these cases:
--
-- * The holder was on this machine, and its process number is free or belongs to a
--   process that started at another time.
-- * The holder was an earlier start of the same Slurm job, which Slurm has requeued.
-- * The holder is elsewhere, and the lease has not been touched for a while, by the
--   clock of the file system (the clocks of machines may differ).
--
-- Removing a lease requires the folder's lock, which the system releases when its
-- process ends. Without the lock, a process might remove the lease that another one has
-- just made in place of an abandoned one.
module BlackHole.Animation.Lease
  ( Holder (..),
    currentHolder,
    holderName,
    renderHolder,
    parseHolder,
    LeaseFolder (..),
    leaseFile,
    Leased (..),
    takeLease,
    releaseLease,
    keepingAlive,
    liveHolder,
  )
where

import BlackHole.Image.PartFile (machine)
import Control.Concurrent (myThreadId, threadDelay)
import Control.Concurrent.Async (withAsync)
import Control.Exception (IOException, bracket, catch, throwIO, try)
import Control.Monad (forever, void)
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Char8 as Char8
import Data.Char (isDigit)
import Data.List (intercalate, stripPrefix)
import Data.Maybe (fromMaybe, mapMaybe)
import Foreign.C (throwErrnoIfMinus1, withCString)
import GHC.IO.Handle.Lock (FileLockingNotSupported (..), LockMode (ExclusiveLock), hLock, hUnlock)
import System.Directory (removeFile)
import System.Environment (lookupEnv)
import System.FilePath ((</>))
import System.IO (IOMode (ReadWriteMode), hClose, openFile)
import System.IO.Error (isAlreadyExistsError, isAlreadyInUseError, isDoesNotExistError)
import System.Posix.Files (createLink, getFileStatus, linkCount, modificationTime, touchFile)
import System.Posix.Internals (c_close, c_open, o_CREAT, o_EXCL, o_WRONLY)
import System.Posix.Process (getProcessID)
import System.Posix.Signals (nullSignal, signalProcess)
import Text.Read (readMaybe)

-- | A process that holds leases.
data Holder = Holder
  { holderHost :: !String,
    -- | What else makes process numbers comparable: the machine's last start and, in a
    -- container, its own numbering.
    holderBoot :: !String,
    holderProcess :: !Int,
    -- | The start time of the process, in the system's own format.
    holderStarted :: !String,
    -- | The Slurm job to which it belongs, if any, and the number of times that Slurm
    -- has started the job again.
    holderJob :: !(Maybe (String, Int))
  }
  deriving (Eq, Show)

-- | This process.
currentHolder :: IO Holder
currentHolder = do
  (host, boot) <- machine
  process <- fromIntegral <$> getProcessID
  started <- processStart process
  job <- lookupEnv "SLURM_JOB_ID"
  restarts <- lookupEnv "SLURM_RESTART_COUNT"
  pure
    Holder
      { holderHost = host,
        holderBoot = boot,
        holderProcess = process,
        holderStarted = fromMaybe "" started,
        holderJob = (,fromMaybe 0 (restarts >>= readMaybe)) <$> job
      }

-- | Process and machine, for messages.
holderName :: Holder -> String
holderName holder = "process " ++ show (holderProcess holder) ++ " on " ++ holderHost holder

-- | The contents of a lease's file: one line per field.
renderHolder :: Holder -> String
renderHolder (Holder host boot process started job) =
  unlines $
    ["host " ++ host, "boot " ++ boot, "process " ++ show process, "started " ++ started]
      ++ ["job " ++ show restarts ++ " " ++ name | Just (name, restarts) <- [job]]

-- | Parses the output of 'renderHolder'.
parseHolder :: String -> Maybe Holder
parseHolder text = do
  host <- field "host "
  boot <- field "boot "
  process <- field "process " >>= readMaybe
  started <- field "started "
  pure (Holder host boot process started (field "job " >>= job))
  where
    field name = case mapMaybe (stripPrefix name) (lines text) of
      value : _ -> Just value
      [] -> Nothing
    job value = case break (== ' ') value of
      (restarts, ' ' : name) -> (,) name <$> readMaybe restarts
      _ -> Nothing

-- | The folder of leases, the process that makes leases here, and the number of seconds
-- without a touch after which a lease from elsewhere counts as abandoned.
data LeaseFolder = LeaseFolder
  { leaseFolderPath :: !FilePath,
    leaseFolderHolder :: !Holder,
    leaseFolderPatience :: !Double
  }

-- | The file of a lease on something of this name.
leaseFile :: LeaseFolder -> String -> FilePath
leaseFile folder name = leaseFolderPath folder </> (name ++ ".claim")

-- | The outcome of asking for a lease.
data Leased
  = -- | This process now holds it; the dead holder from whom it was taken, if any.
    Leased !(Maybe Holder)
  | -- | Another process holds it (unknown if the file is not legible).
    HeldBy !(Maybe Holder)
  deriving (Eq, Show)

-- | Asks for a lease without waiting for another holder. Throws the exceptions of the
-- file system if no file can be created there.
takeLease :: LeaseFolder -> String -> IO Leased
takeLease folder name = do
  made <- makeExclusively folder path
  if made
    then pure (Leased Nothing)
    else do
      found <- judge folder path
      case found of
        Alive holder -> pure (HeldBy holder)
        _ -> locked folder $ do
          -- Another process may have been faster.
          again <- judge folder path
          case again of
            Alive holder -> pure (HeldBy holder)
            Abandoned holder -> removeQuietly path >> make holder
            Absent -> make Nothing
  where
    path = leaseFile folder name
    make former = do
      made <- makeExclusively folder path
      pure (if made then Leased former else HeldBy Nothing)

-- | Releases a lease. A lease that has been taken over in the meantime stays.
releaseLease :: LeaseFolder -> String -> IO ()
releaseLease folder name = locked folder $ do
  text <- quietly "" (readWhole path)
  if parseHolder text == Just (leaseFolderHolder folder) then removeQuietly path else pure ()
  where
    path = leaseFile folder name

-- | Touches a lease every few seconds while an action runs.
keepingAlive :: LeaseFolder -> String -> IO a -> IO a
keepingAlive folder name action = withAsync touching (const action)
  where
    touching = forever $ do
      threadDelay (round (1e6 * max 0.05 (min 10 (leaseFolderPatience folder / 5))))
      quietly () (touchFile (leaseFile folder name))

-- | The holder of a lease, unless the holder is known to be gone.
liveHolder :: LeaseFolder -> String -> IO (Maybe (Maybe Holder))
liveHolder folder name = do
  found <- judge folder (leaseFile folder name)
  pure $ case found of
    Alive holder -> Just holder
    _ -> Nothing

data Judgement
  = Absent
  | Alive !(Maybe Holder)
  | Abandoned !(Maybe Holder)

judge :: LeaseFolder -> FilePath -> IO Judgement
judge (LeaseFolder folder self patience) path = do
  text <- try (readWhole path)
  case text of
    Left refusal
      | isDoesNotExistError refusal -> pure Absent
      | otherwise -> throwIO refusal
    Right content -> case parseHolder content of
      Just holder
        -- A process has one name; its own lease is a remnant of an interrupted attempt.
        | holder == self -> pure (Abandoned (Just holder))
        | requeued holder -> pure (Abandoned (Just holder))
        | comparable holder -> do
          now <- processStart (holderProcess holder)
          pure $ case now of
            Just started | started == holderStarted holder -> Alive (Just holder)
            _ -> Abandoned (Just holder)
        | otherwise -> byAge (Just holder)
      Nothing -> byAge Nothing
  where
    requeued holder = case (holderJob holder, holderJob self) of
      (Just (job, restarts), Just (job', restarts')) -> job == job' && restarts < restarts'
      _ -> False
    comparable holder = holderHost holder == holderHost self && holderBoot holder == holderBoot self
    byAge holder = do
      touched <- try (modificationTime <$> getFileStatus path)
      case touched of
        Left refusal
          | isDoesNotExistError refusal -> pure Absent
          | otherwise -> throwIO (refusal :: IOException)
        -- If no clock can be read, no lease could be made either.
        Right time -> quietly (Alive holder) $ do
          now <- folderClock folder self
          -- A holder touches its lease with the file system's own time, so a time far
          -- in the future is not a sign of life either.
          pure (if abs (realToFrac (now - time)) > patience then Abandoned holder else Alive holder)
    -- The present time according to the file system.
    folderClock at holder =
      bracket
        (temporaryName "clock" holder >>= \name -> writeFile (at </> name) "" >> pure (at </> name))
        removeQuietly
        (fmap modificationTime . getFileStatus)

-- | The start time of a process, as far as the system reveals it; 'Nothing' if there is
-- no such process.
processStart :: Int -> IO (Maybe String)
processStart process = do
  stat <- try (readWhole ("/proc/" ++ show process ++ "/stat")) :: IO (Either IOException String)
  case stat of
    -- The name before the last parenthesis may contain anything. The state follows it,
    -- and the start time is the twentieth word from there.
    Right text -> pure $ case words (afterLast ')' text) of
      state : rest | state `notElem` ["Z", "X"], started : _ <- drop 18 rest -> Just started
      _ -> Nothing
    Left _ -> do
      linux <- quietly False (True <$ readWhole "/proc/self/stat")
      if linux then pure Nothing else answers
  where
    answers = quietly Nothing (Just "" <$ signalProcess nullSignal (fromIntegral process))
    afterLast c text = case break (== c) text of
      (_, _ : rest) | c `elem` rest -> afterLast c rest
      (_, _ : rest) -> rest
      (_, []) -> ""

-- | Creates a file with this process's name in it; 'False' if the file exists.
makeExclusively :: LeaseFolder -> FilePath -> IO Bool
makeExclusively (LeaseFolder folder self _) path =
  bracket
    ( temporaryName "claim" self >>= \name ->
        Bytes.writeFile (folder </> name) content
          >> pure (folder </> name)
    )
    removeQuietly
    $ \temporary -> do
      linked <- try (createLink temporary path)
      case linked of
        Right () -> pure True
        Left refusal
          -- The repeated answer of a network may deny the success of the first attempt.
          | isAlreadyExistsError refusal -> (== 2) . linkCount <$> getFileStatus temporary
          | otherwise -> withoutLinks
  where
    content = Char8.pack (renderHolder self)
    -- Some file systems have no links; a lease is then empty for a moment.
    withoutLinks = do
      made <-
        try
          ( withCString path $
              \name -> throwErrnoIfMinus1 "open" (c_open name (o_WRONLY + o_CREAT + o_EXCL) 0o644)
          )
      case made of
        Right descriptor -> do
          void (c_close descriptor)
          Bytes.writeFile path content
          pure True
        Left refusal
          | isAlreadyExistsError refusal -> pure False
          | otherwise -> throwIO (refusal :: IOException)

-- One for each thread, since an animation's list and its frames are leased at once.
temporaryName :: String -> Holder -> IO String
temporaryName purpose holder = do
  thread <- filter isDigit . show <$> myThreadId
  pure
    ( intercalate
        "."
        [ "",
          purpose,
          filter (/= '/') (holderHost holder),
          take 8 (holderBoot holder),
          show (holderProcess holder),
          thread
        ]
    )

-- | Runs an action with the folder's lock. On a file system without locks it runs
-- without one, protected only by the exclusive creation of leases.
locked :: LeaseFolder -> IO a -> IO a
locked (LeaseFolder folder _ _) action = bracket open close $ \handle ->
  ifSupported (hLock handle ExclusiveLock) >> action
  where
    -- The run-time system allows only one thread to open a file for writing.
    open =
      openFile (folder </> "lock") ReadWriteMode `catch` \refusal ->
        if isAlreadyInUseError refusal then threadDelay 1000 >> open else throwIO refusal
    -- A program started in the meantime, such as ffmpeg, has inherited the open file,
    -- and closing it here alone would leave the lock to that program.
    close handle = ifSupported (hUnlock handle) >> hClose handle
    ifSupported attempt = attempt `catch` unsupported `catch` refused
    unsupported :: FileLockingNotSupported -> IO ()
    unsupported _ = pure ()
    refused :: IOException -> IO ()
    refused _ = pure ()

removeQuietly :: FilePath -> IO ()
removeQuietly = quietly () . removeFile

quietly :: forall a. a -> IO a -> IO a
quietly otherwise' action = action `catch` refused
  where
    refused :: IOException -> IO a
    refused _ = pure otherwise'

-- Reads a small file, whatever its bytes.
readWhole :: FilePath -> IO String
readWhole = fmap Char8.unpack . Bytes.readFile
