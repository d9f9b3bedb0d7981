-- | The section @animation@ of a scene file: what changes from frame to frame.
--
-- One table of keys says what there is; the reader and the JSON Schema both come
-- from it.
module BlackHole.Animation.FilmFile
  ( animationKey,
    readAnimation,
    Entry (..),
    filmEntries,
    pathEntries,
    pathKinds,
    trackEntries,
    isTrackable,
  )
where

import BlackHole.Animation.CameraPath
import BlackHole.Animation.Film
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

-- | The section's name at the top of a scene file.
animationKey :: String
animationKey = "animation"

-- | A key with its kind of value, and one line that says what it is.
data Entry = Entry
  { entryName :: !String,
    entryKind :: !Kind,
    entryDoc :: !String
  }

-- | The simple keys of the section itself; beside them there are @camera-path@
-- and @keyframes@.
filmEntries :: [Entry]
filmEntries =
  [ Entry "frames" (WholeKind 1 maximumFrames "") "Number of frames; give this or the duration",
    Entry "duration" (NumberKind (Quantity "a length" (Above 0) (UpTo 1e6) "seconds")) "Length of the film in seconds",
    Entry "fps" (NumberKind (Quantity "a number of frames per second" (From 0.001) (UpTo 1000) "")) "Frames per second (default: 24)",
    Entry "shutter" (NumberKind (Quantity "a part of the frame's time" (From 0) (UpTo 1) "")) "Motion blur: the part of a frame's time for which the shutter is open (default: 0, a single moment)",
    Entry "shutter-samples" (WholeKind 1 maximumShutterSamples "") "Moments averaged in each frame with an open shutter (default: 8)"
  ]

-- | The keys of the group @camera-path@.
pathEntries :: [Entry]
pathEntries =
  [ Entry "kind" (ChoiceKind "a camera path" [(name, doc) | (name, doc, _) <- pathKinds]) "How the camera moves from where the scene and the keyframes have put it",
    Entry "turns" (NumberKind (Quantity "a number of turns" (From (-1e4)) (UpTo 1e4) "")) "Turns around the hole during the film, right-handed about the axis (default: 1)",
    Entry "axis" VectorKind "Axis of the turns (default: [0, 1, 0], the disk's)",
    Entry "to" VectorKind "The place at which the film ends, in Schwarzschild radii",
    Entry "look-at" VectorKind "The point that the camera looks at in the end, in Schwarzschild radii (default: as in the beginning)",
    Entry "interpolation" (ChoiceKind "a way" [("linear", "at constant speed"), ("eased", "from rest to rest")]) "linear, or eased: from rest to rest (default: linear)",
    Entry "end-distance" (NumberKind (Quantity "a distance" (Above 0) (UpTo 1e6) "Schwarzschild radii")) "Distance from the hole at which the film ends, in Schwarzschild radii",
    Entry "rate" (NumberKind (Quantity "a proper time" (From (-1e9)) (UpTo 1e9) "r_s/c per second of film")) "The camera's own time per second of film, in r_s/c"
  ]

-- | The kinds of camera paths: name, what it is, and the keys it may have.
pathKinds :: [(String, String, [String])]
pathKinds =
  [ ("orbit", "around the hole", ["turns", "axis", "interpolation"]),
    ("dolly", "straight to a place", ["to", "look-at", "interpolation"]),
    ("free-fall", "falling from rest at infinity, straight in", ["end-distance", "rate"]),
    ("circular-orbit", "on the circular geodesic in the disk's plane", ["rate"])
  ]

-- | The keys of a field under @keyframes@ beside its times.
trackEntries :: [Entry]
trackEntries =
  [ Entry "interpolation" (ChoiceKind "a way" [(interpolationName kind, "") | kind <- [minBound ..]]) "held, linear, eased (from rest to rest at each key) or smooth (Catmull-Rom); default: linear",
    Entry "shortest-turn" SwitchKind "For angles in degrees: go from each key to the next by less than half a turn (default: false)"
  ]

-- | Whether a field can have keys: numbers and vectors can, but for the
-- picture's size.
isTrackable :: Field -> Bool
isTrackable field = takeWhile (/= '.') (fieldPath field) /= "image" && isJust (trackValue (fieldKind field) (fieldValues field))
  where
    fieldValues f = case fieldKind f of
      VectorKind -> [0, 0, 0]
      _ -> [0]

-- | The value of a field from numbers; whole ones are rounded.
trackValue :: Kind -> [Double] -> Maybe Value
trackValue kind values = case (kind, values) of
  (NumberKind _, [v]) -> Just (NumberValue v)
  (WholeKind {}, [v]) | abs v < 1e15 -> Just (WholeValue (round v))
  (VectorKind, [x, y, z]) -> Just (VectorValue (XYZ x y z))
  _ -> Nothing

type Faults = [(Int, Problem)]

