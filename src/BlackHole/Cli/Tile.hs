-- | Tiles of one large picture: the options and the header of @render --tile@.
module BlackHole.Cli.Tile
  ( tilePart,
    tileExtension,
    tileHeader,
    tileProblems,
    tileNameProblems,
  )
where

import BlackHole.Image.TileFile
import BlackHole.Render.Shard
import BlackHole.Scene.Camera (Picture (..))
import BlackHole.Scene.File.SceneFile (printScene)
import BlackHole.Scene.Problem
import BlackHole.Scene.Scene
import qualified Data.ByteString.Builder as Builder
import qualified Data.ByteString.Lazy as Lazy
import Data.Char (toLower)
import Options.Applicative
import System.FilePath (takeExtension)

-- | A part of a picture, @I\/N@.
tilePart :: ReadM Shard
tilePart = eitherReader $ \text ->
  maybe (Left ("'" ++ text ++ "' is not I/N with I from 1 to N")) Right (parseShard text)

-- | The extension of tile files.
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
  [ Problem
      "--tile"
      (renderShard part)
      ("a part of this picture, which has only " ++ show height ++ " rows")
    | shardCount part > height
  ]

-- | The problems of a tile file's name.
tileNameProblems :: FilePath -> [Problem]
tileNameProblems output =
  [ Problem "--output" ("'" ++ output ++ "'") ("a file name that ends in " ++ tileExtension)
    | map toLower (takeExtension output) /= tileExtension
  ]
