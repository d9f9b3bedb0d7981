-- | Values for fields, and scenes made of them.
module BlackHole.Scene.Setting
  ( Setting (..),
    applySettings,
    sceneSettings,
    withoutEffect,
  )
where

import BlackHole.Scene.Field.Field
import BlackHole.Scene.Field.Kind (Value)
import BlackHole.Scene.Field.Table
import BlackHole.Scene.Scene
import Data.List (find)
import Data.Maybe (mapMaybe)

-- | A value for a field.
data Setting = Setting
  { -- | The field's path.
    settingPath :: !String,
    settingValue :: !Value
  }
  deriving (Eq, Show)

-- | A scene with settings applied to it, in the order of the table: the order
-- of the list makes no difference, but of two settings of one field the last
-- counts. Settings of fields that the scene does not have are passed over.
applySettings :: [Setting] -> Scene -> Scene
applySettings settings scene = foldl apply scene sceneFields
  where
    latest = reverse settings
    apply s field = case find ((== fieldPath field) . settingPath) latest of
      Just setting -> fieldSet field (settingValue setting) s
      Nothing -> s

-- | Every setting of a scene. Applied to any scene whatever they make this one.
sceneSettings :: Scene -> [Setting]
sceneSettings scene = mapMaybe setting sceneFields
  where
    setting field = Setting (fieldPath field) <$> fieldGet field scene

-- | Those of the settings (one for each field at most) that do not show in the
-- scene they are applied to, each with another one that is to blame, if taking
-- away a single one helps. Quadratic in the number of settings.
withoutEffect :: Scene -> [Setting] -> [(Setting, Maybe Setting)]
withoutEffect scene settings =
  [(s, find (blamed s) settings) | s <- settings, not (s `shownBy` applySettings settings scene)]
  where
    blamed s other = other /= s && s `shownBy` applySettings (filter (/= other) settings) scene
    shownBy s made = (findField (settingPath s) >>= (`fieldGet` made)) == Just (settingValue s)
