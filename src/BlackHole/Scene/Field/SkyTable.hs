-- | The settings of the sky.
module BlackHole.Scene.Field.SkyTable
  ( skyFields,
  )
where

import BlackHole.Scene.Field.Field
import BlackHole.Scene.Field.Kind
import BlackHole.Scene.Field.Parts
import BlackHole.Scene.Sky (Panorama (..), PointStars (..), RealSky (..), Stars (..))

-- | The settings of the sky.
skyFields :: [Field]
skyFields =
  [ number Sky "sky.rotation" (angle (From (-1e6)) (UpTo 1e6) "degrees")
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
      `documented` "Radiance of the bright parts of the random Milky Way; 0 for none"
  ]
  where
    angle = Quantity "an angle"
    features = Quantity "a number of features"
