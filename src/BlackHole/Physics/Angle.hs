-- | Angles with their unit in the type: degrees at the command line and in
-- scene files, radians everywhere else.
module BlackHole.Physics.Angle
  ( Degrees (..),
    Radians (..),
    toRadians,
    toDegrees,
    arcTangent2,
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

-- | @arcTangent2 y x@: the same angle as @atan2 y x@, which in GHC's library
-- takes several times as long for its care about signed zeros and infinities; 0
-- for two zeros.
arcTangent2 :: Double -> Double -> Double
arcTangent2 y x
  | x > 0 = atan (y / x)
  | x < 0 = if y < 0 then atan (y / x) - pi else atan (y / x) + pi
  | y > 0 = pi / 2
  | y < 0 = negate (pi / 2)
  | otherwise = 0
{-# INLINE arcTangent2 #-}
