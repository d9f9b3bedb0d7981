-- | Vectors of the plane: strict, monomorphic 'Double' pairs.
--
-- Meant to be imported qualified, apart from the type and the operators:
--
-- > import BlackHole.Vector.XY (XY (..), (^+^))
-- > import qualified BlackHole.Vector.XY as XY
--
-- Monomorphic on purpose: a polymorphic strict vector boxes every component,
-- these stay in registers.
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

-- | A point or displacement of the plane; the unit is the caller's.
data XY = XY {-# UNPACK #-} !Double {-# UNPACK #-} !Double
  deriving (Eq, Ord, Show, Read)

-- | The origin.
zero :: XY
zero = XY 0 0

-- | Sum, component by component.
(^+^) :: XY -> XY -> XY
XY a b ^+^ XY x y = XY (a + x) (b + y)
{-# INLINE (^+^) #-}

-- | Difference, component by component.
(^-^) :: XY -> XY -> XY
XY a b ^-^ XY x y = XY (a - x) (b - y)
{-# INLINE (^-^) #-}

-- | Product of a number and a vector.
(*^) :: Double -> XY -> XY
k *^ XY x y = XY (k * x) (k * y)
{-# INLINE (*^) #-}

-- | Scalar product.
dot :: XY -> XY -> Double
dot (XY a b) (XY x y) = a * x + b * y
{-# INLINE dot #-}

-- | Squared length.
normSquared :: XY -> Double
normSquared v = dot v v
{-# INLINE normSquared #-}

-- | Length.
norm :: XY -> Double
norm = sqrt . normSquared
{-# INLINE norm #-}

-- | @lerp t a b@ is @a@ at @t = 0@, @b@ at @t = 1@, and straight between.
lerp :: Double -> XY -> XY -> XY
lerp t a b = a ^+^ t *^ (b ^-^ a)
{-# INLINE lerp #-}
