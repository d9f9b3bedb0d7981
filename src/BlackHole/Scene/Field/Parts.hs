-- | The parts of a scene that settings read and set, where that is more than a field of a
-- record.
module BlackHole.Scene.Field.Parts
  ( part,
    widthPart,
    heightPart,
    projectionPart,
    aperturePart,
    camera,
    distancePart,
    inclinationPart,
    azimuthPart,
    positionPart,
    lookAtPart,
    shifts,
    gravityPart,
    spinPart,
    presencePart,
    disk,
    glowPart,
    temperaturePart,
    skyKindPart,
    panoramaSkyFile,
    panorama,
    radiancePart,
    stars,
    realStars,
    rotationPart,
    pointStars,
    ColourKind (..),
    SkyKind (..),
  )
where

import BlackHole.Numeric.Angle
import BlackHole.Scene.Camera
  ( Camera (cameraFieldOfView, cameraPose),
    Picture (..),
    Pose (..),
    Projection (..),
    posePosition,
    projectionFieldOfView,
    projectionHeight,
  )
import BlackHole.Scene.Disk (DiskColour (..), defaultDisk)
import qualified BlackHole.Scene.Disk as Gas
import BlackHole.Scene.Field.Part
import BlackHole.Scene.Scene
import BlackHole.Scene.Shifts (Shifts (..))
import BlackHole.Scene.Sky
  ( Panorama (..),
    PointStars (..),
    RealSky (..),
    Sky (..),
    Stars (..),
    defaultPointStars,
    defaultStars,
    panoramaOf,
    realSky,
  )
import BlackHole.Spacetime.Kerr.Landmarks
import BlackHole.Spacetime.Types (Spacetime (..), spacetimeIsco)
import BlackHole.Vector.XYZ (XYZ (..))
import qualified BlackHole.Vector.XYZ as XYZ
import Data.Maybe (isJust)

-- | A part that is always present.
part :: (whole -> part) -> (part -> whole -> whole) -> Part whole part
part get = Part (Just . get)

-- | The width or height of the picture. Setting the width sets the height, too; the
-- height's own setting comes later.
widthPart, heightPart :: Part Scene Int
widthPart = part (pictureWidth . scenePicture) $ \w s ->
  let height
        | w > 0 = projectionHeight (sceneProjection s) w
        | otherwise = pictureHeight (scenePicture s)
   in s {scenePicture = Picture w height}
heightPart =
  part
    (pictureHeight . scenePicture)
    (\h s -> s {scenePicture = (scenePicture s) {pictureHeight = h}})

-- | The projection. Choosing another one sets the field of view, the height and the bloom
-- that go with it.
projectionPart :: Part Scene Projection
projectionPart = part sceneProjection $ \projection s ->
  let width = pictureWidth (scenePicture s)
   in if projection == sceneProjection s
        then s
        else
          s
            { sceneProjection = projection,
              sceneCamera = (sceneCamera s) {cameraFieldOfView = projectionFieldOfView projection},
              scenePicture = Picture width (projectionHeight projection width),
              sceneBloom = if projection == Equirectangular then 0 else sceneBloom s
            }

-- | The aperture of the lens. Opening it focuses the lens on the hole; the focus has its own
-- setting, which comes later.
aperturePart :: Part Scene Double
aperturePart = part sceneAperture $ \v s ->
  s
    { sceneAperture = v,
      sceneFocus =
        if v > 0 then XYZ.norm (posePosition (cameraPose (sceneCamera s))) else sceneFocus s
    }

-- | A part of the camera.
camera :: Part Camera a -> Part Scene a
camera = inside (part sceneCamera (\c s -> s {sceneCamera = c}))

-- | A spherical coordinate of the camera. For a camera placed by position, setting one
-- changes the coordinates of that position.
distancePart, inclinationPart, azimuthPart :: Part Scene Double
distancePart = around (\r _ _ -> r) (\r (_, i, a) -> Around r i a)
inclinationPart = around (\_ i _ -> inDegrees i) (\i (r, _, a) -> Around r (Degrees i) a)
azimuthPart = around (\_ _ a -> inDegrees a) (\a (r, i, _) -> Around r i (Degrees a))

