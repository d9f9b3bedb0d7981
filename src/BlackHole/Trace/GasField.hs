{-# LANGUAGE BangPatterns #-}
-- Pass positions and patterns, a dozen numbers, in registers and on the stack instead of on
-- the heap.
{-# OPTIONS_GHC -fmax-worker-args=24 #-}

-- | The density and the relative temperature of a disk's gas at a position and a time.
--
-- The density falls off like a Gaussian with height, and smoothly at both edges.
-- Spiral arms are a wave in the disk's thickness, displaced by noise; they rotate
-- rigidly, like the density waves of a galaxy. Turbulence is noise in the
-- logarithm of the density, in cells drawn out along the orbit, with filaments and
-- with coarse eddies that bend the finer ones. A haze of a few thousandths of the
-- density reaches higher than the disk.
--
-- /Heat./ Dense gas is hotter: ln T varies with the surface density's logarithm.
-- It is normalised so that the mean of T⁴, the flux of a ring, stays that of the
-- thin disk without turbulence, whatever octaves are resolved.
--
-- /Time./ Gas orbits faster the nearer it is to the hole, so a pattern carried along
-- would wind up into ever thinner threads. Each pattern of turbulence therefore lasts
-- for one orbit of the disk's inner edge only: it fades in while it unwinds, is
-- undistorted in the middle of its life, and fades out while it winds up. Two patterns
-- alternate.
module BlackHole.Trace.GasField
  ( GasField,
    gasField,
    Here (..),
    gasAt,
    faintest,
  )
where

import BlackHole.Matter.GasFlow (patternRate)
import BlackHole.Noise.CachedNoise (CachedNoise, cacheNoise, cachedPerlin3)
import BlackHole.Noise.Lattice (clampedLevel)
import BlackHole.Noise.Profile (normalised, octaves)
import BlackHole.Noise.Sheets
import BlackHole.Numeric.Angle (arcTangent2)
import BlackHole.Numeric.Exponential (exponential, sineOfTurns)
import BlackHole.Numeric.Floor (turnFraction)
import BlackHole.Scene.Disk
import BlackHole.Spacetime.LightPath (halfHeightAt, regionInnerRadius)
import BlackHole.Spacetime.Types (Spacetime)
import BlackHole.Trace.Seeds
import BlackHole.Trace.Tabulated
import BlackHole.Trace.TurbulenceDetail
import BlackHole.Vector.XYZ (XYZ (..), (*^), (^+^))
import Data.Word (Word64)
import Numeric (log1p)

-- | The gas of a disk, prepared for evaluation.
data GasField = GasField
  { fieldOuter :: {-# UNPACK #-} !Double,
    -- | The thickness on the axis, and its growth per radius.
    fieldThickness :: {-# UNPACK #-} !Double,
    fieldFlare :: {-# UNPACK #-} !Double,
    fieldArms :: {-# UNPACK #-} !Double,
    fieldArmWinding :: {-# UNPACK #-} !Double,
    fieldArmDepth :: {-# UNPACK #-} !Double,
    fieldArmNoise :: {-# UNPACK #-} !Double,
    fieldArmScale :: {-# UNPACK #-} !Double,
    -- | The angle by which the arms have turned: turns, cosine, sine.
    fieldArmTurns :: {-# UNPACK #-} !Double,
    fieldArmCosine :: {-# UNPACK #-} !Double,
    fieldArmSine :: {-# UNPACK #-} !Double,
    fieldDisplacement :: !CachedNoise,
    fieldTurbulence :: {-# UNPACK #-} !Double,
    fieldFrequency :: {-# UNPACK #-} !Double,
    fieldTrail :: {-# UNPACK #-} !Double,
    fieldWeave :: !Weave,
    -- | ln of the relative temperature per ln of the surface density, and what
    -- the arms' mean takes from it.
    fieldHeat :: {-# UNPACK #-} !Double,
    fieldArmHeat :: {-# UNPACK #-} !Double,
    -- | The haze's density over the disk's in the plane, and its thickness over
    -- the disk's, squared and inverted.
    fieldHaze :: {-# UNPACK #-} !Double,
    fieldHazeNarrowness :: {-# UNPACK #-} !Double,
    fieldSheets :: !Sheets,
    fieldFirst :: !Pattern,
    fieldSecond :: !Pattern,
    -- | By the distance from the hole: ln of the density without noise, ln r,
    -- turns of the gas per unit of time.
    fieldRadial :: !Tabulated,
    -- | By the length to resolve over r: how many octaves of the turbulence, what
    -- the others add to the density's logarithm on the average, and ln of the mean
    -- of T⁴ that these make, over 4.
    fieldDetail :: !Tabulated
  }

-- | One pattern of turbulence.
data Pattern
  = -- | Its weight in the sum; the time since it was undistorted, negative before; and
    -- its position in the noise, a height in cells.
    Pattern
      {-# UNPACK #-} !Double
      {-# UNPACK #-} !Double
      {-# UNPACK #-} !Double

-- | The gas of a disk, with its seed.
gasField :: Spacetime -> Word64 -> Disk -> GasField
gasField space seed disk =
  GasField
    { fieldOuter = outer,
      fieldThickness = diskThicknessAt disk 0,
      fieldFlare = (diskThicknessAt disk outer - diskThicknessAt disk 0) / outer,
      fieldArms = fromIntegral (diskArms disk),
      fieldArmWinding = diskArmWinding disk,
      fieldArmDepth = if diskArms disk == 0 then 0 else diskArmDepth disk,
      fieldArmNoise = diskArmNoise disk,
      fieldArmScale = armScale,
      fieldArmTurns = armTurn / (2 * pi),
      fieldArmCosine = cos armTurn,
      fieldArmSine = sin armTurn,
      fieldDisplacement =
        cacheNoise
          tablePoints
          (purposeSeed seed ArmDisplacement)
          (normalised (octaves (clampedLevel 28) (diskArmNoiseOctaves disk) 0.5))
          (armPlace armScale (XYZ (negate outer) (negate top) (negate outer)))
          (armPlace armScale (XYZ outer top outer)),
      fieldTurbulence = diskTurbulence disk,
      fieldFrequency = diskTurbulenceFrequency disk,
      fieldTrail = 0.35,
      fieldWeave = woven,
      fieldHeat = diskTurbulenceHeat disk,
      fieldArmHeat = armHeat,
      fieldHaze = diskHaze disk,
      fieldHazeNarrowness = (1 / diskHazeHeight disk) ^ (2 :: Int),
      fieldSheets = noise,
      fieldFirst = first,
      fieldSecond = second,
      fieldRadial = tabulate 3 2048 innermost outer $ \r -> [logEdges r, log r, rate r / (2 * pi)],
      fieldDetail =
        tabulate 3 1024 0 1 $
          turbulenceDetail disk noise woven (strand first) (strand second)
    }
  where
    inner = diskInnerRadius disk
    outer = diskOuterRadius disk
    region = diskRegion Fine disk
    innermost = regionInnerRadius region
    top = halfHeightAt region outer
    -- The widths of both edges are the report's: 1/10 of a radius unit inside,
    -- 1/15 of the disk outside.
    logEdges r = logLogistic (10 * (r - inner)) + logLogistic (15 * (diskFade disk - r / outer))
    armScale = 16 * diskArmNoiseFrequency disk
    -- The arms turn with the gas half way out, by orders of magnitude.
    armTurn = diskTime disk * rate (sqrt (max 1 inner * outer))
    noise =
      sheets
        (purposeSeed seed GasTurbulence)
        (diskTurbulenceOctaves disk)
        (diskTurbulenceGain disk)
    woven =
      Weave
        (diskTurbulenceFilaments disk)
        (diskTurbulenceWarp disk)
        (diskTurbulenceGrowth disk)
    strand (Pattern weight _ shift) turns = Strand weight turns shift
    -- ln ⟨T⁴⟩ / 4 over the phase of the arms.
    armHeat
      | diskTurbulenceHeat disk == 0 || diskArms disk == 0 = 0
      | otherwise = 0.25 * log (sum [heatOf (sin phase) | phase <- phases] / 256)
    heatOf wave = exp (4 * diskTurbulenceHeat disk * armFluctuation (diskArmDepth disk) wave)
    phases = [2 * pi * fromIntegral k / 256 | k <- [1 .. 256 :: Int]]
    (first, second) = patterns (diskTime disk * rate inner / (2 * pi)) (2 * pi / rate inner)
    rate = patternRate space

-- | The two patterns at a time in lives, each life of this length. Their weights
-- add up to 1; the sum of their squares is made 1 in 'turbulence'.
patterns :: Double -> Double -> (Pattern, Pattern)
patterns lives life =
  ( pattern' lives (1 - 2 * abs early) early,
    pattern' (lives + 0.5) (2 * abs early) late
  )
  where
    early = turnFraction lives
    late = turnFraction (lives + 0.5)
    pattern' at weight age =
      Pattern (weight / norm) (age * life) (17.3 * fromIntegral (round at :: Int))
    norm = sqrt ((1 - 2 * abs early) ^ (2 :: Int) + (2 * abs early) ^ (2 :: Int))

-- | A position in the noise of the arms. It is shifted off the lattice, where all octaves
-- vanish: the disk's plane must not be a lattice plane.
armPlace :: Double -> XYZ -> XYZ
armPlace scale place = scale *^ place ^+^ XYZ 5.3 5.3 5.3
{-# INLINE armPlace #-}

-- | The logarithm of 'thinnestGas'.
faintest :: Double
faintest = -7.5

-- | The gas at a position.
data Here = Here
  { -- | Its density over that of dense gas.
    hereDensity :: {-# UNPACK #-} !Double,
    -- | ln of its temperature over the mean of its ring.
    hereHeat :: {-# UNPACK #-} !Double
  }
  deriving (Eq, Show)

-- | @gasAt field place r len@ is the gas at a position at the distance @r@ from the hole,
-- smoothed to what a length of @len@ can resolve. The density is 0 below 'thinnestGas'.
gasAt :: GasField -> XYZ -> Double -> Double -> Here
gasAt field place@(XYZ x y z) !r !len
  | r >= fieldOuter field = Here 0 0
  | profile - plain * plain < faintest = Here thin 0
  | otherwise =
    let !azimuth = arcTangent2 x z * (1 / (2 * pi))
        !displaced
          | fieldArmDepth field == 0 = 0
          | otherwise = displacement field place
        !wave = armWave field r azimuth displaced
        !height = plain / armThickness field wave
        !resolved = rowAt (fieldDetail field) (len / r)
        !swirl =
          turbulence
            field
            place
            r
            (valueAt (fieldDetail field) resolved 0)
            azimuth
            (valueAt (fieldRadial field) row 1)
            (valueAt (fieldRadial field) row 2)
        !dense =
          exponential (profile - height * height + swirl + valueAt (fieldDetail field) resolved 1)
        !heat
          | fieldHeat field == 0 = 0
          | otherwise =
            fieldHeat field * (swirl + armFluctuation (fieldArmDepth field) wave)
              - valueAt (fieldDetail field) resolved 2
              - fieldArmHeat field
     in -- A literal below 1e-99 would be computed anew each time, on the heap (GHC 9.2 and later).
        Here (dense + thin) (heat * (dense / (dense + thin + 1e-99)))
  where
    row = rowAt (fieldRadial field) r
    profile = valueAt (fieldRadial field) row 0
    -- The arms only make the disk thinner.
    !plain = y / (fieldThickness field + fieldFlare field * r)
    !thin = haze field profile plain
{-# INLINE gasAt #-}

-- | The density of the haze over that of dense gas, from the logarithm of the smooth
-- disk's density in the plane and the height in thicknesses of the disk.
haze :: GasField -> Double -> Double -> Double
haze field !profile !plain
  | fieldHaze field == 0 || e < faintest = 0
  | otherwise = fieldHaze field * exponential e
  where
    e = profile - plain * plain * fieldHazeNarrowness field
{-# INLINE haze #-}

-- | The noise that displaces the arms, from −1 to 1. It rotates with them.
displacement :: GasField -> XYZ -> Double
displacement field (XYZ x y z) =
  cachedPerlin3
    (fieldDisplacement field)
    64
    (armPlace (fieldArmScale field) (XYZ (c * x - s * z) y (s * x + c * z)))
  where
    c = fieldArmCosine field
    s = fieldArmSine field
{-# INLINE displacement #-}

-- | The wave of the arms, from −1 to 1. The azimuth is in turns.
armWave :: GasField -> Double -> Double -> Double -> Double
armWave field r azimuth displaced
  | fieldArmDepth field == 0 = 0
  | otherwise =
    sineOfTurns
      ( fieldArms field * (azimuth - fieldArmTurns field)
          + (fieldArmWinding field * r + fieldArmNoise field * displaced) * (1 / (2 * pi))
      )
{-# INLINE armWave #-}

-- | The thickness of the disk over that without arms, at most 1.
armThickness :: GasField -> Double -> Double
armThickness field wave
  | depth == 0 = 1
  | otherwise = 1 - depth + depth * wave * wave * wave
  where
    depth = fieldArmDepth field
{-# INLINE armThickness #-}

-- | ln of that thickness over its mean, to first order: the effect of the arms on the
-- surface density.
armFluctuation :: Double -> Double -> Double
armFluctuation depth wave = depth / (1 - depth) * wave * wave * wave
{-# INLINE armFluctuation #-}

-- | The contribution of turbulence, up to a number of octaves, to the logarithm of the
-- density. Its cells are drawn out along the orbits, trail outwards, and are similar at
-- every radius.
turbulence :: GasField -> XYZ -> Double -> Double -> Double -> Double -> Double -> Double
turbulence field (XYZ _ y _) r count azimuth logR !rate
  | fieldTurbulence field == 0 = 0
  | otherwise =
    fieldTurbulence field
      * weave
        (fieldSheets field)
        (fieldWeave field)
        count
        v
        (strand (fieldFirst field))
        (strand (fieldSecond field))
  where
    !v = fieldFrequency field * logR
    !height = fieldFrequency field * y / r
    !turns = azimuth + fieldTrail field * logR
    strand (Pattern weight age shift) =
      Strand weight (turnFraction (turns - rate * age)) (height + shift)
{-# INLINE turbulence #-}

-- | The greatest number of lattice points cached for one noise: 2 MB.
tablePoints :: Int
tablePoints = 2000000

-- | ln (1 / (1 + e^(-t))).
logLogistic :: Double -> Double
logLogistic t = if t < 0 then t - log1p (exp t) else negate (log1p (exp (negate t)))
