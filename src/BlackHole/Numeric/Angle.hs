-- | Angles whose unit is part of their type. The command line and scene files use
-- degrees; everything else uses radians.
module BlackHole.Numeric.Angle
  ( Degrees (..),
    Radians (..),
    toRadians,
    toDegrees,
    sineOfDegrees,
    cosineOfDegrees,
    arcTangent2,
    quarterTangent,
  )
where

-- | An angle in degrees.
newtype Degrees = Degrees {inDegrees :: Double}
  deriving (Eq, Ord, Show)

-- | An angle in radians.
newtype Radians = Radians {inRadians :: Double}
  deriving (Eq, Ord, Show)

-- | Converts degrees to radians.
toRadians :: Degrees -> Radians
toRadians (Degrees d) = Radians (d * pi / 180)

-- | Converts radians to degrees.
toDegrees :: Radians -> Degrees
toDegrees (Radians r) = Degrees (r * 180 / pi)

-- | The sine of an angle; exact for multiples of 90 degrees.
sineOfDegrees :: Degrees -> Double
sineOfDegrees = sineAfterQuarters 0

-- | The cosine of an angle; exact for multiples of 90 degrees.
cosineOfDegrees :: Degrees -> Double
cosineOfDegrees = sineAfterQuarters 1

-- | The sine of the sum of a number of quarter turns and an angle.
sineAfterQuarters :: Integer -> Degrees -> Double
sineAfterQuarters more (Degrees d) = case (more + nearest) `mod` 4 of
  0 -> sin rest
  1 -> cos rest
  2 -> negate (sin rest)
  _ -> negate (cos rest)
  where
    nearest = round (d / 90)
    -- Exact: both are multiples of the last digit of d.
    Radians rest = toRadians (Degrees (d - 90 * fromIntegral nearest))

-- | @arcTangent2 y x@ is the angle of the point @(x, y)@ in radians, from −π to π,
-- equal to @atan2 y x@ except that signed zeros and infinities get no special
-- treatment; it is 0 for two zeros. GHC's @atan2@ handles those cases and takes several
-- times as long.
arcTangent2 :: Double -> Double -> Double
arcTangent2 y x
  | x > 0 = atan (y / x)
  | x < 0 = if y < 0 then atan (y / x) - pi else atan (y / x) + pi
  | y > 0 = pi / 2
  | y < 0 = negate (pi / 2)
  | otherwise = 0
{-# INLINE arcTangent2 #-}

-- | tan(ψ/4) from cos ψ and sin ψ.
quarterTangent :: Double -> Double -> Double
quarterTangent cosine sine = sine / (high + sqrt (2 * high))
  where
    -- 1 + cos ψ.
    high
      | cosine < 0 = sine * sine / (1 - cosine)
      | otherwise = 1 + cosine
{-# INLINE quarterTangent #-}
