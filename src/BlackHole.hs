-- | Pictures of a black hole, from a scene to a file.
--
-- A scene starts as a preset or a scene file. 'change' replaces settings by the names
-- that scene files use for them; 'settingNames' lists these names, and @blackhole scene
-- show default@ prints each setting with its meaning and unit. 'Exposed' is
-- the linear light of a scene's pixels. A picture is that light, developed and encoded.
--
-- This module is the library's stable interface: its exports keep their meaning between
-- minor versions. All other modules are exposed as well, for callers who want a part of
-- the physics, and because the program and the tests are separate components that need
-- them. They may change with any version.
--
-- Link programs that render with @-threaded@ and @\"-with-rtsopts=-qg -A4m\"@: several
-- threads that collect garbage would wait for each other in a spin lock.
module BlackHole
  ( -- * Scenes
    Scene,
    defaultScene,
    presetNames,
    findPreset,
    loadScene,
    change,
    settingNames,
    printScene,

    -- * Light
    Exposed,
    renderFilm,
    filmSize,
    filmRadiance,
    Radiance (..),

    -- * Files
    renderToFile,
    writeFilm,
    software,
  )
where

import BlackHole.Image.AtomicFile (renderWriteProblem, writeFileAtomically)
import BlackHole.Image.Coding (Format, defaultCoding, formatExtensions, formatOf)
import BlackHole.Image.Metadata (software)
import BlackHole.Image.SceneSource (readSceneFile)
import BlackHole.Image.SkyFile (SkyFile (..), loadSky)
import BlackHole.Image.Write (pictureBytes)
import BlackHole.Light.Radiance (Radiance (..))
import BlackHole.Render.Exposed (Exposed (..), allRows)
import qualified BlackHole.Render.Exposed as Film
import BlackHole.Render.Film (exposeFilm)
import BlackHole.Render.PixelArray (pixelArrayShape)
import BlackHole.Render.PixelShape (shapeHeight, shapeWidth)
import BlackHole.Render.Workers (Workers, defaultWorkers, withWorkers)
import BlackHole.Scene.Field.Field (Field (..))
import BlackHole.Scene.Field.Kind (readValue)
import BlackHole.Scene.Field.Table (currentPath, findField, sceneFields)
import qualified BlackHole.Scene.File.SceneFile as SceneFile
import BlackHole.Scene.Idle
import BlackHole.Scene.Preset (defaultScene, findPreset, presetNames)
import BlackHole.Scene.Problem (suggestion)
import BlackHole.Scene.Resolve (Request (..), resolveRequest)
import BlackHole.Scene.Scene (Scene (..))
import BlackHole.Scene.Setting (Setting (..), applySettings)
import BlackHole.Scene.Validate (renderProblem, validateScene)
import Data.Either (partitionEithers)
import Data.List (intercalate)
import Data.List.NonEmpty (NonEmpty (..))
import System.FilePath (takeDirectory)

-- | Reads a scene file, and the files it names. 'Left' holds one line per problem with
-- the file, at least one.
loadScene :: FilePath -> IO (Either [String] Scene)
loadScene file = do
  contents <- readSceneFile file
  pure $ do
    bytes <- either (Left . pure) Right contents
    resolveRequest (Request Nothing (Just (file, bytes)) (takeDirectory file) [])

-- | A scene with changed settings: pairs of a name and a value, written as in a scene
-- file, such as @(\"camera.inclination\", \"75\")@. The height follows the width unless
-- it is set as well. If a name occurs twice, the last value counts. 'Left' holds one
-- line for every name that does not exist, every value out of range, and every setting
-- without effect in this scene.
change :: [(String, String)] -> Scene -> Either [String] Scene
change pairs scene = case partitionEithers (map setting pairs) of
  ([], settings) -> case map renderProblem (validateScene changed)
    ++ map (renderIdle InFile) (idleSettings scene (latest settings)) of
    [] -> Right changed
    problems -> Left problems
    where
      changed = applySettings settings scene
  (problems, _) -> Left problems
  where
    setting (name, text) = case findField (currentPath name) of
      Nothing -> Left (name ++ ": there is no such setting" ++ suggestion name settingNames)
      Just field -> case readValue (fieldKind field) text of
        Left expected -> Left (name ++ ": '" ++ text ++ "' is not " ++ expected)
        Right value -> Right (Setting (fieldPath field) value)
    latest = foldr keep []
    keep s later = if settingPath s `elem` map settingPath later then later else s : later

-- | The names of all settings, in the order of a printed scene.
settingNames :: [String]
settingNames = map fieldPath sceneFields

-- | The complete scene as a scene file that explains every setting.
printScene :: Scene -> String
printScene = SceneFile.printScene []

-- | Traces a scene's light on all processors, after reading the image file of its sky
-- if it has one. The first argument is called with the number of finished rows. The
-- result does not depend on the number of processors. 'Left' holds one line per problem
-- with the scene. A ray takes from 0.1 µs through empty space to several microseconds
-- through the gas.
renderFilm :: (Int -> IO ()) -> Scene -> IO (Either [String] Exposed)
renderFilm progress scene = case map renderProblem (validateScene scene) of
  [] -> loadSky scene >>= either (pure . Left . pure) (withAllWorkers . under)
  problems -> pure (Left problems)
  where
    under sky workers =
      maybe (Left ["this scene can't be traced"]) Right
        <$> exposeFilm (skyFileImage <$> sky) workers progress scene (allRows (scenePicture scene))

-- | The width and height of a film in pixels.
filmSize :: Exposed -> (Int, Int)
filmSize exposed = (shapeWidth shape, shapeHeight shape)
  where
    shape = pixelArrayShape (exposedLight exposed)

-- | @filmRadiance film column row@ is the radiance of a pixel, counted from the top
-- left corner; 'Nothing' outside the film.
filmRadiance :: Exposed -> Int -> Int -> Maybe Radiance
filmRadiance = Film.filmRadiance . exposedLight

-- | Develops a film as its scene prescribes, and writes it in the format of the file's
-- extension. The file appears, or replaces an earlier one, only when it is complete. It
-- stores the scene. 'Left' holds one line with the reason for a failure.
writeFilm :: FilePath -> Scene -> Exposed -> IO (Either [String] ())
writeFilm file scene exposed = inFormat file $ \format -> do
  bytes <-
    withAllWorkers
      (\workers -> pictureBytes workers software format defaultCoding (scene :| []) exposed)
  case bytes of
    Nothing -> pure (Left [file ++ ": this format has no room for so large a picture"])
    Just content ->
      either (Left . pure . renderWriteProblem) Right <$> writeFileAtomically file content

-- | 'renderFilm' followed by 'writeFilm'. Writes the same bytes as @blackhole render@.
renderToFile :: FilePath -> Scene -> IO (Either [String] ())
renderToFile file scene = inFormat file . const $ do
  film <- renderFilm (const (pure ())) scene
  either (pure . Left) (writeFilm file scene) film

inFormat :: FilePath -> (Format -> IO (Either [String] a)) -> IO (Either [String] a)
inFormat file act = case formatOf file of
  Nothing ->
    pure
      ( Left
          [file ++ ": not a file name that ends in " ++ intercalate ", " (map fst formatExtensions)]
      )
  Just format -> act format

withAllWorkers :: (Workers -> IO a) -> IO a
withAllWorkers action = do
  workers <- defaultWorkers
  withWorkers workers (action workers)
