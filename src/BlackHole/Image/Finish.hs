-- | From the film of a scene to the bytes of its file.
module BlackHole.Image.Finish
  ( finishFilm,
    finishBands,
    pictureLabel,
  )
where

import BlackHole.Image.Bytes (strict)
import BlackHole.Image.Coding
import BlackHole.Image.File
import BlackHole.Image.Label
import BlackHole.Image.Png
import BlackHole.Render.Bloom
import BlackHole.Render.Film
import BlackHole.Render.Layer
import BlackHole.Render.PixelShape (pixelShape)
import BlackHole.Render.Workers (Workers)
import BlackHole.Scene.Camera (Picture (..))
import BlackHole.Scene.File.SceneFile (printScene)
import BlackHole.Scene.Scene
import Control.Monad (unless, when)
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Builder as Builder
import qualified Data.ByteString.Lazy as Lazy
import System.IO (Handle)
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

-- | What 'finishFilm' does for a picture that need not be in memory as a whole:
-- @rowsOf (first, count)@ gives bands of its light, and the action writes the file, the
-- same bytes. It throws a user error when a band is missing. 'Nothing' where the
-- format, or bloom, takes all of the picture at once.
finishBands :: Workers -> String -> Format -> Coding -> Scene -> ((Int, Int) -> IO (Maybe Film)) -> Maybe (Handle -> IO ())
finishBands crew software format coding scene rowsOf = case (format, pixelShape width height 3) of
  (Png, Just shape) | sceneBloom scene == 0 -> Just $ \handle -> do
    complete <- encodePngBands crew (pictureLabel software coding scene) shape (bits `quot` 8) codes (Bytes.hPut handle)
    unless complete $ ioError (userError "a part of the picture's light cannot be read any more")
  _ -> Nothing
  where
    Picture width height = scenePicture scene
    bits = codingBitsOf format coding
    codes range = rowsOf range >>= traverse (developed (fst range))
    developed first film
      | bits == 16 = Codes16 <$> developFilmFinely crew (sceneExposure scene) (sceneToneMap scene) film
      | otherwise = Codes8 <$> developRows first crew (sceneExposure scene) (sceneToneMap scene) (sceneDither scene) film

-- | What a picture of a scene says of itself.
pictureLabel :: String -> Coding -> Scene -> Label
pictureLabel software coding scene =
  Label software coding (strict (Builder.stringUtf8 (printScene [] scene)))
