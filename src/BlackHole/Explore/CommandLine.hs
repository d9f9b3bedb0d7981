-- | The command line that renders a scene.
module BlackHole.Explore.CommandLine
  ( commandLine,
    CommandLine (..),
    shellWord,
  )
where

import BlackHole.Explore.Message (valueText)
import BlackHole.Scene.Field.Field
import BlackHole.Scene.Field.Table
import BlackHole.Scene.Preset
import BlackHole.Scene.Resolve
import BlackHole.Scene.Scene
import BlackHole.Scene.Setting
import Data.Char (isAlphaNum, isAscii)
import Data.List (delete)
import Data.Maybe (fromMaybe, mapMaybe)

-- | How the command line can render a scene.
data CommandLine
  = -- | With these words behind @blackhole render@.
    Options ![String]
  | -- | Only with a scene file, because of these settings, or because options cannot
    -- be combined in this way (no settings).
    NeedsFile ![String]
  deriving (Eq, Show)

-- | The options that make a scene of a preset: as few as it takes. They are tried out,
-- so that the command line makes exactly this scene.
commandLine :: String -> Scene -> CommandLine
commandLine presetName' scene = case mapMaybe unspeakable needed of
  paths@(_ : _) -> NeedsFile paths
  []
    | resolveRequest (Request (Just presetName') Nothing "." needed) == Right scene ->
      Options (preset ++ concat (mapMaybe optionWords needed))
    | otherwise -> NeedsFile []
  where
    base = fromMaybe defaultScene (findPreset presetName')
    preset = if presetName' == "default" then [] else ["--preset", presetName']
    different =
      [ Setting (fieldPath f) v | f <- sceneFields, Just v <- [fieldGet f scene], fieldGet f base
                                                                                    /= Just v
      ]
    needed = foldl without different different
    -- Some settings follow from others, like the height from the width.
    without settings s
      | applySettings fewer base == scene = fewer
      | otherwise = settings
      where
        fewer = delete s settings
    unspeakable s = case optionWords s of
      Nothing -> Just (settingPath s)
      Just _ -> Nothing

-- | A setting as an option, if it has one for this value.
optionWords :: Setting -> Maybe [String]
optionWords (Setting path value) = do
  option <- findField path >>= fieldOption
  case option of
    Takes _ _ -> Just [optionName option, valueText value]
    Sets _ set _
      | set == value -> Just [optionName option]
      | otherwise -> Nothing

-- | A word as POSIX shells read it, in quotes if it takes them.
shellWord :: String -> String
shellWord word
  | not (null word) && all plain word = word
  | otherwise = "'" ++ concatMap (\c -> if c == '\'' then "'\\''" else [c]) word ++ "'"
  where
    plain c = isAscii c && (isAlphaNum c || c `elem` "-_./,=:+@%")
