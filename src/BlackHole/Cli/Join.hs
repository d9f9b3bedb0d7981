{-# LANGUAGE TupleSections #-}

-- | @blackhole join@: joins the tiles that @render --tile@ writes.
module BlackHole.Cli.Join
  ( JoinOptions (..),
    joinOptions,
    join,
    openTiles,
  )
where

import BlackHole.Cli.Check (checkThreads)
import BlackHole.Cli.CodingOptions (codingOptions)
import BlackHole.Cli.Console (say)
import BlackHole.Cli.ExitStatus
import BlackHole.Cli.Memory
import BlackHole.Cli.PictureOutput
import BlackHole.Cli.Progress (withProgress)
import BlackHole.Cli.Read
import BlackHole.Cli.RunOptions
import BlackHole.Cli.Stats (joinStatsJson)
import BlackHole.Cli.Tile (tileExtension)
import BlackHole.Cli.Version (versionLine)
import BlackHole.Image.Coding
import BlackHole.Image.Destination (toHandle)
import BlackHole.Image.Metadata (software)
import BlackHole.Image.TileFile
import BlackHole.Image.Write (pictureEncoder)
import BlackHole.Scene.Camera (Picture (..))
import BlackHole.Scene.Resolve
import BlackHole.Scene.Scene
import Control.Exception (IOException, try)
import Control.Monad ((>=>))
import Data.Either (partitionEithers)
import Data.List.NonEmpty (NonEmpty (..))
import Data.Maybe (fromMaybe)
import qualified Data.Vector.Storable as Vector
import GHC.Clock (getMonotonicTime)
import Options.Applicative
import System.IO.Error (ioeGetErrorString)

-- | The options of @blackhole join@.
data JoinOptions = JoinOptions
  { joinTiles :: ![FilePath],
    joinOutput :: !FilePath,
    joinCoding :: !Coding,
    joinThreads :: !(Maybe Int),
    joinReporting :: !Reporting
  }
  deriving (Eq, Show)

-- | Their parser.
joinOptions :: Parser JoinOptions
joinOptions =
  JoinOptions
    <$> some
      ( strArgument
          (metavar "TILE..." <> filesEnding [tileExtension] <> help "Tile files, in any order")
      )
    <*> settingOr
      "blackhole.png"
      ( strOption
          ( long "output" <> short 'o' <> metavar "FILE" <> action "file"
              <> help "File to write: .png, .jpg, .tif, .hdr or .exr (default: blackhole.png)"
          )
      )
    <*> codingOptions
    <*> threadsOption
    <*> reporting

-- | Writes the picture of some tiles.
join :: JoinOptions -> IO ExitStatus
join options = case formatOf (joinOutput options) of
  Nothing -> complainAll UsageError [unknownExtensionOf (joinOutput options)]
  Just format
    | problems@(_ : _) <-
        codingProblem format (joinCoding options)
          ++ checkThreads (joinThreads options) ->
      complainAll UsageError problems
    | otherwise -> do
      start <- getMonotonicTime
      opened <- openTiles (joinTiles options)
      either ((BadInput <$) . mapM_ say) (uncurry (joinOpen options format start)) opened

-- | The same for open tiles of a scene, given the time of the start.
joinOpen :: JoinOptions -> Format -> Double -> Scene -> [TileFile] -> IO ExitStatus
joinOpen options format start scene tiles = whenWritable writing . inWorkers (joinThreads options) $
  \workers -> do
    status <- withProgress (progressMode reported) height (width * sceneSamples scene) $ \report ->
      let rowsOf (first, count) = report first >> readPictureRows tiles (first, count)
       in case pictureEncoder workers software format (joinCoding options) (scene :| []) counts of
            Nothing -> complain CannotWrite (noRoom output)
            Just encode -> storeBy output (toHandle >=> encode rowsOf)
    if status == Done
      then do
        pictureSucceeded reported start output (width, height)
        end <- getMonotonicTime
        memory <- peakMemory
        storeStats
          reported
          (joinStatsJson versionLine scene (length tiles) workers (end - start) memory)
      else pure status
  where
    output = joinOutput options
    reported = joinReporting options
    Picture width height = scenePicture scene
    writing =
      Writing
        (Making (Joined format) False False)
        scene
        height
        [("a tile", tileFilePath tile) | tile <- tiles]
        output
        reported
    counts row =
      fromMaybe (Vector.replicate width (fromIntegral (sceneSamples scene)))
        <$> readCountsRow tiles row

-- | The scene of some tile files and the files themselves, or one line for each reason
-- why they cannot be joined. Reads all of them once.
openTiles :: [FilePath] -> IO (Either [String] (Scene, [TileFile]))
openTiles paths = do
  (refused, tiles) <- partitionEithers <$> mapM look paths
  case (refused, joinFaults [(tileFilePath tile, tileFileHeader tile) | tile <- tiles]) of
    (_ : _, _) -> pure (Left refused)
    (_, faults@(_ : _)) -> pure (Left faults)
    _ -> do
      damaged <- concat <$> mapM damage tiles
      pure $ case (damaged, tiles) of
        ([], tile : _) -> (,tiles) <$> sceneOf tile
        (_, _) -> Left damaged
  where
    look path = do
      opened <- try (openTile path)
      pure $ case opened of
        Left refusal ->
          Left
            (path ++ ": cannot be read: " ++ ioeGetErrorString (refusal :: IOException))
        Right (Left reason) -> Left (path ++ ": " ++ reason)
        Right (Right tile) -> Right tile
    damage tile = do
      intact <- try (tileIntact tile) :: IO (Either IOException Bool)
      pure [tileFilePath tile ++ ": damaged; render this tile again" | intact /= Right True]
    sceneOf tile =
      resolveRequest
        (Request Nothing (Just (tileFilePath tile, tileScene (tileFileHeader tile))) "." [])
