-- | The scene that a preset, a scene file and options make together.
module BlackHole.Scene.Resolve
  ( Request (..),
    resolveRequest,
  )
where

import BlackHole.Scene.Field.Field (fieldLabel)
import BlackHole.Scene.Field.Kind (Value (..), showValue)
import BlackHole.Scene.Field.Table
import BlackHole.Scene.File.SceneFile
import BlackHole.Scene.File.Yaml (YamlFault (..))
import BlackHole.Scene.Preset
import BlackHole.Scene.Problem
import BlackHole.Scene.Scene
import BlackHole.Scene.Setting
import BlackHole.Scene.Validate
import qualified Data.ByteString as Bytes
import Data.List (intercalate, sortOn)
import Data.Maybe (fromMaybe, listToMaybe)
import System.FilePath (isRelative, (</>))

-- | What a scene is to be made of.
data Request = Request
  { -- | A preset's name, in the place of the one that the file starts from.
    requestPreset :: !(Maybe String),
    -- | A scene file's name and bytes.
    requestFile :: !(Maybe (FilePath, Bytes.ByteString)),
    -- | The folder, seen from the working directory, from which the file's own
    -- paths start.
    requestFolder :: !FilePath,
    -- | The options' settings, which count more than the file's.
    requestSettings :: ![Setting]
  }
  deriving (Eq, Show)

-- | The scene, checked, or one line for everything that is wrong with it (at
-- least one): the options first, then the file in the order of its lines.
resolveRequest :: Request -> Either [String] Scene
resolveRequest (Request preset file folder options) = case traverse (parseSceneFile . snd) file of
  Left (YamlFault line text) -> Left [fileName ++ ":" ++ show line ++ ": " ++ text]
  Right parsed -> case findPreset chosenName of
    Nothing -> Left [renderProblem (Problem "--preset" chosenName unknownPreset)]
    Just _ | _ : _ <- clashes -> Left (map renderProblem clashes)
    Just base
      | null problems -> Right scene
      | otherwise -> Left (map snd (sortOn fst problems))
      where
        inFile = map (settingFrom folder . placedSetting) settings
        scene = applySettings options (applySettings inFile base)
        faults = (if null malformed then sceneFaults else rangeFaults) scene
        idle = if null malformed then withoutEffect base inFile else []
        problems =
          [(line, fileLine line (renderProblem problem)) | (line, problem) <- malformed]
            ++ [(line, fileLine line (idleText s culprit)) | (s, culprit) <- idle, Just line <- [lineOf (settingPath s)]]
            ++ map faultText faults
    where
      (SceneFile filePresetName settings, malformed) = fromMaybe (SceneFile "default" [], []) parsed
      chosenName = fromMaybe filePresetName preset
      lineOf path = listToMaybe [line | PlacedSetting line s <- settings, settingPath s == path]
      -- A fault is laid to whoever set the field.
      faultText (Fault path value range) = case lineOf path of
        Just line
          | path `notElem` map settingPath options ->
            (line, fileLine line (renderProblem (Problem path (showValue value) range)))
        _ -> (0, renderProblem (Problem (maybe path fieldLabel (findField path)) (showValue value) range))
  where
    fileName = maybe "" fst file
    fileLine line text = fileName ++ ":" ++ show line ++ ": " ++ text
    idleText s culprit =
      settingPath s ++ ": " ++ showValue (settingValue s) ++ " has no effect"
        ++ maybe " in this scene" (\c -> " beside " ++ settingPath c ++ ": " ++ showValue (settingValue c)) culprit
    unknownPreset =
      "a preset" ++ suggestion (fromMaybe "" preset) presetNames ++ "; there are: " ++ intercalate ", " presetNames
    given = map settingPath options
    clashes =
      [ Problem "--camera" "together with --distance, --inclination or --azimuth" "one way to place the camera; choose either"
        | any (`elem` given) ["camera.position", "camera.look-at"],
          any (`elem` given) ["camera.distance", "camera.inclination", "camera.azimuth"]
      ]

-- | A setting that names a file, seen from a folder instead of from within it.
settingFrom :: FilePath -> Setting -> Setting
settingFrom folder s = case settingValue s of
  FileValue file | isRelative file && folder /= "." -> s {settingValue = FileValue (folder </> file)}
  _ -> s