around ::
  (Double -> Degrees -> Degrees -> Double) ->
  (Double -> (Double, Degrees, Degrees) -> Pose) ->
  Part Scene Double
around get put =
  camera . pose $
    Part
      shown
      (\v -> put v . spherical)
  where
    shown (Around r i a) = Just (get r i a)
    shown (LookAt _ _) = Nothing
    spherical (Around r i a) = (r, i, a)
    spherical (LookAt (XYZ x y z) _) =
      let rho = sqrt (x * x + z * z)
       in ( sqrt (rho * rho + y * y),
            toDegrees (Radians (atan2 rho y)),
            toDegrees (Radians (atan2 z x))
          )

-- | The camera's position, which makes it look at the hole, or its target, which keeps the
-- position.
positionPart, lookAtPart :: Part Scene XYZ
positionPart = camera . pose $ Part (fmap fst . placed) (\place _ -> LookAt place (XYZ 0 0 0))
lookAtPart = camera . pose $ Part (fmap snd . placed) (\target p -> LookAt (posePosition p) target)

placed :: Pose -> Maybe (XYZ, XYZ)
placed (LookAt place target) = Just (place, target)
placed Around {} = Nothing

pose :: Part Pose a -> Part Camera a
pose = inside (part cameraPose (\p c -> c {cameraPose = p}))

-- | A part of the shifts of light.
shifts :: Part Shifts a -> Part Scene a
shifts = inside (part sceneShifts (\v s -> s {sceneShifts = v}))

-- | Whether there is a hole at all.
gravityPart :: Part Scene Bool
gravityPart = part ((/= Flat) . sceneSpacetime) $ \on s -> case (on, sceneSpacetime s) of
  (False, _) -> s {sceneSpacetime = Flat}
  (True, Flat) -> s {sceneSpacetime = Schwarzschild}
  (True, _) -> s

-- | The spin of the hole. A disk that reaches down to the innermost stable orbit goes on
-- doing so; a radius that is given is set afterwards.
spinPart :: Part Scene Double
spinPart = Part (spinOf . sceneSpacetime) $ \v s -> case (sceneSpacetime s, spin v) of
  (Flat, _) -> s
  (_, Nothing) -> s
  (before, Just hole) ->
    let after = if v == 0 then Schwarzschild else Kerr hole
        follow d
          | abs (Gas.diskInnerRadius d - spacetimeIsco before) < 1e-9 =
            d {Gas.diskInnerRadius = spacetimeIsco after}
          | otherwise = d
     in s {sceneSpacetime = after, sceneDisk = follow <$> sceneDisk s}
  where
    spinOf space = case space of
      Flat -> Nothing
      Schwarzschild -> Just 0
      Kerr hole -> Just (dimensionlessSpin hole)

-- | Whether there is a disk.
presencePart :: Part Scene Bool
presencePart = part (isJust . sceneDisk) $ \present s -> case (present, sceneDisk s) of
  (False, _) -> s {sceneDisk = Nothing}
  (True, Nothing) -> s {sceneDisk = Just defaultDisk}
  (True, Just _) -> s

-- | A part of the disk.
disk :: Part Gas.Disk a -> Part Scene a
disk = inside (Part sceneDisk (\d s -> s {sceneDisk = Just d}))

-- | 'DiskColour' without its parameters.
data ColourKind = RampGlow | BlackBodyGlow | BolometricGlow | SynchrotronGlow
  deriving (Eq)

-- | The kind of the disk's colours.
glowPart :: Part Scene ColourKind
glowPart =
  disk
    ( part
        (glowOf . Gas.diskColour)
        (\glow d -> d {Gas.diskColour = colourOf glow (Gas.diskColour d)})
    )
  where
    glowOf HueRamp = RampGlow
    glowOf (BlackBody _) = BlackBodyGlow
    glowOf Bolometric = BolometricGlow
    glowOf Synchrotron = SynchrotronGlow
    colourOf RampGlow _ = HueRamp
    colourOf BolometricGlow _ = Bolometric
    colourOf SynchrotronGlow _ = Synchrotron
    colourOf BlackBodyGlow colour@(BlackBody _) = colour
    colourOf BlackBodyGlow _ = BlackBody 2100

