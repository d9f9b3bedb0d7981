-- | Settings that have no effect on the picture of their scene, and why.
module BlackHole.Scene.Idle
  ( Idle (..),
    idleSettings,
    Naming (..),
    renderIdle,
  )
where

import BlackHole.Scene.Field.Condition
import BlackHole.Scene.Field.Field
import BlackHole.Scene.Field.Kind (Value (..), rangeFault, showValue)
import BlackHole.Scene.Field.Table (findField)
import BlackHole.Scene.Scene
import BlackHole.Scene.Setting
import Data.List (find)
import Data.Maybe (isNothing)

-- | A setting that has no effect.
data Idle = Idle
  { idleSetting :: !Setting,
    -- | Whether the scene keeps its value nevertheless, in case the condition holds
    -- later.
    idleKept :: !Bool,
    -- | Another setting that is to blame: without it, this one would have an effect.
    -- Lazy, because the search tries every other setting and only a message needs it.
    idleCulprit :: Maybe Setting,
    -- | What the setting needs to have an effect.
    idleCondition :: !(Maybe Condition)
  }

-- | Those of the settings (at most one for each path) that have no effect on the
-- picture of the scene they are applied to. Takes time proportional to the square of
-- the number of settings.
idleSettings :: Scene -> [Setting] -> [Idle]
idleSettings scene settings =
  [ Idle s (shown s made) (find (blamed s) settings) (unmetCondition made (settingPath s))
    | s <- settings,
      not (effective s made)
  ]
  where
    made = applySettings settings scene
    blamed s other = other /= s && effective s (applySettings (filter (/= other) settings) scene)
    effective s result = shown s result && isNothing (unmetCondition result (settingPath s))
    shown s result = (findField (settingPath s) >>= (`fieldGet` result)) == Just (settingValue s)

-- | What to call a setting in a message.
data Naming
  = -- | By its option, if it has one.
    AsOption
  | -- | By its path.
    InFile
  deriving (Eq, Show)

-- | One line that says that a setting has no effect, and why. A value out of its range,
-- which a scene may be unable to hold, is the reason before any other.
renderIdle :: Naming -> Idle -> String
renderIdle naming (Idle (Setting path value) kept culprit condition) =
  name path ++ ": " ++ showValue value
    ++ maybe (" has no effect" ++ maybe alone besides culprit) (" is not " ++) range
  where
    range
      | kept = Nothing
      | otherwise = findField path >>= \field -> rangeFault (fieldKind field) value
    besides other =
      " with " ++ assigned other
        ++ (if isSwitch (settingValue other) then "" else foldMap needed condition)
    alone = maybe " in this scene" needed condition
    needed c = "; it applies only with " ++ name (conditionPath c) ++ " " ++ conditionNeeds c
    name p = case (naming, findField p >>= fieldOption) of
      (AsOption, Just o@(Takes _ _)) -> optionName o
      _ -> p
    assigned (Setting p v) = case (naming, findField p >>= fieldOption) of
      (AsOption, Just o@(Sets _ set _)) | v == set -> optionName o
      _ -> name p ++ " " ++ showValue v
    isSwitch v = case v of
      SwitchValue _ -> True
      _ -> False
