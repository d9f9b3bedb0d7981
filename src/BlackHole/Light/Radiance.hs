-- | Linear radiance in the Rec. 709 primaries, in which the film accumulates light.
module BlackHole.Light.Radiance
  ( Radiance (..),
    black,
    grey,
    (<+>),
    scaleRadiance,
    mixRadiance,
    mapRadiance,
    luminance,
    isFiniteRadiance,
  )
where

infixl 6 <+>

-- | Linear radiance: the amounts of the red, green and blue primaries of ITU-R BT.709,
-- which sRGB shares together with its D65 white, not yet encoded for a display. The
-- unit is the scene's own; the exposure determines what becomes white. Any value from 0
-- up is meaningful; equal components are white.
data Radiance
  = Radiance
      {-# UNPACK #-} !Double
      {-# UNPACK #-} !Double
      {-# UNPACK #-} !Double
  deriving (Eq, Ord, Show, Read)

-- | The sum of two lights.
instance Semigroup Radiance where
  (<>) = (<+>)
  {-# INLINE (<>) #-}

instance Monoid Radiance where
  mempty = black
  {-# INLINE mempty #-}

-- | No light.
black :: Radiance
black = Radiance 0 0 0

-- | White light of this luminance.
grey :: Double -> Radiance
grey v = Radiance v v v
{-# INLINE grey #-}

-- | The sum of two lights; the operator of the 'Semigroup'.
(<+>) :: Radiance -> Radiance -> Radiance
Radiance r g b <+> Radiance r' g' b' = Radiance (r + r') (g + g') (b + b')
{-# INLINE (<+>) #-}

-- | The light multiplied by a factor.
scaleRadiance :: Double -> Radiance -> Radiance
scaleRadiance k (Radiance r g b) = Radiance (k * r) (k * g) (k * b)
{-# INLINE scaleRadiance #-}

-- | @mixRadiance t a b@ is the light at a fraction t of the way from a to b.
mixRadiance :: Double -> Radiance -> Radiance -> Radiance
mixRadiance t (Radiance r g b) (Radiance r' g' b') =
  Radiance (r + t * (r' - r)) (g + t * (g' - g)) (b + t * (b' - b))
{-# INLINE mixRadiance #-}

-- | Applies a function to each of the three components.
mapRadiance :: (Double -> Double) -> Radiance -> Radiance
mapRadiance f (Radiance r g b) = Radiance (f r) (f g) (f b)
{-# INLINE mapRadiance #-}

-- | CIE luminance Y, which is 1 for @grey 1@. The weights follow from the primaries and
-- the white of BT.709, which rounds them to 0.2126, 0.7152 and 0.0722. Unrounded, they
-- agree with "BlackHole.Light.Cie" to rounding error.
luminance :: Radiance -> Double
luminance (Radiance r g b) =
  0.21263900587151027 * r + 0.715168678767756 * g + 0.07219231536073371 * b
{-# INLINE luminance #-}

-- | Whether all three components are finite numbers.
isFiniteRadiance :: Radiance -> Bool
isFiniteRadiance (Radiance r g b) = finite r && finite g && finite b
  where
    -- The difference is NaN for NaN and for infinities.
    finite a = a - a == 0
{-# INLINE isFiniteRadiance #-}
