{-# LANGUAGE BangPatterns #-}

-- | Light from the celestial sphere.
module BlackHole.Trace.Sky
  ( SkyShader (..),
    skyShader,
    panoramaShader,
  )
where

import BlackHole.Light.BlackBodyTable (tabulatedColour)
import BlackHole.Light.Radiance
import BlackHole.Noise.Lattice (unitLevel)
import BlackHole.Noise.PerlinG (noise3)
import BlackHole.Noise.Profile (normalised, octaves)
import BlackHole.Noise.Threshold (perlin3Above)
import BlackHole.Scene.Sky
import BlackHole.Trace.Beam (Beam)
import BlackHole.Trace.Grid
import BlackHole.Trace.MilkyWay
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
skyShader :: Word64 -> Sky -> SkyShader
skyShader seed sky = case sky of
  SkyNoise stars -> ByDirection (starRadiance seed stars)
  SkyStars stars -> ByBeam (pointStarRadiance seed stars)
  SkyGrid -> ByDirection (\g direction -> scaleRadiance (g * g * (g * g)) (gridRadiance direction))
  SkyUniform v -> ByDirection (\g _ -> grey (v * g ^ (4 :: Int)))
  SkyNone -> ByDirection (\_ _ -> black)

-- | Point stars before the Milky Way.
pointStarRadiance :: Word64 -> PointStars -> Double -> Beam -> Radiance
pointStarRadiance seed stars
  | pointStarsMilkyWay stars > 0 = \g beam ->
    starFieldRadiance field g beam <+> scaleRadiance (pointStarsMilkyWay stars * (g * g * (g * g))) (skyImageRadiance band beam)
  | otherwise = starFieldRadiance field
  where
    field = starField (1e-6 * pointStarsBrightness stars) (starCatalogue (purposeSeed seed StarPlaces) (pointStarsCount stars))
    band = milkyWay (purposeSeed seed GalacticClouds)

-- | A picture of the sky, turned about +y by an angle in radians ('turned'), and
-- so many times as bright.
panoramaShader :: Double -> Double -> SkyImage -> SkyShader
panoramaShader brightness angle image = ByBeam $ \g beam ->
  scaleRadiance (brightness * (g * g * (g * g))) (skyImageRadiance image (turn beam))
  where
    turn = turned angle

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
