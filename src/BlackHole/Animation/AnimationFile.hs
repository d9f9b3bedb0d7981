-- | The section @animation@ of a scene file, which makes an animation of a scene, read by
-- the tables of its keys ("BlackHole.Animation.AnimationKeys").
module BlackHole.Animation.AnimationFile
  ( readAnimation,
    isTrackable,
  )
where

import BlackHole.Animation.Animation
import BlackHole.Animation.AnimationKeys
import BlackHole.Animation.CameraPath
import BlackHole.Animation.Interpolate
import BlackHole.Scene.Field.Field
import BlackHole.Scene.Field.Kind
import BlackHole.Scene.Field.Number
import BlackHole.Scene.Field.Table
import BlackHole.Scene.File.SceneFile (nodeText, readNode)
import BlackHole.Scene.File.Yaml
import BlackHole.Scene.Problem
import BlackHole.Scene.Scene
import BlackHole.Vector.XYZ (XYZ (..))
import Control.Applicative ((<|>))
import Data.List (find, intercalate, sortOn)
import Data.Maybe (fromMaybe, isJust, mapMaybe)

-- | Whether a setting can have keyframes: all numbers and vectors except the picture's
-- size.
isTrackable :: Field -> Bool
isTrackable field =
  takeWhile (/= '.') (fieldPath field) /= "image"
    && isJust (trackValue (fieldKind field) (fieldValues field))
  where
    fieldValues f = case fieldKind f of
      VectorKind -> [0, 0, 0]
      _ -> [0]

-- | The value of a setting from numbers, rounded if it must be whole.
trackValue :: Kind -> [Double] -> Maybe Value
trackValue kind values = case (kind, values) of
  (NumberKind _, [v]) -> Just (NumberValue v)
  (WholeKind {}, [v]) | abs v < 1e15 -> Just (WholeValue (round v))
  (VectorKind, [x, y, z]) -> Just (VectorValue (XYZ x y z))
  _ -> Nothing

type Faults = [(Int, Problem)]

-- | The section of a file, given its root: the animation of a scene, and the problems of the
-- section with their lines. 'Nothing' if there is no such section.
readAnimation :: Node -> Maybe (Scene -> Animation, [(Int, Problem)])
readAnimation root = case root of
  Mapping _ members -> case [(at, value) | (at, key, value) <- members, key == animationKey] of
    [] -> Nothing
    [(_, section)] -> Just (readSection section)
    _ : (second, _) : _ -> Just (stillAnimation, [(second, Mistake animationKey "given twice")])
  _ -> Nothing

readSection :: Node -> (Scene -> Animation, Faults)
readSection section = (animation, faults)
  where
    (values, others, formFaults) =
      entriesOf [animationKey] animationKeys ["camera-path", "keyframes"] section
    (path, pathFaults) = maybe (Nothing, []) readPath (lookup "camera-path" others)
    (tracks, trackFaults) = maybe ([], []) readTracks (lookup "keyframes" others)
    faults = formFaults ++ lengthFaults ++ shutterFaults ++ pathFaults ++ trackFaults ++ clashes
    shutterFaults =
      [ ( line,
          Mistake (within "shutter-samples") "has no effect; it applies only with a shutter above 0"
        )
        | maybe True (<= 0) (numberOf "shutter"),
          Just (line, _) <- [value "shutter-samples"]
      ]
    lengthFaults = case (value "frames", value "duration") of
      (Just _, Just (line, _)) ->
        [(line, Mistake (within "duration") "cannot be combined with frames")]
      (Nothing, Nothing)
        | null formFaults ->
          [(nodeLine section, Mistake animationKey "needs frames or duration")]
      _ -> []
    clashes =
      [ ( nodeLine section,
          Mistake
            (within ("keyframes." ++ trackField track))
            ( "cannot be combined with the camera path " ++ cameraPathName p
                ++ ", which determines the position of the camera"
            )
        )
        | Just p <- [path],
          isGeodesic p,
          track <- tracks,
          trackField track `elem` ["camera.distance", "camera.position"]
      ]
    isGeodesic p = case p of
      FreeFall _ -> True
      CircularOrbit _ -> True
      _ -> False
    value name = lookup name values
    numberOf name = value name >>= asNumber . snd
    wholeOf name = value name >>= asWhole . snd
    rate = fromMaybe 24 (numberOf "fps")
    animation scene =
      Animation
        { animationScene = scene,
          animationFrames =
            fromMaybe
              48
              (wholeOf "frames" <|> fmap (\d -> max 1 (round (d * rate))) (numberOf "duration")),
          animationRate = rate,
          animationTracks = tracks,
          animationPath = path,
          animationShutter =
            Shutter (fromMaybe 0 (numberOf "shutter")) (fromMaybe 8 (wholeOf "shutter-samples"))
        }

