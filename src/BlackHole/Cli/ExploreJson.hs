-- | What the page of @blackhole explore@ receives, as JSON.
module BlackHole.Cli.ExploreJson
  ( replyJson,
    tableJson,
  )
where

import BlackHole.Cli.Explain (explanationLines)
import BlackHole.Cli.Json
import BlackHole.Explore.CommandLine
import BlackHole.Explore.Message (valueText)
import BlackHole.Explore.Reply
import BlackHole.Explore.Slider
import BlackHole.Explore.Timeline (interpolations)
import BlackHole.Image.Coding (formatExtensions)
import BlackHole.Image.Metadata (software)
import BlackHole.Scene.Camera
import BlackHole.Scene.Disk
import BlackHole.Scene.Field.Condition
import BlackHole.Scene.Field.Field
import BlackHole.Scene.Field.Kind
import BlackHole.Scene.Field.Number (splitOn)
import BlackHole.Scene.Field.Table
import BlackHole.Scene.Preset
import BlackHole.Scene.Scene
import BlackHole.Spacetime.Kerr.Landmarks (horizonRadius)
import BlackHole.Spacetime.Types (Spacetime (..))
import BlackHole.Trace.Explain (Explanation (explainedPixel))
import BlackHole.Vector.XYZ (XYZ (..))

-- | A reply. The member @type@ names its kind.
replyJson :: Reply -> Json
replyJson reply = case reply of
  SceneIs input preset scene ->
    kind
      "scene"
      [ ("input", Whole input),
        ("preset", Text preset),
        ("values", valuesJson scene),
        ( "idle",
          Object
            [ (fieldPath f, Text (needed condition))
              | f <- sceneFields,
                Just condition <- [unmetCondition scene (fieldPath f)]
            ]
        )
      ]
  Refused input problems ->
    kind "refused" [("input", maybe Null Whole input), ("lines", texts problems)]
  PixelIs scene explanation path ->
    let (x, y) = explainedPixel explanation
     in kind
          "pixel"
          [ ("x", Whole x),
            ("y", Whole y),
            ("lines", texts (explanationLines scene explanation)),
            ("path", List (map place path)),
            ("camera", place (posePosition (cameraPose (sceneCamera scene)))),
            ("horizon", Number (horizon (sceneSpacetime scene))),
            ("disk", maybe Null diskShape (sceneDisk scene))
          ]
  CommandIs (Options arguments) ->
    kind "command" [("command", Text (unwords ("blackhole render" : map shellWord arguments)))]
  CommandIs (NeedsFile paths) -> kind "command" [("command", Null), ("settings", texts paths)]
  Saved name -> kind "saved" [("file", Text name)]
  Exists name -> kind "exists" [("file", Text name)]
  AnimationIs (Left problems) -> kind "animation" [("problems", texts problems), ("fixed", List [])]
  AnimationIs (Right fixed) -> kind "animation" [("problems", List []), ("fixed", texts fixed)]
  JobIs job -> kind "job" $ case job of
    NoJob -> [("state", Text "none")]
    JobRuns name done -> [("state", Text "runs"), ("file", Text name), ("done", Number done)]
    JobDone name seconds ->
      [("state", Text "done"), ("file", Text name), ("seconds", Number seconds)]
    JobStopped name -> [("state", Text "stopped"), ("file", Text name)]
    JobFailed name problem ->
      [("state", Text "failed"), ("file", Text name), ("problem", Text problem)]
  where
    kind name members = Object (("type", Text name) : members)
    texts = List . map Text
    place (XYZ x y z) = List [Number x, Number y, Number z]
    needed condition = conditionPath condition ++ " " ++ conditionNeeds condition
    horizon space = case space of
      Kerr hole -> horizonRadius hole
      _ -> 1
    diskShape disk =
      Object
        [ ("inner", Number (diskInnerRadius disk)),
          ("outer", Number (diskOuterRadius disk)),
          ( "thickness",
            List
              [Number (diskThicknessAt disk r) | r <- [diskInnerRadius disk, diskOuterRadius disk]]
          )
        ]

-- | What does not change: every setting with its topic, kind, range, slider and
-- documentation, the presets, and the choices of the animation and of file formats.
tableJson :: Json
tableJson =
  Object
    [ ("software", Text software),
      ("topics", List [Text (topicName topic) | topic <- [minBound .. maxBound]]),
      ("settings", List (map settingJson sceneFields)),
      ( "presets",
        List
          [ Object
              [ ("name", Text (presetName p)),
                ("shows", Text (presetShows p)),
                ("values", valuesJson (presetScene p))
              ]
            | p <- describedPresets
          ]
      ),
      ("interpolations", List [Text name | (name, _) <- interpolations]),
      ("extensions", List [Text extension | (extension, _) <- formatExtensions])
    ]

-- | The values of a scene by path, as text.
valuesJson :: Scene -> Json
valuesJson scene =
  Object [(fieldPath f, Text (valueText v)) | f <- sceneFields, Just v <- [fieldGet f scene]]

settingJson :: Field -> Json
settingJson f =
  Object $
    [ ("path", Text (fieldPath f)),
      ("topic", Text (topicName (fieldTopic f))),
      ("name", Text (settingName f)),
      ("doc", Text (fieldDoc f)),
      ("option", maybe Null (Text . optionName) (fieldOption f))
    ]
      ++ kindMembers (fieldKind f)
      ++ maybe [] (\s -> [("slider", sliderJson s)]) (slider f)

-- | The words of a path behind its group: @noise frequency@ of
-- @disk.arms.noise-frequency@, with @arms@ before it.
settingName :: Field -> String
settingName f =
  map (\c -> if c == '-' then ' ' else c) (unwords (drop 1 (splitOn '.' (fieldPath f))))

kindMembers :: Kind -> [(String, Json)]
kindMembers kind = case kind of
  NumberKind quantity ->
    [("kind", Text "number"), ("unit", Text (quantityUnit quantity))]
      ++ least (quantityLeast quantity)
      ++ most (quantityMost quantity)
  WholeKind low high unit ->
    [("kind", Text "whole"), ("unit", Text unit), ("least", Whole low), ("most", Whole high)]
  SeedKind -> [("kind", Text "seed")]
  SwitchKind -> [("kind", Text "switch")]
  ChoiceKind _ choices -> [("kind", Text "choice"), ("choices", choicesJson choices)]
  ChoiceOrFileKind _ choices file ->
    [("kind", Text "choice-or-file"), ("choices", choicesJson choices), ("file", Text file)]
  VectorKind -> [("kind", Text "vector")]
  where
    choicesJson choices =
      List [Object [("name", Text name), ("meaning", Text meaning)] | (name, meaning) <- choices]
    least end = case end of
      Anything -> []
      From v -> [("least", Number v)]
      Above v -> [("least", Number v), ("above", Truth True)]
    most end = case end of
      Endless -> []
      UpTo v -> [("most", Number v)]
      Below v -> [("most", Number v), ("below", Truth True)]

sliderJson :: Slider -> Json
sliderJson (Straight low high) =
  Object
    [("scale", Text "linear"), ("low", Number low), ("high", Number high), ("zero", Truth False)]
sliderJson (Logarithmic low high zero) =
  Object [("scale", Text "log"), ("low", Number low), ("high", Number high), ("zero", Truth zero)]
