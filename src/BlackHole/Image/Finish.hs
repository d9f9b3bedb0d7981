-- | From the film of a scene to the bytes of its file.
module BlackHole.Image.Finish
  ( finishFilm,
    pictureLabel,
  )
where

import BlackHole.Image.Bytes (strict)
import BlackHole.Image.Coding
import BlackHole.Image.File
import BlackHole.Image.Label
import BlackHole.Render.Bloom
import BlackHole.Render.Film
import BlackHole.Render.Layer
import BlackHole.Render.Workers (Workers)
import BlackHole.Scene.File.SceneFile (printScene)
import BlackHole.Scene.Scene
import Control.Monad (when)
import qualified Data.ByteString.Builder as Builder
import qualified Data.ByteString.Lazy as Lazy
import System.Mem (performMajorGC)

-- | @finishFilm workers software format coding scene layers film@: bloom, and then
-- what 'encodeFile' does, with the program's name and version and the scene as the
-- label. The bytes are the same for any number of workers.
finishFilm :: Workers -> String -> Format -> Coding -> Scene -> [Layer] -> Film -> IO (Maybe Lazy.ByteString)
finishFilm crew software format coding scene layers film = do
  bloomed <- bloomFilm crew (sceneBloom scene) film
  -- The film before bloom is the largest thing there is, and of no use any more.
  when (sceneBloom scene > 0) performMajorGC
  encodeFile crew format (pictureLabel software coding scene) development layers bloomed
  where
    development = Development (sceneExposure scene) (sceneToneMap scene) (sceneDither scene)

-- | What a picture of a scene says of itself.
pictureLabel :: String -> Coding -> Scene -> Label
pictureLabel software coding scene =
  Label software coding (strict (Builder.stringUtf8 (printScene [] scene)))
