{-# LANGUAGE BangPatterns #-}
-- The loop along a path keeps its state in registers and on the stack, not on
-- the heap.
{-# OPTIONS_GHC -fmax-worker-args=64 #-}

-- | From a scene and a pixel to its radiance: one pure function.
module BlackHole.Trace.Pixel
  ( Tracer,
    tracer,
    tracerUnder,
    tracerTables,
    addSamples,
    addSamplesToThree,
    onlySample,
    sightRadiance,
    samplePoint,
    meetsPhotonRing,

    -- * Its parts
    tracedScene,
    tracedDirection,
    tracedSight,
    tracedGas,
    tracedSky,
    tracedBeam,
    followSight,
  )
where

import BlackHole.Light.Display (Exposure (..))
import BlackHole.Light.Radiance
import BlackHole.Numeric.Floor (turnFraction)
import BlackHole.Physics.ExactPath
import BlackHole.Physics.Fate
import BlackHole.Physics.Leapfrog
import BlackHole.Physics.LensBeam
import BlackHole.Physics.LensTable
import BlackHole.Physics.LightPath
import BlackHole.Physics.Observer
import BlackHole.Physics.Spacetime (Spacetime (..))
import BlackHole.Physics.SweptPath
import BlackHole.Scene.Camera
import BlackHole.Scene.Disk (Disk)
import BlackHole.Scene.Scene
import BlackHole.Scene.Shifts (SkyShift, noSkyShift, skyShift, skyShiftAt)
import BlackHole.Trace.Beam
import BlackHole.Trace.Estimate
import BlackHole.Trace.Gas
import BlackHole.Trace.Grid
import BlackHole.Trace.Sampling
import BlackHole.Trace.Sky
import BlackHole.Trace.SkyImage (SkyImage)
import BlackHole.Vector.XY (XY (..))
import BlackHole.Vector.XYZ (XYZ, (*^), (^-^))
import qualified BlackHole.Vector.XYZ as XYZ
import GHC.Exts (lazy)

-- | A scene made ready: what all pixels share, worked out once.
data Tracer = Tracer
  { tracerPlane :: !PicturePlane,
    tracerScene :: !Scene,
    tracerEye :: !Eye,
    -- | The exposure's factor.
    tracerGain :: !Double,
    -- | The part of g that counts for the sky.
    tracerSkyShift :: !SkyShift,
    tracerRegion :: !Region,
    -- | Made when first used, like the next.
    tracerMatter :: Matter,
    -- | The paths through the camera's place.
    tracerTable :: LensTable,
    -- | Likewise.
    tracerSky :: SkyShader
  }

-- | What shines along the way.
data Matter
  = Vacuum
  | Checks !Disk
  | Gaseous !Gas

-- | Make a scene ready. 'Nothing' if its camera looks nowhere
-- ('cameraFrame'), which no validated scene has, or its sky is a panorama: that
-- needs 'tracerUnder'.
tracer :: Scene -> Maybe Tracer
tracer = tracerUnder Nothing

-- | The same with the picture of the sky if the scene's is a panorama
-- ('neededPicture').
tracerUnder :: Maybe SkyImage -> Scene -> Maybe Tracer
tracerUnder picture scene = do
  frame <- cameraFrame (sceneCamera scene)
  sky <- shader
  pure
    Tracer
      { tracerPlane = picturePlane (sceneCamera scene) (scenePicture scene) frame,
        tracerScene = scene,
        tracerGain = 2 ** stops,
        tracerEye = eye (sceneSpacetime scene) (sceneObserver scene) place,
        tracerSkyShift = case sceneSpacetime scene of
          Flat -> noSkyShift
          Schwarzschild -> skyShiftAt (sceneShifts scene) (XYZ.norm place),
        tracerRegion = sceneRegion scene,
        tracerMatter = matter,
        tracerTable = table,
        tracerSky = sky
      }
  where
    Exposure stops = sceneExposure scene
    table = lensTable (XYZ.norm place)
    place = posePosition (cameraPose (sceneCamera scene))
    seed = sceneSeed scene
    shader
      | sceneDebugTextures scene = Just (ByDirection (const gridRadiance))
      | otherwise = skyShader picture seed (sceneSky scene)
    matter = case sceneDisk scene of
      Nothing -> Vacuum
      Just disk
        | sceneDebugTextures scene -> Checks disk
        | otherwise -> Gaseous (gas seed (sceneShifts scene) disk place (pixelAngle (sceneCamera scene) (scenePicture scene)) (sceneSamples scene))

-- | What takes time to be made ready, to be evaluated beforehand, each apart from
-- the others. Without, the first ray that needs it waits for it.
tracerTables :: Tracer -> [()]
tracerTables traced =
  seq (tracerMatter traced) () : seq (tracerSky traced) () : [seq (tracerTable traced) () | sceneIntegrator (tracerScene traced) == Tabulated]

-- | Follow a line of sight by the scene's own integrator and hand the stretches
-- that lie where there can be gas to the gatherer. The point of the picture is
-- the one it goes through.
followSight :: Tracer -> XY -> SightLine -> (a -> Stretch -> Onward a) -> a -> Followed a
followSight traced point sight = case sceneIntegrator scene of
  Tabulated -> followSwept space (tracerTable traced) region (stepPhase point) photon
  Exact -> followExact space region photon
  Leapfrogging -> followLeapfrog (sceneLeapfrog scene) space region photon
  where
    scene = tracerScene traced
    space = sceneSpacetime scene
    region = tracerRegion traced
    photon = sightPhoton sight

-- | The light of everything along a line of sight, and what is behind it.
followLight :: Tracer -> XY -> SightLine -> Followed Gathered
followLight traced point sight = case (sceneIntegrator scene, tracerMatter traced) of
  -- The one case that is compiled into a loop of its own.
  (Tabulated, Gaseous glowing) ->
    followSwept
      (sceneSpacetime scene)
      (tracerTable traced)
      (tracerRegion traced)
      (stepPhase point)
      (sightPhoton sight)
      (gatherGas glowing (sightFrequency sight))
      nothingYet
  (Tabulated, Vacuum) ->
    Followed (sweptFate (sceneSpacetime scene) (tracerTable traced) (sightPhoton sight)) nothingYet 0
  _ -> followSight traced point sight (tracedGas traced (sightFrequency sight)) nothingYet
  where
    scene = tracerScene traced

-- | Where on its first step a path enters the gas, 0 … 1: spread evenly over the
-- samples of a pixel and over its neighbours, so that what one step misses
-- another sees. (The additive recurrence of the plastic number.)
stepPhase :: XY -> Double
stepPhase (XY x y) = 0.5 + turnFraction (0.7548776662466927 * x + 0.5698402909980532 * y)

-- | @addSamples traced from to estimate column row@: the estimate with the
-- pixel's samples from one number up to another, which is left out.
addSamples :: Tracer -> Int -> Int -> Estimate -> Int -> Int -> Estimate
addSamples prepared from to estimate column row = go from estimate
  where
    traced = lazy prepared
    shared
      | to - from > 1 = skyPatch traced (XY (fromIntegral column + 0.5) (fromIntegral row + 0.5))
      | otherwise = Nothing
    go !index !sums
      | index < to =
        let Sample place weight = samplePoint (tracerScene traced) column row index
         in go (index + 1) (addSample (tracerGain traced) weight (sharingRadiance traced shared place) sums)
      | otherwise = sums

-- | The same of three pixels in a row, from a column on.
addSamplesToThree :: Tracer -> Int -> Int -> Estimate -> Estimate -> Estimate -> Int -> Int -> (Estimate, Estimate, Estimate)
addSamplesToThree traced from to estimate0 estimate1 estimate2 column row = case sceneIntegrator scene of
  Leapfrogging -> go from estimate0 estimate1 estimate2
  _ -> (single estimate0 column, single estimate1 (column + 1), single estimate2 (column + 2))
  where
    scene = tracerScene traced
    single estimate c = addSamples traced from to estimate c row
    go !index !sums0 !sums1 !sums2
      | index < to =
        let Sample p0 w0 = samplePoint scene column row index
            Sample p1 w1 = samplePoint scene (column + 1) row index
            Sample p2 w2 = samplePoint scene (column + 2) row index
            (r0, r1, r2) = threeSights traced p0 p1 p2
            add = addSample (tracerGain traced)
         in go (index + 1) (add w0 r0 sums0) (add w1 r1 sums1) (add w2 r2 sums2)
      | otherwise = (sums0, sums1, sums2)

-- | What 'addSamples' estimates of a pixel from a single sample: with nothing to
-- weigh, its light as it is, without what a filter or a sum might make negative.
onlySample :: Tracer -> Int -> Int -> Radiance
onlySample traced column row = mapRadiance (max 0) (sightRadiance traced place)
  where
    Sample place _ = samplePoint (tracerScene traced) column row 0
{-# INLINE onlySample #-}

-- | 'sightRadiance' of three points, by three leapfrogs side by side.
threeSights :: Tracer -> XY -> XY -> XY -> (Radiance, Radiance, Radiance)
threeSights traced p0 p1 p2 = case (tracedSight traced p0, tracedSight traced p1, tracedSight traced p2) of
  (Just s0, Just s1, Just s2) ->
    let gathering sight = (sightPhoton sight, tracedGas traced (sightFrequency sight))
        (f0, f1, f2) =
          followThree
            (sceneLeapfrog scene)
            (sceneSpacetime scene)
            (tracerRegion traced)
            (gathering s0)
            (gathering s1)
            (gathering s2)
            nothingYet
     in (seen traced Nothing p0 s0 f0, seen traced Nothing p1 s1 f1, seen traced Nothing p2 s2 f2)
  _ -> (sightRadiance traced p0, sightRadiance traced p1, sightRadiance traced p2)
  where
    scene = tracerScene traced

-- | Radiance that arrives at one point of the picture (pixels from the top
-- left corner).
sightRadiance :: Tracer -> XY -> Radiance
sightRadiance prepared = sharingRadiance prepared Nothing

-- | The same, with the sky of the pixel where it is known.
sharingRadiance :: Tracer -> Maybe SkyPatch -> XY -> Radiance
sharingRadiance prepared shared point = case tracedSight traced point of
  Nothing -> black
  Just sight -> seen traced shared point sight (followLight traced point sight)
  where
    -- GHC would take it apart for the call and put it together again in here.
    traced = lazy prepared

-- | The gas's light and what the sky adds to it.
seen :: Tracer -> Maybe SkyPatch -> XY -> SightLine -> Followed Gathered -> Radiance
seen traced shared point sight (Followed fate (Gathered light transmittance) _) =
  light <+> scaleRadiance transmittance behind
  where
    behind = case fate of
      Escaped direction | Just patch <- shared, Just sky <- patchRadiance patch point direction -> sky
      _ -> tracedSky traced point sight fate
{-# INLINE seen #-}

-- | The sky behind a pixel, past all gas: the pixel's middle, the beam there, the
-- square of how far a line of sight may end from where the beam has it, and the light.
data SkyPatch
  = SkyPatch
      {-# UNPACK #-} !XY
      {-# UNPACK #-} !Beam
      {-# UNPACK #-} !Double
      {-# UNPACK #-} !Radiance

-- | The sky behind the pixel around a point of the picture, for all of its samples:
-- filtered for a pixel, it need not be looked at more than once in each. 'Nothing'
-- where it is cheap to look at or no light arrives from it.
skyPatch :: Tracer -> XY -> Maybe SkyPatch
skyPatch traced point = case tracerSky traced of
  ByDirection _ -> Nothing
  ByBeam shader -> do
    sight <- tracedSight traced point
    direction <- escapeDirection traced point sight
    beam <- tracedBeam traced point sight direction
    let area = beamSolidAngle beam
        breadth = XYZ.dot (beamAlongX beam) (beamAlongX beam) + XYZ.dot (beamAlongY beam) (beamAlongY beam)
    pure (SkyPatch point beam (0.01 * area * area / breadth) (shader (skyShift (tracerSkyShift traced) (sightFrequency sight)) beam))

-- | A patch's light at a point from which a line of sight ends in this direction.
-- 'Nothing' if that is farther from where the beam has it than a tenth of the beam's
-- width: beside a critical curve of the lens, at the edge of the shadow.
patchRadiance :: SkyPatch -> XY -> XYZ -> Maybe Radiance
patchRadiance (SkyPatch (XY x0 y0) (Beam d a b) slack light) (XY x y) direction
  | XYZ.dot miss miss <= slack = Just light
  | otherwise = Nothing
  where
    miss = direction ^-^ d ^-^ (x - x0) *^ a ^-^ (y - y0) *^ b
{-# INLINE patchRadiance #-}

-- | The scene itself.
tracedScene :: Tracer -> Scene
tracedScene = tracerScene

-- | The direction of sight through a point of the picture.
tracedDirection :: Tracer -> XY -> XYZ
tracedDirection traced = sightDirection (tracerPlane traced)

-- | The light path that arrives at a point of the picture; 'Nothing' where it
-- is dark because none does ('sightLine').
tracedSight :: Tracer -> XY -> Maybe SightLine
tracedSight traced point = sightFrom (tracerEye traced) (sightDirection (tracerPlane traced) point)

-- | What a stretch of the scene's gas adds, by the observer's frequency.
tracedGas :: Tracer -> Double -> Gathered -> Stretch -> Onward Gathered
tracedGas traced observed = case tracerMatter traced of
  Vacuum -> \gathered _ -> Onward gathered
  Checks disk -> gatherParity disk
  Gaseous glowing -> gatherGas glowing observed

-- | What the sky sends to the end of a line of sight through a point of the
-- picture, with no gas in between.
tracedSky :: Tracer -> XY -> SightLine -> Fate -> Radiance
tracedSky traced point sight fate = case fate of
  Escaped direction ->
    let !shift = skyShift (tracerSkyShift traced) (sightFrequency sight)
     in case tracerSky traced of
          ByDirection shader -> shader shift direction
          ByBeam shader -> maybe black (shader shift) (tracedBeam traced point sight direction)
  Captured -> black
  Opaque -> black
  StepLimit -> black

-- | The beam behind a point of the picture, past all gas, from the line of sight
-- through it and the direction in which it escapes: by the table of paths, or
-- where that has no answer from the paths through points beside it. 'Nothing'
-- where no light arrives from the sky.
tracedBeam :: Tracer -> XY -> SightLine -> XYZ -> Maybe Beam
tracedBeam traced point@(XY x y) sight direction = case sceneSpacetime (tracerScene traced) of
  Schwarzschild
    | Just beside <- tracedSight traced (XY (x + step) y),
      Just below <- tracedSight traced (XY x (y + step)),
      Just (LensChanges alongX alongY) <-
        lensChanges (tracerTable traced) (sightPhoton sight) direction (sightPhoton beside) (sightPhoton below) ->
      Just (Beam direction ((1 / step) *^ alongX) ((1 / step) *^ alongY))
  _ -> beamByDifferences escape point
  where
    step = 0.01
    escape beside = tracedSight traced beside >>= escapeDirection traced beside

-- | Where a line of sight ends past all gas, if in the sky.
escapeDirection :: Tracer -> XY -> SightLine -> Maybe XYZ
escapeDirection traced point sight = case fate of
  Escaped direction -> Just direction
  _ -> Nothing
  where
    fate
      | sceneIntegrator (tracerScene traced) == Tabulated = sweptFate (sceneSpacetime (tracerScene traced)) (tracerTable traced) (sightPhoton sight)
      | otherwise = followedFate (followSight traced {tracerRegion = emptyRegion} point sight (\() _ -> Onward ()) ())

-- | Whether the edge of the shadow, where all further images of the gas crowd
-- together in rings thinner than a pixel, passes through or beside the pixel around
-- a point of the picture.
meetsPhotonRing :: Tracer -> XY -> Bool
meetsPhotonRing traced point@(XY x y) = case (sceneSpacetime scene, tracerMatter traced, tracedOffset point) of
  (Schwarzschild, Gaseous _, Just here)
    -- The ring is thousands of pixels away from most: be done with them cheaply.
    -- Fast observers see it grow or shrink, but by no such factor.
    | abs here < 16 * pixelAngle (sceneCamera scene) (scenePicture scene),
      Just right <- tracedOffset (XY (x + 1) y),
      Just below <- tracedOffset (XY x (y + 1)) ->
      abs here < 1.5 * (abs (right - here) + abs (below - here))
  _ -> False
  where
    scene = tracerScene traced
    tracedOffset = fmap (criticalOffset (tracerTable traced) . sightPhoton) . tracedSight traced

-- | One of a pixel's samples, by column, row and number.
samplePoint :: Scene -> Int -> Int -> Int -> Sample
samplePoint scene = sampleOf (sceneFilter scene) (sceneSeed scene) (mostSamples scene)