readPath :: Node -> (Maybe CameraPath, Faults)
readPath node = case value "kind" of
  Just (_, NameValue kind) ->
    (if null missing then build kind else Nothing, formFaults ++ surplus kind ++ missing ++ both)
    where
      missing =
        [ (nodeLine node, Mistake pathLabel ("a path of the kind " ++ kind ++ " needs " ++ wanted))
          | wanted <- lacking kind
        ]
  _ ->
    ( Nothing,
      formFaults
        ++ [ ( nodeLine node,
               Mistake
                 pathLabel
                 ("needs a kind: " ++ intercalate ", " [kind | (kind, _, _) <- pathKinds])
             )
             | null formFaults
           ]
    )
  where
    (values, _, formFaults) = entriesOf [animationKey, "camera-path"] cameraPathKeys [] node
    pathLabel = within "camera-path"
    value name = lookup name values
    surplus kind =
      [ ( line,
          Mistake
            (pathLabel ++ "." ++ name)
            ("not a key of the kind " ++ kind ++ "; its keys are: " ++ intercalate ", " allowed)
        )
        | (name, (line, _)) <- values,
          (known, _, allowed) <- pathKinds,
          known == kind,
          name `notElem` ("kind" : allowed)
      ]
    both =
      [ (line, Mistake pathLabel "end-distance and rate exclude each other")
        | Just _ <- [value "rate"],
          Just (line, _) <- [value "end-distance"]
      ]
    lacking kind = case kind of
      "dolly" -> ["to" | Nothing <- [value "to"]]
      "free-fall" -> case (value "end-distance", value "rate") of
        (Nothing, Nothing) -> ["end-distance or rate"]
        _ -> []
      "circular-orbit" -> ["rate" | Nothing <- [value "rate"]]
      _ -> []
    numberOf name = value name >>= asNumber . snd
    vectorOf name = case value name of
      Just (_, VectorValue v) -> Just v
      _ -> Nothing
    way = case value "interpolation" of
      Just (_, NameValue "eased") -> Eased
      _ -> Linear
    build kind = case kind of
      "orbit" ->
        Just (Orbit (fromMaybe (XYZ 0 1 0) (vectorOf "axis")) (fromMaybe 1 (numberOf "turns")) way)
      "dolly" -> (\place -> Dolly place (vectorOf "look-at") way) <$> vectorOf "to"
      "free-fall" ->
        FreeFall
          <$> ((ProperTimePerSecond <$> numberOf "rate") <|> (FallsTo <$> numberOf "end-distance"))
      "circular-orbit" -> CircularOrbit <$> numberOf "rate"
      _ -> Nothing

readTracks :: Node -> ([Track], Faults)
readTracks node = case node of
  Mapping _ members -> (mapMaybe fst found, concatMap snd found)
    where
      found = zipWith track [0 :: Int ..] members
      track i (line, path, keys)
        | path `elem` [p | (j, (_, p, _)) <- zip [0 ..] members, j < i] =
          (Nothing, [(line, Mistake label "given twice")])
        | otherwise = case findField (currentPath path) of
          Just field
            | isTrackable field -> readTrack label field keys
            | otherwise ->
              ( Nothing,
                [ ( line,
                    Mistake
                      label
                      "cannot have keyframes; only numbers \
                      \and vectors can, except the picture's size"
                  )
                ]
              )
          Nothing ->
            ( Nothing,
              [(line, Problem label ("'" ++ path ++ "'") ("a setting of a scene" ++ hint path))]
            )
        where
          label = within ("keyframes." ++ path)
  _ ->
    ( [],
      [ ( nodeLine node,
          Problem
            (within "keyframes")
            (nodeText node)
            "a group of settings, each with times and values"
        )
      ]
    )
  where
    names = map fieldPath (filter isTrackable sceneFields)
    hint path = case suggestion path names of
      "" -> "; blackhole scene show default lists all settings"
      text -> text

