-- | Camera movements by hand.
module BlackHole.Explore.Steer
  ( Steering (..),
    steer,
  )
where

import BlackHole.Numeric.Angle
import BlackHole.Scene.Camera
import BlackHole.Scene.Scene
import BlackHole.Scene.Validate
import BlackHole.Vector.XYZ (XYZ (..), (*^), (^+^))
import qualified BlackHole.Vector.XYZ as XYZ

-- | A movement. Angles are in degrees.
data Steering
  = -- | Around the hole: by an azimuth, and by an inclination.
    OrbitHole !Double !Double
  | -- | Multiply the distance from the hole by a factor above 0.
    Approach !Double
  | -- | Turn the line of sight, to the right and upwards as the picture shows them.
    LookAround !Double !Double
  | -- | Turn the camera clockwise about its line of sight.
    RollBy !Double
  | -- | Turn the line of sight to the hole.
    FaceHole
  deriving (Eq, Show)

-- | The scene after a movement. A movement to where the camera cannot be, such as into a
-- hole at whose distance the observer cannot stand, leaves the scene as it is.
steer :: Steering -> Scene -> Scene
steer how scene
  | null (validateScene moved) = moved
  | otherwise = scene
  where
    camera = sceneCamera scene
    pose = cameraPose camera
    place = posePosition pose
    moved = scene {sceneCamera = steered}
    steered = case how of
      OrbitHole azimuth inclination -> camera {cameraPose = orbited azimuth inclination pose}
      Approach factor -> camera {cameraPose = approached factor pose}
      LookAround right up ->
        maybe
          camera
          (\frame -> camera {cameraPose = lookingAlong (turned frame right up)})
          (cameraFrame camera)
      RollBy angle ->
        camera {cameraRoll = Degrees (wrapped (inDegrees (cameraRoll camera) + angle))}
      FaceHole -> camera {cameraPose = facing place}
    lookingAlong direction = LookAt place (rounded (place ^+^ XYZ.norm place *^ direction))

-- | A direction turned from straight ahead, to the right and upwards.
turned :: Frame -> Double -> Double -> XYZ
turned (Frame forward right up) yaw pitch =
  (cos p * cos y) *^ forward ^+^ (cos p * sin y) *^ right ^+^ sin p *^ up
  where
    Radians y = toRadians (Degrees yaw)
    Radians p = toRadians (Degrees pitch)

orbited :: Double -> Double -> Pose -> Pose
orbited azimuth inclination pose = case pose of
  Around r i a -> Around r (tilted 0 i) (Degrees (turnedAzimuth (inDegrees a + azimuth)))
  -- Position and target turn as one. Near the poles the upward direction of such a
  -- camera would flip.
  LookAt place target ->
    let (_, i, a) = spherical place
        i' = tilted 1 (Degrees i)
        tilt = inDegrees i' - i
        turn = about (XYZ 0 1 0) (negate azimuth) . about (tangent a) (negate tilt)
     in LookAt (rounded (turn place)) (rounded (turn target))
  where
    tilted margin (Degrees i) =
      Degrees (hundredths (max margin (min (180 - margin) (i + inclination))))
    turnedAzimuth = hundredths . wrapped
    -- The axis about which the inclination grows against the right-hand rule.
    tangent a = let Radians t = toRadians (Degrees a) in XYZ (negate (sin t)) 0 (cos t)

approached :: Double -> Pose -> Pose
approached factor pose = case pose of
  Around r i a -> Around (significant (r * factor)) i a
  LookAt place target -> LookAt (rounded (factor *^ place)) target

-- | The camera at a place, looking at the hole.
facing :: XYZ -> Pose
facing place = Around (significant r) (Degrees (hundredths i)) (Degrees (hundredths a))
  where
    (r, i, a) = spherical place

-- | Distance, inclination and azimuth in degrees.
spherical :: XYZ -> (Double, Double, Double)
spherical (XYZ x y z) = (sqrt (rho * rho + y * y), degrees (atan2 rho y), degrees (atan2 z x))
  where
    rho = sqrt (x * x + z * z)
    degrees = inDegrees . toDegrees . Radians

-- | A rotation about an axis of unit length, right-handed, by degrees.
about :: XYZ -> Double -> XYZ -> XYZ
about axis angle v =
  cos t *^ v ^+^ sin t *^ XYZ.cross axis v ^+^ ((1 - cos t) * XYZ.dot axis v) *^ axis
  where
    Radians t = toRadians (Degrees angle)

-- | The same angle from 0 to below 360.
wrapped :: Double -> Double
wrapped angle = angle - 360 * fromIntegral (floor (angle / 360) :: Int)

-- | Rounded to what a person would write: the command line and scene files show it.
hundredths :: Double -> Double
hundredths v = fromIntegral (round (100 * v) :: Int) / 100

-- | Rounded to five significant digits.
significant :: Double -> Double
significant v
  | v == 0 || isNaN v || isInfinite v = v
  | e >= 0 = fromIntegral (round (v / scale) :: Integer) * scale
  | otherwise = fromIntegral (round (v * inverse) :: Integer) / inverse
  where
    e = floor (logBase 10 (abs v)) - 4 :: Int
    scale = 10 ^^ e
    inverse = 10 ^^ negate e

rounded :: XYZ -> XYZ
rounded v@(XYZ x y z) = XYZ (at x) (at y) (at z)
  where
    -- A hundred-thousandth of the distance, or less.
    unit = 10 ^^ (4 - floor (logBase 10 (max 1e-9 (XYZ.norm v))) :: Int) :: Double
    at c = fromIntegral (round (c * unit) :: Integer) / unit
