-- | Scene files: from YAML to settings, and back from a scene to YAML that says
-- what everything is.
module BlackHole.Scene.File.SceneFile
  ( SceneFile (..),
    PlacedSetting (..),
    parseSceneFile,
    readSettings,
    printScene,
    otherSections,

    -- * Single values
    readNode,
    nodeText,
  )
where

import BlackHole.Scene.Field.Field
import BlackHole.Scene.Field.Kind
import BlackHole.Scene.Field.Number
import BlackHole.Scene.Field.Table
import BlackHole.Scene.File.Yaml
import BlackHole.Scene.Preset
import BlackHole.Scene.Problem
import BlackHole.Scene.Scene
import BlackHole.Scene.Setting
import BlackHole.Vector.XYZ (XYZ (..))
import qualified Data.ByteString as Bytes
import Data.List (intercalate, isSuffixOf, nub, stripPrefix)
import Data.Maybe (mapMaybe)

-- | What a scene file says.
data SceneFile = SceneFile
  { -- | The preset it starts from, and its name; the default if it names none.
    filePreset :: !String,
    fileSettings :: ![PlacedSetting]
  }
  deriving (Eq, Show)

-- | A setting and the line it stands on.
data PlacedSetting = PlacedSetting
  { placedLine :: !Int,
    placedSetting :: !Setting
  }
  deriving (Eq, Show)

-- | The settings of a file, given its bytes, and the lines of what is wrong with
-- the form of the others. Left is a file that is no YAML.
parseSceneFile :: Bytes.ByteString -> Either YamlFault (SceneFile, [(Int, Problem)])
parseSceneFile bytes = do
  tree <- parseYaml bytes
  case tree of
    Just root -> Right (readSettings otherSections root)
    Nothing -> Left (YamlFault 1 "there is nothing in the file")

-- | The settings of a tree. The first argument names top-level keys that are
-- somebody else's business, like those of an animation.
readSettings :: [String] -> Node -> (SceneFile, [(Int, Problem)])
readSettings foreign' root = (SceneFile preset settings, problems)
  where
    (found, problems) = level foreign' [] root
    settings = [PlacedSetting line (Setting path value) | (line, path, value) <- found, path /= presetKey]
    preset = case [name | (_, path, NameValue name) <- found, path == presetKey] of
      name : _ -> name
      [] -> "default"

presetKey :: String
presetKey = "preset"

-- | Top-level keys that say nothing about a single picture.
otherSections :: [String]
otherSections = ["animation"]

type Found = ([(Int, String, Value)], [(Int, Problem)])

