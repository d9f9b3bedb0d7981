-- | What a page tells @blackhole explore@: a text of lines. The first line has the name
-- of the message and its arguments, separated by single spaces. Each further line is a
-- setting: its path, a space and its value, written as on the command line.
--
-- Any bytes are either a message whose numbers are in range or one line that says what
-- is wrong with them.
module BlackHole.Explore.Message
  ( Message (..),
    Input,
    Overwriting (..),
    parseMessage,
    valueText,
    maximumWindowSide,
  )
where

import BlackHole.Explore.Steer
import BlackHole.Explore.Timeline
import BlackHole.Scene.Field.Field
import BlackHole.Scene.Field.Kind
import BlackHole.Scene.Field.Number
import BlackHole.Scene.Field.Table
import BlackHole.Scene.Setting
import BlackHole.Vector.XYZ (XYZ (..))
import qualified Data.ByteString as Bytes
import Data.List (intercalate)
import qualified Data.Text as Text
import qualified Data.Text.Encoding as Text
import qualified Data.Text.Encoding.Error as Text

-- | The page's number for a message that changes the picture. Answers repeat it.
type Input = Int

-- | Whether a file may be replaced.
data Overwriting = KeepFile | ReplaceFile
  deriving (Eq, Show)

-- | A message.
data Message
  = -- | The size of the page's view in pixels.
    Window !Int !Int
  | -- | The page has drawn the frame of this number.
    Drawn !Int
  | -- | New values for some settings.
    Change !Input ![Setting]
  | -- | All settings of an earlier scene, and the name of the preset it came from.
    Restore !Input !String ![Setting]
  | LoadPreset !Input !String
  | Steer !Input !Steering
  | -- | Explain the pixel at these fractions of the picture's width and height.
    Inspect !Double !Double
  | -- | Ask for the command line that renders the present scene.
    AskCommand
  | SaveScene !Overwriting !FilePath
  | -- | Check the keyframes.
    DefineAnimation !Timeline
  | SaveAnimation !Overwriting !FilePath
  | -- | Show the animation at a time in seconds.
    Scrub !Input !Double
  | -- | Render the present scene at its full size.
    RenderFile !Overwriting !FilePath
  | CancelRender
  deriving (Eq, Show)

-- | The greatest width and height of a page's view in pixels: an 8K screen's.
maximumWindowSide :: Int
maximumWindowSide = 7680

-- | The message of some bytes, which are UTF-8; or what is wrong with them, and the
-- number of the input if they have one.
parseMessage :: Bytes.ByteString -> Either (Maybe Input, String) Message
parseMessage bytes = case lines (Text.unpack (Text.decodeUtf8With Text.lenientDecode bytes)) of
  [] -> Left (Nothing, "an empty message")
  first : rest ->
    either (Left . (,) (numbered (splitOn ' ' first))) Right (messageOf (splitOn ' ' first) rest)
  where
    numbered line = case line of
      word : n : _
        | word
            `elem` [ "change",
                     "restore",
                     "preset",
                     "orbit",
                     "approach",
                     "look",
                     "roll",
                     "face",
                     "scrub"
                   ],
          Right input <- count n ->
          Just input
      _ -> Nothing

