-- | Which settings depend on others: the one table that says when a setting has an
-- effect on the picture. To make a setting depend on another one, add a line.
module BlackHole.Scene.Field.Condition
  ( Condition (..),
    settingConditions,
    unmetCondition,
  )
where

import BlackHole.Scene.Field.Field (Field (..))
import BlackHole.Scene.Field.Kind (Value (..), showValue)
import BlackHole.Scene.Field.Table (findField)
import BlackHole.Scene.Scene (Scene)
import Data.List (isPrefixOf, isSuffixOf)

-- | What another setting must be for this one to have an effect.
data Condition = Condition
  { -- | The path of the other setting.
    conditionPath :: !String,
    -- | The value that it needs, in words, such as @above 0@.
    conditionNeeds :: !String,
    conditionHolds :: !(Value -> Bool)
  }

-- | Paths, or groups of paths that end in a point, with their conditions. A setting
-- needs all conditions that apply to it, except one on itself.
settingConditions :: [(String, Condition)]
settingConditions =
  [ ("physics.step", "physics.integrator" `is` NameValue "leapfrog"),
    ("hole.spin", "physics.gravity" `is` SwitchValue True),
    ("disk.", "disk.present" `is` SwitchValue True),
    ("disk.arms.", above 0 "disk.arms.count"),
    ("disk.turbulence.", above 0 "disk.turbulence.strength"),
    ( "disk.turbulence.heat",
      Condition "disk.colour" "black-body, bolometric or synchrotron" (/= NameValue "hue-ramp")
    ),
    ("disk.haze.height", above 0 "disk.haze.density"),
    ("sky.", "diagnostics.debug-textures" `is` SwitchValue False),
    ( "sky.rotation",
      Condition "sky.kind" "stars or FILE" (\v -> v == NameValue "stars" || isFile v)
    ),
    ("sky.brightness", "sky.kind" `is` NameValue "stars"),
    ("sky.milky-way", "sky.kind" `is` NameValue "stars"),
    ("sky.panorama.", Condition "sky.kind" "FILE" isFile),
    ("sky.radiance", "sky.kind" `is` NameValue "uniform"),
    ("sky.stars.", "sky.kind" `is` NameValue "noise"),
    ("sky.points.", "sky.kind" `is` NameValue "random-stars"),
    ("camera.aperture", "camera.projection" `is` NameValue "perspective"),
    ("camera.focus", above 0 "camera.aperture"),
    ("output.spike-light", above 0 "output.spikes"),
    ("sampling.most-samples", above 0 "sampling.noise")
  ]
  where
    is path value = Condition path (showValue value) (== value)
    above least path = Condition path ("above " ++ show least) (exceeds least)
    exceeds :: Int -> Value -> Bool
    exceeds least value = case value of
      NumberValue v -> v > fromIntegral least
      WholeValue n -> n > least
      _ -> False
    isFile value = case value of
      FileValue _ -> True
      _ -> False

-- | The first condition for the setting of this path that does not hold in a scene;
-- 'Nothing' if the setting has an effect there.
unmetCondition :: Scene -> String -> Maybe Condition
unmetCondition scene path = case filter
  unmet
  [ condition | (start, condition) <- settingConditions, start `covers` path, conditionPath
                                                                                condition
                                                                                /= path
  ] of
  first : _ -> Just first
  [] -> Nothing
  where
    covers start = if "." `isSuffixOf` start then (start `isPrefixOf`) else (start ==)
    unmet condition =
      not
        ( any
            (conditionHolds condition)
            (findField (conditionPath condition) >>= (`fieldGet` scene))
        )
