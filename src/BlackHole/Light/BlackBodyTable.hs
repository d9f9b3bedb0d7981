-- | Black-body colour and brightness from a table, for every sample of the gas.
--
-- The table is built once from "BlackHole.Light.BlackBody", at its first use, in a few
-- milliseconds, and takes 32 KiB. Its nodes are equally spaced in s = ln(1 + 3000 K/T),
-- which behaves like ln T for cold gas and reaches T = ∞ at s = 0, so the table needs
-- no upper end. It starts at 'coldestTabulated'. Between the nodes the values are
-- linear in s and therefore as monotone as the functions themselves.
module BlackHole.Light.BlackBodyTable
  ( Brightness (..),
    tabulatedColour,
    tabulatedLuminance,
    blackBodyRadiance,
    coldestTabulated,
  )
where

import BlackHole.Light.BlackBody
import BlackHole.Light.Gamut (desaturateIntoGamut)
import BlackHole.Light.Radiance
import qualified Data.Vector.Unboxed as U
import Numeric (expm1, log1p)

-- | The measure of a black body's brightness relative to one at a reference
-- temperature.
data Brightness
  = -- | Radiance over all wavelengths: (T/T₀)⁴.
    Bolometric
  | -- | Luminance, the part that an eye or a camera sees.
    Visible
  deriving (Eq, Ord, Show, Read, Enum, Bounded)

-- | 'blackBodyColour' from the table, at any temperature, within 2e-5 in each component
-- (at luminance 1). Below 'coldestTabulated' it keeps the value at that temperature,
-- which is the limit T → 0 to within 1e-7.
tabulatedColour :: Double -> Radiance
tabulatedColour temperature =
  desaturateIntoGamut
    ( Radiance
        (interpolate place 0)
        (interpolate place 1)
        (interpolate place 2)
    )
  where
    place = placeOf temperature

-- | 'blackBodyLuminance' from the table in cd/m², within a relative error of 6e-5. 0
-- below 'coldestTabulated', where the exact value is below 1e-72 cd/m².
tabulatedLuminance :: Double -> Double
tabulatedLuminance temperature
  | temperature >= coldestTabulated =
    temperature
      * exp
        ( interpolate (placeOf temperature) 3
            - secondRadiationConstant / (redWavelength * temperature)
        )
  | otherwise = 0

-- | @blackBodyRadiance brightness reference temperature@ is the light of a black body,
-- in units in which one at the reference temperature has luminance 1. The reference
-- should be at least 'coldestTabulated'; below it, the visible brightness is undefined
-- and the result 'black'. Bind the result of the first two arguments to prepare them
-- once.
blackBodyRadiance :: Brightness -> Double -> Double -> Radiance
blackBodyRadiance Bolometric reference =
  \temperature ->
    scaleRadiance
      (bolometricIntensity reference temperature)
      (tabulatedColour temperature)
blackBodyRadiance Visible reference =
  \temperature ->
    scaleRadiance
      (unit * tabulatedLuminance temperature)
      (tabulatedColour temperature)
  where
    unit
      | reference >= coldestTabulated = 1 / tabulatedLuminance reference
      | otherwise = 0

-- | The lowest temperature of the table, 100 K.
coldestTabulated :: Double
coldestTabulated = 100

-- | A node, and the fraction of the way to the next one, 0 to 1.
data Place = Place !Int !Double

placeOf :: Double -> Place
placeOf temperature
  | temperature >= coldestTabulated && node < nodeCount - 1 =
    Place node (s - fromIntegral node)
  | otherwise = Place (nodeCount - 2) 1
  where
    s = log1p (softeningTemperature / temperature) / nodeSpacing
    node = truncate s
{-# INLINE placeOf #-}

interpolate :: Place -> Int -> Double
interpolate (Place node t) column = a + t * (b - a)
  where
    a = U.unsafeIndex table (columnCount * node + column)
    b = U.unsafeIndex table (columnCount * (node + 1) + column)
{-# INLINE interpolate #-}

-- | The rows of the table. Red, green and blue at luminance 1 are stored before the
-- mapping into the gamut, which has a kink that no interpolation would follow. The
-- fourth column is ln(luminance/T) + hc/(λkT) with λ at 'redWavelength', which removes
-- most of the curvature on the Wien side.
table :: U.Vector Double
table = U.fromListN (columnCount * nodeCount) (concatMap row [0 .. nodeCount - 1])
  where
    row :: Int -> [Double]
    row node =
      let s = nodeSpacing * fromIntegral node
          temperature = min hottest (softeningTemperature / expm1 s)
          Radiance r g b = unmappedColour temperature
       in [ r,
            g,
            b,
            logLuminance temperature - log temperature
              + secondRadiationConstant / (redWavelength * temperature)
          ]
    -- Already at the limit, and still finite.
    hottest = 1e20
{-# NOINLINE table #-}

columnCount :: Int
columnCount = 4

nodeCount :: Int
nodeCount = 1024

nodeSpacing :: Double
nodeSpacing =
  log1p (softeningTemperature / coldestTabulated) / fromIntegral (nodeCount - 1)

-- | The temperature at which the spacing of the nodes changes from that of ln T to that
-- of 1/T.
softeningTemperature :: Double
softeningTemperature = 3000

redWavelength :: Double
redWavelength = 700
