-- | The JSON Schema of scene files, from the tables of settings and of the section
-- @animation@.
module BlackHole.Cli.Schema
  ( sceneSchema,
  )
where

import BlackHole.Animation.AnimationFile
import BlackHole.Animation.AnimationKeys
import BlackHole.Cli.Json
import BlackHole.Scene.Field.Field
import BlackHole.Scene.Field.Kind
import BlackHole.Scene.Field.Number (splitOn)
import BlackHole.Scene.Field.Table
import BlackHole.Scene.Preset (presetNames)
import Data.List (nub)

-- | The schema in draft 7, which most editors support. It has no former names.
sceneSchema :: Json
sceneSchema =
  Object $
    [ ("$schema", Text "http://json-schema.org/draft-07/schema#"),
      ("title", Text "blackhole scene file")
    ]
      ++ group
        [("preset", presetSchema), (animationKey, animationSchema)]
        [(splitOn '.' (fieldPath f), f) | f <- sceneFields]
  where
    presetSchema =
      Object
        [ ("description", Text "Preset to start from"),
          ("enum", List (map Text presetNames))
        ]

-- Settings by the rest of their paths.
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
fieldSchema f = valueSchema (fieldDoc f) (fieldKind f)

-- The section @animation@.
animationSchema :: Json
animationSchema =
  Object
    [ ("description", Text "Animation for blackhole animate: what changes from frame to frame"),
      ("type", Text "object"),
      ("additionalProperties", Truth False),
      ( "properties",
        Object
          (map entry animationKeys ++ [("camera-path", pathSchema), ("keyframes", keyframesSchema)])
      )
    ]
  where
    entry e = (keyName e, valueSchema (keyDoc e) (keyKind e))
    pathSchema =
      Object
        [ ( "description",
            Text "Movement of the camera, starting from where the scene and the keyframes put it"
          ),
          ("oneOf", List (map pathKindSchema pathKinds))
        ]
    pathKindSchema (kind, doc, names) =
      Object
        [ ("title", Text (kind ++ ": " ++ doc)),
          ("type", Text "object"),
          ("additionalProperties", Truth False),
          ("required", List [Text "kind"]),
          ( "properties",
            Object
              ( ("kind", Object [("const", Text kind)]) :
                  [ entry e
                    | e <- cameraPathKeys,
                      keyName e `elem` names
                  ]
              )
          )
        ]
    keyframesSchema =
      Object
        [ ("description", Text "Settings with their values at times in seconds"),
          ("type", Text "object"),
          ("additionalProperties", Truth False),
          ("properties", Object [(fieldPath f, trackSchema f) | f <- sceneFields, isTrackable f])
        ]
    trackSchema f =
      Object
        [ ("description", Text (fieldDoc f)),
          ("type", Text "object"),
          ("additionalProperties", Truth False),
          ("properties", Object (map entry keyframeKeys)),
          ("patternProperties", Object [("^[-+]?[0-9.]+([eE][-+]?[0-9]+)?$", fieldSchema f)])
        ]

valueSchema :: String -> Kind -> Json
valueSchema doc kind = Object (("description", Text doc) : ofKind)
  where
    ofKind = case kind of
      NumberKind quantity ->
        ("type", Text "number") :
        least (quantityLeast quantity)
          ++ most (quantityMost quantity)
      WholeKind low high _ ->
        [("type", Text "integer"), ("minimum", Whole low), ("maximum", Whole high)]
      SeedKind ->
        [ ("type", Text "integer"),
          ("minimum", Whole 0),
          ("exclusiveMaximum", Number 18446744073709551616)
        ]
      SwitchKind ->
        [("enum", List ([Truth True, Truth False] ++ map Text ["on", "off", "yes", "no"]))]
      ChoiceKind _ choices -> [("enum", List (map (Text . fst) choices))]
      -- A period or slash distinguishes the name of a file from a choice.
      ChoiceOrFileKind _ choices _ ->
        [ ( "anyOf",
            List
              [ Object [("enum", List (map (Text . fst) choices))],
                Object
                  [("type", Text "string"), ("pattern", Text "[./]"), ("maxLength", Whole 1024)]
              ]
          )
        ]
      VectorKind ->
        [ ("type", Text "array"),
          ("items", Object [("type", Text "number")]),
          ("minItems", Whole 3),
          ("maxItems", Whole 3)
        ]
    least end = case end of
      Anything -> []
      From v -> [("minimum", Number v)]
      Above v -> [("exclusiveMinimum", Number v)]
    most end = case end of
      Endless -> []
      UpTo v -> [("maximum", Number v)]
      Below v -> [("exclusiveMaximum", Number v)]
