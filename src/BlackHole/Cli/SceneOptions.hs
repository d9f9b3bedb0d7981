-- | The options that determine a scene, made from the table of settings, and the scene
-- that they make.
module BlackHole.Cli.SceneOptions
  ( SceneOptions (..),
    sceneOptions,
    resolveScene,
    resolveMetadata,
    loadScene,
    warnFormerNames,
    sceneInputs,
    underSky,
  )
where

import BlackHole.Cli.Console (say)
import BlackHole.Cli.ExitStatus
import BlackHole.Cli.Read
import BlackHole.Image.MotionBlur (splitBlurredScenes)
import BlackHole.Image.SceneSource (readSceneFile)
import BlackHole.Image.SkyFile
import BlackHole.Scene.Field.Field
import BlackHole.Scene.Field.Kind
import BlackHole.Scene.Field.Table
import BlackHole.Scene.Preset (presetNames)
import BlackHole.Scene.Resolve
import BlackHole.Scene.Scene (Scene (..))
import BlackHole.Scene.Setting
import BlackHole.Trace.Sky (neededPicture)
import qualified Data.ByteString as Bytes
import Data.List (intercalate)
import Data.List.NonEmpty (NonEmpty (..))
import Data.Maybe (catMaybes)
import Options.Applicative
import System.FilePath (takeDirectory)

-- | What makes a scene.
data SceneOptions = SceneOptions
  { sceneFile :: !(Maybe FilePath),
    scenePreset :: !(Maybe String),
    -- | The settings of the given options, in the order of the table, each once.
    sceneGiven :: ![Setting]
  }
  deriving (Eq, Show)

-- | An optional scene file, @--preset@, and the options of all settings.
sceneOptions :: Parser SceneOptions
sceneOptions =
  SceneOptions
    <$> optional
      ( strArgument
          ( metavar "SCENE.yaml" <> filesEnding [".yaml", ".yml"]
              <> help "Scene file; options override its settings"
          )
      )
    <*> setting
      ( strOption
          ( long "preset" <> metavar "NAME" <> completeWith presetNames
              <> help
                ( "Preset to start from, also instead of the scene file's: "
                    ++ intercalate ", " presetNames
                    ++ " (default: default)"
                )
          )
      )
    <*> (catMaybes <$> traverse fieldSetting sceneFields)

fieldSetting :: Field -> Parser (Maybe Setting)
fieldSetting field = fmap (Setting (fieldPath field)) <$> given
  where
    given = case fieldOption field of
      Nothing -> pure Nothing
      Just (Takes name placeholder) ->
        setting
          ( option
              (valueOf (fieldKind field))
              ( long name <> metavar placeholder <> valueCompletion (fieldKind field)
                  <> help (fieldDoc field)
              )
          )
      Just (Sets name v text) ->
        (\on -> if on then Just v else Nothing) <$> toggle (long name <> help text)

-- Completion of values that are names or files.
valueCompletion :: HasCompleter f => Kind -> Mod f a
valueCompletion kind = case kind of
  ChoiceKind _ choices -> completeWith (map fst choices)
  ChoiceOrFileKind _ choices _ -> completeWith (map fst choices) <> action "file"
  SwitchKind -> completeWith ["on", "off"]
  _ -> mempty

valueOf :: Kind -> ReadM Value
valueOf kind = eitherReader $ \s ->
  either (\expected -> Left ("'" ++ s ++ "' is not " ++ expected)) Right (readValue kind s)

-- | The scene that the options ask for, given the bytes of the scene file, validated;
-- or one line for each mistake (at least one).
resolveScene :: SceneOptions -> Maybe Bytes.ByteString -> Either [String] Scene
resolveScene options bytes =
  resolveRequest (sceneRequest options bytes)

sceneRequest :: SceneOptions -> Maybe Bytes.ByteString -> Request
sceneRequest (SceneOptions file preset settings) bytes =
  Request preset ((,) <$> file <*> bytes) (maybe "." takeDirectory file) settings

-- | The scenes whose mean light a picture is, given the picture's name and the
-- scenes' text in its metadata ('splitBlurredScenes'). Files that they name are relative to
-- the working directory.
resolveMetadata :: SceneOptions -> FilePath -> Bytes.ByteString -> Either [String] (NonEmpty Scene)
resolveMetadata (SceneOptions _ preset settings) picture bytes = do
  texts <- either (Left . pure . ((picture ++ ": ") ++)) Right (splitBlurredScenes bytes)
  scenes@(first :| others) <-
    traverse
      (\text -> resolveRequest (Request preset (Just (picture, text)) "." settings))
      texts
  let alike scene =
        scenePicture scene == scenePicture first
          && neededPicture scene == neededPicture first
  if all alike others
    then Right scenes
    else
      Left
        [picture ++ ": the scenes of its motion blur differ in picture size or environment map"]

-- | The scene that the options ask for, like 'resolveScene', reading the file. Warns of
-- former names on standard error.
loadScene :: SceneOptions -> IO (Either [String] Scene)
loadScene options = do
  bytes <- traverse readSceneFile (sceneFile options)
  mapM_ (mapM_ (warnFormerNames options)) bytes
  pure (either (Left . pure) (resolveScene options) (sequence bytes))

-- | Write a warning on standard error for each former name of a setting in a scene file
-- with these bytes.
warnFormerNames :: SceneOptions -> Bytes.ByteString -> IO ()
warnFormerNames options bytes =
  mapM_ say (requestWarnings (sceneRequest options (Just bytes)))

-- | The files that a scene is read from, with the names that messages use for them.
sceneInputs :: SceneOptions -> Scene -> [(String, FilePath)]
sceneInputs options scene =
  [("the scene", file) | Just file <- [sceneFile options]]
    ++ [("the sky", file) | Just file <- [neededPicture scene]]

-- | Continues with the environment map of a scene, if it has one.
underSky :: Scene -> (Maybe SkyFile -> IO ExitStatus) -> IO ExitStatus
underSky scene continue = loadSky scene >>= either (complain BadInput) continue
