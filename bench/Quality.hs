-- | The error of the default picture against a picture of 256 rays per pixel, by kind of
-- pixel and with the rays and the processor time that it takes.
module Quality (printQuality) where

import BlackHole.Light.Display
import BlackHole.Light.Dither (Dither (..))
import BlackHole.Render.Exposed
import BlackHole.Render.Film
import BlackHole.Render.PixelArray (toPixelVector)
import BlackHole.Render.Workers
import BlackHole.Scene.Camera (Picture (..))
import BlackHole.Scene.Preset
import BlackHole.Scene.Scene
import Control.Monad (forM_)
import qualified Data.Vector.Storable as Vector
import System.CPUTime (getCPUTime)
import Text.Printf (printf)

-- | Renders the default scene with several settings of sampling and prints the table.
-- Takes a few minutes.
printQuality :: IO ()
printQuality = do
  (reference, _, time) <- render defaultScene {sceneSamples = 256, sceneNoise = 0}
  let kinds = kindsOf reference
  printf "default, %d x %d, error in codes against 256 rays per pixel (%.0f s)\n" width height time
  printf "%-24s %8s %7s" "sampling" "rays/px" "CPU s"
  forM_ kinds $ \(name, part) ->
    printf " %9s" (printf "%s %.0f%%" name (100 * share part) :: String)
  printf " %9s\n" "8x8 means"
  forM_ samplings $ \(name, change) -> do
    (codes, rays, seconds) <- render (change defaultScene)
    printf "%-24s %8.2f %7.2f" (name :: String) rays seconds
    forM_ kinds $ \(_, part) ->
      printf " %9.2f" (rootMeanSquare [e | (True, e) <- zip part (errors codes reference)])
    printf " %9.2f\n" (rootMeanSquare (blockErrors codes reference))
  where
    share part = fromIntegral (length (filter id part)) / fromIntegral (length part) :: Double

samplings :: [(String, Scene -> Scene)]
samplings =
  [(printf "--noise %.3f" t, \s -> s {sceneNoise = t}) | t <- [0.12, 0.06, 0.03, 0.015]]
    ++ [ ("--noise 0 --samples " ++ show n, \s -> s {sceneSamples = n, sceneNoise = 0})
         | n <- [1, 4, 16]
       ]

width, height :: Int
width = 960
height = 540

-- | Codes of all channels, rays per pixel, and seconds of processor time.
render :: Scene -> IO (Vector.Vector Double, Double, Double)
render scene = do
  start <- getCPUTime
  exposed <- exposeFilm Nothing oneWorker (const (pure ())) small (0, height)
  case exposed of
    Nothing -> fail "the default scene cannot be traced"
    Just film -> do
      picture <- developFilm oneWorker plain (exposedLight film)
      let codes = Vector.map fromIntegral (toPixelVector picture)
      end <- codes `seq` getCPUTime
      pure (codes, rays film, fromIntegral (end - start) / 1e12)
  where
    small = scene {scenePicture = Picture width height}
    plain = (sceneDevelopment small) {developmentDither = NoDither}
    rays film = maybe (fromIntegral (sceneSamples scene)) mean (exposedCounts film)
    mean counts =
      let numbers = toPixelVector counts
       in realToFrac (Vector.sum numbers) / fromIntegral (Vector.length numbers)

-- | The kinds of pixels: all; gas without edges; edges, where the codes of neighbours in
-- the reference differ by more than 30; and the sky.
kindsOf :: Vector.Vector Double -> [(String, [Bool])]
kindsOf codes =
  [ ("all", map (const True) gas),
    ("gas", zipWith (\g e -> g && not e) gas edge),
    ("edges", edge),
    ("sky", zipWith (\g e -> not (g || e)) gas edge)
  ]
  where
    places = [(x, y) | y <- [0 .. height - 1], x <- [0 .. width - 1]]
    gas = [grey x y > 25 | (x, y) <- places]
    edge = [maximum near - minimum near > 30 | place' <- places, let near = around place']
    around (x, y) = [grey (x + i) (y + j) | i <- [-1, 0, 1], j <- [-1, 0, 1]]
    grey x y = sum [codes Vector.! (3 * place x y + k) | k <- [0 .. 2]] / 3
    place x y = inside height y * width + inside width x
    inside n v = max 0 (min (n - 1) v)

-- | The root mean square difference of each pixel's channels.
errors :: Vector.Vector Double -> Vector.Vector Double -> [Double]
errors codes reference =
  [rootMeanSquare [difference (3 * i + k) | k <- [0 .. 2]] | i <- [0 .. width * height - 1]]
  where
    difference i = codes Vector.! i - reference Vector.! i

-- | The mean difference of blocks of 8 × 8 pixels: noise nearly cancels in it, structure
-- does not.
blockErrors :: Vector.Vector Double -> Vector.Vector Double -> [Double]
blockErrors codes reference =
  [ sum (map (differenceIn (8 * column) (8 * row)) [0 .. 191]) / 192
    | row <- [0 .. height `quot` 8 - 1],
      column <- [0 .. width `quot` 8 - 1]
  ]
  where
    differenceIn x y n =
      let i = 3 * ((y + n `quot` 24) * width + x) + n `rem` 24
       in codes Vector.! i - reference Vector.! i

rootMeanSquare :: [Double] -> Double
rootMeanSquare values = sqrt (sum (map (^ (2 :: Int)) values) / fromIntegral (length values))