-- | The message of the words of the first line, and of the other lines.
messageOf :: [String] -> [String] -> Either String Message
messageOf first rest = case first of
  ["window", w, h] ->
    Window <$> wholeWithin 1 maximumWindowSide w <*> wholeWithin 1 maximumWindowSide h <* none
  ["drawn", n] -> Drawn <$> count n <* none
  ["change", n] -> Change <$> count n <*> settings rest
  ["restore", n, preset] -> Restore <$> count n <*> pure preset <*> settings rest
  ["preset", n, name] -> LoadPreset <$> count n <*> pure name <* none
  ["orbit", n, azimuth, inclination] ->
    steering n (OrbitHole <$> within (-3600) 3600 azimuth <*> within (-3600) 3600 inclination)
  ["approach", n, factor] -> steering n (Approach <$> within 0.01 100 factor)
  ["look", n, right, up] ->
    steering n (LookAround <$> within (-3600) 3600 right <*> within (-3600) 3600 up)
  ["roll", n, angle] -> steering n (RollBy <$> within (-3600) 3600 angle)
  ["face", n] -> steering n (Right FaceHole)
  ["inspect", x, y] -> Inspect <$> within 0 1 x <*> within 0 1 y <* none
  ["command"] -> AskCommand <$ none
  "save-scene" : how : name -> SaveScene <$> overwriting how <*> fileName name <* none
  ["animation", duration, rate, way] ->
    DefineAnimation
      <$> ( Timeline <$> within 0.01 3600 duration <*> within 0.1 240 rate <*> interpolation way
              <*> keys rest
          )
  "save-animation" : how : name -> SaveAnimation <$> overwriting how <*> fileName name <* none
  ["scrub", n, seconds] -> Scrub <$> count n <*> within 0 3600 seconds <* none
  "render" : how : name -> RenderFile <$> overwriting how <*> fileName name <* none
  ["cancel"] -> CancelRender <$ none
  word : _ -> Left ("no message: " ++ shown word)
  [] -> Left "an empty message"
  where
    none = if null rest then Right () else Left "a message with too many lines"
    steering n how = Steer <$> count n <*> how <* none
    overwriting how = case how of
      "keep" -> Right KeepFile
      "replace" -> Right ReplaceFile
      _ -> Left ("neither keep nor replace: " ++ shown how)
    fileName name = case unwords name of
      "" -> Left "a file needs a name"
      text -> Right text
    interpolation way =
      maybe (Left ("no interpolation: " ++ shown way)) Right (lookup way interpolations)

-- | Numbers of frames and inputs.
count :: String -> Either String Int
count = wholeWithin 0 1000000000

wholeWithin :: Int -> Int -> String -> Either String Int
wholeWithin low high text = case readWhole text of
  Just n | n >= toInteger low, n <= toInteger high -> Right (fromInteger n)
  _ -> Left (shown text ++ " is not a whole number from " ++ show low ++ " to " ++ show high)

within :: Double -> Double -> String -> Either String Double
within low high text = case readNumber text of
  Just v | v >= low, v <= high -> Right v
  _ -> Left (shown text ++ " is not a number from " ++ showNumber low ++ " to " ++ showNumber high)

settings :: [String] -> Either String [Setting]
settings given
  | null (drop 500 given) = traverse settingOf given
  | otherwise = Left "more than 500 settings in one message"

settingOf :: String -> Either String Setting
settingOf line = case findField path of
  Nothing -> Left ("no setting: " ++ shown path)
  Just field -> case readValue (fieldKind field) (drop 1 text) of
    Left expected -> Left (path ++ ": " ++ shown (drop 1 text) ++ " is not " ++ expected)
    Right value -> case rangeFault (fieldKind field) value of
      Just range -> Left (path ++ ": " ++ shown (drop 1 text) ++ " is not " ++ range)
      Nothing -> Right (Setting path value)
  where
    (path, text) = break (== ' ') line

-- | Keys, each a line @key SECONDS@ and the lines of its settings.
keys :: [String] -> Either String [Key]
keys given = case given of
  [] -> Right []
  line : rest
    | ["key", seconds] <- splitOn ' ' line ->
      let (own, others) = break ((== "key ") . take 4) rest
       in (:) <$> (Key <$> within 0 3600 seconds <*> settings own) <*> keys others
    | otherwise -> Left ("no key: " ++ shown line)

shown :: String -> String
shown text = "'" ++ take 60 (map (\c -> if c < ' ' then '?' else c) text) ++ "'"

-- | A value as messages have it: 'readValue' returns exactly this value.
valueText :: Value -> String
valueText value = case value of
  NumberValue v -> exactNumber v
  VectorValue (XYZ x y z) -> intercalate "," (map exactNumber [x, y, z])
  _ -> showValue value