-- | The temperature in kelvin of a disk that glows as a black body.
temperaturePart :: Part Scene Double
temperaturePart =
  disk (Part (temperature . Gas.diskColour) (\v d -> d {Gas.diskColour = BlackBody v}))
  where
    temperature (BlackBody t) = Just t
    temperature _ = Nothing

-- | 'Sky' without its parameters.
data SkyKind
  = NoiseSky
  | StarSky
  | RandomStarSky
  | PanoramaSky !FilePath
  | GridSky
  | UniformSky
  | NoSky
  deriving (Eq)

-- | The kind of the sky. Choosing the present kind, or another file, keeps the other
-- settings of the sky.
skyKindPart :: Part Scene SkyKind
skyKindPart = part (skyKind . sceneSky) $ \kind s -> case (kind, sceneSky s) of
  (PanoramaSky file, SkyPanorama p) -> s {sceneSky = SkyPanorama p {panoramaFile = file}}
  (_, sky) | kind == skyKind sky -> s
  _ -> s {sceneSky = standard kind}
  where
    standard kind = case kind of
      NoiseSky -> SkyNoise defaultStars
      StarSky -> SkyStars realSky
      RandomStarSky -> SkyRandomStars defaultPointStars
      PanoramaSky file -> SkyPanorama (panoramaOf file)
      GridSky -> SkyGrid
      UniformSky -> SkyUniform 1
      NoSky -> SkyNone

skyKind :: Sky -> SkyKind
skyKind sky = case sky of
  SkyNoise _ -> NoiseSky
  SkyStars _ -> StarSky
  SkyRandomStars _ -> RandomStarSky
  SkyPanorama p -> PanoramaSky (panoramaFile p)
  SkyGrid -> GridSky
  SkyUniform _ -> UniformSky
  SkyNone -> NoSky

-- | The file of an environment map.
panoramaSkyFile :: SkyKind -> Maybe FilePath
panoramaSkyFile (PanoramaSky file) = Just file
panoramaSkyFile _ = Nothing

-- | A part of the environment map.
panorama :: Part Panorama a -> Part Scene a
panorama = inside (Part (shown . sceneSky) (\v s -> s {sceneSky = SkyPanorama v}))
  where
    shown (SkyPanorama p) = Just p
    shown _ = Nothing

-- | The radiance of a uniform sky.
radiancePart :: Part Scene Double
radiancePart = Part (uniform . sceneSky) $ \v s ->
  if skyKind (sceneSky s) == UniformSky then s {sceneSky = SkyUniform v} else s
  where
    uniform (SkyUniform v) = Just v
    uniform _ = Nothing

-- | A part of the stars of noise.
stars :: Part Stars a -> Part Scene a
stars = inside (Part (noise . sceneSky) (\v s -> s {sceneSky = SkyNoise v}))
  where
    noise (SkyNoise v) = Just v
    noise _ = Nothing

-- | A part of the real stars.
realStars :: Part RealSky a -> Part Scene a
realStars = inside (Part (real . sceneSky) (\v s -> s {sceneSky = SkyStars v}))
  where
    real (SkyStars v) = Just v
    real _ = Nothing

-- | The angle in degrees by which the sky is turned.
rotationPart :: Part Scene Double
rotationPart = Part (rotation . sceneSky) $ \v s -> case sceneSky s of
  SkyStars real -> s {sceneSky = SkyStars real {realSkyRotation = Degrees v}}
  SkyPanorama p -> s {sceneSky = SkyPanorama p {panoramaRotation = Degrees v}}
  _ -> s
  where
    rotation (SkyStars real) = Just (inDegrees (realSkyRotation real))
    rotation (SkyPanorama p) = Just (inDegrees (panoramaRotation p))
    rotation _ = Nothing

-- | A part of the random stars. Setting one makes the real stars random, which some
-- presets show instead of random ones in scenes of earlier versions.
pointStars :: Part PointStars a -> Part Scene a
pointStars (Part get set) =
  Part (\scene -> random (sceneSky scene) >>= get) $ \v scene -> case sceneSky scene of
    SkyRandomStars points -> scene {sceneSky = SkyRandomStars (set v points)}
    SkyStars _ -> scene {sceneSky = SkyRandomStars (set v defaultPointStars)}
    _ -> scene
  where
    random (SkyRandomStars v) = Just v
    random _ = Nothing
