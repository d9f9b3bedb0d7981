-- | Draws the number of rays of each pixel of the default picture, as a PNG file: black for
-- none, and a step of grey for each doubling.
module Main (main) where

import BlackHole.Render.Exposed (Exposed (..))
import BlackHole.Render.Film (exposeFilm)
import BlackHole.Render.PixelArray (toPixelVector)
import BlackHole.Render.Workers (oneWorker)
import BlackHole.Scene.Camera (Picture (..))
import BlackHole.Scene.Preset (defaultScene)
import BlackHole.Scene.Scene (Scene (..), mostSamples)
import Codec.Picture (Pixel8, generateImage, writePng)
import qualified Data.Vector.Storable as Vector
import System.Environment (getArgs)
import System.Exit (die)
import Text.Read (readMaybe)

main :: IO ()
main = do
  arguments <- getArgs
  case arguments of
    [across, down, file]
      | Just width <- readMaybe across,
        Just height <- readMaybe down -> do
        let scene = defaultScene {scenePicture = Picture width height}
        exposed <- exposeFilm Nothing oneWorker (const (pure ())) scene (0, height)
        case toPixelVector <$> (exposed >>= exposedCounts) of
          Just counts ->
            let at x y = shade scene (counts Vector.! (y * width + x))
             in writePng file (generateImage at width height)
          Nothing -> die "SamplingMap: no rays are counted"
    _ -> die "usage: SamplingMap WIDTH HEIGHT FILE"

shade :: Scene -> Float -> Pixel8
shade scene count
  | count < 1 = 0
  | otherwise = round (255 * (1 + logBase 2 count) / (1 + logBase 2 most))
  where
    most = fromIntegral (mostSamples scene)
