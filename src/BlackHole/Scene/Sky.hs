-- | The celestial sphere: what lies behind everything, infinitely far away.
module BlackHole.Scene.Sky
  ( Sky (..),
    Stars (..),
    reportStars,
    defaultStars,
    RealSky (..),
    realSky,
    PointStars (..),
    defaultPointStars,
    Panorama (..),
    panoramaOf,
  )
where

import BlackHole.Numeric.Angle (Degrees (..))

-- | The celestial sphere.
data Sky
  = -- | Stars cut out of three-dimensional noise on the sphere.
    SkyNoise !Stars
  | -- | The real stars and the real Milky Way.
    SkyStars !RealSky
  | -- | Point stars made from the seed, before a band like the Milky Way.
    SkyRandomStars !PointStars
  | -- | An environment map.
    SkyPanorama !Panorama
  | -- | Alternating fields of 10°, which show the lensing.
    SkyGrid
  | -- | The same radiance everywhere.
    SkyUniform !Double
  | -- | Dark.
    SkyNone
  deriving (Eq, Show)

-- | Stars of noise: there is a star where the noise exceeds the threshold:
-- @brightness · 1/(1 + e^{−sharpness·(noise − threshold)})@.
data Stars = Stars
  { -- | Noise features per radian.
    starFrequency :: !Double,
    -- | Octaves of the noise: one gives round stars, more give ragged ones.
    starOctaves :: !Int,
    -- | Noise level (−1…1) at which a star has half its brightness.
    starThreshold :: !Double,
    -- | Steepness of a star's edge.
    starSharpness :: !Double,
    -- | Radiance of the brightest stars.
    starBrightness :: !Double,
    -- | Whether stars have the colours of black bodies, or are all white.
    starColours :: !Bool
  }
  deriving (Eq, Show)

-- | The report's: on its sphere of radius 2000 with three noise units a
-- Schwarzschild radius, the coarsest of five levels has cells of 16 units.
reportStars :: Stars
reportStars =
  Stars
    { starFrequency = 375,
      starOctaves = 5,
      starThreshold = 0.55,
      starSharpness = 30,
      starBrightness = 4,
      starColours = False
    }

-- | Small coloured stars.
defaultStars :: Stars
defaultStars =
  Stars
    { starFrequency = 420,
      starOctaves = 1,
      starThreshold = 0.72,
      starSharpness = 40,
      starBrightness = 2.5,
      starColours = True
    }

-- | How the real sky is shown.
data RealSky = RealSky
  { -- | Turn about the axis +y, as of a panorama ('panoramaRotation').
    realSkyRotation :: !Degrees,
    -- | Gain: 1 gives a star of magnitude 0 a flux of 80e-6 radiance times steradians,
    -- and with it the brightest clouds of the Milky Way a radiance of 0.02.
    realSkyBrightness :: !Double,
    -- | Further gain of the diffuse light alone: 1 is its true ratio to the stars, 0
    -- leaves it out.
    realSkyMilkyWay :: !Double
  }
  deriving (Eq, Show)

-- | The real sky in its true proportions.
realSky :: RealSky
realSky = RealSky (Degrees 0) 1 1

-- | Random stars without extent, and the light of those too faint to be single.
data PointStars = PointStars
  { -- | Number of the whole sky's brightest stars that are shown one by one; the naked
    -- eye sees 9000 of the real ones.
    pointStarsCount :: !Int,
    -- | Flux of a star of magnitude 0 in units of 1e-6 radiance times steradians; with
    -- 1, a pixel of one milliradian squared has radiance 1.
    pointStarsBrightness :: !Double,
    -- | Radiance of the band where it is bright; 0 leaves it out.
    pointStarsMilkyWay :: !Double
  }
  deriving (Eq, Show)

-- | A clear night far from any town.
defaultPointStars :: PointStars
defaultPointStars =
  PointStars
    { pointStarsCount = 60000,
      pointStarsBrightness = 80,
      pointStarsMilkyWay = 0.07
    }

-- | An environment map: an equirectangular image of the whole sky, from a file.
data Panorama = Panorama
  { -- | The file, relative to the working directory.
    panoramaFile :: !FilePath,
    -- | Turn of the image's centre about the axis +y: at 0° the centre is in the
    -- direction −z, behind the hole for a camera at azimuth 90°; at 90° it is in the
    -- direction +x. A positive turn moves what is seen to the right.
    panoramaRotation :: !Degrees,
    -- | Radiance of the image's white.
    panoramaBrightness :: !Double
  }
  deriving (Eq, Show)

-- | A file's image, neither turned nor brightened.
panoramaOf :: FilePath -> Panorama
panoramaOf file = Panorama file (Degrees 0) 1
