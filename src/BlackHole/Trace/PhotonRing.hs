{-# LANGUAGE BangPatterns #-}
{-# OPTIONS_GHC -fmax-worker-args=64 #-}

-- | The samples of pixels on the photon ring, at the edge of the shadow, where the images
-- of the gas crowd together.
module BlackHole.Trace.PhotonRing
  ( PhotonRing,
    photonRing,
    photonRingWithin,
    ringSamples,
    addRingSamples,
    ringPoint,
    ringPatch,
  )
where

import BlackHole.Light.Radiance (black)
import BlackHole.Scene.Scene
import BlackHole.Spacetime.Follow (shadowOffset)
import BlackHole.Trace.Estimate
import BlackHole.Trace.Ray
import BlackHole.Trace.Sampling
import BlackHole.Trace.SkyLight
import BlackHole.Trace.Tracer
import BlackHole.Vector.XY (XY (..))
import GHC.Exts (lazy)

-- | The edge of the shadow where it passes through or beside a pixel: the unit vector
-- across it and out of the shadow, by how much 'shadowOffset' shrinks per pixel along that
-- vector, and the edge's distance from the pixel's middle in pixels.
data PhotonRing
  = PhotonRing
      {-# UNPACK #-} !XY
      {-# UNPACK #-} !Double
      {-# UNPACK #-} !Double

-- | The edge of the shadow if it passes through or beside the pixel around a point of
-- the picture. All higher-order images of the gas crowd together at that edge in rings
-- thinner than a pixel.
photonRing :: Tracer -> XY -> Maybe PhotonRing
photonRing traced point@(XY x y) = case (tracerMatter traced, tracedOffset traced point) of
  (Gaseous _, Just here)
    -- Most pixels are thousands of pixels away from the ring; dismiss them cheaply.
    -- Fast observers see the ring grow or shrink, but by less than this factor.
    | abs here < 16 * pixelWidth scene,
      Just right <- tracedOffset traced (XY (x + 1) y),
      Just below <- tracedOffset traced (XY x (y + 1)),
      let across = right - here
          down = below - here
          growth = sqrt (across * across + down * down),
      abs here < 1.5 * (abs across + abs down) ->
      let normal = XY (negate across / growth) (negate down / growth)
       in Just (PhotonRing normal growth (abs here / growth))
  _ -> Nothing
  where
    scene = tracerScene traced

-- | @photonRingWithin traced widths point@ tells whether 'shadowOffset' at a point of the
-- picture is less than this many times a pixel's angle. For an observer at rest it grows by
-- about that angle per pixel; for fast ones by up to ten times as much.
photonRingWithin :: Tracer -> Double -> XY -> Bool
photonRingWithin traced widths point = case tracedOffset traced point of
  Just here -> abs here < widths * pixelWidth (tracerScene traced)
  Nothing -> False

-- | 'shadowOffset' of the light path that arrives at a point of the picture.
tracedOffset :: Tracer -> XY -> Maybe Double
tracedOffset traced place = tracedSight traced place >>= shadowOffset (tracerPaths traced)

-- | The number of samples of a pixel on the photon ring: 'mostSamples', or half as many
-- where the filter gives the edge of the shadow little weight.
ringSamples :: Scene -> PhotonRing -> Int
ringSamples scene (PhotonRing _ _ away)
  | away < 0.9 = most
  | otherwise = max 1 (most `quot` 2)
  where
    most = mostSamples scene

-- | @addRingSamples traced ring from to estimate column row@ is 'addSamples' with the
-- points of 'ringPoint'.
addRingSamples :: Tracer -> PhotonRing -> Int -> Int -> Estimate -> Int -> Int -> Estimate
addRingSamples prepared ring from to estimate column row = go from estimate
  where
    traced = lazy prepared
    shared = ringPatch traced ring column row
    go !index !sums
      | index < to =
        let Sample place weight = ringPoint traced ring column row index
            light = if weight == 0 then black else sharingRadiance traced shared place
         in go (index + 1) (addSample (tracerGain traced) weight light sums)
      | otherwise = sums

-- | The sky behind a pixel on the photon ring, for all of its samples.
ringPatch :: Tracer -> PhotonRing -> Int -> Int -> Maybe SkyPatch
ringPatch traced ring column row =
  ringSky traced [samplePlace (ringPoint traced ring column row k) | k <- [0 .. 7]]

-- | One of the samples of a pixel on the photon ring, by column, row and sample number:
-- more of them where the images of the gas are thinner.
ringPoint :: Tracer -> PhotonRing -> Int -> Int -> Int -> Sample
ringPoint traced (PhotonRing normal growth _) =
  curveSample
    (sceneFilter scene)
    (sceneSeed scene)
    normal
    (fmap (negate . (/ growth)) . tracedOffset traced)
  where
    scene = tracerScene traced
