-- | The settings of the disk of gas.
module BlackHole.Scene.Field.DiskTable
  ( diskFields,
  )
where

import BlackHole.Scene.Disk (DiskProfile (..))
import qualified BlackHole.Scene.Disk as Gas
import BlackHole.Scene.Field.Field
import BlackHole.Scene.Field.Kind
import BlackHole.Scene.Field.Parts

-- | The settings of the disk of gas.
diskFields :: [Field]
diskFields =
  [ switch Disk "disk.present"
      `sets` presencePart
      `documented` "Whether there is a disk; without one, no other setting of the disk has an \
                   \effect"
      `withFlag` ("no-disk", SwitchValue False, "Render without a disk"),
    number Disk "disk.inner" (Quantity "a radius" (From 0) (UpTo 1e4) radii)
      `sets` disk (part Gas.diskInnerRadius (\v d -> d {Gas.diskInnerRadius = v}))
      `documented` "Inner radius of the disk in Schwarzschild radii"
      `withOption` ("disk-inner", "R"),
    number Disk "disk.outer" (Quantity "a radius" (Above 1) (UpTo 1e4) radii)
      `sets` disk (part Gas.diskOuterRadius (\v d -> d {Gas.diskOuterRadius = v}))
      `documented` "Outer radius of the disk in Schwarzschild radii"
      `withOption` ("disk-outer", "R"),
    number Disk "disk.fade" (Quantity "a fraction of the outer radius" (From 0) (UpTo 1) "")
      `sets` disk (part Gas.diskFade (\v d -> d {Gas.diskFade = v}))
      `documented` "Fraction of the outer radius at which the density has fallen to half",
    number Disk "disk.thickness" (Quantity "a length" (From 1e-4) (UpTo 100) radii)
      `sets` disk (part Gas.diskThickness (\v d -> d {Gas.diskThickness = v}))
      `documented` "Height above the disk's plane, in Schwarzschild radii, at which the density \
                   \has fallen to 1/e"
      `withOption` ("disk-thickness", "W"),
    choice Disk "disk.profile" "a profile" profiles
      `sets` disk (part Gas.diskProfile (\v d -> d {Gas.diskProfile = v}))
      `documented` "Profile of the thickness: constant, or opening (in proportion to the radius, \
                   \with the given thickness at the outer radius)",
    number Disk "disk.opacity" (Quantity "an optical depth" (From 0) (UpTo 1e6) "")
      `sets` disk (part Gas.diskOpacity (\v d -> d {Gas.diskOpacity = v}))
      `documented` "Optical depth of gas of full density over a path as long as the thickness"
      `withOption` ("disk-opacity", "TAU"),
    number Disk "disk.brightness" (Quantity "a radiance" (From 0) (UpTo 1e9) "")
      `sets` disk (part Gas.diskBrightness (\v d -> d {Gas.diskBrightness = v}))
      `documented` "Radiance of opaque gas where it is brightest; 1 is display white at exposure 0",
    choice Disk "disk.colour" "a way to colour the gas" glows
      `sets` glowPart
      `documented` "Colour of the gas: black-body, bolometric (intensity over all wavelengths, \
                   \without colour), synchrotron (radio waves of an optically thin flow, without \
                   \colour), or hue-ramp (yellow to red by radius, as in the design report, \
                   \without physics)",
    number Disk "disk.temperature" (Quantity "a temperature" (From 500) (UpTo 1e6) "kelvin")
      `sets` temperaturePart
      `documented` "Temperature of the gas in kelvin where it is hottest; makes the gas a black \
                   \body"
      `withOption` ("temperature", "KELVIN"),
    number Disk "disk.time" (Quantity "a time" (From (-1e9)) (UpTo 1e9) "r_s/c")
      `sets` disk (part Gas.diskTime (\v d -> d {Gas.diskTime = v}))
      `documented` "Time up to which the gas has moved, in r_s/c (Schwarzschild radii over the \
                   \speed of light)"
      `withOption` ("time", "T"),
    whole Disk "disk.arms.count" (0, 1000) ""
      `sets` disk (part Gas.diskArms (\v d -> d {Gas.diskArms = v}))
      `documented` "Number of spiral arms; 0 for none",
    number
      Disk
      "disk.arms.winding"
      (Quantity "an angle" (From (-1e4)) (UpTo 1e4) "radians per Schwarzschild radius")
      `sets` disk (part Gas.diskArmWinding (\v d -> d {Gas.diskArmWinding = v}))
      `documented` "Winding of the arms in radians per Schwarzschild radius outwards",
    number Disk "disk.arms.depth" (Quantity "a fraction" (From 0) (UpTo 0.5) "")
      `sets` disk (part Gas.diskArmDepth (\v d -> d {Gas.diskArmDepth = v}))
      `documented` "Fraction by which the disk is thinner between the arms, 0 to 0.5",
    number Disk "disk.arms.noise" (Quantity "an angle" (From 0) (UpTo 1000) "radians")
      `sets` disk (part Gas.diskArmNoise (\v d -> d {Gas.diskArmNoise = v}))
      `documented` "Angle by which noise displaces the arms, in radians",
    number
      Disk
      "disk.arms.noise-frequency"
      (features (From 0) (UpTo 1000) "per Schwarzschild radius")
      `sets` disk (part Gas.diskArmNoiseFrequency (\v d -> d {Gas.diskArmNoiseFrequency = v}))
      `documented` "Frequency of that noise in features per Schwarzschild radius",
    whole Disk "disk.arms.noise-octaves" (1, 20) ""
      `sets` disk (part Gas.diskArmNoiseOctaves (\v d -> d {Gas.diskArmNoiseOctaves = v}))
      `documented` "Octaves of that noise",
    number Disk "disk.turbulence.strength" (Quantity "a number" (From 0) (UpTo 100) "")
      `sets` disk (part Gas.diskTurbulence (\v d -> d {Gas.diskTurbulence = v}))
      `documented` "Strength of the turbulence; 0 for smooth gas",
    number Disk "disk.turbulence.frequency" (features (From 0) (UpTo 1000) "")
      `sets` disk (part Gas.diskTurbulenceFrequency (\v d -> d {Gas.diskTurbulenceFrequency = v}))
      `documented` "Frequency of the turbulence in features between any radius and e times that \
                   \radius",
    whole Disk "disk.turbulence.octaves" (1, 8) ""
      `sets` disk (part Gas.diskTurbulenceOctaves (\v d -> d {Gas.diskTurbulenceOctaves = v}))
      `documented` "Octaves of the turbulence, each at twice the frequency of the one before",
    number Disk "disk.turbulence.gain" (Quantity "a fraction" (From 0) (UpTo 1) "")
      `sets` disk (part Gas.diskTurbulenceGain (\v d -> d {Gas.diskTurbulenceGain = v}))
      `documented` "Strength of each octave relative to the one before, 0 to 1",
    number Disk "disk.turbulence.warp" (features (From 0) (UpTo 100) "")
      `sets` disk (part Gas.diskTurbulenceWarp (\v d -> d {Gas.diskTurbulenceWarp = v}))
      `documented` "How far the coarse octaves displace the finer ones, in widths of the coarsest \
                   \features",
    number Disk "disk.turbulence.filaments" (Quantity "a fraction" (From 0) (UpTo 1) "")
      `sets` disk (part Gas.diskTurbulenceFilaments (\v d -> d {Gas.diskTurbulenceFilaments = v}))
      `documented` "Fraction of bright filaments in the finer octaves, 0 to 1",
    number Disk "disk.turbulence.intermittency" (Quantity "a number" (From 0) (UpTo 100) "")
      `sets` disk (part Gas.diskTurbulenceGrowth (\v d -> d {Gas.diskTurbulenceGrowth = v}))
      `documented` "How much stronger fine turbulence is where the gas is dense; 0 for equally \
                   \strong everywhere",
    number Disk "disk.turbulence.heat" (Quantity "an exponent" (From 0) (UpTo 2) "")
      `sets` disk (part Gas.diskTurbulenceHeat (\v d -> d {Gas.diskTurbulenceHeat = v}))
      `documented` "Exponent of the temperature as a power of the surface density within a ring, \
                   \whose mean flux stays; 0 for rings of one temperature",
    number Disk "disk.haze.density" (Quantity "a density" (From 0) (UpTo 1) "")
      `sets` disk (part Gas.diskHaze (\v d -> d {Gas.diskHaze = v}))
      `documented` "Density of a haze above and below the disk relative to full density; 0 \
                   \for none",
    number Disk "disk.haze.height" (Quantity "a ratio" (From 1) (UpTo 100) "")
      `sets` disk (part Gas.diskHazeHeight (\v d -> d {Gas.diskHazeHeight = v}))
      `documented` "Thickness of the haze relative to that of the disk, at least 1",
    choiceOrFile
      Sky
      "sky.kind"
      "a sky"
      skies
      "the file of an environment map"
      (PanoramaSky, panoramaSkyFile)
      `sets` skyKindPart
      `documented` "Background: stars (the real stars and the Milky Way), random-stars (made from \
                   \the seed), noise (stars made from noise, as in the design report), grid, \
                   \uniform, none, or the file of an environment map (a picture twice as wide as \
                   \high)"
      `withOption` ("sky", "NAME|FILE")
  ]
  where
    radii = "Schwarzschild radii"
    features = Quantity "a number of features"
    profiles =
      [ (ConstantThickness, "constant", "the same everywhere"),
        (ConstantOpening, "opening", "in proportion to the radius")
      ]
    glows =
      [ (RampGlow, "hue-ramp", "yellow inside to red outside, without physics"),
        (BlackBodyGlow, "black-body", "by its temperature"),
        (BolometricGlow, "bolometric", "all wavelengths together, without colour"),
        (SynchrotronGlow, "synchrotron", "radio waves of a thin flow, without colour")
      ]
    skies =
      [ (StarSky, "stars", "the real stars and the Milky Way"),
        ( RandomStarSky,
          "random-stars",
          "point stars made from the seed, and a band like the Milky Way"
        ),
        (NoiseSky, "noise", "stars made from noise, as in the design report"),
        (GridSky, "grid", "a checkerboard with fields of 10 degrees"),
        (UniformSky, "uniform", "equal radiance in all directions"),
        (NoSky, "none", "dark")
      ]
