{-# LANGUAGE BangPatterns #-}
-- One sample of gas is a function of a dozen numbers: they go from caller to
-- callee as they are, not through the heap.
{-# OPTIONS_GHC -fmax-worker-args=24 #-}

-- | Light gathered from the disk's gas along a path, front to back.
module BlackHole.Trace.Gas
  ( Gathered (..),
    nothingYet,
    opaqueEnough,
    Gas,
    gas,
    gatherGas,
    gatherParity,
  )
where

import BlackHole.Light.BlackBodyTable (Brightness (..), blackBodyRadiance)
import BlackHole.Light.Display (decodeSrgb)
import BlackHole.Light.Radiance
import BlackHole.Noise.Lattice (clampedLevel)
import BlackHole.Noise.Profile (normalised, octaves)
import BlackHole.Noise.Remembered (Remembered, remember, rememberedPerlin3)
import BlackHole.Noise.Sheets
import BlackHole.Numeric.Exponential (exponential, sineOfTurns)
import BlackHole.Numeric.Floor (turnFraction)
import BlackHole.Physics.Angle (arcTangent2)
import BlackHole.Physics.LightPath
import BlackHole.Physics.Redshift (gasFrequency)
import BlackHole.Physics.ThinDisk (relativeTemperature)
import BlackHole.Scene.Disk
import BlackHole.Scene.Shifts
import BlackHole.Trace.Seeds
import BlackHole.Trace.Tabulated
import BlackHole.Vector.XYZ (XYZ (..), (*^), (^+^))
import qualified BlackHole.Vector.XYZ as XYZ
import Data.Word (Word64)
import GHC.Exts (lazy)
import Numeric (log1p)

-- | What has been gathered so far.
data Gathered = Gathered
  { -- | Light that reaches the camera from the gas passed so far.
    gatheredRadiance :: {-# UNPACK #-} !Radiance,
    -- | The part of the light from behind that still gets through.
    gatheredTransmittance :: {-# UNPACK #-} !Double
  }

-- | At the camera: no light, nothing in the way.
nothingYet :: Gathered
nothingYet = Gathered black 1

-- | The report's "opacity exceeds 99 %".
opaqueEnough :: Double
opaqueEnough = 0.01

-- | Whether to go on behind what has been gathered.
onward :: Gathered -> Onward Gathered
onward gathered
  | gatheredTransmittance gathered < opaqueEnough = Hidden gathered
  | otherwise = Onward gathered
{-# INLINE onward #-}

-- | Pass through gas of optical depth @tau@ that would have the radiance
-- @source@ if nothing could be seen through it. The closed form is exact for
-- uniform gas, so that thick stretches are as right as thin ones.
pass :: Double -> Radiance -> Gathered -> Gathered
pass !tau !source (Gathered light transmittance) =
  Gathered (light <+> scaleRadiance (transmittance - transmittance') source) transmittance'
  where
    transmittance' = transmittance * exponential (negate tau)
{-# INLINE pass #-}

-- | A disk's gas made ready.
data Gas = Gas
  { gasInner :: {-# UNPACK #-} !Double,
    gasOuter :: {-# UNPACK #-} !Double,
    -- | The reciprocal of the thickness is the one over this polynomial's value
    -- at r: constant and linear part.
    gasThickness :: {-# UNPACK #-} !Double,
    gasFlare :: {-# UNPACK #-} !Double,
    -- | Opacity per length of dense gas.
    gasExtinction :: {-# UNPACK #-} !Double,
    gasArms :: {-# UNPACK #-} !Double,
    gasArmWinding :: {-# UNPACK #-} !Double,
    gasArmDepth :: {-# UNPACK #-} !Double,
    gasArmNoise :: {-# UNPACK #-} !Double,
    gasArmScale :: {-# UNPACK #-} !Double,
    gasArmField :: !Remembered,
    gasTurbulence :: {-# UNPACK #-} !Double,
    gasTurbulenceFrequency :: {-# UNPACK #-} !Double,
    gasTurbulenceField :: !Sheets,
    -- | By the length to resolve over r: how many levels of the turbulence, and
    -- what the others add to the density's logarithm on the average.
    gasDetail :: !Tabulated,
    gasEye :: !XYZ,
    -- | The angle of a pixel, in radians.
    gasPixel :: {-# UNPACK #-} !Double,
    -- | The part of a stretch that has to be resolved: the samples of a pixel
    -- share the work.
    gasShare :: {-# UNPACK #-} !Double,
    -- | By the distance from the hole: density without noise, temperature over
    -- the peak's, ln r.
    gasRadial :: !Tabulated,
    gasShifts :: !Shifts,
    gasGlow :: !Glow
  }

-- | How gas shines.
data Glow
  = -- | The report's colours, by the radius.
    ByRadius {-# UNPACK #-} !Double
  | -- | As a black body: by its temperature over the peak's; tabulated, and
    -- for those beyond the table.
    ByTemperature !Tabulated !(Double -> Radiance)

-- | The gas of a disk under a seed, with the shifts that count, for an eye at a
-- place with pixels of an angle and so many samples.
gas :: Word64 -> Shifts -> Disk -> XYZ -> Double -> Int -> Gas
gas seed shifts disk eye pixel samples =
  Gas
    { gasInner = inner,
      gasOuter = outer,
      gasThickness = diskThicknessAt disk 0,
      gasFlare = (diskThicknessAt disk outer - diskThicknessAt disk 0) / outer,
      gasExtinction = diskOpacity disk / diskThickness disk,
      gasArms = fromIntegral (diskArms disk),
      gasArmWinding = diskArmWinding disk,
      gasArmDepth = if diskArms disk == 0 then 0 else diskArmDepth disk,
      gasArmNoise = diskArmNoise disk,
      gasArmScale = armScale,
      gasArmField =
        remember
          tablePoints
          (purposeSeed seed ArmDisplacement)
          (normalised (octaves (clampedLevel 28) (diskArmNoiseOctaves disk) 0.5))
          (armPlace armScale (XYZ (negate outer) (negate top) (negate outer)))
          (armPlace armScale (XYZ outer top outer)),
      gasTurbulence = diskTurbulence disk,
      gasTurbulenceFrequency = diskTurbulenceFrequency disk,
      gasTurbulenceField = turbulenceField,
      gasDetail = tabulate 2 1024 0 1 (detail disk (sheetsAmplitudes turbulenceField)),
      gasEye = eye,
      gasPixel = pixel,
      gasShare = 1 / sqrt (fromIntegral samples),
      gasRadial = tabulate 3 2048 innermost outer $ \r -> [logEdges r, relativeTemperature r, log r],
      gasShifts = shifts,
      gasGlow = case diskColour disk of
        HueRamp -> ByRadius (diskBrightness disk)
        BlackBody peak ->
          let blackBody = blackBodyRadiance Bolometric peak
              glow t = scaleRadiance (diskBrightness disk) (blackBody (t * peak))
           in ByTemperature (tabulate 3 4096 0 hottest (\t -> let Radiance r g b = glow t in [r, g, b])) glow
    }
  where
    inner = diskInnerRadius disk
    outer = diskOuterRadius disk
    innermost = regionInnerRadius (diskRegion Fine disk)
    -- The widths of both edges are the report's: 1/10 of a radius unit inside,
    -- 1/15 of the disk outside.
    logEdges r = logLogistic (10 * (r - inner)) + logLogistic (15 * (diskFade disk - r / outer))
    armScale = 16 * diskArmNoiseFrequency disk
    turbulenceField = sheets (purposeSeed seed GasTurbulence) 4 0.6
    -- The region's greatest height.
    top = halfHeightAt (diskRegion Fine disk) outer

-- | How many levels of turbulence a length over r resolves: those whose cells
-- are no shorter, and half of the next. The finer ones are felt by their mean
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

-- | Relative temperatures that are tabulated. Only somebody who falls or orbits
-- close to the hole sees higher ones.
hottest :: Double
hottest = 4

-- | Off the lattice, on which all octaves vanish together: the disk's plane
-- must not lie in one of its planes.
armPlace :: Double -> XYZ -> XYZ
armPlace scale place = scale *^ place ^+^ XYZ 5.3 5.3 5.3
{-# INLINE armPlace #-}

-- | @gatherGas gas observed@ adds the gas of one stretch, for light that an
-- observer sees at @observed@ times its frequency at infinity.
gatherGas :: Gas -> Double -> Gathered -> Stretch -> Onward Gathered
gatherGas g observed gathered stretch = onward (throughGas g observed gathered stretch)
{-# INLINE gatherGas #-}

-- A call of its own: inlined into the loop that follows a path, it would leave
-- no register for either. The gas goes in as a pointer, for which 'lazy' stands.
throughGas :: Gas -> Double -> Gathered -> Stretch -> Gathered
throughGas prepared !observed !gathered !stretch
  | r >= gasOuter g || profile - plain * plain < faintest = gathered
  | otherwise =
    let !azimuth = arcTangent2 x z * (1 / (2 * pi))
        !height = plain / armThickness g place r azimuth
        !opacity = gasExtinction g * exponential (profile - height * height + turbulence g stretch r azimuth logR)
     in case gasGlow g of
          ByRadius brightness ->
            pass
              (opacity * stretchLength stretch)
              (scaleRadiance brightness (hueRamp ((r - 1) / (gasOuter g - 1))))
              gathered
          ByTemperature table glow
            | r <= 1 -> gathered
            | otherwise ->
              let !static = sqrt (r / (r - 1))
                  !emitted = gasFrequency place r (stretchVelocity stretch)
                  -- The length of the stretch in the gas's own frame, where its
                  -- opacity is meant: ν_em times the affine length. Without the
                  -- Doppler shift that gas is thought at rest.
                  Shifts doppler gravity = gasShifts g
                  !frequency = if doppler then emitted else static
                  !tau = opacity * frequency * stretchAffineLength stretch
                  !shift = (if gravity then observed / static else 1) * (if doppler then static / emitted else 1)
                  !temperature = shift * relative
                  source
                    | temperature < hottest =
                      let row' = rowAt table temperature
                       in Radiance (valueAt table row' 0) (valueAt table row' 1) (valueAt table row' 2)
                    | otherwise = glow temperature
               in pass tau source gathered
  where
    g = lazy prepared
    !place@(XYZ x y z) = stretchMiddle stretch
    !r = XYZ.norm place
    row = rowAt (gasRadial g) r
    profile = valueAt (gasRadial g) row 0
    relative = valueAt (gasRadial g) row 1
    logR = valueAt (gasRadial g) row 2
    -- The arms only make the disk thinner.
    !plain = y / (gasThickness g + gasFlare g * r)
{-# NOINLINE throughGas #-}

-- | The thickness of the disk over that without arms, at most 1. The azimuth is
-- in turns.
armThickness :: Gas -> XYZ -> Double -> Double -> Double
armThickness g place r azimuth
  | depth == 0 = 1
  | otherwise = 1 - depth + depth * wave * wave * wave
  where
    depth = gasArmDepth g
    displacement = gasArmNoise g * rememberedPerlin3 (gasArmField g) 64 (armPlace (gasArmScale g) place)
    wave = sineOfTurns (gasArms g * azimuth + (gasArmWinding g * r + displacement) * (1 / (2 * pi)))
{-# INLINE armThickness #-}

-- | What turbulence adds to the logarithm of the density. Gas is drawn out along
-- its orbit, trailing outwards, and looks alike at every radius.
turbulence :: Gas -> Stretch -> Double -> Double -> Double -> Double
turbulence g stretch r azimuth logR
  | gasTurbulence g == 0 = 0
  | otherwise =
    gasTurbulence g
      * sheetsValue
        (gasTurbulenceField g)
        (valueAt (gasDetail g) resolved 0)
        (turnFraction (azimuth + 0.35 * logR))
        (gasTurbulenceFrequency g * logR)
        (gasTurbulenceFrequency g * y / r)
      + valueAt (gasDetail g) resolved 1
  where
    place@(XYZ _ y _) = stretchMiddle stretch
    finest = max (gasShare g * stretchLength stretch) (gasPixel g * XYZ.distance place (gasEye g)) / r
    resolved = rowAt (gasDetail g) finest
{-# INLINE turbulence #-}

-- | The most lattice points to remember for one noise: 2 MB.
tablePoints :: Int
tablePoints = 2000000

-- | Gas below this logarithm of its density is left out: all of it together has
-- less than a thousandth of the optical depth.
faintest :: Double
faintest = -7.5

-- | ln (1 / (1 + e^(-t))).
logLogistic :: Double -> Double
logLogistic t = if t < 0 then t - log1p (exp t) else negate (log1p (exp (negate t)))

-- | The report's gas colour between the hole's edge (0) and the disk's (1):
-- hue 50° to 20°, saturation 0.8, full value, read as a display colour.
hueRamp :: Double -> Radiance
hueRamp t = Radiance 1 (decodeSrgb green) (decodeSrgb 0.2)
  where
    green = 0.2 + 0.8 * (50 - 30 * t) / 60

-- | Alternating blue and green blocks of one Schwarzschild radius, as thick as
-- the disk; everything behind them is hidden.
gatherParity :: Disk -> Gathered -> Stretch -> Onward Gathered
gatherParity disk gathered stretch
  | abs y > diskThickness disk || r > diskOuterRadius disk = Onward gathered
  | otherwise = onward (pass 10 (if even blocks then Radiance 0 0 1 else Radiance 0 1 0) gathered)
  where
    place@(XYZ x y z) = stretchMiddle stretch
    r = XYZ.norm place
    blocks = round x + round y + round z :: Int
