-- | Every rule a scene must obey, checked at once: the ranges of the single
-- fields, and what they may be together.
module BlackHole.Scene.Validate
  ( Problem (..),
    renderProblem,
    validateScene,
    Fault (..),
    rangeFaults,
    sceneFaults,
    maximumPictureSide,
  )
where

import BlackHole.Physics.Observer
import BlackHole.Physics.Spacetime (Spacetime (..))
import BlackHole.Scene.Camera
import BlackHole.Scene.Disk
import BlackHole.Scene.Field.Field (Field (..), fieldLabel)
import BlackHole.Scene.Field.Kind
import BlackHole.Scene.Field.Number (showNumber)
import BlackHole.Scene.Field.Table
import BlackHole.Scene.Problem
import BlackHole.Scene.Scene
import BlackHole.Vector.XYZ (XYZ (..))
import qualified BlackHole.Vector.XYZ as XYZ

-- | A field whose value is not allowed, with what is.
data Fault = Fault
  { -- | The field's path.
    faultPath :: !String,
    faultValue :: !Value,
    faultRange :: !String
  }
  deriving (Eq, Show)

-- | All problems of a scene, named by its options where there are any; none
-- means that it can be rendered.
validateScene :: Scene -> [Problem]
validateScene = map problem . sceneFaults
  where
    problem (Fault path value range) =
      Problem (maybe path fieldLabel (findField path)) (showValue value) range

-- | All faults of a scene, in the order of the table.
sceneFaults :: Scene -> [Fault]
sceneFaults scene =
  faults ++ posture
  where
    faults = concatMap fieldFaults sceneFields
    -- A field that is out of its own range breaks no other rule.
    fieldFaults field = case rangeFaultsOf scene field of
      [] -> [fault | fault <- crossFaults scene, faultPath fault == fieldPath field]
      found -> found
    posture
      | any ((`elem` poseFields) . faultPath) faults = []
      | otherwise = sightFaults scene
    poseFields = ["camera.distance", "camera.inclination", "camera.azimuth", "camera.position", "camera.look-at", "camera.roll"]

-- | The faults that a field has by itself.
rangeFaults :: Scene -> [Fault]
rangeFaults scene = concatMap (rangeFaultsOf scene) sceneFields

rangeFaultsOf :: Scene -> Field -> [Fault]
rangeFaultsOf scene field =
  [ Fault (fieldPath field) value range
    | Just value <- [fieldGet field scene],
      Just range <- [rangeFault (fieldKind field) value]
  ]

-- | The rules between fields.
crossFaults :: Scene -> [Fault]
crossFaults scene = pose ++ foldMap edges (sceneDisk scene) ++ turning
  where
    -- What is defined for a hole without spin only.
    turning = case sceneSpacetime scene of
      Kerr _ ->
        [Fault "physics.integrator" (NameValue "leapfrog") "table or exact around a rotating hole; the leapfrog's law of motion holds without spin only" | sceneIntegrator scene == Leapfrogging]
          ++ [Fault "observer.motion" (NameValue (observerName Coordinate)) "static, zamo, orbiting, counter-orbiting or falling around a rotating hole" | sceneObserver scene == Coordinate]
      _ -> []
    pose = case cameraPose (sceneCamera scene) of
      Around r _ _ ->
        [Fault "camera.distance" (NumberValue r) placeRange | not (standsAt r)]
      LookAt _ _ ->
        [Fault "camera.position" (VectorValue place) ("X,Y,Z at " ++ placeRange) | not (standsAt (XYZ.norm place))]
    place = posePosition (cameraPose (sceneCamera scene))
    XYZ _ height _ = place
    least = observerRange (sceneSpacetime scene) (sceneObserver scene) (acos (max (-1) (min 1 (height / XYZ.norm place))))
    standsAt r = r > least && r <= 1e6 && observerExists (sceneSpacetime scene) (sceneObserver scene) place
    placeRange =
      "a distance above "
        ++ showNumber least
        ++ " and up to 1e6 Schwarzschild radii from the hole (for the "
        ++ observerName (sceneObserver scene)
        ++ " observer"
        ++ (if rotates && sceneObserver scene == Static then "; zamo and falling observers can be closer" else "")
        ++ ")"
    rotates = case sceneSpacetime scene of
      Kerr _ -> True
      _ -> False
    edges disk =
      [ Fault "disk.inner-radius" (NumberValue (diskInnerRadius disk)) "a radius from 0 to below the outer radius (Schwarzschild radii)"
        | diskInnerRadius disk >= diskOuterRadius disk
      ]

-- | A camera that looks nowhere.
sightFaults :: Scene -> [Fault]
sightFaults scene = case (cameraFrame camera, cameraPose camera) of
  (Nothing, LookAt _ target) ->
    [ Fault "camera.look-at" (VectorValue target) "a point off the camera's own place and off the vertical (+y) through it, its up vector"
    ]
  _ -> []
  where
    camera = sceneCamera scene