-- | What stands below a path, the path's last part first.
level :: [String] -> [String] -> Node -> Found
level foreign' above node = case node of
  -- Looking for repeated keys is quadratic in their number.
  Mapping line members
    | length (take 501 members) > 500 ->
      wrong line (Problem (pathOr "scene" above) "a group of more than 500 keys" "possible in a scene file")
  Mapping _ members -> foldMap (member members) (zip [0 :: Int ..] members)
  _ -> ([], [(nodeLine node, Problem (pathOr "scene" above) (nodeText node) ("a group of settings; there are: " ++ intercalate ", " children))])
  where
    children = childrenOf above
    member members (i, (line, key, value))
      | null above && key `elem` foreign' = mempty
      | (first, _, _) : _ <- [m | (j, m@(_, k, _)) <- zip [0 ..] members, k == key, j < i] =
        wrong line (Problem path ("a second '" ++ shorten key ++ "'") ("possible; the first one is in line " ++ show first))
      | null above && key == presetKey = leaf path line (ChoiceKind "a preset" [(n, "") | n <- presetNames]) value
      | Just f <- findField path = leaf (fieldPath f) line (fieldKind f) value
      | key `elem` children = level [] (key : above) value
      | otherwise = wrong line (Problem path ("'" ++ shorten key ++ "'") (unknown key))
      where
        path = pathOf (shorten key : above)
        leaf current at kind v = case readNode kind v of
          Right ok -> ([(at, current, ok)], [])
          Left expected -> wrong (nodeLine v) (Problem path (nodeText v) expected)
    wrong line problem = ([], [(line, problem)])
    unknown key =
      "a setting"
        ++ (if null above then "" else " of " ++ pathOf above)
        ++ hint key
    hint key = case (nearest key children, elsewhere key) of
      (Just name, _) -> " (did you mean " ++ name ++ "?)"
      (Nothing, path : _) -> " (did you mean " ++ path ++ "?)"
      _ -> "; there are: " ++ intercalate ", " children
    elsewhere key = [fieldPath f | f <- sceneFields, ('.' : key) `isSuffixOf` fieldPath f || optionName' f == Just key]
    optionName' f = drop 2 . optionName <$> fieldOption f

pathOf :: [String] -> String
pathOf = intercalate "." . reverse

pathOr :: String -> [String] -> String
pathOr whole' above = if null above then whole' else pathOf above

-- | The keys that there may be below a path.
childrenOf :: [String] -> [String]
childrenOf above = (if null above then presetKey : otherSections else []) ++ nub (mapMaybe (fmap (takeWhile (/= '.')) . below) sceneFields)
  where
    below f = if null above then Just (fieldPath f) else stripPrefix (pathOf above ++ ".") (fieldPath f)

-- | A value of a kind from a node, or what it should have been.
readNode :: Kind -> Node -> Either String Value
readNode VectorKind node = case node of
  Sequence _ items | Just [x, y, z] <- traverse coordinate items -> Right (VectorValue (XYZ x y z))
  _ -> Left "[X, Y, Z], three numbers in square brackets"
  where
    coordinate (Scalar _ True text) = yamlNumber text
    coordinate _ = Nothing
readNode kind node = case (kind, node) of
  (ChoiceKind _ _, Scalar _ _ text) -> readValue kind text
  (ChoiceOrFileKind {}, Scalar _ _ text) -> readValue kind text
  (NumberKind _, Scalar _ True text) | Just v <- yamlNumber text -> Right (NumberValue v)
  (_, Scalar _ True text) -> readValue kind text
  _ -> Left (expectation kind "")

-- | YAML has its own words for what is no number.
yamlNumber :: String -> Maybe Double
yamlNumber text = case text of
  ".nan" -> Just (0 / 0)
  ".inf" -> Just (1 / 0)
  "-.inf" -> Just (-1 / 0)
  _ -> readNumber text

-- | A node as a message names it.
nodeText :: Node -> String
nodeText node = case node of
  Scalar _ _ "" -> "nothing"
  Scalar _ True text -> "'" ++ shorten text ++ "'"
  Scalar _ False text -> "the text '" ++ shorten text ++ "'"
  Sequence _ _ -> "a list"
  Mapping _ _ -> "a group"

-- | One line of moderate length of any text.
shorten :: String -> String
shorten text = case splitAt 60 (map (\c -> if c < ' ' then ' ' else c) text) of
  (start, []) -> start
  (start, _) -> start ++ "…"

-- | The whole scene as commented YAML, which reads as the same scene. The first
-- lines are comments, made of the given ones.
printScene :: [String] -> Scene -> String
printScene heading scene = unlines (map ("# " ++) heading ++ go [] entries)
  where
    entries = [(f, value) | f <- sceneFields, Just value <- [fieldGet f scene]]
    go _ [] = []
    go open ((f, value) : rest) =
      let parts = splitOn '.' (fieldPath f)
          groups = take (length parts - 1) parts
          shared = length (takeWhile id (zipWith (==) open groups))
          opened = [indent depth ++ name ++ ":" | (depth, name) <- drop shared (zip [0 ..] groups)]
          deep = indent (length groups)
       in ["" | shared == 0]
            ++ opened
            ++ [deep ++ "# " ++ fieldDoc f, deep ++ foldr const "" (reverse parts) ++ ": " ++ yamlValue value]
            ++ go groups rest
    indent depth = replicate (2 * depth) ' '

yamlValue :: Value -> String
yamlValue value = case value of
  NumberValue v -> exactNumber v
  WholeValue n -> show n
  SeedValue n -> show n
  SwitchValue b -> if b then "true" else "false"
  NameValue name -> name
  FileValue file -> quoted file
  VectorValue (XYZ x y z) -> "[" ++ intercalate ", " (map exactNumber [x, y, z]) ++ "]"

-- | Any text without control characters, in the quotes in which only they
-- themselves mean anything.
quoted :: String -> String
quoted text = "'" ++ concatMap (\c -> if c == '\'' then "''" else [c]) text ++ "'"
