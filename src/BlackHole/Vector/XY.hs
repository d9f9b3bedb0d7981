-- | Vectors in the plane: strict, monomorphic pairs of @Double@.
--
-- Import the module qualified, apart from the type and the operators:
--
-- > import BlackHole.Vector.XY (XY (..), (^+^))
-- > import qualified BlackHole.Vector.XY as XY
--
-- The type is monomorphic because a polymorphic strict vector boxes every component,
-- whereas these components stay in registers.
module BlackHole.Vector.XY
  ( XY (..),
    zero,
    (^+^),
    (^-^),
    (*^),
    dot,
    normSquared,
    norm,
    lerp,
  )
where

infixl 6 ^+^, ^-^

infixl 7 *^

-- | A point or displacement in the plane; the unit is the caller's.
data XY = XY {-# UNPACK #-} !Double {-# UNPACK #-} !Double
  deriving (Eq, Ord, Show, Read)

-- | The origin.
zero :: XY
zero = XY 0 0

-- | The componentwise sum.
(^+^) :: XY -> XY -> XY
XY a b ^+^ XY x y = XY (a + x) (b + y)
{-# INLINE (^+^) #-}

-- | The componentwise difference.
(^-^) :: XY -> XY -> XY
XY a b ^-^ XY x y = XY (a - x) (b - y)
{-# INLINE (^-^) #-}

-- | The product of a number and a vector.
(*^) :: Double -> XY -> XY
k *^ XY x y = XY (k * x) (k * y)
{-# INLINE (*^) #-}

-- | The scalar product.
dot :: XY -> XY -> Double
dot (XY a b) (XY x y) = a * x + b * y
{-# INLINE dot #-}

-- | The squared length.
normSquared :: XY -> Double
normSquared v = dot v v
{-# INLINE normSquared #-}

-- | The length.
norm :: XY -> Double
norm = sqrt . normSquared
{-# INLINE norm #-}

-- | @lerp t a b@ interpolates linearly: it is @a@ at @t = 0@ and @b@ at @t = 1@.
lerp :: Double -> XY -> XY -> XY
lerp t a b = a ^+^ t *^ (b ^-^ a)
{-# INLINE lerp #-}
