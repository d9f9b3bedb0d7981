{-# LANGUAGE BangPatterns #-}

-- | The light that arrives from the sky along lines of sight: along each, and behind whole
-- pixels, whose samples share it.
module BlackHole.Trace.SkyLight
  ( tracedSky,
    skyBeam,

    -- * The sky shared by the samples of a pixel
    SkyPatch,
    pixelSky,
    ringSky,
    patchLight,
    sharedSky,
  )
where

import BlackHole.Light.Radiance
import BlackHole.Scene.Camera (pixelMiddle)
import BlackHole.Scene.Scene (mostSamples)
import BlackHole.Scene.Shifts (skyShift)
import BlackHole.Spacetime.Fate
import BlackHole.Spacetime.Follow
import BlackHole.Spacetime.Observer
import BlackHole.Spacetime.Schwarzschild.LensDifferential (LensChanges (..))
import BlackHole.Trace.RayDifferential
import BlackHole.Trace.Sky
import BlackHole.Trace.Tracer
import BlackHole.Vector.XY (XY (..))
import BlackHole.Vector.XYZ (XYZ, (*^), (^-^))
import qualified BlackHole.Vector.XYZ as XYZ
import Control.Monad ((>=>))
import Data.Maybe (listToMaybe, mapMaybe)
import GHC.Exts (lazy)

-- | 'tracedSky', given the sky behind the pixel where it is known.
sharedSky :: Tracer -> Maybe SkyPatch -> XY -> SightLine -> Fate XYZ -> Radiance
sharedSky traced shared point sight fate = case fate of
  Escaped direction | Just patch <- shared, Just sky <- patchRadiance patch point direction -> sky
  _ -> tracedSky traced point sight fate
{-# INLINE sharedSky #-}

-- | The sky behind a pixel, without gas: the pixel's centre, the beam through it, the
-- square of the distance from the beam's prediction up to which a line of sight may
-- share the light, and the light.
data SkyPatch
  = SkyPatch
      {-# UNPACK #-} !XY
      {-# UNPACK #-} !RayDifferential
      {-# UNPACK #-} !Double
      {-# UNPACK #-} !Radiance

-- | The sky behind a pixel, by column and row, for all of its samples: the light
-- through a beam is already filtered for a whole pixel, so one evaluation is enough.
-- 'Nothing' for a sky that is cheap to evaluate, for pixels of one sample, and where no
-- light arrives from the sky.
pixelSky :: Tracer -> Int -> Int -> Maybe SkyPatch
pixelSky traced column row = skyPatch traced (pixelMiddle column row)

-- | The sky behind a pixel around a point of the picture.
skyPatch :: Tracer -> XY -> Maybe SkyPatch
skyPatch traced point = case tracerSky traced of
  ByDifferential sky
    | mostSamples (tracerScene traced) > 1 -> do
      (differential, shift) <- skyBeam traced point
      let area = differentialSolidAngle differential
          along = XYZ.dot (differentialAlongX differential) (differentialAlongX differential)
          across = XYZ.dot (differentialAlongY differential) (differentialAlongY differential)
          slack = 0.01 * area * area / (along + across)
      pure (SkyPatch point differential slack (skyThrough sky shift differential))
  _ -> Nothing

-- | The sky behind a pixel on the photon ring for all of its samples, from the first of
-- these points through which light arrives from the sky. So near the ring a pixel shows
-- a large part of the sky, of which every sample sees the mean.
ringSky :: Tracer -> [XY] -> Maybe SkyPatch
ringSky traced points = listToMaybe (map sharedByAll (mapMaybe (skyPatch traced) points))
  where
    sharedByAll (SkyPatch point differential _ light) = SkyPatch point differential (1 / 0) light

-- | The light of the sky behind a pixel; black where none arrives.
patchLight :: Maybe SkyPatch -> Radiance
patchLight = maybe black (\(SkyPatch _ _ _ light) -> light)

-- | A patch's light for a line of sight through a point of the picture that escapes in
-- this direction. 'Nothing' if the direction is farther from the beam's prediction than
-- a tenth of the beam's width, as beside a critical curve and at the edge of the shadow.
patchRadiance :: SkyPatch -> XY -> XYZ -> Maybe Radiance
patchRadiance (SkyPatch (XY x0 y0) (RayDifferential d a b) slack light) (XY x y) direction
  | XYZ.dot miss miss <= slack = Just light
  | otherwise = Nothing
  where
    miss = direction ^-^ d ^-^ (x - x0) *^ a ^-^ (y - y0) *^ b
{-# INLINE patchRadiance #-}

-- | The radiance that the sky sends to the end of a line of sight through a point of
-- the picture, without gas in between.
tracedSky :: Tracer -> XY -> SightLine -> Fate XYZ -> Radiance
tracedSky prepared point sight fate = case fate of
  Escaped direction ->
    let !shift = skyShift (tracerSkyShift traced) (sightFrequency sight)
     in case tracerSky traced of
          ByDirection shader -> shader shift direction
          ByDifferential sky ->
            maybe black (skyThrough sky shift) (tracedDifferential traced point sight direction)
  _ -> black
  where
    -- Otherwise GHC takes the record apart for the call and reassembles it here.
    traced = lazy prepared

-- | The beam behind a point of the picture, beyond all gas, from the line of sight
-- through it and the direction of escape. Uses the derivatives of the paths or, where
-- they are not known, the paths through points beside it. 'Nothing' if no light arrives
-- from the sky.
tracedDifferential :: Tracer -> XY -> SightLine -> XYZ -> Maybe RayDifferential
tracedDifferential prepared point sight direction =
  case skyJacobian (tracerPaths traced) beside sight direction of
    Just (LensChanges alongX alongY) -> Just (RayDifferential direction alongX alongY)
    Nothing -> differentialByDifferences (beside >=> escapeDirection traced) (XY 0 0)
  where
    traced = lazy prepared
    beside = sightBesidePoint traced point

-- | The direction in which a line of sight escapes, disregarding gas, if it does.
escapeDirection :: Tracer -> SightLine -> Maybe XYZ
escapeDirection traced sight = case pathFate (tracerPaths traced) sight of
  Escaped direction -> Just direction
  _ -> Nothing

-- | The beam behind a point of the picture, beyond all gas, and the observed frequency
-- over the sky's. 'Nothing' if no light arrives from the sky.
skyBeam :: Tracer -> XY -> Maybe (RayDifferential, Double)
skyBeam traced point = do
  sight <- tracedSight traced point
  direction <- escapeDirection traced sight
  differential <- tracedDifferential traced point sight direction
  pure (differential, skyShift (tracerSkyShift traced) (sightFrequency sight))
