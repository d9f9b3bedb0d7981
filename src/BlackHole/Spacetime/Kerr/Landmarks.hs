-- | Landmark radii of a Kerr hole: horizons, ergosphere, and the circular
-- orbits of light and matter that separate one kind of motion from another.
--
-- Units: @r_s = 2M = c = 1@, so that the spin length is @a = s\/2@ for the
-- dimensionless spin @s = J\/M²@. The hole's spin vector is @s@ times @+y@; a
-- negative spin turns left-handed about @+y@. Radii are Boyer–Lindquist's. The
-- closed forms are those of Bardeen, Press and Teukolsky 1972.
module BlackHole.Spacetime.Kerr.Landmarks
  ( Spin,
    spin,
    noSpin,
    dimensionlessSpin,
    spinLength,
    Handedness (..),
    horizonRadius,
    innerHorizonRadius,
    kerrDelta,
    ergosphereRadius,
    photonOrbitRadius,
    sphericalOrbitRadius,
    iscoRadius,
  )
where

-- | The dimensionless spin of a hole, in (−1, 1), with the radii of its horizons.
data Spin
  = Spin
      {-# UNPACK #-} !Double
      {-# UNPACK #-} !Double
      {-# UNPACK #-} !Double
  deriving (Eq, Ord)

instance Show Spin where
  showsPrec depth hole =
    showParen (depth > 10) (showString "Spin " . showsPrec 11 (dimensionlessSpin hole))

-- | The spin of a hole with a horizon. 'Nothing' unless @−1 < s < 1@.
spin :: Double -> Maybe Spin
spin s
  | abs s < 1 = Just (spinOf s)
  | otherwise = Nothing

-- | The spin of a hole that does not rotate.
noSpin :: Spin
noSpin = spinOf 0

-- The inner horizon, a²/r₊, keeps its digits for slow holes.
spinOf :: Double -> Spin
spinOf s = Spin s outer (0.25 * s * s / outer)
  where
    outer = 0.5 * (1 + sqrt ((1 - s) * (1 + s)))

-- | @s = J\/M²@, in (−1, 1).
dimensionlessSpin :: Spin -> Double
dimensionlessSpin (Spin s _ _) = s

-- | @a = J\/M = s\/2@, a length in (−½, ½).
spinLength :: Spin -> Double
spinLength (Spin s _ _) = 0.5 * s

-- | The sense in which something turns about @+y@. The gas of a disk is always
-- right-handed; it counter-rotates where the spin is negative.
data Handedness = RightHanded | LeftHanded
  deriving (Eq, Show, Enum, Bounded)

-- | The spin as something of this handedness feels it: positive if it turns with
-- the hole.
spinAlong :: Handedness -> Spin -> Double
spinAlong RightHanded hole = dimensionlessSpin hole
spinAlong LeftHanded hole = negate (dimensionlessSpin hole)

-- | The event horizon @r₊@, in (½, 1].
horizonRadius :: Spin -> Double
horizonRadius (Spin _ outer _) = outer

-- | The inner horizon @r₋@, in [0, ½).
innerHorizonRadius :: Spin -> Double
innerHorizonRadius (Spin _ _ inner) = inner

-- | @Δ = (r − r₊)(r − r₋)@ at a radius.
kerrDelta :: Spin -> Double -> Double
kerrDelta (Spin _ outer inner) r = (r - outer) * (r - inner)

-- | The radius below which nothing can be at rest, from the cosine of the
-- polar angle: between the horizon on the axis and 1 in the equatorial plane.
ergosphereRadius :: Spin -> Double -> Double
ergosphereRadius (Spin s _ _) cosine = 0.5 * (1 + sqrt ((1 - s * cosine) * (1 + s * cosine)))

-- | The circular orbit of light in the equatorial plane, in (½, 2).
photonOrbitRadius :: Handedness -> Spin -> Double
photonOrbitRadius handedness hole = 1 + cos (2 / 3 * acos (negate (spinAlong handedness hole)))

-- | The radius of the spherical orbit of light with an angular momentum λ per energy: the
-- greatest root of @r³ − (3\/2)r² + a(a + λ)r + a(a − λ)\/2@, between the circular orbits
-- of both senses. With λ = 0 it passes over both poles.
sphericalOrbitRadius :: Spin -> Double -> Double
sphericalOrbitRadius hole lambda
  | linear < 0 = 0.5 + 2 * size * sinh (asinh argument / 3)
  | argument <= 1 = 0.5 + 2 * size * cos (acos argument / 3)
  | otherwise = 0.5 + 2 * size * cosh (acosh argument / 3)
  where
    a = spinLength hole
    -- With r = ½ + x: x³ − 3 linear x − (¼ − a²) = 0, by Viète's formulas.
    linear = (0.75 - a * a - a * lambda) / 3
    size = sqrt (max 1e-100 (abs linear))
    argument = (0.25 - a * a) / (2 * size * size * size)

-- | The innermost stable circular orbit of matter, in (½, 4.5).
--
-- The published closed form takes a difference that costs half the digits of a
-- slow hole. Newton's method on @x⁴ − 6x² + 8sx − 3s²@, which vanishes for
-- @x = √(2r)@, restores them; close to @s = 1@ the root is nearly double, and the
-- closed form is the better one.
iscoRadius :: Handedness -> Spin -> Double
iscoRadius handedness hole
  | s == 0 = 3
  | abs s < 0.9 = let x = newton (newton (newton (sqrt (2 * closed)))) in 0.5 * x * x
  | otherwise = closed
  where
    s = spinAlong handedness hole
    cubeRoot v = v ** (1 / 3)
    z1 = 1 + cubeRoot ((1 - s) * (1 + s)) * (cubeRoot (1 + s) + cubeRoot (1 - s))
    z2 = sqrt (3 * s * s + z1 * z1)
    closed = 0.5 * (3 + z2 - signum s * sqrt (max 0 ((3 - z1) * (3 + z1 + 2 * z2))))
    newton x =
      x - (((x * x - 6) * x + 8 * s) * x - 3 * s * s) / ((4 * x * x - 12) * x + 8 * s)
