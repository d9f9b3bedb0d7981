-- | The options that make a scene, from the table of its fields, and the scene
-- that they make.
module BlackHole.Cli.SceneOptions
  ( SceneOptions (..),
    sceneOptions,
    resolveScene,
    resolveLabel,
    loadScene,
    readSceneFile,
  )
where

import BlackHole.Cli.Read
import BlackHole.Image.Moments (splitMoments)
import BlackHole.Scene.Field.Field
import BlackHole.Scene.Field.Kind
import BlackHole.Scene.Field.Table
import BlackHole.Scene.File.Yaml (maximumYamlBytes)
import BlackHole.Scene.Preset (presetNames)
import BlackHole.Scene.Resolve
import BlackHole.Scene.Scene (Scene (..))
import BlackHole.Scene.Setting
import BlackHole.Trace.Sky (neededPicture)
import Control.Exception (IOException, try)
import qualified Data.ByteString as Bytes
import Data.List (intercalate)
import Data.List.NonEmpty (NonEmpty (..))
import Data.Maybe (catMaybes)
import Options.Applicative
import System.FilePath (takeDirectory)
import System.IO (IOMode (ReadMode), withBinaryFile)
import System.IO.Error (ioeGetErrorString)

-- | What a scene is made of.
data SceneOptions = SceneOptions
  { sceneFile :: !(Maybe FilePath),
    scenePreset :: !(Maybe String),
    -- | The options that were given, in the order of the table, each once.
    sceneGiven :: ![Setting]
  }
  deriving (Eq, Show)

-- | A scene file, if there is to be one, and the options of all fields.
sceneOptions :: Parser SceneOptions
sceneOptions =
  SceneOptions
    <$> optional (strArgument (metavar "SCENE.yaml" <> action "file" <> help "Scene file to start from; the options count more than it does"))
    <*> setting (strOption (long "preset" <> metavar "NAME" <> completeWith presetNames <> help ("Scene to start from: " ++ intercalate ", " presetNames ++ " (default: default)")))
    <*> (catMaybes <$> traverse fieldSetting sceneFields)

fieldSetting :: Field -> Parser (Maybe Setting)
fieldSetting field = fmap (Setting (fieldPath field)) <$> given
  where
    given = case fieldOption field of
      Nothing -> pure Nothing
      Just (Takes name placeholder) ->
        setting (option (valueOf (fieldKind field)) (long name <> metavar placeholder <> completeWith (valueNames (fieldKind field)) <> help (fieldDoc field)))
      Just (Sets name v text) ->
        (\on -> if on then Just v else Nothing) <$> toggle (long name <> help text)

-- | The values of a kind that has few, for completion.
valueNames :: Kind -> [String]
valueNames kind = case kind of
  ChoiceKind _ choices -> map fst choices
  ChoiceOrFileKind _ choices _ -> map fst choices
  SwitchKind -> ["on", "off"]
  _ -> []

valueOf :: Kind -> ReadM Value
valueOf kind = eitherReader $ \s ->
  either (\expected -> Left ("'" ++ s ++ "' is not " ++ expected)) Right (readValue kind s)

-- | The scene that the options ask for, given the bytes of its file, checked;
-- or a line for everything that is wrong with it (at least one).
resolveScene :: SceneOptions -> Maybe Bytes.ByteString -> Either [String] Scene
resolveScene (SceneOptions file preset settings) bytes =
  resolveRequest (Request preset ((,) <$> file <*> bytes) (maybe "." takeDirectory file) settings)

-- | The scenes whose mean light a picture is, given the picture's name and the
-- scenes' text in its label ('splitMoments'). Files that they name are relative to
-- the working directory.
resolveLabel :: SceneOptions -> FilePath -> Bytes.ByteString -> Either [String] (NonEmpty Scene)
resolveLabel (SceneOptions _ preset settings) picture bytes = do
  texts <- either (Left . pure . ((picture ++ ": ") ++)) Right (splitMoments bytes)
  scenes@(first :| others) <- traverse (\text -> resolveRequest (Request preset (Just (picture, text)) "." settings)) texts
  let alike scene = scenePicture scene == scenePicture first && neededPicture scene == neededPicture first
  if all alike others
    then Right scenes
    else Left [picture ++ ": the scenes of its motion blur differ in picture size or environment map"]

-- | The scene that the options ask for, like 'resolveScene', reading the file.
loadScene :: SceneOptions -> IO (Either [String] Scene)
loadScene options = do
  bytes <- traverse readSceneFile (sceneFile options)
  pure (either (Left . pure) (resolveScene options) (sequence bytes))

-- | A scene file's bytes, or one line that says why it can't be read. A file
-- that is far too long is not read to its end.
readSceneFile :: FilePath -> IO (Either String Bytes.ByteString)
readSceneFile file = do
  outcome <- try (withBinaryFile file ReadMode (`Bytes.hGet` (maximumYamlBytes + 1)))
  pure $ case outcome of
    Left failure -> Left (file ++ ": can't be read: " ++ ioeGetErrorString (failure :: IOException))
    Right bytes -> Right bytes
