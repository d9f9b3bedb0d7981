-- | Vectors in space: strict, monomorphic triples of @Double@.
--
-- Import the module qualified, apart from the type and the operators:
--
-- > import BlackHole.Vector.XYZ (XYZ (..), (^+^))
-- > import qualified BlackHole.Vector.XYZ as XYZ
--
-- Axes are right-handed, and the disk's axis is @+y@ throughout the program.
module BlackHole.Vector.XYZ
  ( XYZ (..),
    zero,
    (^+^),
    (^-^),
    (*^),
    negated,
    dot,
    cross,
    normSquared,
    norm,
    normalize,
    perpendicular,
    distance,
    lerp,
    isFinite,
  )
where

infixl 6 ^+^, ^-^

infixl 7 *^

-- | A point or displacement in space. Positions are in Schwarzschild radii; directions
-- are dimensionless.
data XYZ
  = XYZ
      {-# UNPACK #-} !Double
      {-# UNPACK #-} !Double
      {-# UNPACK #-} !Double
  deriving (Eq, Ord, Show, Read)

-- | The origin, which is the centre of the hole.
zero :: XYZ
zero = XYZ 0 0 0

-- | The componentwise sum.
(^+^) :: XYZ -> XYZ -> XYZ
XYZ a b c ^+^ XYZ x y z = XYZ (a + x) (b + y) (c + z)
{-# INLINE (^+^) #-}

-- | The componentwise difference.
(^-^) :: XYZ -> XYZ -> XYZ
XYZ a b c ^-^ XYZ x y z = XYZ (a - x) (b - y) (c - z)
{-# INLINE (^-^) #-}

-- | The product of a number and a vector.
(*^) :: Double -> XYZ -> XYZ
k *^ XYZ x y z = XYZ (k * x) (k * y) (k * z)
{-# INLINE (*^) #-}

-- | The vector of equal length in the opposite direction.
negated :: XYZ -> XYZ
negated (XYZ x y z) = XYZ (negate x) (negate y) (negate z)
{-# INLINE negated #-}

-- | The scalar product.
dot :: XYZ -> XYZ -> Double
dot (XYZ a b c) (XYZ x y z) = a * x + b * y + c * z
{-# INLINE dot #-}

-- | The right-handed vector product: @cross x y == z@ for the axes.
cross :: XYZ -> XYZ -> XYZ
cross (XYZ a b c) (XYZ x y z) =
  XYZ (b * z - c * y) (c * x - a * z) (a * y - b * x)
{-# INLINE cross #-}

-- | The squared length.
normSquared :: XYZ -> Double
normSquared v = dot v v
{-# INLINE normSquared #-}

-- | The length.
norm :: XYZ -> Double
norm = sqrt . normSquared
{-# INLINE norm #-}

-- | The unit vector in the same direction; 'Nothing' if the length is zero, not finite,
-- or too small to invert.
normalize :: XYZ -> Maybe XYZ
normalize v
  -- An infinity minus itself is NaN. This avoids @isInfinite@, for which GHC calls a C
  -- function.
  | n > 0 && n - n == 0 && k - k == 0 = Just (k *^ v)
  | otherwise = Nothing
  where
    n = norm v
    k = 1 / n
{-# INLINE normalize #-}

-- | A unit vector perpendicular to the given unit vector; which one is unspecified.
perpendicular :: XYZ -> XYZ
perpendicular (XYZ x y z)
  -- The cross product with an axis that is far enough from the vector, divided by its
  -- length.
  | abs x < 0.7 = let n = sqrt (y * y + z * z) in XYZ 0 (z / n) (negate y / n)
  | otherwise = let n = sqrt (x * x + z * z) in XYZ (negate z / n) 0 (x / n)

-- | The distance between two points.
distance :: XYZ -> XYZ -> Double
distance a b = norm (a ^-^ b)
{-# INLINE distance #-}

-- | @lerp t a b@ interpolates linearly: it is @a@ at @t = 0@ and @b@ at @t = 1@.
lerp :: Double -> XYZ -> XYZ -> XYZ
lerp t a b = a ^+^ t *^ (b ^-^ a)
{-# INLINE lerp #-}

-- | Whether all three components are finite numbers.
isFinite :: XYZ -> Bool
isFinite (XYZ x y z) = finite x && finite y && finite z
  where
    finite a = not (isNaN a || isInfinite a)
