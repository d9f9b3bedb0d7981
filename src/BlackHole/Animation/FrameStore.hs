{-# LANGUAGE ScopedTypeVariables #-}

-- | The frame store of an animation's frames: a folder @.blackhole@ next to them.
--
-- Each finished frame has a record, a small text with the fingerprints of the frame's
-- scene and of its file. A frame counts as done only if both match. The program moves
-- the file into place first and the record after it, each in one step, so a program
-- killed at any moment leaves complete frames, and at worst one frame without a record,
-- which is rendered again. A list of all frames shows which ones the animation still lacks,
-- without access to its scene.
module BlackHole.Animation.FrameStore
  ( FrameStore,
    openFrameStore,
    frameStoreLeases,
    frameStoreName,
    frameLabel,
    FrameState (..),
    frameState,
    Record (..),
    storeFrame,
    removeLeftOver,
    sweepFrame,

    -- * The list of all frames
    writeFrameList,
    readFrameLists,
  )
where

import BlackHole.Animation.FrameName
import BlackHole.Animation.Lease
import BlackHole.Image.AtomicFile (renderWriteProblem, writeFileAtomically)
import BlackHole.Image.Digest
import BlackHole.Image.Exhaustion (removeIfExhausted)
import BlackHole.Image.PartFile (placePartFile, removePartFile)
import Control.Exception (IOException, catch, finally, onException)
import Control.Monad (unless, when)
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Char8 as Char8
import qualified Data.ByteString.Lazy as Lazy
import qualified Data.ByteString.Lazy.Char8 as LazyChar8
import Data.List (isSuffixOf, sort, stripPrefix)
import Data.Maybe (mapMaybe)
import System.Directory
  ( createDirectoryIfMissing,
    doesFileExist,
    getFileSize,
    listDirectory,
    pathIsSymbolicLink,
    removeFile,
  )
import System.FilePath (takeDirectory, takeFileName, (</>))
import System.IO (IOMode (WriteMode), withBinaryFile)
import Text.Read (readMaybe)

-- | The frame store of the frames of one name pattern.
data FrameStore = FrameStore
  { -- | The pattern of the frames' files.
    frameStoreName :: !FrameName,
    -- | Where processes take leases on frames.
    frameStoreLeases :: !LeaseFolder
  }

-- | Creates the folder of the frames and the frame store in it if they are missing. Leases
-- from other machines count as abandoned after this many seconds. Throws the exceptions
-- of the file system.
openFrameStore :: FrameName -> Holder -> Double -> IO FrameStore
openFrameStore name holder patience = do
  createDirectoryIfMissing True folder
  pure (FrameStore name (LeaseFolder folder holder patience))
  where
    folder = takeDirectory (frameFile name 0) </> frameStoreFolderName

frameStoreFolderName :: FilePath
frameStoreFolderName = ".blackhole"

-- | The state of a frame's file.
data FrameState
  = -- | Finished, for the requested scene, and undamaged.
    Finished !Record
  | -- | The file does not exist.
    Missing
  | -- | The file belongs to another scene, or to an unknown one.
    Stale
  | -- | The file's contents have changed since it was written.
    Damaged
  deriving (Eq, Show)

-- | The record of a finished frame.
data Record = Record
  { recordScene :: !Digest,
    recordFile :: !Digest,
    recordBytes :: !Integer,
    -- | The seconds that the frame took.
    recordSeconds :: !Double
  }
  deriving (Eq, Show)

-- | The state of a frame relative to the fingerprint of its scene. Reads the file
-- unless its size already decides.
frameState :: FrameStore -> Int -> Digest -> IO FrameState
frameState store frame scene = do
  exists <- doesFileExist file
  if not exists
    then pure Missing
    else do
      record <- quietly "" (readWhole (recordPath store frame))
      case parseRecord record of
        Just found
          | recordScene found == scene -> do
            size <- getFileSize file
            if size /= recordBytes found
              then pure Damaged
              else do
                (digest, _) <- digestFile file
                pure (if digest == recordFile found then Finished found else Damaged)
        _ -> pure Stale
  where
    file = frameFile (frameStoreName store) frame

-- | Moves a frame's file into place, and then its record. A symbolic link stays, and
-- the file to which it leads is replaced.
storeFrame :: FrameStore -> Int -> Digest -> Double -> Lazy.ByteString -> IO ()
storeFrame store frame scene seconds bytes = do
  link <- quietly False (pathIsSymbolicLink file)
  -- The link may lead to another file system.
  if link
    then writeFileAtomically file bytes >>= either (ioError . userError . renderWriteProblem) pure
    else inOneStep store name file bytes
  inOneStep store name (recordPath store frame) . LazyChar8.pack . renderRecord $
    Record scene (digestBytes bytes) (toInteger (Lazy.length bytes)) seconds
  where
    file = frameFile (frameStoreName store) frame
    name = frameLabel store frame

-- | Removes what a dead process has left of a finished frame: it may have been killed
-- before it could release its lease.
sweepFrame :: FrameStore -> Int -> IO ()
sweepFrame store frame = do
  left <- doesFileExist (leaseFile leases name)
  when left $ do
    leased <- takeLease leases name
    case leased of
      Leased former -> mapM_ (removeLeftOver store frame) former >> releaseLease leases name
      HeldBy _ -> pure ()
  where
    leases = frameStoreLeases store
    name = frameLabel store frame

-- | Removes what a dead holder may have left of a frame.
removeLeftOver :: FrameStore -> Int -> Holder -> IO ()
removeLeftOver store frame holder =
  quietly () (removeFile (partPath store (frameLabel store frame) holder))

-- A process that is killed while writing leaves its temporary file behind, under a name
-- that the process which takes over its lease can determine.
inOneStep :: FrameStore -> String -> FilePath -> Lazy.ByteString -> IO ()
inOneStep store name target bytes =
  ( removeIfExhausted part >> withBinaryFile part WriteMode (`Lazy.hPut` bytes)
      >> placePartFile part target
  )
    `onException` removePartFile part
  where
    part = partPath store name (leaseFolderHolder (frameStoreLeases store))

partPath :: FrameStore -> String -> Holder -> FilePath
partPath store name holder =
  frameStorePath store
    </> ( name ++ "." ++ filter (/= '/') (holderHost holder) ++ "."
            ++ show (holderProcess holder)
            ++ ".part"
        )

recordPath :: FrameStore -> Int -> FilePath
recordPath store frame = frameStorePath store </> (frameLabel store frame ++ ".done")

-- | The frame's name in the frame store, which is the name of its file.
frameLabel :: FrameStore -> Int -> String
frameLabel store = takeFileName . frameFile (frameStoreName store)

frameStorePath :: FrameStore -> FilePath
frameStorePath = leaseFolderPath . frameStoreLeases

renderRecord :: Record -> String
renderRecord (Record scene file bytes seconds) =
  unlines
    [ "scene " ++ digestHex scene,
      "file " ++ digestHex file,
      "bytes " ++ show bytes,
      "seconds " ++ show seconds
    ]

parseRecord :: String -> Maybe Record
parseRecord text =
  Record
    <$> (field "scene " >>= parseDigest)
    <*> (field "file " >>= parseDigest)
    <*> (field "bytes " >>= readMaybe)
    <*> (field "seconds " >>= readMaybe)
  where
    field name = case mapMaybe (stripPrefix name) (lines text) of
      [value] -> Just value
      _ -> Nothing

-- | Writes the list of all frames with the fingerprints of their scenes. Replaces an
-- earlier list for the same pattern. If another process is writing a list at the same
-- time, that one counts as the later.
writeFrameList :: FrameStore -> [(Int, Digest)] -> IO ()
writeFrameList store frames = do
  leased <- takeLease leases name
  case leased of
    HeldBy _ -> pure ()
    Leased former ->
      (mapM_ (sweep . partPath store name) former >> write)
        `finally` releaseLease leases name
  where
    write = do
      before <- quietly Bytes.empty (Bytes.readFile path)
      unless (before == Lazy.toStrict content) $ inOneStep store name path content
    sweep = quietly () . removeFile
    leases = frameStoreLeases store
    name = takeFileName (framePattern (frameStoreName store)) ++ listExtension
    path = frameStorePath store </> name
    content =
      LazyChar8.pack
        (unlines [show frame ++ " " ++ digestHex scene | (frame, scene) <- frames])

listExtension :: String
listExtension = ".film"

-- | All lists in a folder of frames with their patterns; empty without a frame store. Lists
-- that are not legible are left out.
readFrameLists :: FilePath -> IO [(FrameName, [(Int, Digest)])]
readFrameLists folder = do
  names <- quietly [] (listDirectory store)
  found <- mapM load (sort (filter (listExtension `isSuffixOf`) names))
  pure (concat found)
  where
    store = folder </> frameStoreFolderName
    load name = do
      text <- quietly "-" (readWhole (store </> name))
      pure $ case (parseFrameName (folder </> escapeless name), traverse entry (lines text)) of
        (Right pattern', Just frames) -> [(pattern', frames)]
        _ -> []
    escapeless name = take (length name - length listExtension) name
    entry line = case words line of
      [frame, digest] -> (,) <$> readMaybe frame <*> parseDigest digest
      _ -> Nothing

-- Reads a file that this program wrote, whatever its bytes have become.
readWhole :: FilePath -> IO String
readWhole = fmap Char8.unpack . Bytes.readFile

quietly :: forall a. a -> IO a -> IO a
quietly otherwise' action = action `catch` refused
  where
    refused :: IOException -> IO a
    refused _ = pure otherwise'
