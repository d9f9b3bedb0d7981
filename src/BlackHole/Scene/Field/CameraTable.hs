-- | The settings of the camera, its observer, the picture's size, the hole and light's paths.
module BlackHole.Scene.Field.CameraTable
  ( cameraFields,
    maximumPictureSide,
  )
where

import BlackHole.Numeric.Angle
import BlackHole.Scene.Camera
  ( Camera (cameraFieldOfView, cameraRoll),
    Projection (..),
    projectionName,
  )
import BlackHole.Scene.Field.Field
import BlackHole.Scene.Field.Kind
import BlackHole.Scene.Field.Parts
import BlackHole.Scene.Scene
import BlackHole.Scene.Shifts (Shifts (..))
import qualified BlackHole.Spacetime.Observer as Observer

-- | The greatest width and height of a picture in pixels.
maximumPictureSide :: Int
maximumPictureSide = 65536

-- | The settings of the camera, its observer, the picture's size, the hole and light's paths.
cameraFields :: [Field]
cameraFields =
  [ choice Camera "camera.projection" "a projection" projections
      `sets` projectionPart
      `documented` "Projection of directions onto the picture: perspective, fisheye (for domes) \
                   \or equirectangular (for VR); also sets the field of view, height and bloom \
                   \that are usual for it"
      `withOption` ("projection", "NAME"),
    number Camera "camera.distance" (Quantity "a distance" Anything (UpTo 1e6) radii)
      `sets` distancePart
      `documented` "Distance of the camera from the hole in Schwarzschild radii"
      `withOption` ("distance", "R"),
    number Camera "camera.inclination" (angle (From 0) (UpTo 180) "degrees from the disk's axis")
      `sets` inclinationPart
      `documented` "Angle between the disk's axis and the camera in degrees: 0 is above the pole, \
                   \90 in the disk's plane"
      `withOption` ("inclination", "DEGREES"),
    number Camera "camera.azimuth" (angle (From (-1e6)) (UpTo 1e6) "degrees")
      `sets` azimuthPart
      `documented` "Angle of the camera around the disk's axis in degrees"
      `withOption` ("azimuth", "DEGREES"),
    vector Camera "camera.position"
      `sets` positionPart
      `documented` "Position of the camera in Schwarzschild radii, instead of distance, \
                   \inclination and azimuth; the disk's axis is +y"
      `withOption` ("position", "X,Y,Z"),
    vector Camera "camera.look-at"
      `sets` lookAtPart
      `documented` "Point that the camera looks at, in Schwarzschild radii (default: the hole)"
      `withOption` ("look-at", "X,Y,Z"),
    number Camera "camera.roll" (angle (From (-1e6)) (UpTo 1e6) "degrees")
      `sets` camera (part (inDegrees . cameraRoll) (\v c -> c {cameraRoll = Degrees v}))
      `documented` "Rotation of the camera about its line of sight in degrees, clockwise"
      `withOption` ("roll", "DEGREES"),
    number Camera "camera.fov" (angle (Above 0) (UpTo 360) "degrees")
      `sets` camera
        (part (inDegrees . cameraFieldOfView) (\v c -> c {cameraFieldOfView = Degrees v}))
      `documented` "Field of view across the width of the picture in degrees: below 180 in \
                   \perspective, up to 360 in the other projections"
      `withOption` ("fov", "DEGREES"),
    number Camera "camera.aperture" (Quantity "a length" (From 0) (UpTo 1e4) radii)
      `sets` aperturePart
      `documented` "Diameter of the lens in Schwarzschild radii, for depth of field; 0 for a \
                   \pinhole. Setting it also focuses on the hole"
      `withOption` ("aperture", "R"),
    number Camera "camera.focus" (Quantity "a distance" (Above 0) (UpTo 1e9) radii)
      `sets` part sceneFocus (\v s -> s {sceneFocus = v})
      `documented` "Distance along the line of sight at which the picture is sharp, in \
                   \Schwarzschild radii"
      `withOption` ("focus", "R"),
    choice Observer "camera.observer" "an observer" observers
      `sets` part sceneObserver (\v s -> s {sceneObserver = v})
      `documented` "Motion of the observer: static, zamo (without angular momentum, turning with \
                   \the space around a rotating hole), orbiting, counter-orbiting, falling, or \
                   \coordinate (aims by coordinate directions, like the design report)"
      `withOption` ("observer", "WHO"),
    whole Image "image.width" (1, maximumPictureSide) "pixels"
      `sets` widthPart
      `documented` "Width of the picture in pixels; also sets the height: to 9/16 of it, in a \
                   \fisheye picture to the same, in an equirectangular one to half of it"
      `withOption` ("width", "PIXELS"),
    whole Image "image.height" (1, maximumPictureSide) "pixels"
      `sets` heightPart
      `documented` "Height of the picture in pixels (default: by the width and the projection)"
      `withOption` ("height", "PIXELS"),
    switch Observer "physics.gravity"
      `sets` gravityPart
      `documented` "Whether gravity bends light; without gravity, light travels straight and the \
                   \hole is a black ball"
      `withFlag` ( "no-gravity",
                   SwitchValue False,
                   "Let light travel in straight lines; the hole is a black ball"
                 ),
    switch Observer "physics.doppler"
      `sets` shifts (part shiftsDoppler (\v s -> s {shiftsDoppler = v}))
      `documented` "Whether to show frequency shifts due to motion (the Doppler effect)"
      `withOption` ("doppler", "on|off"),
    switch Observer "physics.redshift"
      `sets` shifts (part shiftsGravity (\v s -> s {shiftsGravity = v}))
      `documented` "Whether to show frequency shifts due to gravity"
      `withOption` ("redshift", "on|off"),
    choice Observer "physics.integrator" "an integrator" integrators
      `sets` part sceneIntegrator (\v s -> s {sceneIntegrator = v})
      `documented` "How to compute light paths: table (tabulated closed-form orbits), exact \
                   \(closed form for each ray and finer steps through the gas; slower) or leapfrog \
                   \(numerical integration, as in the design report)"
      `withOption` ("integrator", "NAME"),
    number Observer "physics.step" (Quantity "a length" (From 1e-5) (UpTo 10) radii)
      `sets` part sceneStep (\v s -> s {sceneStep = v})
      `documented` "Base step length of the leapfrog in Schwarzschild radii"
      `withOption` ("step", "L"),
    number Observer "hole.spin" (Quantity "a spin" (Above (-1)) (Below 1) "")
      `sets` spinPart
      `documented` "Spin of the hole, from -1 to 1: its angular momentum as a fraction of the \
                   \greatest possible, positive if the hole turns with the disk"
      `withOption` ("spin", "A")
  ]
  where
    radii = "Schwarzschild radii"
    angle = Quantity "an angle"
    named name value meaning = (value, name value, meaning)
    projections =
      [ named projectionName Perspective "a flat picture, as a lens draws it",
        named projectionName Fisheye "a round picture with angles in proportion, as domes need it",
        named projectionName Equirectangular "longitude and latitude, as VR viewers need them"
      ]
    observers =
      [ named Observer.observerName Observer.Static "at rest",
        named Observer.observerName Observer.Zamo "without angular momentum, turning with space",
        named Observer.observerName Observer.Orbiting "on a circular orbit",
        named Observer.observerName Observer.CounterOrbiting "on a circular orbit against the gas",
        named Observer.observerName Observer.Falling "falling in from rest at infinity",
        named
          Observer.observerName
          Observer.Coordinate
          "aims by coordinate directions, like the design report; not a real observer"
      ]
    integrators =
      [ named integratorName Tabulated "closed-form orbits, tabulated for the camera's distance",
        named
          integratorName
          Exact
          "closed-form orbits for each ray, and finer steps through the gas",
        named integratorName Leapfrogging "numerical integration, as in the design report"
      ]
