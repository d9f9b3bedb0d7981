-- | @blackhole rays@: its options and the contents of its file.
module BlackHole.Cli.Rays
  ( RaysOptions (..),
    raysOptions,
    RaysTask (..),
    FigureFormat (..),
    resolveRays,
    raysFile,
    rays,
  )
where

import BlackHole.Cli.Check
import BlackHole.Cli.Console (succeeded)
import BlackHole.Cli.ExitStatus
import BlackHole.Cli.Json (showDouble)
import BlackHole.Cli.Read
import BlackHole.Figure.Raster (rasterise)
import BlackHole.Figure.RayFan
import BlackHole.Figure.RayFanFigure
import BlackHole.Figure.Svg (renderSvg)
import BlackHole.Image.AtomicFile
import BlackHole.Image.Metadata (software)
import BlackHole.Scene.Validate (Problem (..))
import BlackHole.Spacetime.Kerr.Landmarks (noSpin, spin)
import Codec.Picture.Metadata (Keys (..), singleton)
import Codec.Picture.Png (encodePngWithMetadata)
import Control.Monad (unless)
import qualified Data.ByteString.Lazy as Lazy
import Data.Char (toLower)
import Data.Maybe (fromMaybe)
import GHC.Clock (getMonotonicTime)
import Options.Applicative
import System.FilePath (takeExtension)

-- | The options of @blackhole rays@.
data RaysOptions = RaysOptions
  { raysCount :: !Int,
    raysExtent :: !Double,
    raysWidth :: !Int,
    raysSpin :: !Double,
    raysOutput :: !FilePath,
    raysQuiet :: !Bool
  }
  deriving (Eq, Show)

-- | Their parser.
raysOptions :: Parser RaysOptions
raysOptions =
  RaysOptions
    <$> settingOr
      (fanRays defaultRayFan)
      ( option
          wholeNumber
          ( long "rays" <> metavar "N"
              <> help
                ( "Number of rays, 1 to 1001; with 8 or more, four of them wind around the hole \
                  \(default: "
                    ++ show (fanRays defaultRayFan)
                    ++ ")"
                )
          )
      )
    <*> settingOr
      (fanExtent defaultRayFan)
      ( option
          number
          ( long "extent" <> metavar "R"
              <> help
                ( "Half the width of the figure in Schwarzschild radii (default: "
                    ++ showDouble (fanExtent defaultRayFan)
                    ++ ")"
                )
          )
      )
    <*> settingOr
      (fanWidth defaultRayFan)
      ( option
          wholeNumber
          ( long "width" <> metavar "PIXELS"
              <> help ("Width of the figure (default: " ++ show (fanWidth defaultRayFan) ++ ")")
          )
      )
    <*> settingOr
      0
      ( option
          number
          ( long "spin" <> metavar "A"
              <> help
                "Spin of the hole, above -1 and below 1: the rays lie in the equatorial \
                \plane, and a positive spin turns anticlockwise (default: 0)"
          )
      )
    <*> settingOr
      "rays.svg"
      ( strOption
          ( long "output" <> short 'o' <> metavar "FILE" <> action "file"
              <> help "File to write, .svg or .png (default: rays.svg)"
          )
      )
    <*> toggle (long "quiet" <> short 'q' <> help "Do not report success")

-- | The file's format.
data FigureFormat = Svg | Png
  deriving (Eq, Show, Enum, Bounded)

-- | A figure to draw.
data RaysTask = RaysTask
  { taskFormat :: !FigureFormat,
    taskFan :: !RayFan
  }
  deriving (Eq, Show)

-- | The figure that the options ask for, or all their mistakes (at least one).
resolveRays :: RaysOptions -> Either [Problem] RaysTask
resolveRays (RaysOptions count extent width a output _) = case (format, problems) of
  (Just f, []) -> Right (RaysTask f (RayFan count extent width (fromMaybe noSpin (spin a))))
  (Just _, _) -> Left problems
  (Nothing, _) ->
    Left
      ( problems
          ++ [Problem "--output" ("'" ++ output ++ "'") "a file name that ends in .svg or .png"]
      )
  where
    problems =
      checkWhole "--rays" 1 1001 "" count
        ++ checkNumber
          "--extent"
          (\r -> r >= least && r <= 1000)
          ("a length from " ++ showDouble least ++ " to 1000 (Schwarzschild radii)")
          extent
        ++ checkNumber "--spin" ((< 1) . abs) "a spin above -1 and below 1" a
        ++ checkWhole "--width" 200 4096 " (pixels)" width
    -- The impact parameter of light on a retrograde orbit can be 3.5.
    least = if a == 0 then 4 else 5
    format = case map toLower (takeExtension output) of
      ".svg" -> Just Svg
      ".png" -> Just Png
      _ -> Nothing

-- | The file's bytes, with the program's name and version and without a time stamp.
raysFile :: RaysTask -> Lazy.ByteString
raysFile (RaysTask format fan) = case format of
  Svg -> renderSvg figure
  Png -> encodePngWithMetadata (singleton Software software) (rasterise figure)
  where
    figure = rayFanFigure fan

-- | Draws the figure that the options ask for.
rays :: RaysOptions -> IO ExitStatus
rays options = case resolveRays options of
  Left problems -> complainAll UsageError problems
  Right task -> do
    start <- getMonotonicTime
    written <- writeFileAtomically (raysOutput options) (raysFile task)
    case written of
      Left problem -> complain CannotWrite ("--output: " ++ renderWriteProblem problem)
      Right () ->
        Done
          <$ unless
            (raysQuiet options)
            (succeeded start (raysOutput options) (show (raysCount options) ++ " rays"))
