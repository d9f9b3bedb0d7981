{-# LANGUAGE TupleSections #-}

-- | Tiles of one huge picture: what @render --tile@ writes and @blackhole join@
-- puts together.
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
    joinThreads :: !(Maybe Int)
  }
  deriving (Eq, Show)

-- | Their parser.
joinOptions :: Parser JoinOptions
joinOptions =
  JoinOptions
    <$> some (strArgument (metavar "TILE..." <> help "Tile files, in any order"))
    <*> settingOr "blackhole.png" (strOption (long "output" <> short 'o' <> metavar "FILE" <> help "File to write: .png, .jpg, .tif, .hdr or .exr (default: blackhole.png)"))
    <*> codingOptions
    <*> setting (option wholeNumber (long "threads" <> metavar "N" <> help "Workers (default: one per core)"))

-- | A part of a picture, @I\/N@.
tilePart :: ReadM Shard
tilePart = eitherReader $ \text ->
  maybe (Left ("'" ++ text ++ "' is not I/N with I from 1 to N")) Right (parseShard text)

tileExtension :: String
tileExtension = ".tile"

-- | What a tile of a scene says of itself, given lines that must be the same for
-- tiles to belong together: the program's name and version, and those of the sky.
tileHeader :: [String] -> Shard -> Scene -> TileHeader
tileHeader origin part scene =
  TileHeader part (width, height) . Lazy.toStrict . Builder.toLazyByteString . Builder.stringUtf8 $
    printScene origin scene
  where
    Picture width height = scenePicture scene

-- | What is wrong with such a part of a picture.
tileProblems :: Shard -> Picture -> [Problem]
tileProblems part (Picture _ height) =
  [Problem "--tile" (renderShard part) ("a part of a picture of " ++ show height ++ " rows") | shardCount part > height]

-- | What is wrong with a tile file's name.
tileNameProblems :: FilePath -> [Problem]
tileNameProblems output =
  [ Problem "--output" ("'" ++ output ++ "'") ("a file name that ends in " ++ tileExtension)
    | map toLower (takeExtension output) /= tileExtension
  ]

-- | The scene of some tile files and the files themselves, or a line for
-- everything for which they can't be joined. Reads all of them once.
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
        Left refusal -> Left (path ++ ": can't be read: " ++ ioeGetErrorString (refusal :: IOException))
        Right (Left reason) -> Left (path ++ ": " ++ reason)
        Right (Right tile) -> Right tile
    damage tile = do
      intact <- try (tileIntact tile) :: IO (Either IOException Bool)
      pure [tileFilePath tile ++ ": damaged; render this tile again" | intact /= Right True]
    sceneOf tile =
      resolveRequest (Request Nothing (Just (tileFilePath tile, tileScene (tileFileHeader tile))) "." [])
