{-# LANGUAGE BangPatterns #-}

-- | Fourier profiles: the strength of the noise at each level of the grid, that is, in
-- each octave of spatial frequency (Will Yager, "Accurately Rendering a Black Hole",
-- section "Texture Generation").
module BlackHole.Noise.Profile
  ( Profile,
    profile,
    octaves,
    layers,
    profileBound,
    normalised,
    sumLayers,
  )
where

import BlackHole.Noise.Lattice (Level, clampedLevel, levelNumber)
import Data.Primitive.PrimArray
  ( PrimArray,
    indexPrimArray,
    mapPrimArray,
    primArrayFromList,
    primArrayToList,
    sizeofPrimArray,
  )

-- | An amplitude for every level. The sum of two profiles ('<>') adds the amplitudes
-- level by level; 'mempty' has the amplitude 0 everywhere.
--
-- The amplitudes of consecutive levels are stored in one unboxed array, from the first
-- level with an amplitude to the last.
data Profile = Profile {-# UNPACK #-} !Int !(PrimArray Double)

-- | Equality of the amplitudes at every level, whether stored or not.
instance Eq Profile where
  a == b = layers a == layers b

instance Show Profile where
  showsPrec p a =
    showParen (p > 10) (showString "profile " . showsPrec 11 (layers a))

instance Semigroup Profile where
  a <> b = profile (layers a <> layers b)

instance Monoid Profile where
  mempty = profile []

-- | The profile with these amplitudes, which should be finite. A level that occurs
-- twice gets the sum, and a level that does not occur gets 0.
profile :: [(Level, Double)] -> Profile
profile [] = Profile 0 (primArrayFromList [])
profile pairs = Profile first (primArrayFromList (map amplitudeOf [first .. final]))
  where
    numbers = map (levelNumber . fst) pairs
    first = minimum numbers
    final = maximum numbers
    amplitudeOf n = sum [a | (l, a) <- pairs, levelNumber l == n]

-- | @octaves first count gain@ is the profile of @count@ levels from @first@ on. Each
-- is twice as fine and @gain@ times as strong as the previous one, and the first has
-- the amplitude 1. Levels beyond 64 are left out; a count below 1 gives 'mempty'. A
-- gain of 0.5 looks like clouds, and a larger one rougher.
octaves :: Level -> Int -> Double -> Profile
octaves first count gain =
  profile (zip levels (take count (iterate (* gain) 1)))
  where
    levels = map clampedLevel [levelNumber first .. levelNumber maxBound]

-- | The levels whose amplitude is not 0, from coarse to fine.
layers :: Profile -> [(Level, Double)]
layers (Profile first amplitudes) =
  [ (clampedLevel n, a)
    | (n, a) <- zip [first ..] (primArrayToList amplitudes),
      a /= 0
  ]

-- | The sum of the amplitudes' moduli, which bounds the modulus of the profile's noise.
profileBound :: Profile -> Double
profileBound (Profile _ amplitudes) = sum (map abs (primArrayToList amplitudes))

-- | The profile scaled to the bound 1, so its noise lies in −1 to 1. A profile whose
-- bound is 0 or not finite is returned unchanged.
normalised :: Profile -> Profile
normalised p@(Profile first amplitudes)
  | bound > 0 && not (isInfinite bound) = Profile first (mapPrimArray (/ bound) amplitudes)
  | otherwise = p
  where
    bound = profileBound p

-- | The sum of amplitude times value over the levels whose amplitude is not 0, from
-- coarse to fine, in any monad. At most 65 steps; allocates nothing once inlined.
sumLayers :: Monad m => (Level -> m Double) -> Profile -> m Double
sumLayers value (Profile first amplitudes) = go 0 0
  where
    count = sizeofPrimArray amplitudes
    go !i !acc
      | i >= count = pure acc
      | amplitude == 0 = go (i + 1) acc
      | otherwise = do
        !v <- value (clampedLevel (first + i))
        go (i + 1) (acc + amplitude * v)
      where
        amplitude = indexPrimArray amplitudes i
{-# INLINE sumLayers #-}
