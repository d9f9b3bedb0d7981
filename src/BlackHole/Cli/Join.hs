{-# LANGUAGE TupleSections #-}

-- | Tiles of one large picture, which @render --tile@ writes and @blackhole join@ joins.
module BlackHole.Cli.Join
  ( JoinOptions (..),
    joinOptions,
    tilePart,
    tileHeader,
    tileProblems,
    tileNameProblems,
    openTiles,
  )
where

import BlackHole.Cli.CodingOptions (codingOptions)
import BlackHole.Cli.Read
import BlackHole.Cli.RunOptions
import BlackHole.Image.Coding (Coding)
import BlackHole.Image.TileFile
import BlackHole.Render.Shard
import BlackHole.Scene.Camera (Picture (..))
import BlackHole.Scene.File.SceneFile (printScene)
import BlackHole.Scene.Problem
import BlackHole.Scene.Resolve
import BlackHole.Scene.Scene
import Control.Exception (IOException, try)
import qualified Data.ByteString.Builder as Builder
import qualified Data.ByteString.Lazy as Lazy
import Data.Char (toLower)
import Data.Either (partitionEithers)
import Options.Applicative
import System.FilePath (takeExtension)
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
    <$> some (strArgument (metavar "TILE..." <> filesEnding [tileExtension] <> help "Tile files, in any order"))
    <*> settingOr "blackhole.png" (strOption (long "output" <> short 'o' <> metavar "FILE" <> action "file" <> help "File to write: .png, .jpg, .tif, .hdr or .exr (default: blackhole.png)"))
    <*> codingOptions
    <*> threadsOption
    <*> reporting

-- | A part of a picture, @I\/N@.
tilePart :: ReadM Shard
tilePart = eitherReader $ \text ->
  maybe (Left ("'" ++ text ++ "' is not I/N with I from 1 to N")) Right (parseShard text)

tileExtension :: String
tileExtension = ".tile"

-- | The header of a tile of a scene, given lines that must be equal in all tiles of a
-- picture: the program's name and version, and those of the sky.
tileHeader :: [String] -> Shard -> Scene -> TileHeader
tileHeader origin part scene =
  TileHeader part (width, height) . Lazy.toStrict . Builder.toLazyByteString . Builder.stringUtf8 $
    printScene origin scene
  where
    Picture width height = scenePicture scene

-- | The problems of a part for a picture.
tileProblems :: Shard -> Picture -> [Problem]
tileProblems part (Picture _ height) =
  [Problem "--tile" (renderShard part) ("a part of this picture, which has only " ++ show height ++ " rows") | shardCount part > height]

-- | The problems of a tile file's name.
tileNameProblems :: FilePath -> [Problem]
tileNameProblems output =
  [ Problem "--output" ("'" ++ output ++ "'") ("a file name that ends in " ++ tileExtension)
    | map toLower (takeExtension output) /= tileExtension
  ]

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
        Left refusal -> Left (path ++ ": cannot be read: " ++ ioeGetErrorString (refusal :: IOException))
        Right (Left reason) -> Left (path ++ ": " ++ reason)
        Right (Right tile) -> Right tile
    damage tile = do
      intact <- try (tileIntact tile) :: IO (Either IOException Bool)
      pure [tileFilePath tile ++ ": damaged; render this tile again" | intact /= Right True]
    sceneOf tile =
      resolveRequest (Request Nothing (Just (tileFilePath tile, tileScene (tileFileHeader tile))) "." [])
