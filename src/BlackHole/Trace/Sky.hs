{-# LANGUAGE BangPatterns #-}

-- | Light from the celestial sphere.
module BlackHole.Trace.Sky
  ( SkyShader (..),
    FilteredSky (..),
    Between (..),
    skyThrough,
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
import BlackHole.Numeric.Angle
import BlackHole.Scene.Scene
import BlackHole.Scene.Sky
import BlackHole.Trace.EnvironmentMap
import BlackHole.Trace.Grid
import BlackHole.Trace.MilkyWay
import BlackHole.Trace.RayDifferential (RayDifferential (..), turned)
import BlackHole.Trace.RealSky
import BlackHole.Trace.Seeds
import BlackHole.Trace.StarCatalogue
import BlackHole.Trace.StarField
import BlackHole.Vector.XYZ (XYZ, (*^))
import Data.Word (Word64)

-- | Light from the sky for an observer who sees it at g times its frequency: a function
-- of the direction alone (unit length, in which the path escapes), or of the whole beam
-- where the sky is filtered for it.
data SkyShader
  = ByDirection !(Double -> XYZ -> Radiance)
  | ByDifferential !FilteredSky

-- | Light from the sky through a beam, in two parts. Both take the beam in the frame of the
-- sky, and g.
data FilteredSky = FilteredSky
  { -- | Turns a beam of the scene into the frame of the sky.
    skyFrame :: !(RayDifferential -> RayDifferential),
    -- | All light but that of point stars.
    skyDiffuse :: !(Double -> RayDifferential -> Radiance),
    -- | The light of point stars.
    skyStars :: !(Double -> RayDifferential -> Radiance),
    -- | What both simplify to between two beams of a row that differ little.
    skyBetween :: !(RayDifferential -> RayDifferential -> Between)
  }

-- | The light of a sky between two beams.
data Between = Between
  { betweenDiffuse :: !Evenness,
    -- | The light of stars, if there are any.
    betweenStars :: !(Maybe (Double -> RayDifferential -> Radiance))
  }

-- | All light of a sky through a beam of the scene.
skyThrough :: FilteredSky -> Double -> RayDifferential -> Radiance
skyThrough sky g differential = skyDiffuse sky g framed <+> skyStars sky g framed
  where
    framed = skyFrame sky differential

-- | The light of a sky, given the scene's seed. A star is a black body and changes its
-- colour with g; light of unknown spectrum keeps its colour. Either way the intensity
-- grows as g⁴.
--
-- The image of an environment map must be given. 'Nothing' if the sky is one and the
-- image is missing.
skyShader :: Maybe EnvironmentMap -> Word64 -> Sky -> Maybe SkyShader
skyShader picture seed sky = case sky of
  SkyPanorama panorama -> panoramaShader panorama <$> picture
  SkyNoise stars -> Just (ByDirection (starRadiance seed stars))
  SkyStars settings -> starsAndMilkyWay settings <$> realMilkyWay
  SkyRandomStars stars -> Just (pointStarRadiance seed stars)
  SkyGrid -> Just (ByDirection grid)
  SkyUniform v -> Just (ByDirection (\g _ -> grey (v * g ^ (4 :: Int))))
  SkyNone -> Just (ByDifferential blackSky)
  where
    grid g direction = scaleRadiance (g * g * (g * g)) (gridRadiance direction)

-- | The environment map that must be read before a scene can be traced.
neededPicture :: Scene -> Maybe FilePath
neededPicture scene = case sceneSky scene of
  SkyPanorama panorama | not (sceneDebugTextures scene) -> Just (panoramaFile panorama)
  _ -> Nothing

-- | The real stars before the real Milky Way, whose light has about the colour of one
-- black body and takes on that of another for an observer who sees it shifted.
starsAndMilkyWay :: RealSky -> EnvironmentMap -> SkyShader
starsAndMilkyWay settings milkyWayImage =
  ByDifferential (withStars gain realStarField (filtered turn diffuse tint milkyWayImage))
  where
    gain = realSkyBrightness settings * magnitudeZeroFlux
    diffuse = gain * realSkyMilkyWay settings
    tint = shiftedMixture 5200
    turn (RayDifferential d a b) = RayDifferential (toFrame d) (toFrame a) (toFrame b)
    !toFrame = toRealSky (inRadians (toRadians (realSkyRotation settings)))

-- | The real stars, arranged at the first use, in units of the flux of magnitude 0.
realStarField :: StarField
realStarField = starField 1 realStars
{-# NOINLINE realStarField #-}

-- | Flux of a star of magnitude 0 at gain 1: radiance times steradians.
magnitudeZeroFlux :: Double
magnitudeZeroFlux = 80e-6

-- | Random stars in front of the random band.
pointStarRadiance :: Word64 -> PointStars -> SkyShader
pointStarRadiance seed stars = ByDifferential (withStars 1 field band)
  where
    field = starField (1e-6 * pointStarsBrightness stars) catalogue
    catalogue = starCatalogue (purposeSeed seed StarPlaces) (pointStarsCount stars)
    band
      | pointStarsMilkyWay stars > 0 =
        filtered id (pointStarsMilkyWay stars) (const id) $
          milkyWay (purposeSeed seed GalacticClouds)
      | otherwise = blackSky

-- | An image of the sky with the turn ('turned') and the brightness of an environment
-- map.
panoramaShader :: Panorama -> EnvironmentMap -> SkyShader
panoramaShader panorama = ByDifferential . filtered turn (panoramaBrightness panorama) (const id)
  where
    turn = turned (inRadians (toRadians (panoramaRotation panorama)))

-- | @filtered frame gain tint image@ is an image in a frame of its own, so many times as
-- bright, in the colours that @tint@ gives it for a g.
filtered ::
  (RayDifferential -> RayDifferential) ->
  Double ->
  (Double -> Radiance -> Radiance) ->
  EnvironmentMap ->
  FilteredSky
filtered frame gain tint image =
  blackSky {skyFrame = frame, skyDiffuse = diffuse, skyBetween = between}
  where
    between first final = Between (evennessBetween image first final) Nothing
    diffuse g differential =
      scaleRadiance (gain * (g * g * (g * g))) (tint g (environmentMapRadiance image differential))

-- | A sky with the stars of a field, so many times as bright, in its frame.
withStars :: Double -> StarField -> FilteredSky -> FilteredSky
withStars gain field sky =
  field `seq` sky {skyStars = brightened (starFieldRadiance field), skyBetween = between}
  where
    between first final =
      (skyBetween sky first final)
        { betweenStars = brightened <$> starFieldBetween field first final
        }
    brightened stars g differential = scaleRadiance gain (stars g differential)

-- | No light at all.
blackSky :: FilteredSky
blackSky = FilteredSky id (\_ _ -> black) (\_ _ -> black) (\_ _ -> Between Linear Nothing)

-- | Stars where noise on the sphere rises above a threshold.
starRadiance :: Word64 -> Stars -> Double -> XYZ -> Radiance
starRadiance seed stars = \g direction ->
  let place = starFrequency stars *^ direction
   in -- Four widths below the threshold a star has 2 % of its brightness. Stars end
      -- there, so that the sky between them is black.
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
        -- From cool orange to hot blue, uniform over each star.
        let temperature = 5500 * exp (2 * noise3 colourSeed unitLevel (0.4 *^ place))
         in scaleRadiance (g ^ (4 :: Int)) (tabulatedColour (g * temperature))
      | otherwise = \g _ -> grey (g ^ (4 :: Int))
