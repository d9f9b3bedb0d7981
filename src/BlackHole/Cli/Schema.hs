-- | The JSON Schema of scene files, from the table of fields.
module BlackHole.Cli.Schema
  ( sceneSchema,
  )
where

import BlackHole.Cli.Json
import BlackHole.Scene.Field.Field
import BlackHole.Scene.Field.Kind
import BlackHole.Scene.Field.Number (splitOn)
import BlackHole.Scene.Field.Table
import BlackHole.Scene.Preset (presetNames)
import Data.List (nub)

-- | JSON Schema, draft 7, which is what editors understand.
sceneSchema :: Json
sceneSchema =
  Object $
    [ ("$schema", Text "http://json-schema.org/draft-07/schema#"),
      ("title", Text "A scene of blackhole")
    ]
      ++ group [("preset", presetSchema)] [(splitOn '.' (fieldPath f), f) | f <- sceneFields]
  where
    presetSchema =
      Object
        [ ("description", Text "Scene to start from"),
          ("enum", List (map Text presetNames))
        ]

-- Fields by what is left of their paths.
group :: [(String, Json)] -> [([String], Field)] -> [(String, Json)]
group first fields =
  [ ("type", Text "object"),
    ("additionalProperties", Truth False),
    ("properties", Object (first ++ map property names))
  ]
  where
    names = nub [name | (name : _, _) <- fields]
    property name = case [(rest, f) | (key : rest, f) <- fields, key == name] of
      [([], f)] -> (name, fieldSchema f)
      below -> (name, Object (group [] below))

fieldSchema :: Field -> Json
fieldSchema f = Object (("description", Text (fieldDoc f)) : kind)
  where
    kind = case fieldKind f of
      NumberKind quantity -> ("type", Text "number") : least (quantityLeast quantity) ++ most (quantityMost quantity)
      WholeKind low high _ -> [("type", Text "integer"), ("minimum", Whole low), ("maximum", Whole high)]
      SeedKind -> [("type", Text "integer"), ("minimum", Whole 0), ("exclusiveMaximum", Number 18446744073709551616)]
      SwitchKind -> [("enum", List ([Truth True, Truth False] ++ map Text ["on", "off", "yes", "no"]))]
      ChoiceKind _ choices -> [("enum", List (map (Text . fst) choices))]
      VectorKind -> [("type", Text "array"), ("items", Object [("type", Text "number")]), ("minItems", Whole 3), ("maxItems", Whole 3)]
    least end = case end of
      Anything -> []
      From v -> [("minimum", Number v)]
      Above v -> [("exclusiveMinimum", Number v)]
    most end = case end of
      Endless -> []
      UpTo v -> [("maximum", Number v)]
      Below v -> [("exclusiveMaximum", Number v)]
