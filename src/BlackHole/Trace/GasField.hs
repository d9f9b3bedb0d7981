{-# LANGUAGE BangPatterns #-}

-- | Where the gas of a disk is: its density at a place and a time.
--
-- The density falls off like a Gaussian with the height, and softly at both
-- edges. Spiral arms are a wave in the disk's thickness, displaced by noise; they
-- turn as one, like the density waves of a galaxy. Turbulence is noise in the
-- logarithm of the density, in cells drawn out along the orbit, and bent by the
-- noise that displaces the arms.
--
-- /Time./ Gas nearer to the hole is faster, and a pattern that went with it would
-- be wound up into threads in the end. So each pattern of turbulence lives for one
-- orbit of the disk's inner edge only: it fades in while it unwinds, is itself in
-- the middle of its life and fades out while it is wound up, and two of them take
-- turns.
module BlackHole.Trace.GasField
  ( GasField,
    gasField,
    logDensity,
    faintest,
  )
where

import BlackHole.Noise.Lattice (clampedLevel)
import BlackHole.Noise.Profile (normalised, octaves)
import BlackHole.Noise.Remembered (Remembered, remember, rememberedPerlin3)
import BlackHole.Noise.Sheets
import BlackHole.Numeric.Exponential (sineOfTurns)
import BlackHole.Numeric.Floor (turnFraction)
import BlackHole.Physics.Angle (arcTangent2)
import BlackHole.Physics.GasMotion (keplerianRate)
import BlackHole.Physics.LightPath (halfHeightAt, regionInnerRadius)
import BlackHole.Scene.Disk
import BlackHole.Trace.Seeds
import BlackHole.Trace.Tabulated
import BlackHole.Vector.XYZ (XYZ (..), (*^), (^+^))
import qualified BlackHole.Vector.XYZ as XYZ
import Data.Word (Word64)
import Numeric (log1p)

-- | A disk's density made ready.
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
    fieldDisplacement :: !Remembered,
    fieldTurbulence :: {-# UNPACK #-} !Double,
    fieldFrequency :: {-# UNPACK #-} !Double,
    fieldWarp :: {-# UNPACK #-} !Double,
    fieldSheets :: !Sheets,
    fieldFirst :: !Pattern,
    fieldSecond :: !Pattern,
    -- | By the distance from the hole: ln of the density without noise, ln r,
    -- turns of the gas per unit of time.
    fieldRadial :: !Tabulated,
    -- | By the length to resolve over r: how many octaves of the turbulence, and
    -- what the others add to the density's logarithm on the average.
    fieldDetail :: !Tabulated,
    fieldEye :: !XYZ,
    -- | The angle of a pixel, in radians.
    fieldPixel :: {-# UNPACK #-} !Double,
    -- | The part of a stretch that has to be resolved: the samples of a pixel
    -- share the work.
    fieldShare :: {-# UNPACK #-} !Double
  }

-- | One pattern of turbulence.
data Pattern
  = -- | Its part in the sum; the time since it was itself, negative before; and
    -- where in the noise it is cut out, a height in cells.
    Pattern
      {-# UNPACK #-} !Double
      {-# UNPACK #-} !Double
      {-# UNPACK #-} !Double

-- | The density of a disk under a seed, for an eye at a place with pixels of an
-- angle and so many samples.
gasField :: Word64 -> Disk -> XYZ -> Double -> Int -> GasField
gasField seed disk eye pixel samples =
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
        remember
          tablePoints
          (purposeSeed seed ArmDisplacement)
          (normalised (octaves (clampedLevel 28) (diskArmNoiseOctaves disk) 0.5))
          (armPlace armScale (XYZ (negate outer) (negate top) (negate outer)))
          (armPlace armScale (XYZ outer top outer)),
      fieldTurbulence = diskTurbulence disk,
      fieldFrequency = diskTurbulenceFrequency disk,
      fieldWarp = diskTurbulenceWarp disk,
      fieldSheets = noise,
      fieldFirst = first,
      fieldSecond = second,
      fieldRadial = tabulate 3 2048 innermost outer $ \r -> [logEdges r, log r, keplerianRate (max 3 r) / (2 * pi)],
      fieldDetail = tabulate 2 1024 0 1 (detail disk (sheetsAmplitudes noise)),
      fieldEye = eye,
      fieldPixel = pixel,
      fieldShare = 1 / sqrt (fromIntegral samples)
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
    armTurn = diskTime disk * keplerianRate (max 3 (sqrt (max 1 inner * outer)))
    noise = sheets (purposeSeed seed GasTurbulence) (diskTurbulenceOctaves disk) 0.6
    (first, second) = patterns (diskTime disk * keplerianRate (max 3 inner) / (2 * pi)) (2 * pi / keplerianRate (max 3 inner))

-- | The two patterns at a time in lives, each life of this length. Their weights
-- add up to 1; the sum of their squares is made 1 in 'turbulence'.
patterns :: Double -> Double -> (Pattern, Pattern)
patterns lives life = (pattern' lives (1 - 2 * abs early) early, pattern' (lives + 0.5) (2 * abs early) late)
  where
    early = turnFraction lives
    late = turnFraction (lives + 0.5)
    pattern' at weight age = Pattern (weight / norm) (age * life) (17.3 * fromIntegral (round at :: Int))
    norm = sqrt ((1 - 2 * abs early) ^ (2 :: Int) + (2 * abs early) ^ (2 :: Int))

-- | How many octaves of turbulence a length over r resolves: those whose cells
-- are longer, and a part of the next. The finer ones are felt by their mean
-- alone; what noise of the variance v does to the mean of its exponential is a
-- factor of e^(v/2).
detail :: Disk -> [Double] -> Double -> [Double]
detail disk amplitudes len = [count, 0.5 * variance]
  where
    count = max 1 (min (fromIntegral (length amplitudes)) (0.75 - logBase 2 (max 1e-9 (diskTurbulenceFrequency disk * len))))
    variance = sum (zipWith lost [0 ..] amplitudes)
    lost i amplitude =
      let weight = max 0 (min 1 (count - i))
       in 0.0962 * (1 - weight * weight) * (diskTurbulence disk * amplitude) ^ (2 :: Int)

-- | Off the lattice, on which all octaves vanish together: the disk's plane
-- must not lie in one of its planes.
armPlace :: Double -> XYZ -> XYZ
armPlace scale place = scale *^ place ^+^ XYZ 5.3 5.3 5.3
{-# INLINE armPlace #-}

-- | Gas below this logarithm of its density is left out: all of it together has
-- less than a thousandth of the optical depth.
faintest :: Double
faintest = -7.5

-- | @logDensity field place r len@: the natural logarithm of the density over
-- that of dense gas, at a place at the distance r from the hole, as far as a
-- stretch of this length can tell; far below 'faintest' where there is none.
logDensity :: GasField -> XYZ -> Double -> Double -> Double
logDensity field place@(XYZ x y z) !r !len
  | r >= fieldOuter field || profile - plain * plain < faintest = 2 * faintest
  | otherwise =
    let !azimuth = arcTangent2 x z * (1 / (2 * pi))
        !displaced
          | fieldArmDepth field == 0 && fieldWarp field == 0 = 0
          | otherwise = displacement field place
        !height = plain / armThickness field r azimuth displaced
     in profile - height * height + turbulence field place r len azimuth displaced (valueAt (fieldRadial field) row 1) (valueAt (fieldRadial field) row 2)
  where
    row = rowAt (fieldRadial field) r
    profile = valueAt (fieldRadial field) row 0
    -- The arms only make the disk thinner.
    !plain = y / (fieldThickness field + fieldFlare field * r)
{-# INLINE logDensity #-}

-- | The noise that displaces the arms and bends the turbulence, −1 … 1. It turns
-- with the arms.
displacement :: GasField -> XYZ -> Double
displacement field (XYZ x y z) =
  rememberedPerlin3 (fieldDisplacement field) 64 (armPlace (fieldArmScale field) (XYZ (c * x - s * z) y (s * x + c * z)))
  where
    c = fieldArmCosine field
    s = fieldArmSine field
{-# INLINE displacement #-}

-- | The thickness of the disk over that without arms, at most 1. The azimuth is
-- in turns.
armThickness :: GasField -> Double -> Double -> Double -> Double
armThickness field r azimuth displaced
  | depth == 0 = 1
  | otherwise = 1 - depth + depth * wave * wave * wave
  where
    depth = fieldArmDepth field
    wave =
      sineOfTurns
        (fieldArms field * (azimuth - fieldArmTurns field) + (fieldArmWinding field * r + fieldArmNoise field * displaced) * (1 / (2 * pi)))
{-# INLINE armThickness #-}

-- | What turbulence adds to the logarithm of the density. Gas is drawn out along
-- its orbit, trailing outwards, and looks alike at every radius.
turbulence :: GasField -> XYZ -> Double -> Double -> Double -> Double -> Double -> Double -> Double
turbulence field place@(XYZ _ y _) r len azimuth displaced logR !rate
  | fieldTurbulence field == 0 = 0
  | otherwise = fieldTurbulence field * (part (fieldFirst field) + part (fieldSecond field)) + valueAt (fieldDetail field) resolved 1
  where
    finest = max (fieldShare field * len) (fieldPixel field * XYZ.distance place (fieldEye field)) / r
    !resolved = rowAt (fieldDetail field) finest
    !count = valueAt (fieldDetail field) resolved 0
    !v = fieldFrequency field * logR + fieldWarp field * displaced
    !height = fieldFrequency field * y / r
    !turns = azimuth + 0.35 * logR
    part (Pattern weight age shift)
      | weight < 1e-6 = 0
      | otherwise = weight * sheetsValue (fieldSheets field) count (turnFraction (turns - rate * age)) v (height + shift)
{-# INLINE turbulence #-}

-- | The most lattice points to remember for one noise: 2 MB.
tablePoints :: Int
tablePoints = 2000000

-- | ln (1 / (1 + e^(-t))).
logLogistic :: Double -> Double
logLogistic t = if t < 0 then t - log1p (exp t) else negate (log1p (exp (negate t)))
