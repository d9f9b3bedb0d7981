{-# LANGUAGE BangPatterns #-}

-- | Light from the celestial sphere.
module BlackHole.Trace.Sky
  ( SkyShader (..),
    skyShader,
    panoramaShader,
    neededPicture,
  )
where

import BlackHole.Light.BlackBodyTable (tabulatedColour)
import BlackHole.Light.Radiance
import BlackHole.Noise.Lattice (unitLevel)
import BlackHole.Noise.PerlinG (noise3)
import BlackHole.Noise.Profile (normalised, octaves)
import BlackHole.Noise.Threshold (perlin3Above)
import BlackHole.Physics.Angle
import BlackHole.Scene.Scene
import BlackHole.Scene.Sky
import BlackHole.Trace.Beam (Beam (..))
import BlackHole.Trace.Grid
import BlackHole.Trace.MilkyWay
import BlackHole.Trace.RealSky
import BlackHole.Trace.Seeds
import BlackHole.Trace.SkyImage
import BlackHole.Trace.StarCatalogue
import BlackHole.Trace.StarField
import BlackHole.Vector.XYZ (XYZ, (*^))
import Data.Word (Word64)

-- | Light from the sky by the frequency g times as high at which the observer
-- sees it: where the direction (unit length, as the light escapes) says all,
-- or where the sky is finer than a pixel and it takes the whole beam.
data SkyShader
  = ByDirection !(Double -> XYZ -> Radiance)
  | ByBeam !(Double -> Beam -> Radiance)

-- | The light of a sky under a scene's seed. A star is a black body and changes
-- its colour with g; light of no known spectrum keeps it. Either way the
-- intensity grows as g⁴.
--
-- The picture of a panorama comes from outside; 'Nothing' where the sky is one
-- and there is no picture.
skyShader :: Maybe SkyImage -> Word64 -> Sky -> Maybe SkyShader
skyShader picture seed sky = case sky of
  SkyPanorama panorama -> panoramaShader panorama <$> picture
  SkyNoise stars -> Just (ByDirection (starRadiance seed stars))
  SkyStars settings -> ByBeam . realSkyRadiance settings <$> realMilkyWay
  SkyRandomStars stars -> Just (ByBeam (pointStarRadiance seed stars))
  SkyGrid -> Just (ByDirection (\g direction -> scaleRadiance (g * g * (g * g)) (gridRadiance direction)))
  SkyUniform v -> Just (ByDirection (\g _ -> grey (v * g ^ (4 :: Int))))
  SkyNone -> Just (ByDirection (\_ _ -> black))

-- | The file that has to be read before a scene can be traced.
neededPicture :: Scene -> Maybe FilePath
neededPicture scene = case sceneSky scene of
  SkyPanorama panorama | not (sceneDebugTextures scene) -> Just (panoramaFile panorama)
  _ -> Nothing

-- | The real stars before the real Milky Way, whose light has about the colour of one
-- black body and takes on that of another for an observer who sees it shifted.
realSkyRadiance :: RealSky -> SkyImage -> Double -> Beam -> Radiance
realSkyRadiance settings milkyWayImage =
  stars `seq` milkyWayImage `seq` \g beam ->
    let turnedBeam = turn beam
     in scaleRadiance gain (starFieldRadiance stars g turnedBeam)
          <+> scaleRadiance (diffuse * (g * g * (g * g))) (tint g (skyImageRadiance milkyWayImage turnedBeam))
  where
    stars = realStarField
    gain = realSkyBrightness settings * magnitudeZeroFlux
    diffuse = gain * realSkyMilkyWay settings
    tint = shiftedMixture 5200
    turn (Beam d a b) = Beam (toFrame d) (toFrame a) (toFrame b)
    toFrame = toRealSky (inRadians (toRadians (realSkyRotation settings)))

-- | The real stars, arranged at the first use, in units of the flux of magnitude 0.
realStarField :: StarField
realStarField = starField 1 realStars
{-# NOINLINE realStarField #-}

-- | Flux of a star of magnitude 0 at gain 1: radiance times steradians.
magnitudeZeroFlux :: Double
magnitudeZeroFlux = 80e-6

-- | Point stars before the Milky Way.
pointStarRadiance :: Word64 -> PointStars -> Double -> Beam -> Radiance
pointStarRadiance seed stars
  | pointStarsMilkyWay stars > 0 =
    band `seq` field `seq` \g beam ->
      starFieldRadiance field g beam <+> scaleRadiance (pointStarsMilkyWay stars * (g * g * (g * g))) (skyImageRadiance band beam)
  | otherwise = field `seq` starFieldRadiance field
  where
    field = starField (1e-6 * pointStarsBrightness stars) (starCatalogue (purposeSeed seed StarPlaces) (pointStarsCount stars))
    band = milkyWay (purposeSeed seed GalacticClouds)

-- | A picture of the sky, turned ('turned') and as bright as the panorama says.
panoramaShader :: Panorama -> SkyImage -> SkyShader
panoramaShader panorama image = ByBeam $ \g beam ->
  scaleRadiance (panoramaBrightness panorama * (g * g * (g * g))) (skyImageRadiance image (turn beam))
  where
    turn = turned (inRadians (toRadians (panoramaRotation panorama)))

-- | Stars where noise on the sphere rises above a threshold.
starRadiance :: Word64 -> Stars -> Double -> XYZ -> Radiance
starRadiance seed stars = \g direction ->
  let place = starFrequency stars *^ direction
   in -- Four widths below the threshold a star is darker than 2 % of itself:
      -- cut there, so that the sky between the stars is black.
      case above (starThreshold stars - 4 / starSharpness stars) place of
        Nothing -> black
        Just value ->
          let excess = starSharpness stars * (value - starThreshold stars)
           in scaleRadiance (starBrightness stars / (1 + exp (negate excess))) (light g place)
  where
    !above = perlin3Above fieldSeed (normalised (octaves unitLevel (starOctaves stars) 0.5))
    fieldSeed = purposeSeed seed StarField
    colourSeed = purposeSeed seed StarColour
    light
      | starColours stars = \g place ->
        -- From cool orange to hot blue stars, the same over the whole of one.
        let temperature = 5500 * exp (2 * noise3 colourSeed unitLevel (0.4 *^ place))
         in scaleRadiance (g ^ (4 :: Int)) (tabulatedColour (g * temperature))
      | otherwise = \g _ -> grey (g ^ (4 :: Int))
