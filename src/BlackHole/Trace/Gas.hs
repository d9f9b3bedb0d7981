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
    gasSeenFrom,
    gatherGas,
    gatherParity,
  )
where

import BlackHole.Light.BlackBodyTable (blackBodyRadiance)
import qualified BlackHole.Light.BlackBodyTable as BlackBodyTable (Brightness (..))
import BlackHole.Light.Display (decodeSrgb)
import BlackHole.Light.Radiance
import BlackHole.Matter.GasFlow
import BlackHole.Matter.ThinDisk (relativeTemperature, thinDisk)
import BlackHole.Numeric.Exponential (exponential)
import BlackHole.Scene.Disk
import BlackHole.Scene.Shifts
import BlackHole.Spacetime.LightPath
import BlackHole.Spacetime.Types (Spacetime, spacetimeHorizon, spacetimeSpin)
import BlackHole.Trace.GasField
import BlackHole.Trace.Tabulated
import BlackHole.Vector.XYZ (XYZ (..))
import qualified BlackHole.Vector.XYZ as XYZ
import Data.Word (Word64)
import GHC.Exts (lazy)

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

-- | Continues until the gas in front hides what lies behind it.
onward :: Gathered -> Continue Gathered
onward gathered
  | gatheredTransmittance gathered < opaqueEnough = Stop gathered
  | otherwise = Continue gathered
{-# INLINE onward #-}

-- | The light after a uniform segment of optical depth @tau@ whose radiance would be
-- @source@ if it were opaque. The closed form is exact for any optical depth.
pass :: Double -> Radiance -> Gathered -> Gathered
pass !tau !source (Gathered light transmittance) =
  Gathered (light <+> scaleRadiance (transmittance - transmittance') source) transmittance'
  where
    transmittance' = transmittance * exponential (negate tau)
{-# INLINE pass #-}

-- | The gas of a disk, prepared for tracing.
data Gas = Gas
  { gasDensity :: !GasField,
    -- | The camera's position, and the angle of a pixel in radians.
    gasEye :: {-# UNPACK #-} !XYZ,
    gasPixel :: {-# UNPACK #-} !Double,
    gasOuter :: {-# UNPACK #-} !Double,
    -- | Opacity per length of dense gas.
    gasExtinction :: {-# UNPACK #-} !Double,
    gasShifts :: !Shifts,
    -- | The horizon's radius; there is no gas at and inside it.
    gasHorizon :: {-# UNPACK #-} !Double,
    gasGlow :: !Glow,
    -- | How the gas moves.
    gasAround :: !GasFlow
  }

-- | The emission of the gas.
data Glow
  = -- | The colours of the design report, which depend on the radius. Holds the
    -- brightness.
    ByRadius {-# UNPACK #-} !Double
  | -- | Thermal emission. Temperatures are relative to that of the hottest ring: a table
    -- of the temperature by radius, a table of the radiance by observed temperature, and
    -- the function for temperatures beyond that table.
    ByTemperature !Tabulated !Tabulated !(Double -> Radiance)

-- | @gas space seed shifts disk eye pixel@ is the gas of a disk with its seed and
-- the frequency shifts that apply, for a camera at @eye@ whose pixels subtend @pixel@
-- radians.
gas :: Spacetime -> Word64 -> Shifts -> Disk -> XYZ -> Double -> Gas
gas space seed shifts disk eye pixel =
  Gas
    { gasDensity = gasField space seed disk,
      gasEye = eye,
      gasPixel = pixel,
      gasOuter = diskOuterRadius disk,
      gasExtinction = diskOpacity disk / diskThickness disk,
      gasShifts = shifts,
      gasHorizon = spacetimeHorizon space,
      gasAround = gasFlow space,
      gasGlow = case diskColour disk of
        HueRamp -> ByRadius (diskBrightness disk)
        BlackBody peak ->
          let blackBody = blackBodyRadiance BlackBodyTable.Bolometric peak
           in byTemperature thin (\t -> blackBody (t * peak))
        Bolometric -> byTemperature thin bolometric
        Synchrotron -> byTemperature recip bolometric
    }
  where
    bolometric t = grey (t * t * (t * t))
    thin = relativeTemperature (thinDisk (spacetimeSpin space))
    byTemperature temperatureAt light =
      ByTemperature
        (tabulate 1 2048 innermost (diskOuterRadius disk) (pure . temperatureAt))
        (tabulate 3 4096 0 hottest (\t -> let Radiance r g b = glow t in [r, g, b]))
        glow
      where
        innermost = regionInnerRadius (diskRegion Fine disk)
        glow t = scaleRadiance (diskBrightness disk) (light t)

-- | The gas for another camera position and pixel size, without computing its tables
-- again.
gasSeenFrom :: XYZ -> Double -> Gas -> Gas
gasSeenFrom eye pixel g = g {gasEye = eye, gasPixel = pixel}

-- | The highest relative temperature in the table. Only an observer who falls or orbits
-- close to the hole sees higher ones.
hottest :: Double
hottest = 4

-- | @gatherGas gas observed@ adds the gas of one segment, for light that an
-- observer sees at @observed@ times its frequency at infinity.
gatherGas :: Gas -> Double -> Gathered -> PathSegment -> Continue Gathered
gatherGas g observed gathered segment = onward (throughGas g observed gathered segment)
{-# INLINE gatherGas #-}

-- Not inlined, because the loop that follows a path would run out of registers. 'lazy'
-- makes GHC pass the gas as a pointer instead of unpacking it.
throughGas :: Gas -> Double -> Gathered -> PathSegment -> Gathered
throughGas prepared !observed !gathered !segment = case gasAt (gasDensity g) place r resolved of
  Here dense heat
    | dense < thinnestGas -> gathered
    | otherwise -> shining (gasExtinction g * dense) heat
  where
    g = lazy prepared
    !place@(XYZ _ py _) = segmentMiddle segment
    !r = segmentRadius segment
    !inward = abs (segmentRadialStep segment)
    !upward = abs (segmentVerticalStep segment)
    -- The length that the gas resolves: that of the pixel's image on it, and no less than a
    -- fifth of the segment across the orbits, along which structure is drawn out.
    !resolved =
      max
        (0.2 * (max inward upward + 0.1 * segmentLength segment))
        (gasPixel g * slant * XYZ.distance place (gasEye g))
    !slant = min 8 (max 1 (0.7 * inward / (upward + 1e-9 * segmentAffineLength segment)))
    shining !opacity !heat = case gasGlow g of
      ByRadius brightness ->
        pass
          (opacity * segmentLength segment)
          (scaleRadiance brightness (hueRamp ((r - 1) / (gasOuter g - 1))))
          gathered
      ByTemperature temperatures table glow
        | r <= gasHorizon g -> gathered
        | otherwise -> case gasFrequencies (gasAround g) r py (segmentMomentum segment) of
          Frequencies emitted beside -> glowing heat opacity temperatures table glow beside emitted
    -- The frequencies over that at infinity for the observer at rest beside the gas
    -- (around a rotating hole, the one without angular momentum), and for the gas.
    glowing !heat !opacity !temperatures !table glow !static !emitted =
      let -- The length of the segment in the gas's own frame, where its
          -- opacity is meant: ν_em times the affine length. Without the
          -- Doppler shift that gas is thought at rest.
          Shifts doppler gravity = gasShifts g
          !frequency = if doppler then emitted else static
          !tau = opacity * frequency * segmentAffineLength segment
          !shift =
            (if gravity then observed / static else 1)
              * (if doppler then static / emitted else 1)
          !warmth = if heat == 0 then 1 else exponential heat
          !temperature = warmth * shift * valueAt temperatures (rowAt temperatures r) 0
          source
            | temperature < hottest =
              let row = rowAt table temperature
               in Radiance (valueAt table row 0) (valueAt table row 1) (valueAt table row 2)
            | otherwise = glow temperature
       in pass tau source gathered
{-# NOINLINE throughGas #-}

-- | The gas colour of the design report between the horizon (0) and the disk's outer edge
-- (1): hue 50° to 20°, saturation 0.8, full value, as a display colour.
hueRamp :: Double -> Radiance
hueRamp t = Radiance 1 (decodeSrgb green) (decodeSrgb 0.2)
  where
    green = 0.2 + 0.8 * (50 - 30 * t) / 60

-- | Alternating blue and green blocks of one Schwarzschild radius, as thick as
-- the disk; everything behind them is hidden.
gatherParity :: Disk -> Gathered -> PathSegment -> Continue Gathered
gatherParity disk gathered segment
  | abs y > diskThickness disk || r > diskOuterRadius disk = Continue gathered
  | otherwise = onward (pass 10 (if even blocks then Radiance 0 0 1 else Radiance 0 1 0) gathered)
  where
    XYZ x y z = segmentMiddle segment
    r = segmentRadius segment
    blocks = round x + round y + round z :: Int
