-- | Environment maps from files.
module Support.Panorama (readPanorama) where

import BlackHole.Image.Panorama
import BlackHole.Trace.EnvironmentMap (EnvironmentMap)

-- | The environment map of a file, or a message.
readPanorama :: FilePath -> IO (Either String EnvironmentMap)
readPanorama file = readPanoramaBytes file >>= either (pure . Left) decodePanorama
