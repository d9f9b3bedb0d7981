-- | Statistics of a rendering, for @--stats@.
module BlackHole.Cli.Stats
  ( Stats (..),
    statsJson,
    joinStatsJson,
  )
where

import BlackHole.Cli.Json
import BlackHole.Render.Workers (Workers, workersCount)
import BlackHole.Scene.Camera (Picture (..))
import BlackHole.Scene.File.SceneFile (printScene)
import BlackHole.Scene.Scene
import BlackHole.Trace.EnvironmentMap (EnvironmentMap)
import BlackHole.Trace.RenderStatistics
import qualified Crypto.Hash.SHA256 as SHA256
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Builder as Builder
import Numeric (showHex)

-- | Measurements of one rendering.
data Stats = Stats
  { statsVersion :: !String,
    statsScene :: !Scene,
    -- | The environment map, if the scene has one.
    statsSky :: !(Maybe EnvironmentMap),
    statsWorkers :: !Workers,
    -- | The first row and the number of rows.
    statsRows :: !(Int, Int),
    -- | Seconds of tracing.
    statsTrace :: !Double,
    -- | Seconds of bloom, development, encoding and writing, which overlap: a file
    -- is written while its rows are encoded.
    statsFinish :: !Double,
    -- | In bytes, if the system reports it.
    statsPeakMemory :: !(Maybe Integer),
    -- | Pixels without finite radiance, and the first of them.
    statsFaults :: !(Int, Maybe (Int, Int))
  }

-- | The statistics as one JSON object. The object @estimates@ has the numbers that the
-- tracer does not count, estimated from a thousand lines of sight ('renderStatistics'), with
-- their standard errors. The hash is the SHA-256 of the complete scene as
-- 'printScene' prints it.
statsJson :: Stats -> Json
statsJson s =
  Object
    [ ("version", Text (statsVersion s)),
      ("scene_sha256", Text (hash (printScene [] scene))),
      -- As text, because many readers of JSON cannot represent 64 bits.
      ("seed", Text (show (sceneSeed scene))),
      ("width", Whole width),
      ("height", Whole height),
      ("first_row", Whole (fst (statsRows s))),
      ("rows", Whole rows),
      ("workers", Whole (workersCount (statsWorkers s))),
      ("samples_per_pixel", Whole (sceneSamples scene)),
      ("rays", Whole (round (pixels * raysOfPixel))),
      ("rays_estimated", Truth adaptive),
      ( "rays_per_second",
        if statsTrace s > 0
          then Number (pixels * raysOfPixel / statsTrace s)
          else Null
      ),
      ( "seconds",
        Object [("trace", Number (statsTrace s)), ("develop_and_write", Number (statsFinish s))]
      ),
      ("peak_memory_bytes", maybe Null (Whole . fromInteger) (statsPeakMemory s)),
      ("not_finite_pixels", Whole (fst (statsFaults s))),
      ( "first_not_finite_pixel",
        maybe Null (\(x, y) -> List [Whole x, Whole y]) (snd (statsFaults s))
      ),
      ("estimates", maybe Null estimates found),
      ("error_bounds", maybe Null bounds found)
    ]
  where
    found = renderStatistics (statsSky s) scene (statsRows s)
    adaptive = isAdaptive scene
    raysOfPixel =
      maybe
        (fromIntegral (sceneSamples scene))
        (\c -> let Mean m _ = statisticsRays c in m)
        found
    estimates c =
      Object
        [ ("lines_of_sight", Whole (statisticsLines c)),
          ("rays", total pixels (statisticsRays c)),
          ("steps", total (pixels * raysOfPixel) (statisticsSteps c)),
          ("gas_samples", total (pixels * raysOfPixel) (statisticsGasSamples c))
        ]
    total factor (Mean mean off) =
      Object
        [("total", Number (mean * factor)), ("standard_error", Number (off * factor))]
    bounds c =
      Object
        [ ("against", Text "closed form of the orbit"),
          ("lines_of_sight", Whole (statisticsLines c)),
          ("greatest_direction_error_radians", Number (statisticsDirectionError c)),
          ("other_fates", Whole (statisticsOtherFates c))
        ]
    scene = statsScene s
    Picture width height = scenePicture scene
    rows = snd (statsRows s)
    pixels = fromIntegral (width * rows) :: Double
    hash text =
      concatMap
        twoDigits
        (Bytes.unpack (SHA256.hashlazy (Builder.toLazyByteString (Builder.stringUtf8 text))))
    twoDigits b = (if b < 16 then "0" else "") ++ showHex b ""

-- | The statistics of @blackhole join@ as one JSON object, given the program's version,
-- the scene, the number of tiles, the workers, the seconds, and the peak of the memory in
-- bytes.
joinStatsJson :: String -> Scene -> Int -> Workers -> Double -> Maybe Integer -> Json
joinStatsJson version scene tiles workers seconds memory =
  Object
    [ ("version", Text version),
      ("width", Whole width),
      ("height", Whole height),
      ("tiles", Whole tiles),
      ("workers", Whole (workersCount workers)),
      ("seconds", Number seconds),
      ("peak_memory_bytes", maybe Null (Whole . fromInteger) memory)
    ]
  where
    Picture width height = scenePicture scene
