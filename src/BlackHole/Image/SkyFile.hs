-- | The picture of a scene's sky, from its file.
module BlackHole.Image.SkyFile
  ( SkyFile (..),
    loadSky,
    skyFault,
    skyLines,
  )
where

import BlackHole.Image.Digest
import BlackHole.Image.Panorama
import BlackHole.Scene.Scene (Scene)
import BlackHole.Trace.EnvironmentMap (EnvironmentMap)
import BlackHole.Trace.Sky (neededPicture)
import qualified Data.ByteString.Lazy as Lazy

-- | A picture of the sky with the fingerprint of its file.
data SkyFile = SkyFile
  { skyFileImage :: !EnvironmentMap,
    skyFileDigest :: !Digest
  }

-- | The picture that a scene needs, 'Nothing' if it needs none, or one line that
-- says what is wrong with its file. Time as for 'readPanorama'.
loadSky :: Scene -> IO (Either String (Maybe SkyFile))
loadSky scene = case neededPicture scene of
  Nothing -> pure (Right Nothing)
  Just file -> do
    contents <- readPanoramaBytes file
    outcome <-
      either
        (pure . Left)
        ( \bytes ->
            fmap
              (fmap (`SkyFile` digestBytes (Lazy.fromStrict bytes)))
              (decodePanorama bytes)
        )
        contents
    pure (either (Left . faultLine file) (Right . Just) outcome)

-- | What is wrong with the file as far as that is known without decoding it.
skyFault :: Scene -> IO (Maybe String)
skyFault scene = case neededPicture scene of
  Nothing -> pure Nothing
  Just file -> fmap (faultLine file) . either Just panoramaFault <$> readPanoramaBytes file

faultLine :: FilePath -> String -> String
faultLine file problem = "the sky " ++ file ++ " " ++ problem

-- | What else than the scene makes a picture what it is: lines that are equal for
-- equal skies.
skyLines :: Maybe SkyFile -> [String]
skyLines = maybe [] (\sky -> ["sky " ++ digestHex (skyFileDigest sky)])
