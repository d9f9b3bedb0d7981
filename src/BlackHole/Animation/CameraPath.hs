-- | Camera movements that keyframes cannot express: around the hole, along a line, and
-- on the world lines of observers in free fall.
module BlackHole.Animation.CameraPath
  ( CameraPath (..),
    cameraPathName,
    Pace (..),
    alongPath,
  )
where

import BlackHole.Animation.Interpolate (Interpolation (..), easedFraction)
import BlackHole.Numeric.Angle
import BlackHole.Scene.Camera
import BlackHole.Scene.Scene
import BlackHole.Spacetime.Observer (Observer (..))
import BlackHole.Spacetime.WorldLine
import BlackHole.Vector.XYZ (XYZ (..), (*^), (^+^), (^-^))
import qualified BlackHole.Vector.XYZ as XYZ

-- | A movement, from the scene's own camera onwards.
data CameraPath
  = -- | A number of turns around the hole during the animation, right-handed about
    -- an axis (of any length but zero), at constant speed or 'Eased'. The camera
    -- keeps looking where it looked, seen from the hole: at the hole if it did.
    Orbit !XYZ !Double !Interpolation
  | -- | A straight line to a place, while the point looked at moves straight to
    -- another one if there is one.
    Dolly !XYZ !(Maybe XYZ) !Interpolation
  | -- | Free fall from rest at infinity, straight in, past the horizon. Sets the
    -- observer to 'Falling'; the animation's time is his proper time. The camera
    -- keeps its direction of sight.
    FreeFall !Pace
  | -- | The circular geodesic through the camera's place, which must lie in the
    -- disk's plane for the 'Orbiting' observer to be the one who moves on it.
    -- Proper time per second of animation in @r_s\/c@.
    CircularOrbit !Double
  deriving (Eq, Show)

-- | The name in a scene file.
cameraPathName :: CameraPath -> String
cameraPathName path = case path of
  Orbit {} -> "orbit"
  Dolly {} -> "dolly"
  FreeFall {} -> "free-fall"
  CircularOrbit {} -> "circular-orbit"

-- | How fast a fall is shown.
data Pace
  = -- | Proper time in @r_s\/c@ per second of animation.
    ProperTimePerSecond !Double
  | -- | Such that the animation ends at this radius.
    FallsTo !Double
  deriving (Eq, Show)

-- | @alongPath path duration seconds scene@: the scene with its camera moved to
-- where it is after some seconds of an animation of the given duration (above 0). On
-- the left, why there is no such place.
alongPath :: CameraPath -> Double -> Double -> Scene -> Either String Scene
alongPath path duration seconds scene = case path of
  Orbit axis turns kind -> case XYZ.normalize axis of
    Nothing -> Left "the axis has no direction"
    Just unit -> Right (posed (turnPose unit (360 * turns * progress kind) pose))
  Dolly place target kind ->
    let from = posePosition pose
        s = progress kind
        looking = poseTarget pose
     in Right (posed (LookAt (XYZ.lerp s from place) (maybe looking (XYZ.lerp s looking) target)))
  FreeFall pace
    | Just r <- fallRadius space cosine start (properTime pace start) ->
      Right (posed (moveTo r)) {sceneObserver = Falling}
    | otherwise ->
      Left
        ("after " ++ show seconds ++ " s, the camera has fallen into the centre of the hole")
  CircularOrbit rate
    | not inPlane -> Left "the camera must be in the disk's plane (camera.inclination 90)"
    | Just phase <- orbitPhase space start (rate * seconds) ->
      let Degrees turned = toDegrees (Radians phase)
       in Right (posed (turnPose (XYZ 0 1 0) turned pose)) {sceneObserver = Orbiting}
    | otherwise ->
      Left
        ( "there is no circular orbit at the camera's distance, " ++ show start
            ++ " Schwarzschild radii"
        )
  where
    camera = sceneCamera scene
    pose = cameraPose camera
    posed p = scene {sceneCamera = camera {cameraPose = p}}
    start = XYZ.norm (posePosition pose)
    progress kind = case kind of
      Eased -> easedFraction (seconds / duration)
      _ -> seconds / duration
    properTime (ProperTimePerSecond rate) _ = rate * seconds
    properTime (FallsTo end) from = fallTime space cosine from end * seconds / duration
    space = sceneSpacetime scene
    cosine = let XYZ _ y _ = posePosition pose in y / start
    -- The hole stays where it is in the picture of a camera that looks at it;
    -- another direction of sight is kept as well.
    moveTo r = case pose of
      Around _ inclination azimuth -> Around r inclination azimuth
      LookAt place target ->
        let new = (r / start) *^ place
         in LookAt new (target ^+^ (new ^-^ place))
    inPlane = let XYZ _ y _ = posePosition pose in abs y <= 1e-9 * start

-- | The point a pose looks at.
poseTarget :: Pose -> XYZ
poseTarget (LookAt _ target) = target
poseTarget Around {} = XYZ.zero

-- | Turn place and target right-handed about an axis (unit length) by degrees.
turnPose :: XYZ -> Double -> Pose -> Pose
turnPose axis@(XYZ ax ay az) degrees pose = case pose of
  -- Without the detour through sines the animation of a whole turn closes exactly.
  Around r inclination (Degrees azimuth)
    | ax == 0 && az == 0 -> Around r inclination (Degrees (azimuth - signum ay * degrees))
  Around {} -> around (turned (posePosition pose))
  LookAt place target -> LookAt (turned place) (turned target)
  where
    Radians angle = toRadians (Degrees degrees)
    -- Rodrigues' formula.
    turned v =
      cos angle *^ v
        ^+^ sin angle *^ XYZ.cross axis v
        ^+^ ((1 - cos angle) * XYZ.dot axis v) *^ axis
    around place@(XYZ x y z) =
      Around
        (XYZ.norm place)
        (toDegrees (Radians (atan2 (sqrt (x * x + z * z)) y)))
        (toDegrees (Radians (atan2 z x)))
