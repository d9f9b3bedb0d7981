-- | @blackhole rays@: its options and the file it makes.
module BlackHole.Cli.Rays
  ( RaysOptions (..),
    raysOptions,
    RaysTask (..),
    FigureFormat (..),
    resolveRays,
    raysFile,
  )
where

import BlackHole.Cli.Check
import BlackHole.Cli.Read
import BlackHole.Figure.Raster (rasterise)
import BlackHole.Figure.RayFan
import BlackHole.Figure.Svg (renderSvg)
import BlackHole.Scene.Validate (Problem (..))
import Codec.Picture.Metadata (Keys (..), singleton)
import Codec.Picture.Png (encodePngWithMetadata)
import qualified Data.ByteString.Lazy as Lazy
import Data.Char (toLower)
import Options.Applicative
import System.FilePath (takeExtension)

-- | The options of @blackhole rays@.
data RaysOptions = RaysOptions
  { raysCount :: !Int,
    raysExtent :: !Double,
    raysWidth :: !Int,
    raysOutput :: !FilePath
  }
  deriving (Eq, Show)

-- | Their grammar.
raysOptions :: Parser RaysOptions
raysOptions =
  RaysOptions
    <$> settingOr (fanRays defaultRayFan) (option wholeNumber (long "rays" <> metavar "N" <> help ("Number of rays; from 8 on, four of them wind around the hole (default: " ++ show (fanRays defaultRayFan) ++ ")")))
    <*> settingOr (fanExtent defaultRayFan) (option number (long "extent" <> metavar "R" <> help ("Half of the figure's width in Schwarzschild radii (default: " ++ show (fanExtent defaultRayFan) ++ ")")))
    <*> settingOr (fanWidth defaultRayFan) (option wholeNumber (long "width" <> metavar "PIXELS" <> help ("Width of the figure (default: " ++ show (fanWidth defaultRayFan) ++ ")")))
    <*> settingOr "rays.svg" (strOption (long "output" <> short 'o' <> metavar "FILE" <> help "File to write; .svg or .png decides what it is (default: rays.svg)"))

-- | How the figure is written.
data FigureFormat = Svg | Png
  deriving (Eq, Show, Enum, Bounded)

-- | A figure to draw.
data RaysTask = RaysTask
  { taskFormat :: !FigureFormat,
    taskFan :: !RayFan
  }
  deriving (Eq, Show)

-- | The figure that the options ask for, or everything that is wrong with them
-- (at least one problem).
resolveRays :: RaysOptions -> Either [Problem] RaysTask
resolveRays (RaysOptions count extent width output) = case (format, problems) of
  (Just f, []) -> Right (RaysTask f (RayFan count extent width))
  (Just _, _) -> Left problems
  (Nothing, _) -> Left (problems ++ [Problem "--output" ("'" ++ output ++ "'") "a file name that ends in .svg or .png"])
  where
    problems =
      checkWhole "--rays" 1 1001 "" count
        ++ checkNumber "--extent" (\r -> r >= 4 && r <= 1000) "a length from 4 to 1000 (Schwarzschild radii)" extent
        ++ checkWhole "--width" 200 4096 " (pixels)" width
    format = case map toLower (takeExtension output) of
      ".svg" -> Just Svg
      ".png" -> Just Png
      _ -> Nothing

-- | The file's bytes; the first argument is the program's name for the file's
-- record of its origin. Without a time stamp.
raysFile :: String -> RaysTask -> Lazy.ByteString
raysFile software (RaysTask format fan) = case format of
  Svg -> renderSvg figure
  Png -> encodePngWithMetadata (singleton Software software) (rasterise figure)
  where
    figure = rayFanFigure fan
