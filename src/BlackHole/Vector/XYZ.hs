-- | Vectors of space: strict, monomorphic 'Double' triples.
--
-- Meant to be imported qualified, apart from the type and the operators:
--
-- > import BlackHole.Vector.XYZ (XYZ (..), (^+^))
-- > import qualified BlackHole.Vector.XYZ as XYZ
--
-- Axes are right-handed and the disk's axis is @+y@ throughout the program.
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

-- | A point or displacement of space. Positions are in units of the
-- Schwarzschild radius; directions are pure numbers.
data XYZ
  = XYZ
      {-# UNPACK #-} !Double
      {-# UNPACK #-} !Double
      {-# UNPACK #-} !Double
  deriving (Eq, Ord, Show, Read)

-- | The origin: the centre of the hole.
zero :: XYZ
zero = XYZ 0 0 0

-- | Sum, component by component.
(^+^) :: XYZ -> XYZ -> XYZ
XYZ a b c ^+^ XYZ x y z = XYZ (a + x) (b + y) (c + z)
{-# INLINE (^+^) #-}

-- | Difference, component by component.
(^-^) :: XYZ -> XYZ -> XYZ
XYZ a b c ^-^ XYZ x y z = XYZ (a - x) (b - y) (c - z)
{-# INLINE (^-^) #-}

-- | Product of a number and a vector.
(*^) :: Double -> XYZ -> XYZ
k *^ XYZ x y z = XYZ (k * x) (k * y) (k * z)
{-# INLINE (*^) #-}

-- | The vector of the same length that points the other way.
negated :: XYZ -> XYZ
negated (XYZ x y z) = XYZ (negate x) (negate y) (negate z)
{-# INLINE negated #-}

-- | Scalar product.
dot :: XYZ -> XYZ -> Double
dot (XYZ a b c) (XYZ x y z) = a * x + b * y + c * z
{-# INLINE dot #-}

-- | Vector product, right-handed: @cross x y == z@ for the axes.
cross :: XYZ -> XYZ -> XYZ
cross (XYZ a b c) (XYZ x y z) =
  XYZ (b * z - c * y) (c * x - a * z) (a * y - b * x)
{-# INLINE cross #-}

-- | Squared length.
normSquared :: XYZ -> Double
normSquared v = dot v v
{-# INLINE normSquared #-}

-- | Length.
norm :: XYZ -> Double
norm = sqrt . normSquared
{-# INLINE norm #-}

-- | The unit vector of the same direction; 'Nothing' where there is none,
-- because the length is zero, not finite, or too small to invert.
normalize :: XYZ -> Maybe XYZ
normalize v
  -- The difference from itself is NaN for an infinity. GHC asks a C function.
  | n > 0 && n - n == 0 && k - k == 0 = Just (k *^ v)
  | otherwise = Nothing
  where
    n = norm v
    k = 1 / n
{-# INLINE normalize #-}

-- | Some unit vector at right angles to a unit vector.
perpendicular :: XYZ -> XYZ
perpendicular (XYZ x y z)
  -- Crossed with the axis that is far enough from it, and divided by the length.
  | abs x < 0.7 = let n = sqrt (y * y + z * z) in XYZ 0 (z / n) (negate y / n)
  | otherwise = let n = sqrt (x * x + z * z) in XYZ (negate z / n) 0 (x / n)

-- | Distance of two points.
distance :: XYZ -> XYZ -> Double
distance a b = norm (a ^-^ b)
{-# INLINE distance #-}

-- | @lerp t a b@ is @a@ at @t = 0@, @b@ at @t = 1@, and straight between.
lerp :: Double -> XYZ -> XYZ -> XYZ
lerp t a b = a ^+^ t *^ (b ^-^ a)
{-# INLINE lerp #-}

-- | Whether all three components are finite numbers.
isFinite :: XYZ -> Bool
isFinite (XYZ x y z) = finite x && finite y && finite z
  where
    finite a = not (isNaN a || isInfinite a)
