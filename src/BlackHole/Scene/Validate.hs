-- | All rules for a valid scene: the ranges of single settings, and the rules between
-- settings.
module BlackHole.Scene.Validate
  ( Problem (..),
    problemOption,
    problemValue,
    renderProblem,
    validateScene,
    Fault (..),
    rangeFaults,
    sceneFaults,
    maximumPictureSide,
  )
where

import BlackHole.Numeric.Angle (Degrees (..))
import BlackHole.Scene.Camera
import BlackHole.Scene.Disk
import BlackHole.Scene.Field.Field (Field (..), fieldLabel)
import BlackHole.Scene.Field.Kind
import BlackHole.Scene.Field.Number (showNumber)
import BlackHole.Scene.Field.Table
import BlackHole.Scene.Problem
import BlackHole.Scene.Scene
import BlackHole.Spacetime.Observer
import BlackHole.Spacetime.Types (Spacetime (..))
import BlackHole.Vector.XYZ (XYZ (..))
import qualified BlackHole.Vector.XYZ as XYZ

-- | A setting whose value is not allowed.
data Fault = Fault
  { -- | The setting's path.
    faultPath :: !String,
    faultValue :: !Value,
    -- | What is allowed, as a noun phrase.
    faultRange :: !String
  }
  deriving (Eq, Show)

-- | All problems of a scene, named by options where the settings have one. A scene
-- without problems can be rendered.
validateScene :: Scene -> [Problem]
validateScene = map problem . sceneFaults
  where
    problem (Fault path value range) =
      Problem (maybe path fieldLabel (findField path)) (showValue value) range

-- | All faults of a scene, in the order of the table of settings.
sceneFaults :: Scene -> [Fault]
sceneFaults scene =
  faults ++ posture
  where
    faults = concatMap fieldFaults sceneFields
    -- A value out of its own range would only cause misleading faults of other rules.
    fieldFaults field = case rangeFaultsOf scene field of
      [] -> [fault | fault <- crossFaults scene, faultPath fault == fieldPath field]
      found -> found
    posture
      | any ((`elem` poseFields) . faultPath) faults = []
      | otherwise = sightFaults scene
    poseFields =
      [ "camera.distance",
        "camera.inclination",
        "camera.azimuth",
        "camera.position",
        "camera.look-at",
        "camera.roll"
      ]

-- | The values outside the range of their own setting.
rangeFaults :: Scene -> [Fault]
rangeFaults scene = concatMap (rangeFaultsOf scene) sceneFields

rangeFaultsOf :: Scene -> Field -> [Fault]
rangeFaultsOf scene field =
  [ Fault (fieldPath field) value range
    | Just value <- [fieldGet field scene],
      Just range <- [rangeFault (fieldKind field) value]
  ]

