-- | The table of all settings of a scene. The options of the command line, scene
-- files, their printed form, the JSON Schema and the checks of ranges all derive from
-- it; docs/architecture.md explains how to add a setting.
module BlackHole.Scene.Field.Table
  ( sceneFields,
    findField,
    formerPaths,
    currentPath,
    maximumPictureSide,
  )
where

import BlackHole.Light.Display (Exposure (..), ToneMap (..), toneMapName)
import BlackHole.Light.Dither (Dither (..))
import BlackHole.Numeric.Angle
import BlackHole.Scene.Camera
  ( Camera (cameraFieldOfView, cameraRoll),
    Projection (..),
    projectionName,
  )
import BlackHole.Scene.Disk (DiskProfile (..))
import qualified BlackHole.Scene.Disk as Gas
import BlackHole.Scene.Field.Field
import BlackHole.Scene.Field.Kind
import BlackHole.Scene.Field.Parts
import BlackHole.Scene.Filter (Filter (..), filterName)
import BlackHole.Scene.Scene
import BlackHole.Scene.Shifts (Shifts (..))
import BlackHole.Scene.Sky (Panorama (..), PointStars (..), RealSky (..), Stars (..))
import qualified BlackHole.Spacetime.Observer as Observer
import Data.List (intercalate)
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe)

-- | The greatest width and height of a picture in pixels.
maximumPictureSide :: Int
maximumPictureSide = 65536

-- | A setting by its path.
findField :: String -> Maybe Field
findField path = Map.lookup path fieldsByPath

fieldsByPath :: Map.Map String Field
fieldsByPath = Map.fromList [(fieldPath field, field) | field <- sceneFields]

-- | Former paths of settings with the present ones. Scene files may still use them.
formerPaths :: [(String, String)]
formerPaths =
  [ ("camera.field-of-view", "camera.fov"),
    ("observer.motion", "camera.observer"),
    ("disk.inner-radius", "disk.inner"),
    ("disk.outer-radius", "disk.outer"),
    ("sky.panorama.rotation", "sky.rotation")
  ]

-- | The present path of a setting, given that or a former one.
currentPath :: String -> String
currentPath path = fromMaybe path (lookup path formerPaths)

