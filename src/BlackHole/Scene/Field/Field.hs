-- | One setting of a scene: everything that the command line, scene files and help need
-- to know about it, and functions to define it.
module BlackHole.Scene.Field.Field
  ( Field (..),
    Topic (..),
    topicName,
    Option (..),
    optionName,
    fieldLabel,

    -- * Kinds of fields
    number,
    whole,
    seed,
    switch,
    choice,
    choiceOrFile,
    vector,

    -- * What follows a kind
    FieldOf,
    sets,
    documented,
    withOption,
    withFlag,
  )
where

import BlackHole.Scene.Field.Kind
import BlackHole.Scene.Field.Part
import BlackHole.Scene.Scene (Scene)
import BlackHole.Vector.XYZ (XYZ)
import Data.List (find)
import Data.Word (Word64)

-- | A setting of a scene.
data Field = Field
  { -- | Its path in a scene file, with points between the levels: @disk.inner@.
    fieldPath :: !String,
    fieldTopic :: !Topic,
    -- | One sentence without a full stop that describes it, with its unit.
    fieldDoc :: !String,
    fieldKind :: !Kind,
    -- | Its option of @blackhole render@, if it has one.
    fieldOption :: !(Maybe Option),
    -- | Its value in a scene; 'Nothing' if the scene has no such value, like the
    -- inner radius in a scene without a disk.
    fieldGet :: !(Scene -> Maybe Value),
    -- | The scene with this value. Leaves the scene alone if it has no place for
    -- the value, or if the value is of another kind.
    fieldSet :: !(Value -> Scene -> Scene)
  }

-- | The topic of a setting. Help is grouped by topic.
data Topic
  = Image
  | Camera
  | Observer
  | Disk
  | Sky
  | Sampling
  | Output
  | Diagnostics
  deriving (Eq, Ord, Show, Enum, Bounded)

-- | The topic's name as a heading.
topicName :: Topic -> String
topicName = show

-- | An option of the command line. Names have no dashes.
data Option
  = -- | An option with a value: its name, and the placeholder for the value in help.
    Takes !String !String
  | -- | A flag: its name, the value that it sets, and its line of help.
    Sets !String !Value !String
  deriving (Eq, Show)

-- | The option's name with dashes.
optionName :: Option -> String
optionName (Takes name _) = "--" ++ name
optionName (Sets name _ _) = "--" ++ name

-- | What messages call a setting that does not come from a scene file: its option, or
-- its path if it has none.
fieldLabel :: Field -> String
fieldLabel f = maybe (fieldPath f) optionName (fieldOption f)

-- | A setting that lacks the part of a scene that it sets, and its documentation.
type FieldOf a = Part Scene a -> String -> Field

-- | @f \`sets\` part@: the setting of this part of a scene.
sets :: FieldOf a -> Part Scene a -> String -> Field
sets = ($)

-- | @f \`documented\` doc@: the setting with one sentence, without a full stop.
documented :: (String -> Field) -> String -> Field
documented = ($)

-- | @number topic path quantity@: a number with unit and range.
number :: Topic -> String -> Quantity -> FieldOf Double
number topic path quantity = field (NumberKind quantity) NumberValue fromValue topic path
  where
    fromValue (NumberValue v) = Just v
    fromValue _ = Nothing

-- | @whole topic path (least, greatest) unit@: a whole number.
whole :: Topic -> String -> (Int, Int) -> String -> FieldOf Int
whole topic path (low, high) unit = field (WholeKind low high unit) WholeValue fromValue topic path
  where
    fromValue (WholeValue n) = Just n
    fromValue _ = Nothing

-- | @seed topic path@: a whole number of 64 bits.
seed :: Topic -> String -> FieldOf Word64
seed = field SeedKind SeedValue fromValue
  where
    fromValue (SeedValue n) = Just n
    fromValue _ = Nothing

-- | @switch topic path@: on or off.
switch :: Topic -> String -> FieldOf Bool
switch = field SwitchKind SwitchValue fromValue
  where
    fromValue (SwitchValue b) = Just b
    fromValue _ = Nothing

-- | @choice topic path noun choices@: one of several values, each with its name
-- in lower case and its meaning.
choice :: Eq a => Topic -> String -> String -> [(a, String, String)] -> FieldOf a
choice topic path what choices part doc =
  Field
    { fieldPath = path,
      fieldTopic = topic,
      fieldDoc = doc,
      fieldKind = ChoiceKind what [(name, meaning) | (_, name, meaning) <- choices],
      fieldOption = Nothing,
      fieldGet = \scene -> do
        value <- partOf part scene
        (_, name, _) <- find (\(v, _, _) -> v == value) choices
        pure (NameValue name),
      fieldSet = \value scene -> case value of
        NameValue name
          | Just (v, _, _) <- find (\(_, n, _) -> n == name) choices ->
            partSet part v scene
        _ -> scene
    }

-- | @choiceOrFile topic path noun choices fileNoun (fromFile, toFile)@: a choice
-- or a file, with the functions from a file's name to a value and back.
choiceOrFile ::
  Eq a =>
  Topic ->
  String ->
  String ->
  [(a, String, String)] ->
  String ->
  (FilePath -> a, a -> Maybe FilePath) ->
  FieldOf a
choiceOrFile topic path what choices file (fromFile, toFile) part doc =
  chosen
    { fieldKind = ChoiceOrFileKind what [(name, meaning) | (_, name, meaning) <- choices] file,
      fieldGet =
        \scene -> maybe (fieldGet chosen scene) (Just . FileValue) (partOf part scene >>= toFile),
      fieldSet = \value -> case value of
        FileValue name -> partSet part (fromFile name)
        _ -> fieldSet chosen value
    }
  where
    chosen = choice topic path what choices part doc

-- | @vector topic path@: three finite numbers.
vector :: Topic -> String -> FieldOf XYZ
vector = field VectorKind VectorValue fromValue
  where
    fromValue (VectorValue v) = Just v
    fromValue _ = Nothing

field :: Kind -> (a -> Value) -> (Value -> Maybe a) -> Topic -> String -> FieldOf a
field kind toValue fromValue topic path part doc =
  Field
    { fieldPath = path,
      fieldTopic = topic,
      fieldDoc = doc,
      fieldKind = kind,
      fieldOption = Nothing,
      fieldGet = fmap toValue . partOf part,
      fieldSet = \value scene -> maybe scene (\v -> partSet part v scene) (fromValue value)
    }

-- | @f \`withOption\` (name, placeholder)@: the setting with an option that takes a
-- value.
withOption :: Field -> (String, String) -> Field
withOption f (name, placeholder) = f {fieldOption = Just (Takes name placeholder)}

-- | @f \`withFlag\` (name, value, help)@: the setting with a flag that sets this value.
withFlag :: Field -> (String, Value, String) -> Field
withFlag f (name, value, text) = f {fieldOption = Just (Sets name value text)}