-- | The rules between settings.
crossFaults :: Scene -> [Fault]
crossFaults scene = pose ++ projected ++ lens ++ bar ++ foldMap edges (sceneDisk scene) ++ turning
  where
    lens =
      [ Fault
          "camera.aperture"
          (NumberValue (sceneAperture scene))
          ( "a length from 0 to the distance of the camera from the hole, which is "
              ++ showNumber (XYZ.norm place)
              ++ " (Schwarzschild radii)"
          )
        | sceneAperture scene > XYZ.norm place
      ]
    bar =
      [ Fault
          "output.scale-bar"
          (NumberValue (sceneScaleBar scene))
          ( "a length that fits into the picture, up to "
              ++ showNumber (0.9 * sceneScaleBar scene * fromIntegral width / scaleBarPixels scene)
              ++ " (Schwarzschild radii)"
          )
        | scaleBarPixels scene > 0.9 * fromIntegral width
      ]
    -- What is defined for a hole without spin only.
    turning = case sceneSpacetime scene of
      Kerr _ ->
        [ Fault
            "physics.integrator"
            (NameValue "leapfrog")
            "table or exact around a rotating hole; \
            \the leapfrog's law of motion holds without spin only"
          | sceneIntegrator scene == Leapfrogging
        ]
          ++ [ Fault
                 "camera.observer"
                 (NameValue (observerName Coordinate))
                 "static, zamo, orbiting, counter-orbiting or falling around a rotating hole"
               | sceneObserver scene == Coordinate
             ]
      _ -> []
    projected = case sceneProjection scene of
      Perspective ->
        [ Fault
            "camera.fov"
            (NumberValue fov)
            "an angle above 0 and below 180 (degrees) in \
            \perspective; --projection fisheye and equirectangular go up to 360"
          | fov >= 180
        ]
      Fisheye -> []
      Equirectangular ->
        [ Fault
            "image.height"
            (WholeValue height)
            ( "a whole number from 1 to " ++ show tallest
                ++ " (pixels): a height of 180 degrees where "
                ++ show width
                ++ " pixels are "
                ++ showNumber fov
                ++ " degrees"
            )
          | fov > 0 && height > tallest
        ]
          ++ [ Fault
                 path
                 value
                 "0 in an equirectangular picture: light does not scatter across \
                 \its edges to where the sphere goes on"
               | (path, value, True) <-
                   [ ("output.bloom", NumberValue (sceneBloom scene), sceneBloom scene > 0),
                     ("output.beam", NumberValue (sceneBeam scene), sceneBeam scene > 0),
                     ("output.spikes", WholeValue (sceneSpikes scene), sceneSpikes scene > 0)
                   ]
             ]
    Degrees fov = cameraFieldOfView (sceneCamera scene)
    Picture width height = scenePicture scene
    -- Half the width of the whole sphere, rounded up.
    tallest = min maximumPictureSide (ceiling (min 1e9 (180 * fromIntegral width / fov) - 1e-6))
    pose = case cameraPose (sceneCamera scene) of
      Around r _ _ ->
        [Fault "camera.distance" (NumberValue r) placeRange | not (standsAt r)]
      LookAt _ _ ->
        [ Fault "camera.position" (VectorValue place) ("X,Y,Z at " ++ placeRange)
          | not (standsAt (XYZ.norm place))
        ]
    -- Any azimuth is as good as another; one that is no angle is reported by itself.
    place = posePosition $ case cameraPose (sceneCamera scene) of
      Around r inclination _ -> Around r inclination (Degrees 0)
      pose' -> pose'
    XYZ _ elevation _ = place
    least =
      observerRange
        (sceneSpacetime scene)
        (sceneObserver scene)
        (acos (max (-1) (min 1 (elevation / XYZ.norm place))))
    standsAt r =
      r > 0 && r <= 1e6 && observerExists (sceneSpacetime scene) (sceneObserver scene) place
    placeRange =
      "a distance above "
        ++ showNumber (fromIntegral (ceiling (1e4 * least) :: Int) / 1e4)
        ++ " and up to 1e6 Schwarzschild radii from the hole (for the "
        ++ observerName (sceneObserver scene)
        ++ " observer"
        ++ ( if rotates && sceneObserver scene == Static
               then "; zamo and falling observers can be closer"
               else ""
           )
        ++ ")"
    rotates = case sceneSpacetime scene of
      Kerr _ -> True
      _ -> False
    edges disk =
      [ Fault
          "disk.inner"
          (NumberValue (diskInnerRadius disk))
          ( "a radius from 0 to below the outer radius, which is "
              ++ showNumber (diskOuterRadius disk)
              ++ " (Schwarzschild radii)"
          )
        | diskInnerRadius disk >= diskOuterRadius disk
      ]

-- | A camera without a direction of sight, or whose up direction is undefined.
sightFaults :: Scene -> [Fault]
sightFaults scene = case (cameraFrame camera, cameraPose camera) of
  (Nothing, LookAt _ target) ->
    [ Fault
        "camera.look-at"
        (VectorValue target)
        "a point other than the camera's position and \
        \not straight above or below it (along y, the up direction)"
    ]
  _ -> []
  where
    camera = sceneCamera scene
