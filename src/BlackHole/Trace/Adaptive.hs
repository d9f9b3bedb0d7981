{-# LANGUAGE BangPatterns #-}

-- | Adaptive sampling: the light of each pixel, from as many rays as it needs.
--
-- The first rays of a pixel and its neighbours usually suffice ("BlackHole.Trace.Layers").
-- Where these nine pixels disagree, the pixel gets rays of its own, and twice as many
-- again and again, until it is certain or has the maximum. Pixels on the edge of the
-- shadow always get the maximum, and those beside it half of that: the third image of the
-- gas is a tenth of a pixel wide, and too many pixels would miss it altogether.
module BlackHole.Trace.Adaptive
  ( Pixel (..),
    PixelSpan,
    pixelSpan,
    refinedPixel,
    singlePixel,

    -- * Explanation
    Origin (..),
    pixelOrigin,
    sharedWorth,
  )
where

import BlackHole.Light.Radiance (Radiance, black)
import BlackHole.Scene.Camera (Picture (..), closesAround, pixelMiddle)
import BlackHole.Scene.Scene
import BlackHole.Trace.Estimate
import BlackHole.Trace.Layers
import BlackHole.Trace.PhotonRing
import BlackHole.Trace.Pixel
import BlackHole.Trace.Sampling (Sample)
import BlackHole.Trace.SkyLight (SkyPatch, pixelSky)
import BlackHole.Trace.SkySpan
import BlackHole.Trace.Tracer

-- | The light of a pixel, and the number of rays traced for it.
data Pixel = Pixel
  { pixelRays :: {-# UNPACK #-} !Int,
    pixelRadiance :: {-# UNPACK #-} !Radiance
  }
  deriving (Eq, Show)

-- | What the pixels of a span share: their sky, and what surrounds them.
data PixelSpan = PixelSpan SkySpan !Surroundings

-- | What surrounds the pixels of a span.
data Surroundings
  = -- | The photon ring may pass through or beside one of them.
    RingNear
  | -- | Nothing is in front of the sky, behind them and their neighbours.
    OpenSky
  | Anything

-- | @pixelSpan traced first next layersAt column row@ is the span from a column, a multiple
-- of 'spanLength', with the nodes of the sky there and at the next multiple, from the stored
-- layers by column and row.
pixelSpan ::
  Tracer ->
  Maybe SkyNode ->
  Maybe SkyNode ->
  (Int -> Int -> Layers) ->
  Int ->
  Int ->
  PixelSpan
pixelSpan traced first next layersAt column row =
  PixelSpan (skySpan traced first next) surroundings
  where
    surroundings
      | ringIsNear = RingNear
      | all clearInRow [max 0 (row - 1) .. min (height - 1) (row + 1)] = OpenSky
      | otherwise = Anything
    ringIsNear = case tracerMatter traced of
      Gaseous _ -> photonRingWithin traced reach (spanMiddle column row)
      _ -> False
    reach = 16 + 5 * fromIntegral spanLength
    clearInRow y = column > 0 && column + spanLength < width && clear (column - 1) y
    clear !x y = x > column + spanLength || layersClear (layersAt x y) == 1 && clear (x + 1) y
    Picture width height = scenePicture (tracerScene traced)
{-# INLINE pixelSpan #-}

-- | Where the light of a pixel comes from.
data Origin = Origin
  { -- | The light of nine pixels' first rays, if it counts: as 'sharedWorth' samples.
    originShared :: !(Maybe Radiance),
    -- | The sky behind the pixel for all of its own samples, where they share it.
    originSky :: !(Maybe SkyPatch),
    -- | Its own samples.
    originSamples :: ![Sample]
  }

-- | The number of a pixel's own samples that count as much as the rays of nine pixels
-- where these disagree.
sharedWorth :: Int
sharedWorth = 4

-- | What has been found out about a pixel before it gets rays of its own.
data Outlook
  = OnRing !PhotonRing
  | Certain !Radiance
  | Uncertain !Radiance

outlook :: Tracer -> Kernel -> PixelSpan -> (Int -> Int -> Layers) -> Int -> Int -> Outlook
outlook traced weights (PixelSpan skies surroundings) layersAt !column !row
  | OpenSky <- surroundings = Certain (skyInSpan traced skies column row)
  | RingNear <- surroundings,
    Just ring <- photonRing traced (pixelMiddle column row) =
    OnRing ring
  | least == 1 = Certain sky
  | uncertain > sceneNoise scene = Uncertain light
  | otherwise = Certain light
  where
    scene = tracerScene traced
    Picture width height = scenePicture scene
    -- Where a picture closes around the sphere its last column is the first one's
    -- neighbour.
    !closed = closesAround (sceneProjection scene) (sceneCamera scene)
    (light, uncertain) = sharedLight weights (tracerGain traced) (sceneNoise scene) sky near
    (least, most) = clearness near
    sky = if most > 0 then skyInSpan traced skies column row else black
    near x y = layersAt (inside (column + x)) (max 0 (min (height - 1) (row + y)))
    inside c
      | c < 0 = if closed then width - 1 else 0
      | c >= width = if closed then 0 else width - 1
      | otherwise = c
{-# INLINE outlook #-}

-- | @refinedPixel traced weights within layersAt column row@ is a pixel in its final form,
-- from the 'kernel' of the scene's filter, its span, and the stored layers of it and its
-- neighbours by column and row.
refinedPixel :: Tracer -> Kernel -> PixelSpan -> (Int -> Int -> Layers) -> Int -> Int -> Pixel
refinedPixel traced weights within layersAt !column !row =
  finished traced (round (layersRays (layersAt column row))) column row $
    outlook traced weights within layersAt column row
{-# INLINE refinedPixel #-}

-- | @finished traced first column row outlook@ is a pixel in its final form, from the
-- number of its first rays.
finished :: Tracer -> Int -> Int -> Int -> Outlook -> Pixel
finished traced !first !column !row seen = case seen of
  Certain light -> Pixel first light
  Uncertain light -> moreSamples traced first light column row
  OnRing ring ->
    let most = ringSamples (tracerScene traced) ring
     in Pixel most (estimatedRadiance (addRingSamples traced ring 0 most noSamples column row))
{-# INLINE finished #-}

-- | @moreSamples traced first light column row@ is a pixel after rays of its own, in
-- addition to the first ones, from whose light it starts. All of them together are no more
-- than 'mostSamples'.
moreSamples :: Tracer -> Int -> Radiance -> Int -> Int -> Pixel
moreSamples traced !first light !column !row = refined 0 (startFrom (tracerGain traced) light)
  where
    scene = tracerScene traced
    most = mostSamples scene - first
    refined !count estimate
      | count >= most || count > 0 && estimatedError estimate <= sceneNoise scene =
        Pixel (first + count) (estimatedRadiance estimate)
      | otherwise = refined count' (addSamples traced count count' estimate column row)
      where
        count' = min most (max (count + 4) (2 * count))

-- | The estimate that starts from the light of nine pixels.
startFrom :: Double -> Radiance -> Estimate
startFrom gain light = iterate (addSample gain 1 light) noSamples !! sharedWorth

-- | A single pixel, bit-identical to the one in a film. Takes much longer than in a film.
singlePixel :: Tracer -> Int -> Int -> Pixel
singlePixel traced column row
  | isAdaptive scene =
    finished traced (firstRays traced column row) column row $
      singleOutlook traced column row
  | otherwise =
    let count = sceneSamples scene
     in Pixel count (estimatedRadiance (addSamples traced 0 count noSamples column row))
  where
    scene = tracerScene traced

-- | The number of the first rays of a single pixel.
firstRays :: Tracer -> Int -> Int -> Int
firstRays traced column row = round (layersRays (storedLayers traced column row))

-- | The 'outlook' of a single pixel.
singleOutlook :: Tracer -> Int -> Int -> Outlook
singleOutlook traced column row =
  outlook traced (kernel (sceneFilter (tracerScene traced))) within (storedLayers traced) column row
  where
    within = pixelSpan traced (node 0) (node spanLength) (storedLayers traced) start row
    start = spanStart column
    node by = skyNode traced (start + by) row

-- | Where the light of a 'singlePixel' comes from.
pixelOrigin :: Tracer -> Int -> Int -> Origin
pixelOrigin traced column row
  | not (isAdaptive scene) = Origin Nothing sky (plain (sceneSamples scene))
  | otherwise = case singleOutlook traced column row of
    Certain light -> Origin (Just light) Nothing []
    Uncertain light ->
      let own = pixelRays (moreSamples traced first light column row) - first
       in Origin (Just light) sky (plain own)
    OnRing ring ->
      Origin Nothing (ringPatch traced ring column row) $
        map (ringPoint traced ring column row) [0 .. ringSamples scene ring - 1]
  where
    scene = tracerScene traced
    first = firstRays traced column row
    sky = pixelSky traced column row
    plain count = map (samplePoint scene column row) [0 .. count - 1]
