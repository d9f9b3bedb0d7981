-- | Values for settings, and the scenes that result from them.
module BlackHole.Scene.Setting
  ( Setting (..),
    applySettings,
    sceneSettings,
  )
where

import BlackHole.Scene.Field.Field (Field (..))
import BlackHole.Scene.Field.Kind (Value)
import BlackHole.Scene.Field.Table (sceneFields)
import BlackHole.Scene.Scene
import qualified Data.Map.Strict as Map
import Data.Maybe (mapMaybe)

-- | A value for a setting.
data Setting = Setting
  { -- | The setting's path.
    settingPath :: !String,
    settingValue :: !Value
  }
  deriving (Eq, Show)

-- | A scene with settings applied to it in the order of the table, whatever the order
-- of the list. If two settings have the same path, the later one counts. Settings
-- that the scene has no place for change nothing.
applySettings :: [Setting] -> Scene -> Scene
applySettings settings scene = foldl apply scene sceneFields
  where
    latest = Map.fromList [(path, value) | Setting path value <- settings]
    apply s field = maybe s (\value -> fieldSet field value s) (Map.lookup (fieldPath field) latest)

-- | Every setting of a scene. Applied to any other scene, they turn it into this one.
sceneSettings :: Scene -> [Setting]
sceneSettings scene = mapMaybe setting sceneFields
  where
    setting field = Setting (fieldPath field) <$> fieldGet field scene
