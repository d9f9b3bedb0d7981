-- | The luminous gas: where it is, how dense, how it shines.
module BlackHole.Scene.Disk
  ( Disk (..),
    DiskProfile (..),
    DiskColour (..),
    reportDisk,
    defaultDisk,
    diskRegion,
    Fineness (..),
    diskThicknessAt,
    thinnestGas,
  )
where

import BlackHole.Spacetime.Region (Region (..))

-- | A spiral disk of gas around @+y@. Radii and lengths are in Schwarzschild
-- radii.
data Disk = Disk
  { -- | The gas has half its density here on the inner side.
    diskInnerRadius :: !Double,
    -- | The gas ends here.
    diskOuterRadius :: !Double,
    -- | It has half its density at this fraction of the outer radius.
    diskFade :: !Double,
    -- | Height at which the density has fallen to @1/e@ (the report's
    -- @w_ad@), at the outer radius.
    diskThickness :: !Double,
    -- | Whether the disk is as thick everywhere or opens outwards.
    diskProfile :: !DiskProfile,
    -- | Optical depth of one thickness of gas of full density.
    diskOpacity :: !Double,
    -- | Radiance of the gas where it is brightest and hides what is behind it.
    diskBrightness :: !Double,
    -- | Number of spiral arms; 0 for none.
    diskArms :: !Int,
    -- | Radians that an arm turns per Schwarzschild radius outwards.
    diskArmWinding :: !Double,
    -- | How much thinner the disk is between the arms, 0…1/2.
    diskArmDepth :: !Double,
    -- | Radians by which noise displaces the arms.
    diskArmNoise :: !Double,
    -- | Noise features per Schwarzschild radius in the arms' displacement.
    diskArmNoiseFrequency :: !Double,
    -- | Octaves of that noise.
    diskArmNoiseOctaves :: !Int,
    -- | Strength of the turbulence in the density, 0 for smooth gas.
    diskTurbulence :: !Double,
    -- | Turbulence features from one radius to @e@ times it.
    diskTurbulenceFrequency :: !Double,
    -- | Octaves of the turbulence, each twice as fine.
    diskTurbulenceOctaves :: !Int,
    -- | How strong an octave is against the one before.
    diskTurbulenceGain :: !Double,
    -- | How far the coarse octaves bend the finer ones, in cells of the coarsest.
    diskTurbulenceWarp :: !Double,
    -- | The part of filaments in the octaves after the first, 0…1.
    diskTurbulenceFilaments :: !Double,
    -- | How much more turbulent dense gas is: 0 for equally everywhere.
    diskTurbulenceGrowth :: !Double,
    -- | How much hotter dense gas is: ln of its temperature per ln of its density.
    diskTurbulenceHeat :: !Double,
    -- | Density of the haze above the disk over that of dense gas, 0 for none.
    diskHaze :: !Double,
    -- | The haze's thickness over the disk's, at least 1.
    diskHazeHeight :: !Double,
    -- | The time to which the gas has moved, in units of r_s/c.
    diskTime :: !Double,
    -- | How the gas shines.
    diskColour :: !DiskColour
  }
  deriving (Eq, Show)

-- | How the thickness depends on the distance from the axis.
data DiskProfile
  = -- | Not at all.
    ConstantThickness
  | -- | In proportion: seen from the hole, the disk has one opening angle.
    ConstantOpening
  deriving (Eq, Show, Read, Enum, Bounded)

-- | The colour and brightness of the gas against its place.
data DiskColour
  = -- | The report's: hue 50° inside to 20° outside, no physics.
    HueRamp
  | -- | A black body with the temperature profile of a thin disk; the field is
    -- the temperature in kelvin at the profile's peak.
    BlackBody !Double
  | -- | The bolometric intensity of that profile, without colour: what all
    -- wavelengths together carry, as in Luminet's picture of 1979.
    Bolometric
  | -- | Radio waves of an optically thin flow, without colour: synchrotron emission that
    -- falls with the fourth power of the distance from the hole and with the frequency
    -- (spectral index 1), so that the flow counts like a black body of a temperature
    -- ∝ 1\/r. The brightness is that at r = 1.
    Synchrotron
  deriving (Eq, Show)

