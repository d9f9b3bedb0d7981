-- | From film to file at 1920 × 1080 on one core: bloom, development and encoding.
module FilmBench (benchmarks) where

import BlackHole.Image.Coding
import BlackHole.Image.Destination (inMemory)
import BlackHole.Image.File
import BlackHole.Image.Metadata
import BlackHole.Light.Display
import BlackHole.Light.Dither
import BlackHole.Render.Bloom
import BlackHole.Render.Exposed
import BlackHole.Render.Layer (noLayers)
import BlackHole.Render.PixelArray
import BlackHole.Render.PixelShape
import BlackHole.Render.Workers
import Control.DeepSeq (NFData (..))
import Control.Exception (throwIO)
import Criterion.Main
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Lazy as Lazy
import qualified Data.Vector.Storable as Vector

-- | A film that is already in memory.
newtype Ready = Ready Film

instance NFData Ready where
  rnf (Ready film) = toPixelVector film `seq` ()

benchmarks :: Benchmark
benchmarks =
  env (Ready <$> gradient) $ \ready ->
    bgroup
      "film of 1920 × 1080"
      [ bench "bloom" (nfIO (Ready <$> bloomFilm oneWorker 0.1 (filmOf ready))),
        bench
          "development"
          ( whnfIO
              ( developFilm
                  oneWorker
                  (Development (Exposure 0) ToneFilm noGrain BlueNoise)
                  (filmOf ready)
              )
          ),
        file ready Png 8,
        file ready Png 16,
        file ready Jpeg 8,
        file ready Tiff 16,
        file ready Hdr 8,
        file ready Exr 16,
        file ready Exr 32
      ]
  where
    filmOf (Ready film) = film
    file ready format bits =
      bench ("development and " ++ show format ++ " in " ++ show bits ++ " bits") . whnfIO $
        traverse
          (\encode -> Lazy.length . snd <$> inMemory (encode (pure . filmRows (filmOf ready))))
          ( fileEncoder
              oneWorker
              format
              (Metadata "bench" (Coding (Just bits) Nothing) Bytes.empty)
              (Development (Exposure 0) ToneFilm noGrain BlueNoise)
              noLayers
              (1920, 1080)
          )

-- | A third black, the rest smooth with some texture, like a rendering.
gradient :: IO Film
gradient = case pixelShape width height 3 >>= \shape ->
  fromPixelVector shape (Vector.generate (3 * width * height) amount) of
  Just film -> pure film
  Nothing -> throwIO (userError "no picture")
  where
    (width, height) = (1920, 1080)
    amount i =
      let (y, x) = (i `quot` 3) `quotRem` width
          u = fromIntegral x / fromIntegral width
          v = fromIntegral y / fromIntegral height
       in max 0 (2 * v - 0.6)
            * (1 + 0.2 * sin (40 * u + 9 * sin (30 * v))) / fromIntegral (1 + i `rem` 3) ::
            Float
