{-# LANGUAGE BangPatterns #-}
-- The loop along a path keeps its state in registers and on the stack instead of the
-- heap.
{-# OPTIONS_GHC -fmax-worker-args=64 #-}

-- | The light that arrives along one line of sight: from the gas on its way, and from the
-- sky behind it.
module BlackHole.Trace.Ray
  ( sightRadiance,
    sharingRadiance,
    threeSights,

    -- * Its parts
    followSight,
    tracedGas,

    -- * The sky shared by the samples of a pixel
    SkyPatch,
    pixelSky,
    sharedSky,
  )
where

import BlackHole.Light.Radiance
import BlackHole.Numeric.Floor (turnFraction)
import BlackHole.Scene.Scene
import BlackHole.Scene.Shifts (skyShift)
import BlackHole.Spacetime.Fate
import BlackHole.Spacetime.Follow
import BlackHole.Spacetime.LightPath
import BlackHole.Spacetime.Observer
import BlackHole.Spacetime.Schwarzschild.Leapfrog (followThree)
import BlackHole.Spacetime.Schwarzschild.LensDifferential (LensChanges (..))
import BlackHole.Trace.Gas
import BlackHole.Trace.RayDifferential
import BlackHole.Trace.Sky
import BlackHole.Trace.Tracer
import BlackHole.Vector.XY (XY (..))
import BlackHole.Vector.XYZ (XYZ, (*^), (^-^))
import qualified BlackHole.Vector.XYZ as XYZ
import Control.Monad ((>=>))
import GHC.Exts (lazy)

-- | Follows a line of sight by the scene's integrator and passes the segments that may
-- contain gas to the gathering function. The line of sight must be the one through this
-- point of the picture.
followSight :: Tracer -> XY -> SightLine -> (a -> PathSegment -> Continue a) -> a -> Followed a
followSight traced point = follow (tracerPaths traced) (tracerRegion traced) (stepPhase point)

-- | The light of everything along a line of sight, and what lies behind it.
followLight :: Tracer -> XY -> SightLine -> Followed Gathered
followLight traced point sight = case tracerMatter traced of
  Gaseous glowing ->
    let !observed = sightFrequency sight
     in follow
          (tracerPaths traced)
          (tracerRegion traced)
          (stepPhase point)
          sight
          (gatherGas glowing observed)
          nothingYet
  Vacuum -> Followed (pathFate (tracerPaths traced) sight) nothingYet 0
  Checks disk -> followSight traced point sight (gatherParity disk) nothingYet

-- | The phase of the first step in the gas, 0 to 1. Phases are spread evenly over the
-- samples of a pixel and its neighbours, so that one step finds what another misses
-- (the additive recurrence of the plastic number).
stepPhase :: XY -> Double
stepPhase (XY x y) = 0.5 + turnFraction (0.7548776662466927 * x + 0.5698402909980532 * y)

-- | 'sightRadiance' of three points, from three leapfrogs interleaved on one core.
threeSights :: Tracer -> XY -> XY -> XY -> (Radiance, Radiance, Radiance)
threeSights traced p0 p1 p2 =
  case (tracedSight traced p0, tracedSight traced p1, tracedSight traced p2) of
    (Just s0@(SightLine photon0 _), Just s1@(SightLine photon1 _), Just s2@(SightLine photon2 _)) ->
      let gathering photon sight = (photon, tracedGas traced sight)
          (f0, f1, f2) =
            followThree
              (sceneLeapfrog scene)
              (sceneSpacetime scene)
              (tracerRegion traced)
              (gathering photon0 s0)
              (gathering photon1 s1)
              (gathering photon2 s2)
              nothingYet
       in (seen traced Nothing p0 s0 f0, seen traced Nothing p1 s1 f1, seen traced Nothing p2 s2 f2)
    _ -> (sightRadiance traced p0, sightRadiance traced p1, sightRadiance traced p2)
  where
    scene = tracerScene traced

-- | The radiance that arrives at a point of the picture, in pixels from the top left
-- corner.
sightRadiance :: Tracer -> XY -> Radiance
sightRadiance prepared = sharingRadiance prepared Nothing

-- | 'sightRadiance', given the sky behind the pixel where it is known.
sharingRadiance :: Tracer -> Maybe SkyPatch -> XY -> Radiance
sharingRadiance prepared shared point
  | Just _ <- tracerLens traced = lensRadiance traced shared point
  | otherwise = case tracedSight traced point of
    Nothing -> black
    Just sight -> seen traced shared point sight (followLight traced point sight)
  where
    -- Otherwise GHC takes the record apart for the call and reassembles it here.
    traced = lazy prepared

-- | 'sharingRadiance' through a point of the lens. Not for inlining: the pinhole's code
-- would leave more on the heap.
lensRadiance :: Tracer -> Maybe SkyPatch -> XY -> Radiance
lensRadiance traced shared point = sharingRadiance (throughLens traced point) shared point
{-# NOINLINE lensRadiance #-}

-- | The light of the gas, plus the sky's contribution.
seen :: Tracer -> Maybe SkyPatch -> XY -> SightLine -> Followed Gathered -> Radiance
seen traced shared point sight (Followed fate (Gathered light transmittance) _) =
  light <+> scaleRadiance transmittance behind
  where
    behind = sharedSky traced shared point sight fate
{-# INLINE seen #-}

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
pixelSky traced column row = case tracerSky traced of
  ByDifferential shader | mostSamples (tracerScene traced) > 1 -> do
    let point = XY (fromIntegral column + 0.5) (fromIntegral row + 0.5)
    sight <- tracedSight traced point
    direction <- escapeDirection traced sight
    differential <- tracedDifferential traced point sight direction
    let area = differentialSolidAngle differential
        breadth =
          XYZ.dot (differentialAlongX differential) (differentialAlongX differential)
            + XYZ.dot (differentialAlongY differential) (differentialAlongY differential)
    pure
      ( SkyPatch
          point
          differential
          (0.01 * area * area / breadth)
          (shader (skyShift (tracerSkyShift traced) (sightFrequency sight)) differential)
      )
  _ -> Nothing

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

-- | The contribution of a segment of the scene's gas along a line of sight.
tracedGas :: Tracer -> SightLine -> Gathered -> PathSegment -> Continue Gathered
tracedGas traced sight = case tracerMatter traced of
  Vacuum -> \gathered _ -> Continue gathered
  Checks disk -> gatherParity disk
  Gaseous glowing -> gatherGas glowing (sightFrequency sight)

-- | The radiance that the sky sends to the end of a line of sight through a point of
-- the picture, without gas in between.
tracedSky :: Tracer -> XY -> SightLine -> Fate XYZ -> Radiance
tracedSky prepared point sight fate = case fate of
  Escaped direction ->
    let !shift = skyShift (tracerSkyShift traced) (sightFrequency sight)
     in case tracerSky traced of
          ByDirection shader -> shader shift direction
          ByDifferential shader ->
            maybe black (shader shift) (tracedDifferential traced point sight direction)
  _ -> black
  where
    -- As in 'sharingRadiance'.
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
    -- As in 'sharingRadiance'.
    traced = lazy prepared
    beside = sightBesidePoint traced point

-- | The direction in which a line of sight escapes, disregarding gas, if it does.
escapeDirection :: Tracer -> SightLine -> Maybe XYZ
escapeDirection traced sight = case pathFate (tracerPaths traced) sight of
  Escaped direction -> Just direction
  _ -> Nothing
