-- | Angles with their unit in the type: degrees at the command line and in
-- scene files, radians everywhere else.
module BlackHole.Physics.Angle
  ( Degrees (..),
    Radians (..),
    toRadians,
    toDegrees,
  )
where

-- | An angle in degrees.
newtype Degrees = Degrees {inDegrees :: Double}
  deriving (Eq, Ord, Show)

-- | An angle in radians.
newtype Radians = Radians {inRadians :: Double}
  deriving (Eq, Ord, Show)

-- | The same angle in radians.
toRadians :: Degrees -> Radians
toRadians (Degrees d) = Radians (d * pi / 180)

-- | The same angle in degrees.
toDegrees :: Radians -> Degrees
toDegrees (Radians r) = Degrees (r * 180 / pi)
