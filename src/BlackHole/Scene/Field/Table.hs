-- | The table of all settings of a scene. The options of the command line, scene
-- files, their printed form, the JSON Schema and the checks of ranges all derive from
-- it; docs/architecture.md explains how to add a setting.
module BlackHole.Scene.Field.Table
  ( sceneFields,
    findField,
    formerPaths,
    currentPath,
    maximumPictureSide,
  )
where

import BlackHole.Scene.Field.CameraTable (cameraFields, maximumPictureSide)
import BlackHole.Scene.Field.DiskTable (diskFields)
import BlackHole.Scene.Field.Field (Field (fieldPath))
import BlackHole.Scene.Field.OutputTable (outputFields)
import BlackHole.Scene.Field.SkyTable (skyFields)
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe)

-- | A setting by its path.
findField :: String -> Maybe Field
findField path = Map.lookup path fieldsByPath

fieldsByPath :: Map.Map String Field
fieldsByPath = Map.fromList [(fieldPath field, field) | field <- sceneFields]

-- | Former paths of settings with the present ones. Scene files may still use them.
formerPaths :: [(String, String)]
formerPaths =
  [ ("camera.field-of-view", "camera.fov"),
    ("observer.motion", "camera.observer"),
    ("disk.inner-radius", "disk.inner"),
    ("disk.outer-radius", "disk.outer"),
    ("sky.panorama.rotation", "sky.rotation")
  ]

-- | The present path of a setting, given that or a former one.
currentPath :: String -> String
currentPath path = fromMaybe path (lookup path formerPaths)

-- | Every setting, in the order of printed scenes. Settings are applied in this order,
-- whatever the order in which they are given: a setting that chooses between
-- alternatives comes before the settings of the alternatives, the projection before the
-- size of the picture, and the width before the height, because it sets both. Settings of
-- one group stand together.
--
-- An option is named like the end of its setting's path: @--fov@ sets @camera.fov@ and
-- @--disk-inner@ sets @disk.inner@. @--sky@ sets @sky.kind@, and @--no-gravity@ and
-- @--no-disk@ set @physics.gravity@ and @disk.present@ to false.
sceneFields :: [Field]
sceneFields = cameraFields ++ diskFields ++ skyFields ++ outputFields
