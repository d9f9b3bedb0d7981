-- | Pictures of a black hole, from a scene to a file.
--
-- A scene is a preset, or a scene file, with settings changed by the names that
-- scene files have for them; 'settingNames' lists them, and
-- @blackhole scene show default@ prints each with its meaning and unit. A film is
-- the linear light of a scene's pixels. A picture is a film developed and coded.
--
-- This module is the library's front: what it exports keeps its meaning from one
-- minor version to the next. All other modules are exposed as well, for those who
-- want a part of the physics, and because the program and the tests are
-- components of their own that need them; they may change with any version.
--
-- A program that renders should be linked with @-threaded@ and
-- @\"-with-rtsopts=-qg -A4m\"@: several collecting threads would wait for each other
-- in a spin.
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
    Film,
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

import BlackHole.Cli.SceneOptions (SceneOptions (..))
import qualified BlackHole.Cli.SceneOptions as SceneOptions
import BlackHole.Cli.SkyFile (SkyFile (..), loadSky)
import BlackHole.Image.AtomicFile (renderWriteProblem, writeFileAtomically)
import BlackHole.Image.Coding (Format, defaultCoding, formatExtensions, formatOf)
import BlackHole.Image.Finish (finishFilm)
import BlackHole.Light.Radiance (Radiance (..))
import BlackHole.Render.Film (Exposed (..), exposeCounted)
import qualified BlackHole.Render.Film as Film
import BlackHole.Render.PixelArray (pixelArrayShape)
import BlackHole.Render.PixelShape (shapeHeight, shapeWidth)
import BlackHole.Render.Workers (Workers, defaultWorkers, withWorkers)
import BlackHole.Scene.Camera (Picture (..))
import BlackHole.Scene.Field.Field (Field (..))
import BlackHole.Scene.Field.Kind (readValue)
import BlackHole.Scene.Field.Table (findField, sceneFields)
import qualified BlackHole.Scene.File.SceneFile as SceneFile
import BlackHole.Scene.Preset (defaultScene, findPreset, presetNames)
import BlackHole.Scene.Problem (suggestion)
import BlackHole.Scene.Scene (Scene (..))
import BlackHole.Scene.Setting (Setting (..), applySettings, withoutEffect)
import BlackHole.Scene.Validate (renderProblem, validateScene)
import Data.Either (partitionEithers)
import Data.List (intercalate)
import Data.List.NonEmpty (NonEmpty (..))
import Data.Version (showVersion)
import qualified Paths_blackhole as Package

-- | Read a scene file, and the files it names. 'Left' holds a line for
-- everything that is wrong with it, at least one.
loadScene :: FilePath -> IO (Either [String] Scene)
loadScene file = SceneOptions.loadScene (SceneOptions (Just file) Nothing [])

-- | A scene with other settings: pairs of a name and a value, written as in a
-- scene file, such as @(\"camera.inclination\", \"75\")@. The height follows the
-- width unless it is set as well; of two values for one name the last counts.
-- 'Left' holds a line for every name that does not exist, every value out of its
-- range, and every setting that the scene has no place for.
change :: [(String, String)] -> Scene -> Either [String] Scene
change pairs scene = case partitionEithers (map setting pairs) of
  ([], settings) -> case map renderProblem (validateScene changed) ++ [settingPath s ++ ": has no effect in this scene" | (s, _) <- idle] of
    [] -> Right changed
    problems -> Left problems
    where
      changed = applySettings settings scene
      idle = withoutEffect scene (latest settings)
  (problems, _) -> Left problems
  where
    setting (name, text) = case findField name of
      Nothing -> Left (name ++ ": there is no such setting" ++ suggestion name settingNames)
      Just field -> case readValue (fieldKind field) text of
        Left expected -> Left (name ++ ": '" ++ text ++ "' is not " ++ expected)
        Right value -> Right (Setting (fieldPath field) value)
    latest = foldr keep []
    keep s later = if settingPath s `elem` map settingPath later then later else s : later

-- | The names of all settings, in the order of a printed scene.
settingNames :: [String]
settingNames = map fieldPath sceneFields

-- | The whole scene as a scene file, with every setting's meaning.
printScene :: Scene -> String
printScene = SceneFile.printScene []

-- | Trace a scene's light with all processors, after reading the picture of its sky
-- if that is a file; the first argument hears how many
-- rows are done. The numbers are the same for any number of processors. 'Left'
-- holds what is wrong with the scene. From 0.1 µs for a ray through empty space to
-- some microseconds for one through the gas.
renderFilm :: (Int -> IO ()) -> Scene -> IO (Either [String] Film)
renderFilm progress scene = case map renderProblem (validateScene scene) of
  [] -> loadSky scene >>= either (pure . Left . pure) (crewed . under)
  problems -> pure (Left problems)
  where
    under sky crew = maybe (Left ["this scene can't be traced"]) (Right . Film) <$> exposeCounted (skyFileImage <$> sky) crew progress scene (0, pictureHeight (scenePicture scene))

-- | Linear light of a scene's pixels, and how many samples each of them got.
newtype Film = Film Exposed

-- | A film's width and height in pixels.
filmSize :: Film -> (Int, Int)
filmSize (Film exposed) = (shapeWidth shape, shapeHeight shape)
  where
    shape = pixelArrayShape (exposedLight exposed)

-- | @filmRadiance film column row@: the radiance of a pixel, from the top left
-- corner; 'Nothing' outside.
filmRadiance :: Film -> Int -> Int -> Maybe Radiance
filmRadiance (Film exposed) = Film.filmRadiance (exposedLight exposed)

-- | Develop a scene's film as the scene says and write it in the format of the
-- file's extension. The file appears, or is replaced, only when it is complete; it
-- says of which scene it was made. 'Left' holds one line that says why not.
writeFilm :: FilePath -> Scene -> Film -> IO (Either [String] ())
writeFilm file scene (Film exposed) = inFormat file $ \format -> do
  bytes <- crewed (\crew -> finishFilm crew software format defaultCoding (scene :| []) exposed)
  case bytes of
    Nothing -> pure (Left [file ++ ": this format has no room for so large a picture"])
    Just content -> either (Left . pure . renderWriteProblem) Right <$> writeFileAtomically file content

-- | 'renderFilm' and 'writeFilm' in one: the same bytes as @blackhole render@ writes.
renderToFile :: FilePath -> Scene -> IO (Either [String] ())
renderToFile file scene = inFormat file . const $ do
  film <- renderFilm (const (pure ())) scene
  either (pure . Left) (writeFilm file scene) film

inFormat :: FilePath -> (Format -> IO (Either [String] a)) -> IO (Either [String] a)
inFormat file act = case formatOf file of
  Nothing -> pure (Left [file ++ ": not a file name that ends in " ++ intercalate ", " (map fst formatExtensions)])
  Just format -> act format

-- | Name and version, as they are written into the pictures.
software :: String
software = "blackhole " ++ showVersion Package.version

crewed :: (Workers -> IO a) -> IO a
crewed action = do
  crew <- defaultWorkers
  withWorkers crew (action crew)
