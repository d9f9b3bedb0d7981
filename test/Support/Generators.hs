-- | Random vectors, directions, photons and scenes for the properties.
module Support.Generators
  ( Coordinates (..),
    Plane (..),
    Direction (..),
    Outside (..),
    inRange,
    validScene,
  )
where

import BlackHole.Scene.Field.Field
import BlackHole.Scene.Field.Kind
import BlackHole.Scene.Field.Table
import BlackHole.Scene.Preset
import BlackHole.Scene.Scene (Scene)
import BlackHole.Scene.Setting
import BlackHole.Scene.Validate (validateScene)
import BlackHole.Vector.XY (XY (..))
import BlackHole.Vector.XYZ (XYZ (..), (*^))
import Data.Maybe (isNothing)
import Test.QuickCheck

-- | A vector of space with components of moderate size.
newtype Coordinates = Coordinates XYZ
  deriving (Show)

instance Arbitrary Coordinates where
  arbitrary = Coordinates <$> (XYZ <$> component <*> component <*> component)
    where
      component = inRange (-100) 100

-- | A vector of the plane, likewise.
newtype Plane = Plane XY
  deriving (Show)

instance Arbitrary Plane where
  arbitrary = Plane <$> (XY <$> inRange (-100) 100 <*> inRange (-100) 100)

-- | A unit vector, evenly over the sphere (Archimedes).
newtype Direction = Direction XYZ
  deriving (Show)

instance Arbitrary Direction where
  arbitrary = do
    z <- inRange (-1) 1
    phi <- inRange 0 (2 * pi)
    let s = sqrt (max 0 (1 - z * z))
    pure (Direction (XYZ (s * cos phi) (s * sin phi) z))

-- | A place between the photon sphere and @r = 40@.
newtype Outside = Outside XYZ
  deriving (Show)

instance Arbitrary Outside where
  arbitrary = do
    r <- inRange 1.6 40
    Direction d <- arbitrary
    pure (Outside (r *^ d))

-- | A number from an interval.
inRange :: Double -> Double -> Gen Double
inRange low high = choose (low, high)

-- | A scene that can be rendered, with random values in random fields.
validScene :: Gen Scene
validScene =
  (applySettings <$> settings <*> elements (map snd presets)) `suchThat` (null . validateScene)
  where
    settings = concat <$> traverse maybeSetting sceneFields
    maybeSetting field =
      frequency
        [(2, pure []), (1, (: []) . Setting (fieldPath field) <$> valueOf (fieldKind field))]

-- | A value that a field of this kind may have by itself.
valueOf :: Kind -> Gen Value
valueOf kind = case kind of
  NumberKind quantity -> (NumberValue <$> numberIn quantity) `suchThat` allowed
  WholeKind low high _ -> WholeValue <$> choose (low, high)
  SeedKind -> SeedValue <$> oneof [arbitrary, pure maxBound]
  SwitchKind -> SwitchValue <$> arbitrary
  ChoiceKind _ choices -> NameValue . fst <$> elements choices
  ChoiceOrFileKind _ choices _ ->
    oneof
      [ NameValue . fst <$> elements choices,
        FileValue <$> elements ["sky.png", "../a b/it's #1: sky.hdr", "/x/\228\8364.jpg", "'.' "]
      ]
  VectorKind -> do
    Coordinates place <- arbitrary
    pure (VectorValue place)
  where
    allowed value = isNothing (rangeFault kind value)
    numberIn quantity =
      let low = case quantityLeast quantity of
            Anything -> -1000
            From l -> l
            Above l -> l
          high = case quantityMost quantity of
            Endless -> 1000
            UpTo h -> h
            Below h -> h
       in oneof
            [ inRange low high,
              inRange low (min high (low + 30)),
              pure low,
              pure high,
              (\e -> low + 10 ** e) <$> inRange (-12) 2
            ]
