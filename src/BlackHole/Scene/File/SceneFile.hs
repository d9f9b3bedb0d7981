-- | Scene files: from YAML to settings, and from a scene back to commented YAML.
module BlackHole.Scene.File.SceneFile
  ( SceneFile (..),
    PlacedSetting (..),
    FormerName (..),
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
import Data.List (intercalate, isPrefixOf, isSuffixOf, nub, stripPrefix)
import Data.Maybe (mapMaybe)

-- | The contents of a scene file.
data SceneFile = SceneFile
  { -- | The name of the preset that it starts from; @default@ if it names none.
    filePreset :: !String,
    fileSettings :: ![PlacedSetting],
    -- | Settings that the file calls by former names.
    fileFormerNames :: ![FormerName]
  }
  deriving (Eq, Show)

-- | The line, the former path that the file uses, and the present one.
data FormerName = FormerName !Int !String !String
  deriving (Eq, Show)

-- | A setting and its line in the file, from 1.
data PlacedSetting = PlacedSetting
  { placedLine :: !Int,
    placedSetting :: !Setting
  }
  deriving (Eq, Show)

-- | The contents of a file, given its bytes, and with their lines the problems of
-- keys and values that could not be read. 'Left' if the file is not YAML.
parseSceneFile :: Bytes.ByteString -> Either YamlFault (SceneFile, [(Int, Problem)])
parseSceneFile bytes = do
  tree <- parseYaml bytes
  case tree of
    Just root -> Right (readSettings otherSections root)
    Nothing -> Left (YamlFault 1 "the file is empty")

-- | The contents of a tree, without the sections (top-level keys) named in the first
-- argument.
readSettings :: [String] -> Node -> (SceneFile, [(Int, Problem)])
readSettings sections root = (SceneFile preset settings former, problems)
  where
    (found, problems) = level sections [] root
    settings =
      [ PlacedSetting line (Setting (currentPath path) (current path value))
        | (line, path, value) <- found,
          path /= presetKey
      ]
    former =
      [FormerName line path (currentPath path) | (line, path, _) <- found, currentPath path /= path]
    -- Before there were real stars, these were the random ones.
    current path value
      | path == "sky.kind" && value == NameValue "stars"
          && any (\(_, other, _) -> "sky.points." `isPrefixOf` other) found =
        NameValue "random-stars"
      | otherwise = value
    preset = case [name | (_, path, NameValue name) <- found, path == presetKey] of
      name : _ -> name
      [] -> "default"

presetKey :: String
presetKey = "preset"

-- | Sections (top-level keys) that do not belong to the scene of a single picture.
otherSections :: [String]
otherSections = ["animation"]

type Found = ([(Int, String, Value)], [(Int, Problem)])

-- | The settings below a path (its last part first), each with its line and the path
-- as it is written in the file.
level :: [String] -> [String] -> Node -> Found
level sections above node = case node of
  -- The search for repeated keys takes time quadratic in their number.
  Mapping line members
    | length (take 501 members) > 500 ->
      wrong line (Mistake (pathOr "scene" above) "a group of settings can have at most 500 keys")
  Mapping _ members -> foldMap (member members) (zip [0 :: Int ..] members)
  _ ->
    ( [],
      [ ( nodeLine node,
          Problem
            (pathOr "scene" above)
            (nodeText node)
            ("a group of settings; the settings here are: " ++ intercalate ", " children)
        )
      ]
    )
  where
    children = childrenOf above
    member members (i, (line, key, value))
      | null above && key `elem` sections = mempty
      | (first, _, _) : _ <- [m | (j, m@(_, k, _)) <- zip [0 ..] members, k == key, j < i] =
        wrong line (Mistake path ("given twice; the first one is in line " ++ show first))
      | null above && key == presetKey =
        leaf line (ChoiceKind "a preset" [(n, "") | n <- presetNames]) value
      | Just f <- findField (currentPath path) = leaf line (fieldKind f) value
      | key `elem` children || any (((path ++ ".") `isPrefixOf`) . fst) formerPaths =
        level [] (key : above) value
      | otherwise = wrong line (Problem path ("'" ++ shorten key ++ "'") (unknown key))
      where
        path = pathOf (shorten key : above)
        leaf at kind v = case readNode kind v of
          Right ok -> ([(at, path, ok)], [])
          Left expected -> wrong (nodeLine v) (Problem path (nodeText v) expected)
    wrong line problem = ([], [(line, problem)])
    unknown key =
      "a setting"
        ++ (if null above then "" else " of " ++ pathOf above)
        ++ hint key
    hint key = case (nearest key children, elsewhere key) of
      (Just name, _) -> " (did you mean " ++ name ++ "?)"
      (Nothing, path : _) -> " (did you mean " ++ path ++ "?)"
      _ -> if null children then "" else "; the settings here are: " ++ intercalate ", " children
    elsewhere key =
      [ fieldPath f | f <- sceneFields, ('.' : key) `isSuffixOf` fieldPath f
                                          || optionName' f == Just key
      ]
    optionName' f = drop 2 . optionName <$> fieldOption f

pathOf :: [String] -> String
pathOf = intercalate "." . reverse

pathOr :: String -> [String] -> String
pathOr whole' above = if null above then whole' else pathOf above

-- | The keys that are allowed below a path.
childrenOf :: [String] -> [String]
childrenOf above =
  (if null above then presetKey : otherSections else [])
    ++ nub (mapMaybe (fmap (takeWhile (/= '.')) . below) sceneFields)
  where
    below f =
      if null above then Just (fieldPath f) else stripPrefix (pathOf above ++ ".") (fieldPath f)

-- | The value of a node of a kind, or what it should have been, as a noun phrase.
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

-- YAML spells infinity and NaN in its own way.
yamlNumber :: String -> Maybe Double
yamlNumber text = case text of
  ".nan" -> Just (0 / 0)
  ".inf" -> Just (1 / 0)
  "-.inf" -> Just (-1 / 0)
  _ -> readNumber text

-- | What messages call a node.
nodeText :: Node -> String
nodeText node = case node of
  Scalar _ _ "" -> "an empty value"
  Scalar _ True text -> "'" ++ shorten text ++ "'"
  Scalar _ False text -> "the text '" ++ shorten text ++ "'"
  Sequence _ _ -> "a list"
  Mapping _ _ -> "a group"

-- | A text as one line of at most 61 characters.
shorten :: String -> String
shorten text = case splitAt 60 (map (\c -> if c < ' ' then ' ' else c) text) of
  (start, []) -> start
  (start, _) -> start ++ "…"

-- | The whole scene as commented YAML, which reads as the same scene. It begins with
-- the given lines as comments.
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
            ++ [ deep ++ "# " ++ fieldDoc f,
                 deep ++ foldr const "" (reverse parts) ++ ": " ++ yamlValue value
               ]
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

-- | A text without control characters as a YAML string in single quotes.
quoted :: String -> String
quoted text = "'" ++ concatMap (\c -> if c == '\'' then "''" else [c]) text ++ "'"
