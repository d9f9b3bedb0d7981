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
    gasBeforeSky,
  )
where

import BlackHole.Light.Radiance
import BlackHole.Numeric.Floor (turnFraction)
import BlackHole.Scene.Scene
import BlackHole.Spacetime.Fate
import BlackHole.Spacetime.Follow
import BlackHole.Spacetime.LightPath
import BlackHole.Spacetime.Observer
import BlackHole.Spacetime.Schwarzschild.Leapfrog (followThree)
import BlackHole.Trace.Gas
import BlackHole.Trace.Sky
import BlackHole.Trace.SkyLight
import BlackHole.Trace.Tracer
import BlackHole.Vector.XY (XY (..))
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

-- | The phase of the first step in the gas, 0 to 1, so that one step finds what another
-- misses. The factors spread phases as evenly as possible over nine neighbours, and over
-- nine pixels two or four columns apart, between which the others are interpolated.
stepPhase :: XY -> Double
stepPhase (XY x y) = 0.5 + turnFraction (0.596 * x + 0.604 * y)

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

-- | The light of the gas at a point of the picture, and the share of the sky's light
-- that arrives there. Where the sky is not known for whole pixels, as behind a lens, its
-- light is part of the first and the second is 0.
gasBeforeSky :: Tracer -> XY -> (Radiance, Double)
gasBeforeSky prepared point
  | Just _ <- tracerLens traced = (lensRadiance traced Nothing point, 0)
  | otherwise = case tracedSight traced point of
    Nothing -> (black, 0)
    Just sight -> case followLight traced point sight of
      Followed fate (Gathered light transmittance) _ -> case tracerSky traced of
        ByDifferential _ | Escaped _ <- fate -> (light, transmittance)
        _ -> (light <+> scaleRadiance transmittance (tracedSky traced point sight fate), 0)
  where
    traced = lazy prepared

-- | The contribution of a segment of the scene's gas along a line of sight.
tracedGas :: Tracer -> SightLine -> Gathered -> PathSegment -> Continue Gathered
tracedGas traced sight = case tracerMatter traced of
  Vacuum -> \gathered _ -> Continue gathered
  Checks disk -> gatherParity disk
  Gaseous glowing -> gatherGas glowing (sightFrequency sight)
