{-# LANGUAGE ScopedTypeVariables #-}

-- | What is known of a film's frames: a folder @.blackhole@ beside them.
--
-- For each finished frame there is a record, a small text with the fingerprints
-- of the frame's scene and of its file; a frame counts as done only if both are
-- what they should be. The file is put into its place first and the record after
-- it, each in one step, so that a program killed at any moment leaves whole
-- frames, and at worst one without its record, which is rendered again. A list
-- of all frames lets anybody see what the film still lacks without its scene.
module BlackHole.Animation.Ledger
  ( Ledger,
    openLedger,
    ledgerClaims,
    ledgerFrameName,
    frameLabel,
    Condition (..),
    frameCondition,
    Record (..),
    storeFrame,
    removeLeftOver,

    -- * The list of all frames
    writeFrameList,
    readFrameLists,
  )
where

import BlackHole.Animation.Claim
import BlackHole.Animation.Digest
import BlackHole.Animation.FrameName
import Control.Exception (IOException, catch, onException)
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Char8 as Char8
import qualified Data.ByteString.Lazy as Lazy
import qualified Data.ByteString.Lazy.Char8 as LazyChar8
import Data.List (isSuffixOf, sort, stripPrefix)
import Data.Maybe (mapMaybe)
import System.Directory (createDirectoryIfMissing, doesFileExist, getFileSize, listDirectory, removeFile, renameFile)
import System.FilePath (takeDirectory, takeFileName, (</>))
import System.IO (IOMode (WriteMode), withBinaryFile)
import Text.Read (readMaybe)

-- | The ledger of the frames of one name pattern.
data Ledger = Ledger
  { -- | The pattern of the frames' files.
    ledgerFrameName :: !FrameName,
    -- | Where claims on frames are made.
    ledgerClaims :: !ClaimFolder
  }

-- | Make the frames' folder and the ledger in it if they are missing. Claims
-- from elsewhere count as abandoned after the given seconds. Throws what the
-- file system says.
openLedger :: FrameName -> Holder -> Double -> IO Ledger
openLedger name holder patience = do
  createDirectoryIfMissing True folder
  pure (Ledger name (ClaimFolder folder holder patience))
  where
    folder = takeDirectory (frameFile name 0) </> ledgerFolderName

ledgerFolderName :: FilePath
ledgerFolderName = ".blackhole"

-- | The state of a frame's file.
data Condition
  = -- | Finished, of the scene asked for, and undamaged.
    Finished !Record
  | -- | There is no such file.
    Missing
  | -- | The file is of another scene, or nobody knows of which.
    Stale
  | -- | The file is not what was written.
    Damaged
  deriving (Eq, Show)

-- | What is written down about a finished frame.
data Record = Record
  { recordScene :: !Digest,
    recordFile :: !Digest,
    recordBytes :: !Integer,
    -- | Time that the frame took.
    recordSeconds :: !Double
  }
  deriving (Eq, Show)

-- | The state of a frame that should be of the scene with this fingerprint.
-- Reads the file, unless its size already tells.
frameCondition :: Ledger -> Int -> Digest -> IO Condition
frameCondition ledger frame scene = do
  exists <- doesFileExist file
  if not exists
    then pure Missing
    else do
      record <- quietly "" (readWhole (recordPath ledger frame))
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
    file = frameFile (ledgerFrameName ledger) frame

-- | Put a frame's file into its place, then its record.
storeFrame :: Ledger -> Int -> Digest -> Double -> Lazy.ByteString -> IO ()
storeFrame ledger frame scene seconds bytes = do
  inOneStep ledger frame (frameFile (ledgerFrameName ledger) frame) bytes
  inOneStep ledger frame (recordPath ledger frame) . LazyChar8.pack . renderRecord $
    Record scene (digestBytes bytes) (toInteger (Lazy.length bytes)) seconds

-- | Remove what a holder that is gone may have left of a frame.
removeLeftOver :: Ledger -> Int -> Holder -> IO ()
removeLeftOver ledger frame holder =
  quietly () (removeFile (partPath ledger frame holder))

-- Whoever is killed while he writes leaves the part behind under a name that
-- whoever takes over his claim can tell.
inOneStep :: Ledger -> Int -> FilePath -> Lazy.ByteString -> IO ()
inOneStep ledger frame target bytes =
  (withBinaryFile part WriteMode (`Lazy.hPut` bytes) >> renameFile part target)
    `onException` removeLeftOver ledger frame holder
  where
    holder = claimFolderHolder (ledgerClaims ledger)
    part = partPath ledger frame holder

partPath :: Ledger -> Int -> Holder -> FilePath
partPath ledger frame holder =
  ledgerPath ledger </> (frameLabel ledger frame ++ "." ++ filter (/= '/') (holderHost holder) ++ "." ++ show (holderProcess holder) ++ ".part")

recordPath :: Ledger -> Int -> FilePath
recordPath ledger frame = ledgerPath ledger </> (frameLabel ledger frame ++ ".done")

-- | What the frame is called in the ledger: the name of its file.
frameLabel :: Ledger -> Int -> String
frameLabel ledger = takeFileName . frameFile (ledgerFrameName ledger)

ledgerPath :: Ledger -> FilePath
ledgerPath = claimFolderPath . ledgerClaims

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

-- | Write down which frames there are to be, with the fingerprints of their
-- scenes; takes the place of an earlier list of the same pattern.
writeFrameList :: Ledger -> [(Int, Digest)] -> IO ()
writeFrameList ledger frames =
  inOneStep ledger 0 path . LazyChar8.pack . unlines $
    [show frame ++ " " ++ digestHex scene | (frame, scene) <- frames]
  where
    path = ledgerPath ledger </> (takeFileName (framePattern (ledgerFrameName ledger)) ++ ".film")

-- | All lists in a folder of frames, with their patterns; none if there is no
-- ledger. Lists that are not legible are left out.
readFrameLists :: FilePath -> IO [(FrameName, [(Int, Digest)])]
readFrameLists folder = do
  names <- quietly [] (listDirectory ledger)
  found <- mapM load (sort (filter (".film" `isSuffixOf`) names))
  pure (concat found)
  where
    ledger = folder </> ledgerFolderName
    load name = do
      text <- quietly "-" (readWhole (ledger </> name))
      pure $ case (parseFrameName (folder </> escapeless name), traverse entry (lines text)) of
        (Right pattern', Just frames) -> [(pattern', frames)]
        _ -> []
    escapeless name = take (length name - length ".film") name
    entry line = case words line of
      [frame, digest] -> (,) <$> readMaybe frame <*> parseDigest digest
      _ -> Nothing

-- A text of our own, whatever its bytes have become.
readWhole :: FilePath -> IO String
readWhole = fmap Char8.unpack . Bytes.readFile

quietly :: forall a. a -> IO a -> IO a
quietly otherwise' action = action `catch` refused
  where
    refused :: IOException -> IO a
    refused _ = pure otherwise'
