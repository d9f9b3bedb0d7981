-- | The scene that a preset, a scene file and options make together.
module BlackHole.Scene.Resolve
  ( Request (..),
    resolveRequest,
    requestWarnings,
  )
where

import BlackHole.Scene.Field.Field (fieldLabel)
import BlackHole.Scene.Field.Kind (Value (..), showValue)
import BlackHole.Scene.Field.Table
import BlackHole.Scene.File.SceneFile
import BlackHole.Scene.File.Yaml (YamlFault (..))
import BlackHole.Scene.Idle
import BlackHole.Scene.Preset
import BlackHole.Scene.Problem
import BlackHole.Scene.Scene
import BlackHole.Scene.Setting
import BlackHole.Scene.Validate
import qualified Data.ByteString as Bytes
import Data.List (intercalate, sortOn)
import Data.Maybe (fromMaybe, listToMaybe)
import qualified Data.Set as Set
import System.FilePath (isRelative, (</>))

-- | What a scene is made of.
data Request = Request
  { -- | The name of a preset, which replaces the one that the file starts from.
    requestPreset :: !(Maybe String),
    -- | A scene file's name and bytes.
    requestFile :: !(Maybe (FilePath, Bytes.ByteString)),
    -- | The folder that paths in the file are relative to, seen from the working
    -- directory.
    requestFolder :: !FilePath,
    -- | The settings of the options, which override those of the file.
    requestSettings :: ![Setting]
  }
  deriving (Eq, Show)

-- | The scene, validated, or one line for each mistake (at least one): those in the
-- options first, then those in the file in the order of its lines.
--
-- A setting that has no effect is a mistake. In a file there are two exceptions: a
-- setting may repeat the value that the preset has anyway, and a file that states
-- every setting, as 'BlackHole.Scene.File.SceneFile.printScene' writes it, may state
-- those that have no effect.
resolveRequest :: Request -> Either [String] Scene
resolveRequest (Request preset file folder options) = case traverse (parseSceneFile . snd) file of
  Left (YamlFault line text) -> Left [fileLine line text]
  Right parsed -> case findPreset chosenName of
    Nothing -> Left [renderProblem (Problem "--preset" chosenName unknownPreset)]
    Just _ | _ : _ <- clashes -> Left (map renderProblem clashes)
    Just base
      | null problems -> Right scene
      | otherwise -> Left (map snd (sortOn fst problems))
      where
        inFile = map (settingFrom folder . placedSetting) settings
        ofFile = applySettings inFile base
        scene = applySettings options ofFile
        faults = (if null malformed then sceneFaults else rangeFaults) scene
        problems =
          [(0, renderIdle AsOption idle) | null malformed, idle <- idleSettings ofFile options]
            ++ [(line, fileLine line (renderProblem problem)) | (line, problem) <- malformed]
            ++ [ (line, fileLine line (renderIdle InFile idle))
                 | null malformed,
                   idle <- idleSettings base inFile,
                   not (idleKept idle && (complete || idleSetting idle `elem` sceneSettings base)),
                   Just line <- [lineOf (settingPath (idleSetting idle))]
               ]
            ++ map faultText faults
        complete =
          all
            ((`Set.member` Set.fromList (map settingPath inFile)) . settingPath)
            (sceneSettings ofFile)
    where
      (SceneFile filePresetName settings _, malformed) =
        fromMaybe (SceneFile "default" [] [], []) parsed
      chosenName = fromMaybe filePresetName preset
      lineOf path = listToMaybe [line | PlacedSetting line s <- settings, settingPath s == path]
      -- A fault is reported where the value was set: by an option or in the file.
      faultText (Fault path value range) = case lineOf path of
        Just line
          | path `notElem` map settingPath options ->
            (line, fileLine line (renderProblem (Problem path (showValue value) range)))
        _ ->
          ( 0,
            renderProblem (Problem (maybe path fieldLabel (findField path)) (showValue value) range)
          )
  where
    fileLine line text = maybe "" fst file ++ ":" ++ show line ++ ": " ++ text
    unknownPreset =
      "a preset" ++ suggestion (fromMaybe "" preset) presetNames ++ "; the presets are: "
        ++ intercalate ", " presetNames
    given = map settingPath options
    clashes =
      [ Mistake
          "--position, --look-at"
          "cannot be combined with --distance, --inclination or --azimuth"
        | any (`elem` given) ["camera.position", "camera.look-at"],
          any (`elem` given) ["camera.distance", "camera.inclination", "camera.azimuth"]
      ]

-- | One line for each former name of a setting that the scene file of a request still
-- uses, with the present name. Empty for a file that cannot be read.
requestWarnings :: Request -> [String]
requestWarnings request =
  [ name ++ ":" ++ show line ++ ": warning: " ++ former ++ " is now called " ++ path
    | Just (name, bytes) <- [requestFile request],
      Right (parsed, _) <- [parseSceneFile bytes],
      FormerName line former path <- fileFormerNames parsed
  ]

-- | A setting whose value is a relative file name, made relative to the working
-- directory instead of the given folder.
settingFrom :: FilePath -> Setting -> Setting
settingFrom folder s = case settingValue s of
  FileValue file
    | isRelative file && folder /= "." ->
      s {settingValue = FileValue (folder </> file)}
  _ -> s
