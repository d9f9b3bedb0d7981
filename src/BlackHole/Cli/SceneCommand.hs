-- | @blackhole scene@: what scenes there are, and what is in them.
module BlackHole.Cli.SceneCommand
  ( SceneCommand (..),
    sceneCommand,
    sceneText,
  )
where

import BlackHole.Animation.Film (filmFrames)
import BlackHole.Cli.FilmScene
import BlackHole.Cli.Json (renderJson)
import BlackHole.Cli.SceneOptions
import BlackHole.Cli.Schema (sceneSchema)
import BlackHole.Cli.SkyFile (skyFault)
import BlackHole.Scene.File.SceneFile (printScene)
import BlackHole.Scene.Preset
import BlackHole.Scene.Problem
import Data.List (intercalate)
import Options.Applicative

-- | What is to be done.
data SceneCommand
  = -- | Name the presets.
    ListScenes
  | -- | Print a preset.
    ShowScene !String
  | -- | Say whether a scene file is right.
    CheckScene !FilePath
  | -- | Print the scene that a file and options make.
    PrintScene !SceneOptions
  | -- | Print the JSON Schema of scene files.
    SceneSchema
  deriving (Eq, Show)

-- | The grammar of the commands.
sceneCommand :: Parser SceneCommand
sceneCommand =
  hsubparser $
    command "list" (info (pure ListScenes) (progDesc "Name the presets and what they are"))
      <> command "show" (info (ShowScene <$> strArgument (metavar "NAME")) (progDesc "Print a preset as a commented scene file"))
      <> command "check" (info (CheckScene <$> strArgument (metavar "SCENE.yaml")) (progDesc "Say everything that is wrong with a scene file"))
      <> command "print" (info (PrintScene <$> sceneOptions) (progDesc "Print the whole scene that a file and the options of render make; it renders to the same bytes"))
      <> command "schema" (info (pure SceneSchema) (progDesc "Print the JSON Schema of scene files, for editors"))

-- | What a command prints, or a line for everything that is wrong.
sceneText :: SceneCommand -> IO (Either [String] String)
sceneText task = case task of
  ListScenes -> pure (Right (unlines [presetName p ++ replicate (14 - length (presetName p)) ' ' ++ presetShows p | p <- describedPresets]))
  ShowScene name -> pure $ case [p | p <- describedPresets, presetName p == name] of
    p : _ -> Right (printScene ["The preset " ++ name ++ ": " ++ presetShows p ++ "."] (presetScene p))
    [] -> Left [renderProblem (Problem "scene show" ("'" ++ name ++ "'") ("a preset" ++ suggestion name presetNames ++ "; there are: " ++ intercalate ", " presetNames))]
  CheckScene file -> do
    film <- loadFilm options
    still <- loadScene options
    picture <- either (const (pure Nothing)) skyFault still
    pure $ case (film, picture) of
      (Right (Just ready), _) | faults@(_ : _) <- frameFaults ready [0 .. filmFrames ready - 1] -> Left (take maximumFaults faults)
      (Right _, Just line) -> Left [line]
      _ -> (file ++ ": no problems\n") <$ film
    where
      options = SceneOptions (Just file) Nothing []
  PrintScene options -> fmap (printScene ["A whole scene, with every setting."]) <$> loadScene options
  SceneSchema -> pure (Right (renderJson sceneSchema))
