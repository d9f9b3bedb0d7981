-- | A scene prepared for tracing, and the lines of sight through its picture.
module BlackHole.Trace.Tracer
  ( Tracer (..),
    Matter (..),
    tracer,
    tracerWithSky,
    tracerAfter,
    tracerTables,
    tracedDirection,
    tracedSight,
    sightBesidePoint,
    throughLens,
    pixelWidth,
  )
where

import BlackHole.Light.Display (Exposure (..))
import BlackHole.Noise.SipHash
import BlackHole.Scene.Camera
import BlackHole.Scene.Disk (Disk)
import BlackHole.Scene.Scene
import BlackHole.Scene.Shifts (SkyShift, skyShiftAt)
import BlackHole.Spacetime.Follow
import BlackHole.Spacetime.LightPath
import BlackHole.Spacetime.Observer
import BlackHole.Trace.EnvironmentMap (EnvironmentMap)
import BlackHole.Trace.Gas
import BlackHole.Trace.Grid
import BlackHole.Trace.Sky
import BlackHole.Vector.XY (XY (..))
import BlackHole.Vector.XYZ (XYZ, (*^), (^+^), (^-^))
import qualified BlackHole.Vector.XYZ as XYZ
import Data.Bits (shiftR, (.&.))
import Data.Maybe (fromMaybe)
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
    -- | The light paths to the camera.
    tracerPaths :: !Tracing,
    -- | Computed at its first use, like the fields below.
    tracerMatter :: Matter,
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
  frame <- cameraFrame camera
  sky <- shader
  pure
    Tracer
      { tracerPlane = picturePlane (sceneProjection scene) camera (scenePicture scene) frame,
        tracerScene = scene,
        tracerGain = 2 ** stops,
        tracerEye = eye space (sceneObserver scene) place,
        tracerLens =
          if sceneAperture scene > 0
            then Just (Lens frame (0.5 * sceneAperture scene) (1 / (sceneFocus scene * pixel)))
            else Nothing,
        tracerSkyShift = skyShiftAt (sceneShifts scene) (frequencyAtRest space place),
        tracerRegion = sceneRegion scene,
        tracerPaths = tracing space method place,
        tracerMatter = matter,
        tracerSky = sky
      }
  where
    Exposure stops = sceneExposure scene
    space = sceneSpacetime scene
    camera = sceneCamera scene
    place = posePosition (cameraPose camera)
    pixel = pixelWidth scene
    seed = sceneSeed scene
    method = case sceneIntegrator scene of
      Tabulated -> ByTable
      Exact -> InClosedForm
      Leapfrogging -> ByLeapfrog (sceneLeapfrog scene)
    shader
      | sceneDebugTextures scene = Just (ByDirection (const gridRadiance))
      | otherwise = skyShader picture seed (sceneSky scene)
    matter = case sceneDisk scene of
      Nothing -> Vacuum
      Just disk
        | sceneDebugTextures scene -> Checks disk
        | otherwise -> Gaseous (gas space seed (sceneShifts scene) disk place pixel)

-- | @tracerAfter earlier picture scene@ is 'tracerWithSky', but takes over those parts of
-- an earlier tracer that are equal for this scene: the tables of the gas, of the light
-- paths to the camera, and of the sky. The table of light paths is also taken over if the
-- distance from the hole differs by rounding alone, so that radiance may differ by rounding
-- from that of 'tracerWithSky'. The environment map must be the one that the earlier tracer
-- was made with if both scenes name the same file.
tracerAfter :: Tracer -> Maybe EnvironmentMap -> Scene -> Maybe Tracer
tracerAfter earlier picture scene = reusing <$> tracerWithSky picture scene
  where
    before = tracerScene earlier
    same :: Eq a => (Scene -> a) -> Bool
    same part = part before == part scene
    reusing traced =
      traced
        { tracerMatter = case tracerMatter earlier of
            Gaseous glowing | sameGas -> Gaseous (gasSeenFrom place (pixelWidth scene) glowing)
            _ -> tracerMatter traced,
          tracerPaths = if samePaths then tracerPaths earlier else tracerPaths traced,
          tracerSky = if sameSky then tracerSky earlier else tracerSky traced
        }
    place = posePosition (cameraPose (sceneCamera scene))
    sameGas =
      same sceneDisk
        && same sceneSpacetime
        && same sceneSeed
        && same sceneShifts
        && same sceneDebugTextures
    samePaths =
      same sceneSpacetime
        && same sceneIntegrator
        && same sceneLeapfrog
        && tracingServes (tracerPaths earlier) place
    sameSky = same sceneSky && same sceneSeed && same sceneDebugTextures

-- | The parts of a tracer that take time to compute, for evaluation in advance and in
-- parallel. Otherwise the first ray that needs a part waits for it.
tracerTables :: Tracer -> [()]
tracerTables traced =
  [seq (tracerMatter traced) (), seq (tracerSky traced) ()]
    ++ tracingTables (tracerPaths traced)

-- | The angle in radians that a pixel in the middle of the picture spans.
pixelWidth :: Scene -> Double
pixelWidth scene = pixelAngle (sceneProjection scene) (sceneCamera scene) (scenePicture scene)

-- | The viewing direction through a point of the picture, in pixels from the top left
-- corner; 'Nothing' outside a fisheye's circle.
tracedDirection :: Tracer -> XY -> Maybe XYZ
tracedDirection traced = sightDirection (tracerPlane traced)

-- | The light path that arrives at a point of the picture; 'Nothing' if none does, so
-- that the point is dark ('sightLine', 'sightDirection').
tracedSight :: Tracer -> XY -> Maybe SightLine
tracedSight traced point =
  sightDirection (tracerPlane traced) point >>= sightFrom (tracerEye traced)

-- | 'tracedSight' at an offset from a point, exact however small the offset is.
sightBesidePoint :: Tracer -> XY -> XY -> Maybe SightLine
sightBesidePoint traced point offset =
  sightBeside (tracerPlane traced) point offset >>= sightFrom (tracerEye traced)

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
    let key = SipKey (sceneSeed scene) 0x6c656e73
        bits = sipHash2 key (castDoubleToWord64 px) (castDoubleToWord64 py)
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
        along = XYZ.dot offset outwards * slope / (slope * slope + 0.01)
        straight = offset ^-^ along *^ direction
    onSphere <- XYZ.normalize (place ^+^ straight)
    let seer = eye (sceneSpacetime scene) (sceneObserver scene) (XYZ.norm place *^ onSphere)
    pure traced {tracerLens = Nothing, tracerPlane = plane, tracerEye = seer}
  where
    scene = tracerScene traced
