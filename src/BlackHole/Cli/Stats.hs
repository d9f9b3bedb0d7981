-- | What a rendering took, for @--stats@.
module BlackHole.Cli.Stats
  ( Stats (..),
    statsText,
  )
where

import BlackHole.Cli.Json
import BlackHole.Render.Workers (Workers, workersCount)
import BlackHole.Scene.Camera (Picture (..))
import BlackHole.Scene.File.SceneFile (printScene)
import BlackHole.Scene.Scene
import BlackHole.Trace.Census
import BlackHole.Trace.SkyImage (SkyImage)
import qualified Crypto.Hash.SHA256 as SHA256
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Builder as Builder
import qualified Data.ByteString.Lazy as Lazy
import Numeric (showHex)

-- | Measurements of one rendering.
data Stats = Stats
  { statsVersion :: !String,
    statsScene :: !Scene,
    -- | The picture of the sky, if the scene's is a panorama.
    statsSky :: !(Maybe SkyImage),
    statsWorkers :: !Workers,
    -- | The first row and the number of rows.
    statsRows :: !(Int, Int),
    -- | Seconds from the beginning of tracing to its end.
    statsTrace :: !Double,
    -- | Seconds for bloom, development, coding and writing, which run into each
    -- other: a file is written while its rows are coded.
    statsFinish :: !Double,
    -- | Bytes, where the system tells them.
    statsPeakMemory :: !(Maybe Integer),
    -- | Pixels without finite radiance, and the first of them.
    statsFaults :: !(Int, Maybe (Int, Int))
  }

-- | One JSON object. What the tracer does not count while it renders is estimated
-- from a thousand lines of sight ('census'), in an object @estimates@ of its own,
-- each number with its standard error. The hash is SHA-256 of the whole scene as the
-- program prints it.
statsText :: Stats -> Lazy.ByteString
statsText s =
  Builder.toLazyByteString . Builder.stringUtf8 . renderJson $
    Object
      [ ("version", Text (statsVersion s)),
        ("scene_sha256", Text (hash (printScene [] scene))),
        -- As text: readers of JSON may not hold 64 bits.
        ("seed", Text (show (sceneSeed scene))),
        ("width", Whole width),
        ("height", Whole height),
        ("first_row", Whole (fst (statsRows s))),
        ("rows", Whole rows),
        ("workers", Whole (workersCount (statsWorkers s))),
        ("samples_per_pixel", Whole (sceneSamples scene)),
        ("rays", Whole (round (pixels * raysOfPixel))),
        ("rays_estimated", Truth adaptive),
        ("rays_per_second", if statsTrace s > 0 then Number (pixels * raysOfPixel / statsTrace s) else Null),
        ("seconds", Object [("trace", Number (statsTrace s)), ("develop_and_write", Number (statsFinish s))]),
        ("peak_memory_bytes", maybe Null (Whole . fromInteger) (statsPeakMemory s)),
        ("not_finite_pixels", Whole (fst (statsFaults s))),
        ("first_not_finite_pixel", maybe Null (\(x, y) -> List [Whole x, Whole y]) (snd (statsFaults s))),
        ("estimates", maybe Null estimates found),
        ("error_bounds", maybe Null bounds found)
      ]
  where
    found = census (statsSky s) scene (statsRows s)
    adaptive = mostSamples scene > sceneSamples scene
    raysOfPixel = maybe (fromIntegral (sceneSamples scene)) (\c -> let Mean m _ = censusRays c in m) found
    estimates c =
      Object
        [ ("lines_of_sight", Whole (censusLines c)),
          ("rays", total pixels (censusRays c)),
          ("steps", total (pixels * raysOfPixel) (censusSteps c)),
          ("gas_samples", total (pixels * raysOfPixel) (censusGasSamples c))
        ]
    total factor (Mean mean off) = Object [("total", Number (mean * factor)), ("standard_error", Number (off * factor))]
    bounds c =
      Object
        [ ("against", Text "closed form of the orbit"),
          ("lines_of_sight", Whole (censusLines c)),
          ("greatest_direction_error_radians", Number (censusDirectionError c)),
          ("other_fates", Whole (censusOtherFates c)),
          ("documentation", Text "docs/validation.md")
        ]
    scene = statsScene s
    Picture width height = scenePicture scene
    rows = snd (statsRows s)
    pixels = fromIntegral (width * rows) :: Double
    hash text = concatMap twoDigits (Bytes.unpack (SHA256.hashlazy (Builder.toLazyByteString (Builder.stringUtf8 text))))
    twoDigits b = (if b < 16 then "0" else "") ++ showHex b ""