-- | Every setting, in the order of printed scenes. Settings are applied in this order,
-- whatever the order in which they are given: a setting that chooses between
-- alternatives comes before the settings of the alternatives, the projection before the
-- size of the picture, and the width before the height, because it sets both. Settings of
-- one group stand together.
--
-- An option is named like the end of its setting's path: @--fov@ sets @camera.fov@ and
-- @--disk-inner@ sets @disk.inner@. @--sky@ sets @sky.kind@, and @--no-gravity@ and
-- @--no-disk@ set @physics.gravity@ and @disk.present@ to false.
sceneFields :: [Field]
sceneFields =
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
      `withOption` ("spin", "A"),
    switch Disk "disk.present"
      `sets` presencePart
      `documented` "Whether there is a disk; without one, no other setting of the disk has an \
                   \effect"
      `withFlag` ("no-disk", SwitchValue False, "Render without a disk"),
    number Disk "disk.inner" (Quantity "a radius" (From 0) (UpTo 1e4) radii)
      `sets` disk (part Gas.diskInnerRadius (\v d -> d {Gas.diskInnerRadius = v}))
      `documented` "Inner radius of the disk in Schwarzschild radii"
      `withOption` ("disk-inner", "R"),
    number Disk "disk.outer" (Quantity "a radius" (Above 1) (UpTo 1e4) radii)
      `sets` disk (part Gas.diskOuterRadius (\v d -> d {Gas.diskOuterRadius = v}))
      `documented` "Outer radius of the disk in Schwarzschild radii"
      `withOption` ("disk-outer", "R"),
    number Disk "disk.fade" (Quantity "a fraction of the outer radius" (From 0) (UpTo 1) "")
      `sets` disk (part Gas.diskFade (\v d -> d {Gas.diskFade = v}))
      `documented` "Fraction of the outer radius at which the density has fallen to half",
    number Disk "disk.thickness" (Quantity "a length" (From 1e-4) (UpTo 100) radii)
      `sets` disk (part Gas.diskThickness (\v d -> d {Gas.diskThickness = v}))
      `documented` "Height above the disk's plane, in Schwarzschild radii, at which the density \
                   \has fallen to 1/e"
      `withOption` ("disk-thickness", "W"),
    choice Disk "disk.profile" "a profile" profiles
      `sets` disk (part Gas.diskProfile (\v d -> d {Gas.diskProfile = v}))
      `documented` "Profile of the thickness: constant, or opening (in proportion to the radius, \
                   \with the given thickness at the outer radius)",
    number Disk "disk.opacity" (Quantity "an optical depth" (From 0) (UpTo 1e6) "")
      `sets` disk (part Gas.diskOpacity (\v d -> d {Gas.diskOpacity = v}))
      `documented` "Optical depth of gas of full density over a path as long as the thickness"
      `withOption` ("disk-opacity", "TAU"),
    number Disk "disk.brightness" (Quantity "a radiance" (From 0) (UpTo 1e9) "")
      `sets` disk (part Gas.diskBrightness (\v d -> d {Gas.diskBrightness = v}))
      `documented` "Radiance of opaque gas where it is brightest; 1 is display white at exposure 0",
    choice Disk "disk.colour" "a way to colour the gas" glows
      `sets` glowPart
      `documented` "Colour of the gas: black-body, bolometric (intensity over all wavelengths, \
                   \without colour), synchrotron (radio waves of an optically thin flow, without \
                   \colour), or hue-ramp (yellow to red by radius, as in the design report, \
                   \without physics)",
    number Disk "disk.temperature" (Quantity "a temperature" (From 500) (UpTo 1e6) "kelvin")
      `sets` temperaturePart
      `documented` "Temperature of the gas in kelvin where it is hottest; makes the gas a black \
                   \body"
      `withOption` ("temperature", "KELVIN"),
    number Disk "disk.time" (Quantity "a time" (From (-1e9)) (UpTo 1e9) "r_s/c")
      `sets` disk (part Gas.diskTime (\v d -> d {Gas.diskTime = v}))
      `documented` "Time up to which the gas has moved, in r_s/c (Schwarzschild radii over the \
                   \speed of light)"
      `withOption` ("time", "T"),
    whole Disk "disk.arms.count" (0, 1000) ""
      `sets` disk (part Gas.diskArms (\v d -> d {Gas.diskArms = v}))
      `documented` "Number of spiral arms; 0 for none",
    number
      Disk
      "disk.arms.winding"
      (Quantity "an angle" (From (-1e4)) (UpTo 1e4) "radians per Schwarzschild radius")
      `sets` disk (part Gas.diskArmWinding (\v d -> d {Gas.diskArmWinding = v}))
      `documented` "Winding of the arms in radians per Schwarzschild radius outwards",
    number Disk "disk.arms.depth" (Quantity "a fraction" (From 0) (UpTo 0.5) "")
      `sets` disk (part Gas.diskArmDepth (\v d -> d {Gas.diskArmDepth = v}))
      `documented` "Fraction by which the disk is thinner between the arms, 0 to 0.5",
    number Disk "disk.arms.noise" (Quantity "an angle" (From 0) (UpTo 1000) "radians")
      `sets` disk (part Gas.diskArmNoise (\v d -> d {Gas.diskArmNoise = v}))
      `documented` "Angle by which noise displaces the arms, in radians",
    number
      Disk
      "disk.arms.noise-frequency"
      (features (From 0) (UpTo 1000) "per Schwarzschild radius")
      `sets` disk (part Gas.diskArmNoiseFrequency (\v d -> d {Gas.diskArmNoiseFrequency = v}))
      `documented` "Frequency of that noise in features per Schwarzschild radius",
    whole Disk "disk.arms.noise-octaves" (1, 20) ""
      `sets` disk (part Gas.diskArmNoiseOctaves (\v d -> d {Gas.diskArmNoiseOctaves = v}))
      `documented` "Octaves of that noise",
    number Disk "disk.turbulence.strength" (Quantity "a number" (From 0) (UpTo 100) "")
      `sets` disk (part Gas.diskTurbulence (\v d -> d {Gas.diskTurbulence = v}))
      `documented` "Strength of the turbulence; 0 for smooth gas",
    number Disk "disk.turbulence.frequency" (features (From 0) (UpTo 1000) "")
      `sets` disk (part Gas.diskTurbulenceFrequency (\v d -> d {Gas.diskTurbulenceFrequency = v}))
      `documented` "Frequency of the turbulence in features between any radius and e times that \
                   \radius",
    whole Disk "disk.turbulence.octaves" (1, 8) ""
      `sets` disk (part Gas.diskTurbulenceOctaves (\v d -> d {Gas.diskTurbulenceOctaves = v}))
      `documented` "Octaves of the turbulence, each at twice the frequency of the one before",
    number Disk "disk.turbulence.gain" (Quantity "a fraction" (From 0) (UpTo 1) "")
      `sets` disk (part Gas.diskTurbulenceGain (\v d -> d {Gas.diskTurbulenceGain = v}))
      `documented` "Strength of each octave relative to the one before, 0 to 1",
    number Disk "disk.turbulence.warp" (features (From 0) (UpTo 100) "")
      `sets` disk (part Gas.diskTurbulenceWarp (\v d -> d {Gas.diskTurbulenceWarp = v}))
      `documented` "How far the coarse octaves displace the finer ones, in widths of the coarsest \
                   \features",
    number Disk "disk.turbulence.filaments" (Quantity "a fraction" (From 0) (UpTo 1) "")
      `sets` disk (part Gas.diskTurbulenceFilaments (\v d -> d {Gas.diskTurbulenceFilaments = v}))
      `documented` "Fraction of bright filaments in the finer octaves, 0 to 1",
    number Disk "disk.turbulence.intermittency" (Quantity "a number" (From 0) (UpTo 100) "")
      `sets` disk (part Gas.diskTurbulenceGrowth (\v d -> d {Gas.diskTurbulenceGrowth = v}))
      `documented` "How much stronger fine turbulence is where the gas is dense; 0 for equally \
                   \strong everywhere",
    number Disk "disk.turbulence.heat" (Quantity "an exponent" (From 0) (UpTo 2) "")
      `sets` disk (part Gas.diskTurbulenceHeat (\v d -> d {Gas.diskTurbulenceHeat = v}))
      `documented` "Exponent of the temperature as a power of the surface density within a ring, \
                   \whose mean flux stays; 0 for rings of one temperature",
    number Disk "disk.haze.density" (Quantity "a density" (From 0) (UpTo 1) "")
      `sets` disk (part Gas.diskHaze (\v d -> d {Gas.diskHaze = v}))
      `documented` "Density of a haze above and below the disk relative to full density; 0 \
                   \for none",
    number Disk "disk.haze.height" (Quantity "a ratio" (From 1) (UpTo 100) "")
      `sets` disk (part Gas.diskHazeHeight (\v d -> d {Gas.diskHazeHeight = v}))
      `documented` "Thickness of the haze relative to that of the disk, at least 1",
    choiceOrFile
      Sky
      "sky.kind"
      "a sky"
      skies
      "the file of an environment map"
      (PanoramaSky, panoramaSkyFile)
      `sets` skyKindPart
      `documented` "Background: stars (the real stars and the Milky Way), random-stars (made from \
                   \the seed), noise (stars made from noise, as in the design report), grid, \
                   \uniform, none, or the file of an environment map (a picture twice as wide as \
                   \high)"
      `withOption` ("sky", "NAME|FILE"),
    number Sky "sky.rotation" (angle (From (-1e6)) (UpTo 1e6) "degrees")
      `sets` rotationPart
      `documented` "Rotation of the real stars or of an environment map about the disk's axis in \
                   \degrees; at 0 a camera at azimuth 90 sees the map's centre behind the hole"
      `withOption` ("sky-rotation", "DEGREES"),
    number Sky "sky.brightness" (Quantity "a gain" (From 0) (UpTo 1e9) "")
      `sets` realStars (part realSkyBrightness (\v s -> s {realSkyBrightness = v}))
      `documented` "Gain of the real stars and the Milky Way; at 1, a star of magnitude 0 has a \
                   \flux of 80e-6 steradians times radiance",
    number Sky "sky.milky-way" (Quantity "a gain" (From 0) (UpTo 1e9) "")
      `sets` realStars (part realSkyMilkyWay (\v s -> s {realSkyMilkyWay = v}))
      `documented` "Further gain of the Milky Way alone; 1 is its true ratio to the stars, 0 \
                   \leaves it out",
    number Sky "sky.panorama.brightness" (Quantity "a radiance" (From 0) (UpTo 1e9) "")
      `sets` panorama (part panoramaBrightness (\v p -> p {panoramaBrightness = v}))
      `documented` "Radiance of white in the environment map; 1 is display white at exposure 0",
    number Sky "sky.radiance" (Quantity "a radiance" (From 0) (UpTo 1e9) "")
      `sets` radiancePart
      `documented` "Radiance of a uniform sky; 1 is display white at exposure 0",
    number Sky "sky.stars.frequency" (features (Above 0) (UpTo 1e6) "per radian")
      `sets` stars (part starFrequency (\v s -> s {starFrequency = v}))
      `documented` "Frequency of the stars' noise in features per radian",
    whole Sky "sky.stars.octaves" (1, 20) ""
      `sets` stars (part starOctaves (\v s -> s {starOctaves = v}))
      `documented` "Octaves of that noise: 1 gives round stars, more give ragged patches of light",
    number Sky "sky.stars.threshold" (Quantity "a noise level" (From (-1)) (UpTo 1) "")
      `sets` stars (part starThreshold (\v s -> s {starThreshold = v}))
      `documented` "Noise level, -1 to 1, at which a star reaches half its brightness",
    number Sky "sky.stars.sharpness" (Quantity "a steepness" (Above 0) (UpTo 1e6) "")
      `sets` stars (part starSharpness (\v s -> s {starSharpness = v}))
      `documented` "Steepness of the edges of stars",
    number Sky "sky.stars.brightness" (Quantity "a radiance" (From 0) (UpTo 1e9) "")
      `sets` stars (part starBrightness (\v s -> s {starBrightness = v}))
      `documented` "Radiance of the brightest stars; 1 is display white at exposure 0",
    switch Sky "sky.stars.colours"
      `sets` stars (part starColours (\v s -> s {starColours = v}))
      `documented` "Whether stars have the colours of black bodies instead of being white",
    whole Sky "sky.points.count" (1, 1000000) ""
      `sets` pointStars (part pointStarsCount (\v s -> s {pointStarsCount = v}))
      `documented` "Number of random stars in the whole sky; turns the real stars into random ones",
    number Sky "sky.points.brightness" (Quantity "a brightness" (From 0) (UpTo 1e9) "")
      `sets` pointStars (part pointStarsBrightness (\v s -> s {pointStarsBrightness = v}))
      `documented` "Flux of a random star of magnitude 0 in units of 1e-6 steradians times \
                   \radiance: at 1, it gives a pixel of one square milliradian the radiance 1",
    number Sky "sky.points.milky-way" (Quantity "a radiance" (From 0) (UpTo 1e9) "")
      `sets` pointStars (part pointStarsMilkyWay (\v s -> s {pointStarsMilkyWay = v}))
      `documented` "Radiance of the bright parts of the random Milky Way; 0 for none",
    whole Sampling "sampling.samples" (1, 65536) ""
      `sets` part sceneSamples (\v s -> s {sceneSamples = v})
      `documented` "Rays traced through every pixel"
      `withOption` ("samples", "N"),
    number Sampling "sampling.noise" (Quantity "a fraction of white" (From 0) (UpTo 1) "")
      `sets` part sceneNoise (\v s -> s {sceneNoise = v})
      `documented` "Standard error, as a fraction of display white, above which a pixel gets more \
                   \rays; 0 for never"
      `withOption` ("noise", "T"),
    whole Sampling "sampling.most-samples" (1, 65536) ""
      `sets` part sceneMostSamples (\v s -> s {sceneMostSamples = v})
      `documented` "Greatest number of rays for such a pixel"
      `withOption` ("most-samples", "N"),
    choice Sampling "sampling.filter" "a filter" filters
      `sets` part sceneFilter (\v s -> s {sceneFilter = v})
      `documented` "Reconstruction filter: box, gaussian or mitchell"
      `withOption` ("filter", "NAME"),
    seed Sampling "sampling.seed"
      `sets` part sceneSeed (\v s -> s {sceneSeed = v})
      `documented` "Seed of the random gas, stars and sampling, 0 to 2^64 - 1"
      `withOption` ("seed", "N"),
    number Output "output.exposure" (Quantity "a number of stops" (From (-100)) (UpTo 100) "")
      `sets` part (exposureStops . sceneExposure) (\v s -> s {sceneExposure = Exposure v})
      `documented` "Exposure in stops: +1 doubles the light, -1 halves it"
      `withOption` ("exposure", "STOPS"),
    choice Output "output.tone-map" "a tone map" toneMaps
      `sets` part sceneToneMap (\v s -> s {sceneToneMap = v})
      `documented` ( "Tone map, which compresses bright light into the range of a display: "
                       ++ intercalate ", " (map toneMapName [minBound ..])
                   )
      `withOption` ("tone-map", "NAME"),
    switch Output "output.dither"
      `sets` part
        ((== BlueNoise) . sceneDither)
        (\on s -> s {sceneDither = if on then BlueNoise else NoDither})
      `documented` "Whether to dither 8-bit files to prevent banding"
      `withOption` ("dither", "on|off"),
    number Output "output.beam" (Quantity "an angle" (From 0) (UpTo 90) "degrees")
      `sets` part sceneBeam (\v s -> s {sceneBeam = v})
      `documented` "Full width at half maximum, in degrees, of the Gaussian with which a radio \
                   \telescope blurs the picture; 0 for none"
      `withOption` ("beam", "DEGREES"),
    number Output "output.bloom" (Quantity "a fraction" (From 0) (UpTo 1) "of the light")
      `sets` part sceneBloom (\v s -> s {sceneBloom = v})
      `documented` "Fraction of the light that the lens scatters, 0 to 1"
      `withOption` ("bloom", "FRACTION"),
    whole Output "output.spikes" (0, 64) ""
      `sets` part sceneSpikes (\v s -> s {sceneSpikes = v})
      `documented` "Number of straight edges of the aperture that make diffraction spikes: an \
                   \even number makes as many spikes, an odd one twice as many; 0 for none"
      `withOption` ("spikes", "N"),
    number Output "output.spike-light" (Quantity "a fraction" (From 0) (UpTo 1) "of the light")
      `sets` part sceneSpikeLight (\v s -> s {sceneSpikeLight = v})
      `documented` "Fraction of the light in the spikes, 0 to 1",
    number
      Output
      "output.grain"
      (Quantity "a length" (From 0) (UpTo 100) "thousandths of the width")
      `sets` part sceneGrain (\v s -> s {sceneGrain = v})
      `documented` "Diameter of the dots of ink that make up the picture, in thousandths of its \
                   \width; 0 for continuous tones"
      `withOption` ("grain", "SIZE"),
    number Output "output.scale-bar" (Quantity "a length" (From 0) (UpTo 1e6) radii)
      `sets` part sceneScaleBar (\v s -> s {sceneScaleBar = v})
      `documented` "Length of a scale bar in the lower right corner, in Schwarzschild radii at \
                   \the distance of the hole; 0 for none"
      `withOption` ("scale-bar", "R"),
    switch Diagnostics "diagnostics.debug-textures"
      `sets` part sceneDebugTextures (\v s -> s {sceneDebugTextures = v})
      `documented` "Show checkerboards instead of the disk and the sky"
      `withFlag` ( "debug-textures",
                   SwitchValue True,
                   "Show checkerboards instead of the disk and the sky"
                 )
  ]
  where
    radii = "Schwarzschild radii"
    angle = Quantity "an angle"
    features = Quantity "a number of features"
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
    filters =
      [ named filterName Box "the mean over the pixel's square",
        named filterName Gaussian "soft, of standard deviation 1/2 pixel",
        named filterName Mitchell "crisp, with negative lobes"
      ]
    integrators =
      [ named integratorName Tabulated "closed-form orbits, tabulated for the camera's distance",
        named
          integratorName
          Exact
          "closed-form orbits for each ray, and finer steps through the gas",
        named integratorName Leapfrogging "numerical integration, as in the design report"
      ]
    profiles =
      [ (ConstantThickness, "constant", "the same everywhere"),
        (ConstantOpening, "opening", "in proportion to the radius")
      ]
    glows =
      [ (RampGlow, "hue-ramp", "yellow inside to red outside, without physics"),
        (BlackBodyGlow, "black-body", "by its temperature"),
        (BolometricGlow, "bolometric", "all wavelengths together, without colour"),
        (SynchrotronGlow, "synchrotron", "radio waves of a thin flow, without colour")
      ]
    skies =
      [ (StarSky, "stars", "the real stars and the Milky Way"),
        ( RandomStarSky,
          "random-stars",
          "point stars made from the seed, and a band like the Milky Way"
        ),
        (NoiseSky, "noise", "stars made from noise, as in the design report"),
        (GridSky, "grid", "a checkerboard with fields of 10 degrees"),
        (UniformSky, "uniform", "equal radiance in all directions"),
        (NoSky, "none", "dark")
      ]
    toneMaps = [(tone, toneMapName tone, toneMapMeaning tone) | tone <- [minBound ..]]
    toneMapMeaning tone = case tone of
      ToneNone -> "none"
      ToneFilm -> "the soft shoulder of photographic film"
      ToneReinhard -> "low contrast"
      ToneAces -> "high contrast"
      ToneAgx -> "for very high dynamic range"
      ToneRadio -> "luminance as false colour, black to orange to white"
