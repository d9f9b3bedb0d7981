{-# LANGUAGE BangPatterns #-}

-- | Light gathered from the disk's gas along a path, front to back.
module BlackHole.Trace.Gas
  ( Gathered (..),
    nothingYet,
    opaqueEnough,
    GasShader,
    gasShader,
    parityShader,
  )
where

import BlackHole.Light.BlackBodyTable (Brightness (..), blackBodyRadiance)
import BlackHole.Light.Display (decodeSrgb)
import BlackHole.Light.Radiance
import BlackHole.Noise.Lattice (circumference, clampedLevel)
import BlackHole.Noise.Profile (normalised, octaves)
import BlackHole.Noise.Remembered (remember, rememberedPerlin3)
import BlackHole.Physics.LightPath
import BlackHole.Physics.Redshift (gasRedshift)
import BlackHole.Physics.ThinDisk (relativeTemperature)
import BlackHole.Scene.Disk
import BlackHole.Scene.Shifts
import BlackHole.Trace.Seeds
import BlackHole.Vector.XYZ (XYZ (..), (*^), (^+^))
import qualified BlackHole.Vector.XYZ as XYZ
import Data.Word (Word64)

-- | What has been gathered so far.
data Gathered = Gathered
  { -- | Light that reaches the camera from the gas passed so far.
    gatheredRadiance :: !Radiance,
    -- | The part of the light from behind that still gets through.
    gatheredTransmittance :: !Double
  }

-- | At the camera: no light, nothing in the way.
nothingYet :: Gathered
nothingYet = Gathered black 1

-- | The report's "opacity exceeds 99 %".
opaqueEnough :: Double
opaqueEnough = 0.01

-- | Adds the gas of one stretch.
type GasShader = Gathered -> Stretch -> Onward Gathered

-- | Pass through gas of optical depth @tau@ that would have the radiance
-- @source@ if nothing could be seen through it. The closed form is exact for
-- uniform gas, so that thick stretches are as right as thin ones.
pass :: Double -> Radiance -> Gathered -> Onward Gathered
pass !tau !source (Gathered light transmittance)
  | transmittance' < opaqueEnough = Hidden gathered
  | otherwise = Onward gathered
  where
    through = exp (negate tau)
    transmittance' = transmittance * through
    gathered =
      Gathered
        (light <+> scaleRadiance (transmittance * (1 - through)) source)
        transmittance'
{-# INLINE pass #-}

-- | The shader of a disk under a seed, with the shifts that count, for light
-- that an observer sees at this multiple of its frequency at infinity.
gasShader :: Word64 -> Shifts -> Disk -> Double -> GasShader
gasShader seed shifts disk = \observed gathered stretch ->
  let !place = stretchMiddle stretch
      XYZ x y z = place
      !rho = sqrt (x * x + z * z)
      !r = XYZ.norm place
      azimuth = atan2 x z
      !height = diskThicknessAt disk rho * armThickness place azimuth rho
      !falloff = edges r * exp (negate (y * y / (height * height)))
   in if falloff < 1e-4
        then Onward gathered
        else
          let !density = falloff * turbulence azimuth y rho
           in shine observed r (density * extinction) stretch gathered
  where
    !inner = diskInnerRadius disk
    !outer = diskOuterRadius disk
    !extinction = diskOpacity disk / diskThickness disk
    -- The widths of both edges are the report's: 1/10 of a radius unit inside,
    -- 1/15 of the disk outside.
    edges r
      | r > outer = 0
      | otherwise = logistic (10 * (r - inner)) * logistic (15 * (diskFade disk - r / outer))
    !arms = fromIntegral (diskArms disk) :: Double
    !armScale = 16 * diskArmNoiseFrequency disk
    armNoise =
      rememberedPerlin3 $
        remember
          tablePoints
          (purposeSeed seed ArmDisplacement)
          (normalised (octaves (clampedLevel 28) (diskArmNoiseOctaves disk) 0.5))
          (armPlace (XYZ (negate outer) (negate top) (negate outer)))
          (armPlace (XYZ outer top outer))
    -- Off the lattice, on which all octaves vanish together: the disk's plane
    -- must not lie in one of its planes.
    armPlace place = armScale *^ place ^+^ XYZ 5.3 5.3 5.3
    armThickness place azimuth rho
      | diskArms disk == 0 = 1
      | otherwise =
        let displacement = diskArmNoise disk * armNoise (armPlace place)
            wave = sin (arms * azimuth + diskArmWinding disk * rho + displacement)
         in 1 - diskArmDepth disk + diskArmDepth disk * wave * wave * wave
    turbulenceNoise =
      rememberedPerlin3 $
        remember
          tablePoints
          (purposeSeed seed GasTurbulence)
          (normalised (octaves (clampedLevel 3) 4 0.6))
          (XYZ (negate (circumference / 2)) (turbulenceRadial 1) (turbulenceVertical (negate steepest)))
          (XYZ (circumference / 2) (turbulenceRadial outer) (turbulenceVertical steepest))
    turbulence azimuth y rho
      | diskTurbulence disk == 0 = 1
      | otherwise = exp (diskTurbulence disk * turbulenceNoise (streaks azimuth y rho))
    -- Level 3 of the grid has eight cells around the whole of it, so an angle
    -- laid around the grid's full 2³² units repeats without a seam. Gas is
    -- drawn out along its orbit, trailing outwards, and looks alike at every
    -- radius.
    streaks azimuth y rho =
      XYZ
        (circumference * (azimuth / (2 * pi) + 0.35 * log rho))
        (turbulenceRadial rho)
        (turbulenceVertical (y / rho))
    !turbulenceScale = circumference / 8 * diskTurbulenceFrequency disk
    turbulenceRadial rho = turbulenceScale * log rho
    turbulenceVertical slope = turbulenceScale * slope + 0.37 * circumference / 8
    -- The region's greatest height and, away from the hole, steepest slope.
    !top = halfHeightAt (diskRegion disk) outer
    !steepest = max (top / outer) (halfHeightAt (diskRegion disk) 1)
    shine = case diskColour disk of
      HueRamp -> \_ r opacity stretch ->
        let ramp = hueRamp ((r - 1) / (outer - 1))
         in pass (opacity * stretchLength stretch) (scaleRadiance (diskBrightness disk) ramp)
      BlackBody peak ->
        let glow = blackBodyRadiance Bolometric peak
         in \observed r opacity stretch gathered ->
              case gasRedshift observed (stretchMiddle stretch) (XYZ.negated (stretchVelocity stretch)) of
                -- Only at and inside the horizon.
                Nothing -> Onward gathered
                Just shift ->
                  let -- The length of the stretch in the gas's own frame, where
                      -- its opacity is meant: ν_em times the affine length.
                      -- Without the Doppler shift that gas is thought at rest.
                      frequency = observed / shiftFactor shifts {shiftsGravity = True} shift
                      tau = opacity * frequency * stretchAffineLength stretch
                      seen = shiftFactor shifts shift * peak * relativeTemperature r
                   in pass tau (scaleRadiance (diskBrightness disk) (glow seen)) gathered

-- | The most lattice points to remember for one noise: 16 MB.
tablePoints :: Int
tablePoints = 2000000

logistic :: Double -> Double
logistic t = 1 / (1 + exp (negate t))
{-# INLINE logistic #-}

-- | The report's gas colour between the hole's edge (0) and the disk's (1):
-- hue 50° to 20°, saturation 0.8, full value, read as a display colour.
hueRamp :: Double -> Radiance
hueRamp t = Radiance 1 (decodeSrgb green) (decodeSrgb 0.2)
  where
    green = 0.2 + 0.8 * (50 - 30 * t) / 60

-- | Alternating blue and green blocks of one Schwarzschild radius, as thick as
-- the disk; everything behind them is hidden.
parityShader :: Disk -> GasShader
parityShader disk gathered stretch
  | abs y > diskThickness disk || r > diskOuterRadius disk = Onward gathered
  | otherwise = pass 10 (if even blocks then Radiance 0 0 1 else Radiance 0 1 0) gathered
  where
    place@(XYZ x y z) = stretchMiddle stretch
    r = XYZ.norm place
    blocks = round x + round y + round z :: Int