-- | Read the section from a file's root: the film of a scene, and everything
-- that is wrong with the section, with lines. 'Nothing' if there is no such
-- section.
readAnimation :: Node -> Maybe (Scene -> Film, [(Int, Problem)])
readAnimation root = case root of
  Mapping _ members -> case [(at, value) | (at, key, value) <- members, key == animationKey] of
    [] -> Nothing
    [(_, section)] -> Just (readSection section)
    _ : (second, _) : _ -> Just (stillFilm, [(second, Problem animationKey ("a second '" ++ animationKey ++ "'") "possible")])
  _ -> Nothing

readSection :: Node -> (Scene -> Film, Faults)
readSection section = (film, faults)
  where
    (values, others, formFaults) = entriesOf [animationKey] filmEntries ["camera-path", "keyframes"] section
    (path, pathFaults) = maybe (Nothing, []) readPath (lookup "camera-path" others)
    (tracks, trackFaults) = maybe ([], []) readTracks (lookup "keyframes" others)
    faults = formFaults ++ lengthFaults ++ pathFaults ++ trackFaults ++ clashes
    lengthFaults = case (value "frames", value "duration") of
      (Just _, Just (line, _)) -> [(line, Problem (within "duration") "together with frames" "possible; give one of them")]
      (Nothing, Nothing) | null formFaults -> [(nodeLine section, Problem animationKey "without frames and duration" "complete; give one of them")]
      _ -> []
    clashes =
      [ (nodeLine section, Problem (within ("keyframes." ++ trackField track)) ("together with the camera path " ++ cameraPathName p) "possible, for the path alone says where the camera is")
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
    film scene =
      Film
        { filmScene = scene,
          filmFrames = fromMaybe 48 (wholeOf "frames" <|> fmap (\d -> max 1 (round (d * rate))) (numberOf "duration")),
          filmRate = rate,
          filmTracks = tracks,
          filmPath = path,
          filmShutter = Shutter (fromMaybe 0 (numberOf "shutter")) (fromMaybe 8 (wholeOf "shutter-samples"))
        }

readPath :: Node -> (Maybe CameraPath, Faults)
readPath node = case value "kind" of
  Just (_, NameValue kind) -> (if null missing then build kind else Nothing, formFaults ++ surplus kind ++ missing ++ both)
    where
      missing = [(nodeLine node, Problem pathLabel ("a path of the kind " ++ kind ++ " without " ++ wanted) "complete") | wanted <- lacking kind]
  _ -> (Nothing, formFaults ++ [(nodeLine node, Problem pathLabel "without kind" "complete") | null formFaults])
  where
    (values, _, formFaults) = entriesOf [animationKey, "camera-path"] pathEntries [] node
    pathLabel = within "camera-path"
    value name = lookup name values
    surplus kind =
      [ (line, Problem (pathLabel ++ "." ++ name) ("a key of the kind " ++ kind) ("possible; it has: " ++ intercalate ", " allowed))
        | (name, (line, _)) <- values,
          (known, _, allowed) <- pathKinds,
          known == kind,
          name `notElem` ("kind" : allowed)
      ]
    both =
      [ (line, Problem pathLabel "both end-distance and rate" "possible; give one of them")
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
      "orbit" -> Just (Orbit (fromMaybe (XYZ 0 1 0) (vectorOf "axis")) (fromMaybe 1 (numberOf "turns")) way)
      "dolly" -> (\place -> Dolly place (vectorOf "look-at") way) <$> vectorOf "to"
      "free-fall" -> FreeFall <$> ((ProperTimePerSecond <$> numberOf "rate") <|> (FallsTo <$> numberOf "end-distance"))
      "circular-orbit" -> CircularOrbit <$> numberOf "rate"
      _ -> Nothing

readTracks :: Node -> ([Track], Faults)
readTracks node = case node of
  Mapping _ members -> (mapMaybe fst found, concatMap snd found)
    where
      found = zipWith track [0 :: Int ..] members
      track i (line, path, keys)
        | path `elem` [p | (j, (_, p, _)) <- zip [0 ..] members, j < i] = (Nothing, [(line, Problem label ("a second '" ++ path ++ "'") "possible")])
        | otherwise = case findField path of
          Just field
            | isTrackable field -> readTrack label field keys
            | otherwise -> (Nothing, [(line, Problem label "a field without numbers that could change" "possible")])
          Nothing -> (Nothing, [(line, Problem label ("'" ++ path ++ "'") ("a field of a scene" ++ hint path))])
        where
          label = within ("keyframes." ++ path)
  _ -> ([], [(nodeLine node, Problem (within "keyframes") (nodeText node) "a group of fields, each with times and values")])
  where
    names = map fieldPath (filter isTrackable sceneFields)
    hint path = case suggestion path names of
      "" -> " that is a number or a vector (blackhole scene show default lists all fields)"
      text -> text

readTrack :: String -> Field -> Node -> (Maybe Track, Faults)
readTrack label field node = case node of
  Mapping line members
    | not (null faults) -> (Nothing, faults)
    | otherwise -> case makeKeys (unwrapped [(time, numbers v) | (time, v) <- sortOn fst keys]) of
      Right good -> (Just (Track (fieldPath field) setField way good), [])
      Left problem -> (Nothing, [(line, Problem label ("a list that " ++ renderKeysProblem problem) "possible")])
    where
      (options, _, formFaults) = entriesWith isTime [label] trackEntries [] node
      isTime = isJust . readNumber
      found = [(at, text, value) | (at, text, value) <- members, isTime text]
      faults = formFaults ++ concat [either pure (const []) (keyOf m) | m <- found] ++ twice ++ turnFaults
      twice =
        [ (at, Problem (label ++ "." ++ text) "a second value for this time" "possible")
          | (i, (at, text, _)) <- zip [0 :: Int ..] found,
            readNumber text `elem` [readNumber earlier | (j, (_, earlier, _)) <- zip [0 ..] found, j < i]
        ]
      keys = [key | m <- found, Right key <- [keyOf m]]
      way = case lookup "interpolation" options of
        Just (_, NameValue name) -> fromMaybe Linear (find ((== name) . interpolationName) [minBound ..])
        _ -> Linear
      short = case lookup "shortest-turn" options of
        Just (_, SwitchValue on) -> on
        _ -> False
      turnFaults = [(at, Problem label "shortest-turn" "possible for this field, which is no angle in degrees") | short, not inDegrees, Just (at, _) <- [lookup "shortest-turn" options]]
      unwrapped list
        | short = zip (map fst list) (map pure (unwrapDegrees (concatMap snd list)))
        | otherwise = list
  _ -> (Nothing, [(nodeLine node, Problem label (nodeText node) "a group of times in seconds with values, as in {0: 30, 1.5: 20}")])
  where
    inDegrees = case fieldKind field of
      NumberKind quantity -> take 7 (quantityUnit quantity) == "degrees"
      _ -> False
    keyOf (at, text, value) = case (readNumber text, readNode (fieldKind field) value) of
      (Just time, Right v) -> case rangeFault (fieldKind field) v of
        Nothing -> Right (time, v)
        Just range -> Left (at, Problem (label ++ "." ++ text) (showValue v) range)
      (_, Left expected) -> Left (nodeLine value, Problem (label ++ "." ++ text) (nodeText value) expected)
      (Nothing, _) -> Left (at, Problem label ("'" ++ text ++ "'") "a time in seconds")
    numbers v = case v of
      NumberValue x -> [x]
      WholeValue n -> [fromIntegral n]
      VectorValue (XYZ x y z) -> [x, y, z]
      _ -> []
    setField values scene = case (fieldGet field scene, trackValue (fieldKind field) values) of
      (Just _, Just value) -> Right (fieldSet field value scene)
      (Nothing, _) -> Left (Problem label "a key" "possible: the scene has no such thing")
      (_, Nothing) -> Left (Problem label (show values) "a value of this field")

within :: String -> String
within name = animationKey ++ "." ++ name

-- | The members of a group: values of known entries with their lines, the nodes
-- of some other keys, and faults.
entriesOf :: [String] -> [Entry] -> [String] -> Node -> ([(String, (Int, Value))], [(String, Node)], Faults)
entriesOf = entriesWith (const False)

-- | The same, where keys that satisfy a predicate are somebody else's business.
entriesWith :: (String -> Bool) -> [String] -> [Entry] -> [String] -> Node -> ([(String, (Int, Value))], [(String, Node)], Faults)
entriesWith foreign' above entries groups node = case node of
  Mapping _ members -> foldMap (member members) (zip [0 :: Int ..] members)
  _ -> ([], [], [(nodeLine node, Problem (intercalate "." above) (nodeText node) ("a group of settings; there are: " ++ intercalate ", " names))])
  where
    names = map entryName entries ++ groups
    member members (i, (line, key, value))
      | foreign' key = ([], [], [])
      | key `elem` [k | (j, (_, k, _)) <- zip [0 ..] members, j < i] = wrong line ("a second '" ++ key ++ "'") "possible"
      | key `elem` groups = ([], [(key, value)], [])
      | Just entry <- find ((== key) . entryName) entries = case readNode (entryKind entry) value of
        Left expected -> wrong (nodeLine value) (nodeText value) expected
        Right v -> case rangeFault (entryKind entry) v of
          Nothing -> ([(key, (line, v))], [], [])
          Just range -> wrong line (showValue v) range
      | otherwise = wrong line ("'" ++ key ++ "'") ("a key of " ++ intercalate "." above ++ suggestion key names ++ "; there are: " ++ intercalate ", " names)
      where
        wrong at text range = ([], [], [(at, Problem (intercalate "." (above ++ [key])) text range)])

asNumber :: Value -> Maybe Double
asNumber value = case value of
  NumberValue v -> Just v
  WholeValue n -> Just (fromIntegral n)
  _ -> Nothing

asWhole :: Value -> Maybe Int
asWhole value = case value of
  WholeValue n -> Just n
  _ -> Nothing
