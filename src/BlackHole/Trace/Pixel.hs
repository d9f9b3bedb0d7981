{-# LANGUAGE BangPatterns #-}
-- The loop along a path keeps its state in registers and on the stack instead of the
-- heap.
{-# OPTIONS_GHC -fmax-worker-args=64 #-}

-- | The radiance of a pixel of a scene, as a pure function.
module BlackHole.Trace.Pixel
  ( Tracer,
    tracer,
    tracerWithSky,
    tracerAfter,
    tracerTables,
    addSamples,
    addSamplesToThree,
    onlySample,
    sightRadiance,
    samplePoint,
    PhotonRing,
    photonRing,
    addRingSamples,
    ringPoint,

    -- * Its parts
    tracedScene,
    tracedDirection,
    tracedSight,
    throughLens,
    tracedGas,
    tracedSky,
    SkyPatch,
    pixelSky,
    sharingRadiance,
    sharedSky,
    tracedDifferential,
    followSight,
  )
where

import BlackHole.Light.Display (Exposure (..))
import BlackHole.Light.Radiance
import BlackHole.Noise.SipHash
import BlackHole.Numeric.Floor (turnFraction)
import BlackHole.Scene.Camera
import BlackHole.Scene.Disk (Disk)
import BlackHole.Scene.Scene
import BlackHole.Scene.Shifts (SkyShift, noSkyShift, skyShift, skyShiftAt)
import BlackHole.Spacetime.Fate
import BlackHole.Spacetime.Kerr.Follow
import BlackHole.Spacetime.Kerr.Radial (photonOrbitOffset)
import BlackHole.Spacetime.Kerr.Sight (LightRay (rayRadius))
import BlackHole.Spacetime.LightPath
import BlackHole.Spacetime.Observer
import BlackHole.Spacetime.Schwarzschild.ExactPath
import BlackHole.Spacetime.Schwarzschild.Leapfrog
import BlackHole.Spacetime.Schwarzschild.LensDifferential
import BlackHole.Spacetime.Schwarzschild.LensTable
import BlackHole.Spacetime.Schwarzschild.TablePath
import BlackHole.Spacetime.Types (Spacetime (..))
import BlackHole.Trace.EnvironmentMap (EnvironmentMap)
import BlackHole.Trace.Estimate
import BlackHole.Trace.Gas
import BlackHole.Trace.Grid
import BlackHole.Trace.RayDifferential
import BlackHole.Trace.Sampling
import BlackHole.Trace.Sky
import BlackHole.Vector.XY (XY (..))
import BlackHole.Vector.XYZ (XYZ, (*^), (^+^), (^-^))
import qualified BlackHole.Vector.XYZ as XYZ
import Data.Bits (shiftR, (.&.))
import Data.Maybe (fromMaybe)
import GHC.Exts (lazy)
import GHC.Float (castDoubleToWord64)

-- | A scene prepared for tracing: everything that its pixels share, computed once.
data Tracer = Tracer
  { tracerPlane :: !PicturePlane,
    tracerScene :: !Scene,
    tracerEye :: !Eye,
    tracerLens :: !(Maybe Lens),
    -- | The exposure's factor.
    tracerGain :: !Double,
    -- | The part of g that applies to the sky.
    tracerSkyShift :: !SkyShift,
    tracerRegion :: !Region,
    -- | Computed at its first use, like the fields below.
    tracerMatter :: Matter,
    -- | The light paths through the camera's position.
    tracerTable :: LensTable,
    -- | The sky as a function of the beam.
    tracerSky :: SkyShader
  }

-- | A lens of some size: the frame of the camera, the lens's radius in Schwarzschild radii,
-- and by how many pixels the picture behind it shifts per Schwarzschild radius.
data Lens = Lens !Frame !Double !Double

-- | What shines along the way.
data Matter
  = Vacuum
  | Checks !Disk
  | Gaseous !Gas

-- | Prepares a scene. 'Nothing' if its camera has no direction of view ('cameraFrame'),
-- which no validated scene has, or if its sky is an environment map, which needs
-- 'tracerWithSky'.
tracer :: Scene -> Maybe Tracer
tracer = tracerWithSky Nothing

-- | Prepares a scene together with its environment map, if it has one
-- ('neededPicture').
tracerWithSky :: Maybe EnvironmentMap -> Scene -> Maybe Tracer
tracerWithSky picture scene = do
  frame <- cameraFrame (sceneCamera scene)
  sky <- shader
  pure
    Tracer
      { tracerPlane = picturePlane (sceneProjection scene) (sceneCamera scene) (scenePicture scene) frame,
        tracerScene = scene,
        tracerGain = 2 ** stops,
        tracerEye = eye (sceneSpacetime scene) (sceneObserver scene) place,
        tracerLens =
          if sceneAperture scene > 0
            then Just (Lens frame (0.5 * sceneAperture scene) (1 / (sceneFocus scene * pixelAngle (sceneProjection scene) (sceneCamera scene) (scenePicture scene))))
            else Nothing,
        tracerSkyShift = case sceneSpacetime scene of
          Flat -> noSkyShift
          space -> skyShiftAt (sceneShifts scene) (frequencyAtRest space place),
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
        | otherwise -> Gaseous (gas (sceneSpacetime scene) seed (sceneShifts scene) disk place (pixelAngle (sceneProjection scene) (sceneCamera scene) (scenePicture scene)) (sceneSamples scene))

-- | @tracerAfter earlier picture scene@ is 'tracerWithSky', but takes over those parts of
-- an earlier tracer that are equal for this scene: the tables of the gas, of the light
-- paths through the camera's position, and of the sky. The table of light paths is also
-- taken over if the distance from the hole differs by rounding alone, so that radiance
-- may differ by rounding from that of 'tracerWithSky'. The environment map must be the one
-- that the earlier tracer was made with if both scenes name the same file.
tracerAfter :: Tracer -> Maybe EnvironmentMap -> Scene -> Maybe Tracer
tracerAfter earlier picture scene = reusing <$> tracerWithSky picture scene
  where
    before = tracerScene earlier
    same :: Eq a => (Scene -> a) -> Bool
    same part = part before == part scene
    place = posePosition (cameraPose (sceneCamera scene))
    distance = XYZ.norm . posePosition . cameraPose . sceneCamera
    reusing traced =
      traced
        { tracerMatter = case tracerMatter earlier of
            Gaseous glowing
              | same sceneDisk && same sceneSpacetime && same sceneSeed && same sceneShifts && same sceneDebugTextures ->
                Gaseous (gasSeenFrom place (pixelAngle (sceneProjection scene) (sceneCamera scene) (scenePicture scene)) (sceneSamples scene) glowing)
            _ -> tracerMatter traced,
          tracerTable = if abs (distance scene - distance before) <= 1e-12 * distance scene then tracerTable earlier else tracerTable traced,
          tracerSky = if same sceneSky && same sceneSeed && same sceneDebugTextures then tracerSky earlier else tracerSky traced
        }

-- | The parts of a tracer that take time to compute, for evaluation in advance and in
-- parallel. Otherwise the first ray that needs a part waits for it.
tracerTables :: Tracer -> [()]
tracerTables traced =
  seq (tracerMatter traced) () : seq (tracerSky traced) () : [seq (tracerTable traced) () | sceneIntegrator scene == Tabulated, not (rotates (sceneSpacetime scene))]
  where
    scene = tracerScene traced
    rotates space = case space of
      Kerr _ -> True
      _ -> False

-- | Follows a line of sight by the scene's integrator and passes the segments that may
-- contain gas to the gathering function. The line of sight must be the one through this
-- point of the picture.
followSight :: Tracer -> XY -> SightLine -> (a -> PathSegment -> Continue a) -> a -> Followed a
followSight traced point sight = case sight of
  RotatingSight hole azimuth ray -> followKerr hole region (stepPhase point) azimuth ray
  SightLine photon _ -> case sceneIntegrator scene of
    Tabulated -> followTable space (tracerTable traced) region (stepPhase point) photon
    Exact -> followExact space region photon
    Leapfrogging -> followLeapfrog (sceneLeapfrog scene) space region photon
  where
    scene = tracerScene traced
    space = sceneSpacetime scene
    region = tracerRegion traced

-- | The light of everything along a line of sight, and what lies behind it.
followLight :: Tracer -> XY -> SightLine -> Followed Gathered
followLight traced point sight = case (sight, sceneIntegrator scene, tracerMatter traced) of
  -- The two cases compiled into loops of their own.
  (SightLine photon observed, Tabulated, Gaseous glowing) ->
    followTable
      (sceneSpacetime scene)
      (tracerTable traced)
      (tracerRegion traced)
      (stepPhase point)
      photon
      (gatherGas glowing observed)
      nothingYet
  (RotatingSight hole azimuth ray, _, Gaseous glowing) ->
    followKerr hole (tracerRegion traced) (stepPhase point) azimuth ray (gatherGasAround glowing ray (sightFrequency sight)) nothingYet
  (SightLine photon _, Tabulated, Vacuum) ->
    Followed (tableFate (sceneSpacetime scene) (tracerTable traced) photon) nothingYet 0
  _ -> followSight traced point sight (tracedGas traced sight) nothingYet
  where
    scene = tracerScene traced

-- | The phase of the first step in the gas, 0 to 1. Phases are spread evenly over the
-- samples of a pixel and its neighbours, so that one step finds what another misses
-- (the additive recurrence of the plastic number).
stepPhase :: XY -> Double
stepPhase (XY x y) = 0.5 + turnFraction (0.7548776662466927 * x + 0.5698402909980532 * y)

-- | @addSamples traced from to estimate column row@ is the estimate with the pixel's
-- samples numbered @from@ to @to − 1@ added.
addSamples :: Tracer -> Int -> Int -> Estimate -> Int -> Int -> Estimate
addSamples prepared from to estimate column row = go from estimate
  where
    traced = lazy prepared
    shared = pixelSky traced column row
    go !index !sums
      | index < to =
        let Sample place weight = samplePoint (tracerScene traced) column row index
         in go (index + 1) (addSample (tracerGain traced) weight (sharingRadiance traced shared place) sums)
      | otherwise = sums

-- | 'addSamples' for three pixels in a row, starting at a column.
addSamplesToThree :: Tracer -> Int -> Int -> Estimate -> Estimate -> Estimate -> Int -> Int -> (Estimate, Estimate, Estimate)
addSamplesToThree traced from to estimate0 estimate1 estimate2 column row = case sceneIntegrator scene of
  Leapfrogging | Nothing <- tracerLens traced -> go from estimate0 estimate1 estimate2
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

-- | The estimate of 'addSamples' from a single sample: its radiance, with neither
-- weights nor the negative values that a filter or a sum might produce.
onlySample :: Tracer -> Int -> Int -> Radiance
onlySample traced column row = mapRadiance (max 0) (sightRadiance traced place)
  where
    Sample place _ = samplePoint (tracerScene traced) column row 0
{-# INLINE onlySample #-}

-- | 'sightRadiance' of three points, from three leapfrogs interleaved on one core.
threeSights :: Tracer -> XY -> XY -> XY -> (Radiance, Radiance, Radiance)
threeSights traced p0 p1 p2 = case (tracedSight traced p0, tracedSight traced p1, tracedSight traced p2) of
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

-- | The camera as a pinhole in a random point of its lens, one for each point of the
-- picture: the thin lens of Cook, Porter and Carpenter 1984, in the observer's frame. What
-- lies at the distance of focus is at the same place of the picture through every point of
-- the lens. Space counts as flat across the lens. So a line of sight may be continued
-- straight to the sphere around the hole on which the lens's middle lies, where its light
-- paths are those of the table; one almost along that sphere, which sees little but the
-- sky, is shifted onto it instead. Without a lens, the camera itself.
throughLens :: Tracer -> XY -> Tracer
throughLens traced point@(XY px py) = case tracerLens traced of
  Nothing -> traced
  Just (Lens frame size pixels) -> fromMaybe traced {tracerLens = Nothing} $ do
    let bits = sipHash2 (SipKey (sceneSeed scene) 0x6c656e73) (castDoubleToWord64 px) (castDoubleToWord64 py)
        fraction w = (fromIntegral (w .&. 0xffffffff) + 0.5) / 4294967296
        radius = size * sqrt (fraction bits)
        angle = 2 * pi * fraction (bits `shiftR` 32)
        across = radius * cos angle
        upwards = radius * sin angle
        plane = shiftedPlane (pixels * across) (pixels * upwards) (tracerPlane traced)
        place = eyePlace (tracerEye traced)
        offset = across *^ frameRight frame ^+^ upwards *^ frameUp frame
    outwards <- XYZ.normalize place
    direction <- sightDirection plane point
    let slope = XYZ.dot direction outwards
        straight = offset ^-^ (XYZ.dot offset outwards * slope / (slope * slope + 0.01)) *^ direction
    onSphere <- XYZ.normalize (place ^+^ straight)
    pure traced {tracerLens = Nothing, tracerPlane = plane, tracerEye = eye (sceneSpacetime scene) (sceneObserver scene) (XYZ.norm place *^ onSphere)}
  where
    scene = tracerScene traced

-- | The light of the gas, plus the sky's contribution.
seen :: Tracer -> Maybe SkyPatch -> XY -> SightLine -> Followed Gathered -> Radiance
seen traced shared point sight (Followed fate (Gathered light transmittance) _) =
  light <+> scaleRadiance transmittance behind
  where
    behind = sharedSky traced shared point sight fate
{-# INLINE seen #-}

-- | 'tracedSky', given the sky behind the pixel where it is known.
sharedSky :: Tracer -> Maybe SkyPatch -> XY -> SightLine -> Fate -> Radiance
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
    direction <- escapeDirection traced point sight
    differential <- tracedDifferential traced point sight direction
    let area = differentialSolidAngle differential
        breadth = XYZ.dot (differentialAlongX differential) (differentialAlongX differential) + XYZ.dot (differentialAlongY differential) (differentialAlongY differential)
    pure (SkyPatch point differential (0.01 * area * area / breadth) (shader (skyShift (tracerSkyShift traced) (sightFrequency sight)) differential))
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

-- | The scene that was prepared.
tracedScene :: Tracer -> Scene
tracedScene = tracerScene

-- | The viewing direction through a point of the picture; 'Nothing' outside a
-- fisheye's circle.
tracedDirection :: Tracer -> XY -> Maybe XYZ
tracedDirection traced = sightDirection (tracerPlane traced)

-- | The light path that arrives at a point of the picture; 'Nothing' if none does, so
-- that the point is dark ('sightLine', 'sightDirection').
tracedSight :: Tracer -> XY -> Maybe SightLine
tracedSight traced point = sightDirection (tracerPlane traced) point >>= sightFrom (tracerEye traced)

-- | The contribution of a segment of the scene's gas along a line of sight.
tracedGas :: Tracer -> SightLine -> Gathered -> PathSegment -> Continue Gathered
tracedGas traced sight = case tracerMatter traced of
  Vacuum -> \gathered _ -> Continue gathered
  Checks disk -> gatherParity disk
  Gaseous glowing -> case sight of
    SightLine _ observed -> gatherGas glowing observed
    RotatingSight _ _ ray -> gatherGasAround glowing ray (sightFrequency sight)

-- | The radiance that the sky sends to the end of a line of sight through a point of
-- the picture, without gas in between.
tracedSky :: Tracer -> XY -> SightLine -> Fate -> Radiance
tracedSky prepared point sight fate = case fate of
  Escaped direction ->
    let !shift = skyShift (tracerSkyShift traced) (sightFrequency sight)
     in case tracerSky traced of
          ByDirection shader -> shader shift direction
          ByDifferential shader -> maybe black (shader shift) (tracedDifferential traced point sight direction)
  Captured -> black
  Opaque -> black
  StepLimit -> black
  where
    -- As in 'sharingRadiance'.
    traced = lazy prepared

-- | The beam behind a point of the picture, beyond all gas, from the line of sight
-- through it and the direction of escape. Uses the table of paths or, where that has no
-- answer, the paths through points beside it. 'Nothing' if no light arrives from the
-- sky.
tracedDifferential :: Tracer -> XY -> SightLine -> XYZ -> Maybe RayDifferential
tracedDifferential prepared point sight direction = case (sceneSpacetime (tracerScene traced), sight) of
  (Schwarzschild, SightLine photon _)
    | Just (SightLine beside _) <- sightAt (XY step 0),
      Just (SightLine below _) <- sightAt (XY 0 step),
      Just (LensChanges alongX alongY) <- lensChanges (tracerTable traced) photon direction beside below ->
      Just (RayDifferential direction ((1 / step) *^ alongX) ((1 / step) *^ alongY))
  -- Two evaluations, where the general way takes three.
  (_, RotatingSight {})
    | Just beside <- escape (XY step 0),
      Just below <- escape (XY 0 step) ->
      Just (RayDifferential direction ((1 / step) *^ (beside ^-^ direction)) ((1 / step) *^ (below ^-^ direction)))
  _ -> differentialByDifferences escape (XY 0 0)
  where
    -- As in 'sharingRadiance'.
    traced = lazy prepared
    step = case sight of
      SightLine _ _ -> 0.01
      RotatingSight {} -> 1e-3
    sightAt offset = sightBeside (tracerPlane traced) point offset >>= sightFrom (tracerEye traced)
    escape offset = sightAt offset >>= escapeDirection traced point

-- | The direction in which a line of sight escapes, disregarding gas, if it does.
escapeDirection :: Tracer -> XY -> SightLine -> Maybe XYZ
escapeDirection traced point sight = case fate of
  Escaped direction -> Just direction
  _ -> Nothing
  where
    fate = case sight of
      SightLine photon _ | sceneIntegrator (tracerScene traced) == Tabulated -> tableFate (sceneSpacetime (tracerScene traced)) (tracerTable traced) photon
      RotatingSight hole azimuth ray -> kerrEnd hole azimuth ray
      _ -> followedFate (followSight traced {tracerRegion = emptyRegion} point sight (\() _ -> Continue ()) ())

-- | The edge of the shadow where it passes through or beside a pixel: the unit vector
-- across it and out of the shadow, and by how much 'criticalOffset' shrinks per pixel
-- along that vector.
data PhotonRing
  = PhotonRing
      {-# UNPACK #-} !XY
      {-# UNPACK #-} !Double

-- | The edge of the shadow if it passes through or beside the pixel around a point of
-- the picture. All higher-order images of the gas crowd together at that edge in rings
-- thinner than a pixel.
photonRing :: Tracer -> XY -> Maybe PhotonRing
photonRing traced point@(XY x y) = case (tracerMatter traced, tracedOffset traced point) of
  (Gaseous _, Just here)
    -- Most pixels are thousands of pixels away from the ring; dismiss them cheaply.
    -- Fast observers see the ring grow or shrink, but by less than this factor.
    | abs here < 16 * pixelAngle (sceneProjection scene) (sceneCamera scene) (scenePicture scene),
      Just right <- tracedOffset traced (XY (x + 1) y),
      Just below <- tracedOffset traced (XY x (y + 1)),
      let across = right - here
          down = below - here
          growth = sqrt (across * across + down * down),
      abs here < 1.5 * (abs across + abs down) ->
      Just (PhotonRing (XY (negate across / growth) (negate down / growth)) growth)
  _ -> Nothing
  where
    scene = tracerScene traced

-- | 'criticalOffset' of the light path that arrives at a point of the picture; around a
-- rotating hole, a measure as smooth and about as large.
tracedOffset :: Tracer -> XY -> Maybe Double
tracedOffset traced place = do
  sight <- tracedSight traced place
  case (sceneSpacetime (tracerScene traced), sight) of
    (Schwarzschild, SightLine photon _) -> Just (criticalOffset (tracerTable traced) photon)
    (_, RotatingSight hole _ ray) -> (* negate (2.6 / max 2.6 (rayRadius ray))) <$> photonOrbitOffset hole ray
    _ -> Nothing

-- | @addRingSamples traced ring from to estimate column row@ is 'addSamples' with the
-- points of 'ringPoint'.
addRingSamples :: Tracer -> PhotonRing -> Int -> Int -> Estimate -> Int -> Int -> Estimate
addRingSamples prepared ring from to estimate column row = go from estimate
  where
    traced = lazy prepared
    shared = pixelSky traced column row
    go !index !sums
      | index < to =
        let Sample place weight = ringPoint traced ring column row index
            light = if weight == 0 then black else sharingRadiance traced shared place
         in go (index + 1) (addSample (tracerGain traced) weight light sums)
      | otherwise = sums

-- | One of the samples of a pixel on the photon ring, by column, row and sample number:
-- more of them where the images of the gas are thinner.
ringPoint :: Tracer -> PhotonRing -> Int -> Int -> Int -> Sample
ringPoint traced (PhotonRing normal growth) =
  curveSample (sceneFilter scene) (sceneSeed scene) normal (fmap (negate . (/ growth)) . tracedOffset traced)
  where
    scene = tracerScene traced

-- | One of a pixel's samples, by column, row and sample number.
samplePoint :: Scene -> Int -> Int -> Int -> Sample
samplePoint scene = sampleOf (sceneFilter scene) (sceneSeed scene) (mostSamples scene)
