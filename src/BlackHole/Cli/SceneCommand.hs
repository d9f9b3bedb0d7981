-- | @blackhole scene@: lists, prints and checks scenes.
module BlackHole.Cli.SceneCommand
  ( SceneCommand (..),
    sceneCommands,
    sceneText,
    runSceneCommand,
  )
where

import BlackHole.Animation.Animation (animationFrames)
import BlackHole.Cli.AnimationScene
import BlackHole.Cli.Console (say)
import BlackHole.Cli.ExitStatus
import BlackHole.Cli.Json (renderJson)
import BlackHole.Cli.Read (filesEnding)
import BlackHole.Cli.SceneOptions
import BlackHole.Cli.Schema (sceneSchema)
import BlackHole.Image.SceneSource (readSceneFile)
import BlackHole.Image.SkyFile (skyFault)
import BlackHole.Scene.File.SceneFile (printScene)
import BlackHole.Scene.Preset
import BlackHole.Scene.Problem
import Data.List (intercalate)
import Options.Applicative

-- | What to do.
data SceneCommand
  = -- | List the presets.
    ListScenes
  | -- | Print a preset.
    ShowScene !String
  | -- | Check a scene file.
    CheckScene !FilePath
  | -- | Print the scene that a file and options make.
    PrintScene !SceneOptions
  | -- | Print the JSON Schema of scene files.
    SceneSchema
  deriving (Eq, Show)

-- | The commands inside @blackhole scene@: name, summary, details, examples, parser.
sceneCommands :: [(String, String, String, [String], Parser SceneCommand)]
sceneCommands =
  [ ("list", "List the presets.", "", ["blackhole scene list"], pure ListScenes),
    ( "show",
      "Print a preset as a scene file with comments.",
      "",
      ["blackhole scene show report > mine.yaml"],
      ShowScene
        <$> strArgument
          ( metavar "NAME" <> completeWith presetNames
              <> help ("Preset: " ++ intercalate ", " presetNames)
          )
    ),
    ( "check",
      "Report every mistake in a scene file.",
      "Each mistake is one line with the file, the line number, the setting, its value and the \
      \allowed range. The exit code is 3 if there are any.",
      ["blackhole scene check mine.yaml"],
      CheckScene
        <$> strArgument (metavar "SCENE.yaml" <> filesEnding [".yaml", ".yml"] <> help "Scene file")
    ),
    ( "print",
      "Print the complete scene that a file and options make.",
      "The printed scene has every setting and renders to the same bytes.",
      ["blackhole scene print --preset luminet --fov 30 > luminet.yaml"],
      PrintScene <$> sceneOptions
    ),
    ( "schema",
      "Print the JSON Schema of scene files, for editors.",
      "",
      ["blackhole scene schema > scene.schema.json"],
      pure SceneSchema
    )
  ]

-- | Prints the output of a command, or its problems.
runSceneCommand :: SceneCommand -> IO ExitStatus
runSceneCommand task = sceneText task >>= either ((status <$) . mapM_ say) (printed Done)
  where
    status = case task of
      ShowScene _ -> UsageError
      _ -> BadInput

-- | The output of a command, or one line for each mistake.
sceneText :: SceneCommand -> IO (Either [String] String)
sceneText task = case task of
  ListScenes ->
    pure
      ( Right
          ( unlines
              [ presetName p ++ replicate (14 - length (presetName p)) ' ' ++ presetShows p
                | p <- describedPresets
              ]
          )
      )
  ShowScene name -> pure $ case [p | p <- describedPresets, presetName p == name] of
    p : _ ->
      Right
        (printScene ["The preset " ++ name ++ ": " ++ presetShows p ++ "."] (presetScene p))
    [] ->
      Left
        [ renderProblem
            ( Problem
                "scene show"
                ("'" ++ name ++ "'")
                ( "a preset" ++ suggestion name presetNames ++ "; the presets are: "
                    ++ intercalate ", " presetNames
                )
            )
        ]
  CheckScene file -> do
    bytes <- readSceneFile file
    either (pure . Left . pure) (checked file) bytes
  PrintScene options ->
    fmap (printScene ["A complete scene, with every setting."])
      <$> loadScene options
  SceneSchema -> pure (Right (renderJson sceneSchema))
  where
    checked file bytes = do
      warnFormerNames options bytes
      picture <- either (const (pure Nothing)) skyFault (resolveScene options (Just bytes))
      pure $ case (resolveAnimation options (Just bytes), picture) of
        (Right (Just ready), _)
          | faults@(_ : _) <-
              frameFaults
                ready
                [0 .. animationFrames ready - 1] ->
            Left (take maximumFaults faults)
        (Right _, Just line) -> Left [line]
        (animation, _) -> (file ++ ": no problems\n") <$ animation
      where
        options = SceneOptions (Just file) Nothing []