readTrack :: String -> Field -> Node -> (Maybe Track, Faults)
readTrack label field node = case node of
  Mapping line members
    | not (null faults) -> (Nothing, faults)
    | otherwise -> case makeKeys (unwrapped [(time, numbers v) | (time, v) <- sortOn fst keys]) of
      Right good -> (Just (Track (fieldPath field) setField way good), [])
      Left problem -> (Nothing, [(line, Mistake label (renderKeysProblem problem))])
    where
      (options, _, formFaults) = entriesWith isTime [label] keyframeKeys [] node
      isTime = isJust . readNumber
      found = [(at, text, value) | (at, text, value) <- members, isTime text]
      faults =
        formFaults ++ concat [either pure (const []) (keyOf m) | m <- found] ++ twice ++ turnFaults
      twice =
        [ (at, Mistake (label ++ "." ++ text) "given twice")
          | (i, (at, text, _)) <- zip [0 :: Int ..] found,
            readNumber text
              `elem` [readNumber earlier | (j, (_, earlier, _)) <- zip [0 ..] found, j < i]
        ]
      keys = [key | m <- found, Right key <- [keyOf m]]
      way = case lookup "interpolation" options of
        Just (_, NameValue name) ->
          fromMaybe Linear (find ((== name) . interpolationName) [minBound ..])
        _ -> Linear
      short = case lookup "shortest-turn" options of
        Just (_, SwitchValue on) -> on
        _ -> False
      turnFaults =
        [ (at, Mistake label "shortest-turn applies only to angles in degrees")
          | short,
            not inDegrees,
            Just (at, _) <- [lookup "shortest-turn" options]
        ]
      unwrapped list
        | short = zip (map fst list) (map pure (unwrapDegrees (concatMap snd list)))
        | otherwise = list
  _ ->
    ( Nothing,
      [ ( nodeLine node,
          Problem
            label
            (nodeText node)
            "a group of times in seconds with values, such as {0: 30, 1.5: 20}"
        )
      ]
    )
  where
    inDegrees = case fieldKind field of
      NumberKind quantity -> take 7 (quantityUnit quantity) == "degrees"
      _ -> False
    keyOf (at, text, value) = case (readNumber text, readNode (fieldKind field) value) of
      (Just time, Right v) -> case rangeFault (fieldKind field) v of
        Nothing -> Right (time, v)
        Just range -> Left (at, Problem (label ++ "." ++ text) (showValue v) range)
      (_, Left expected) ->
        Left (nodeLine value, Problem (label ++ "." ++ text) (nodeText value) expected)
      (Nothing, _) -> Left (at, Problem label ("'" ++ text ++ "'") "a time in seconds")
    numbers v = case v of
      NumberValue x -> [x]
      WholeValue n -> [fromIntegral n]
      VectorValue (XYZ x y z) -> [x, y, z]
      _ -> []
    setField values scene = case (fieldGet field scene, trackValue (fieldKind field) values) of
      (Just _, Just value) -> Right (fieldSet field value scene)
      (Nothing, _) -> Left (Mistake label "has no effect, because the scene has no such value")
      (_, Nothing) -> Left (Problem label (show values) "a value of this setting")

within :: String -> String
within name = animationKey ++ "." ++ name

-- | The members of a group: values of known keys with their lines, the nodes of the
-- groups inside it, and the problems of the other members.
entriesOf ::
  [String] ->
  [AnimationKey] ->
  [String] ->
  Node ->
  ([(String, (Int, Value))], [(String, Node)], Faults)
entriesOf = entriesWith (const False)

-- | The same, without the keys that satisfy a predicate.
entriesWith ::
  (String -> Bool) ->
  [String] ->
  [AnimationKey] ->
  [String] ->
  Node ->
  ([(String, (Int, Value))], [(String, Node)], Faults)
entriesWith skipped above entries groups node = case node of
  Mapping _ members -> foldMap (member members) (zip [0 :: Int ..] members)
  _ ->
    ( [],
      [],
      [ ( nodeLine node,
          Problem
            (intercalate "." above)
            (nodeText node)
            ("a group of settings; the settings here are: " ++ intercalate ", " names)
        )
      ]
    )
  where
    names = map keyName entries ++ groups
    member members (i, (line, key, value))
      | skipped key = ([], [], [])
      | key `elem` [k | (j, (_, k, _)) <- zip [0 ..] members, j < i] =
        ([], [], [(line, Mistake (intercalate "." (above ++ [key])) "given twice")])
      | key `elem` groups = ([], [(key, value)], [])
      | Just entry <- find ((== key) . keyName) entries = case readNode (keyKind entry) value of
        Left expected -> wrong (nodeLine value) (nodeText value) expected
        Right v -> case rangeFault (keyKind entry) v of
          Nothing -> ([(key, (line, v))], [], [])
          Just range -> wrong line (showValue v) range
      | otherwise =
        wrong
          line
          ("'" ++ key ++ "'")
          ( "a key of " ++ intercalate "." above ++ suggestion key names ++ "; its keys are: "
              ++ intercalate ", " names
          )
      where
        wrong at text range =
          ([], [], [(at, Problem (intercalate "." (above ++ [key])) text range)])

asNumber :: Value -> Maybe Double
asNumber value = case value of
  NumberValue v -> Just v
  WholeValue n -> Just (fromIntegral n)
  _ -> Nothing

asWhole :: Value -> Maybe Int
asWhole value = case value of
  WholeValue n -> Just n
  _ -> Nothing