-- | The gas of the report's author.
reportDisk :: Disk
reportDisk =
  Disk
    { diskInnerRadius = 1.7,
      diskOuterRadius = 5,
      diskFade = 0.6,
      diskThickness = 0.01,
      diskProfile = ConstantThickness,
      diskOpacity = 0.2,
      diskBrightness = 5,
      diskArms = 1,
      diskArmWinding = 25,
      diskArmDepth = 0.4,
      diskArmNoise = 4,
      diskArmNoiseFrequency = 12.5,
      diskArmNoiseOctaves = 5,
      diskTurbulence = 0,
      diskTurbulenceFrequency = 1,
      diskTurbulenceOctaves = 4,
      diskTurbulenceGain = 0.6,
      diskTurbulenceWarp = 0,
      diskTurbulenceFilaments = 0,
      diskTurbulenceGrowth = 0,
      diskTurbulenceHeat = 0,
      diskHaze = 0,
      diskHazeHeight = 1,
      diskTime = 0,
      diskColour = HueRamp
    }

-- | A wide, turbulent disk of glowing gas.
defaultDisk :: Disk
defaultDisk =
  Disk
    { diskInnerRadius = 3,
      diskOuterRadius = 16,
      diskFade = 0.56,
      diskThickness = 0.16,
      diskProfile = ConstantOpening,
      diskOpacity = 2.5,
      diskBrightness = 1,
      diskArms = 2,
      diskArmWinding = 0.9,
      diskArmDepth = 0.25,
      diskArmNoise = 3,
      diskArmNoiseFrequency = 0.25,
      diskArmNoiseOctaves = 1,
      diskTurbulence = 4.5,
      diskTurbulenceFrequency = 12,
      diskTurbulenceOctaves = 6,
      diskTurbulenceGain = 0.7,
      diskTurbulenceWarp = 1,
      diskTurbulenceFilaments = 0.6,
      diskTurbulenceGrowth = 2,
      diskTurbulenceHeat = 0.21,
      diskHaze = 0.004,
      diskHazeHeight = 3,
      diskTime = 0,
      diskColour = BlackBody 2100
    }

-- | The thickness at a distance from the axis.
diskThicknessAt :: Disk -> Double -> Double
diskThicknessAt disk rho = case diskProfile disk of
  ConstantThickness -> diskThickness disk
  ConstantOpening -> diskThickness disk * rho / diskOuterRadius disk
{-# INLINE diskThicknessAt #-}

-- | Where there can be gas, and how finely a path through it is to be cut. A
-- Gaussian is integrated to far below a display's precision by steps of up to 0.8
-- of its width; beyond three widths less than 1.3e-4 of the density is left. The haze
-- ends where it is 'thinnestGas', and in it the steps grow.
diskRegion :: Fineness -> Disk -> Region
diskRegion fineness disk =
  Region
    { regionRadius = diskOuterRadius disk,
      -- Ten widths of the inner edge further in 5e-5 of the density is left.
      regionInnerRadius = max 0 (diskInnerRadius disk - 1),
      regionHalfHeight = reach constant,
      regionFlare = reach opening / diskOuterRadius disk,
      regionVerticalStep = vertical / widths,
      regionLongestStep = longest,
      regionCore = if hazy then min 1 (2 / widths) else 1
    }
  where
    reach part = widths * part * diskThickness disk
    hazy = diskHaze disk > 0
    widths =
      if hazy
        then max 3 (diskHazeHeight disk * sqrt (max 0 (log (diskHaze disk / thinnestGas))))
        else 3
    (constant, opening) = case diskProfile disk of
      ConstantThickness -> (1, 0)
      ConstantOpening -> (0, 1)
    (vertical, longest) = case fineness of
      Swift -> (0.8, 0.05)
      Fine -> (0.4, 0.02)

-- | The density over that of dense gas below which gas is left out: all of it together
-- has less than a thousandth of the optical depth.
thinnestGas :: Double
thinnestGas = 5.5e-4

-- | Length of the steps through the gas.
data Fineness
  = -- | For paths that enter the gas in different phases of their steps, so that
    -- neighbours make up for what one leaves out.
    Swift
  | -- | For paths that stand alone.
    Fine
  deriving (Eq, Show, Enum, Bounded)
