-- | The camera: its position, its orientation, and the viewing direction of each point
-- of the picture.
module BlackHole.Scene.Camera
  ( Camera (..),
    Pose (..),
    posePosition,
    Frame (..),
    cameraFrame,
    Picture (..),
    PicturePlane,
    picturePlane,
    sightDirection,
    pixelAngle,
  )
where

import BlackHole.Physics.Angle
import BlackHole.Vector.XY (XY (..))
import BlackHole.Vector.XYZ (XYZ (..), (*^), (^+^), (^-^))
import qualified BlackHole.Vector.XYZ as XYZ

-- | A pinhole camera with a flat picture plane.
data Camera = Camera
  { cameraPose :: !Pose,
    -- | Turns the camera clockwise about its line of sight.
    cameraRoll :: !Degrees,
    -- | Angle between the left and the right edge of the picture, in the open interval
    -- (0, 180).
    cameraFieldOfView :: !Degrees
  }
  deriving (Eq, Show)

-- | The camera's position and line of sight.
data Pose
  = -- | On a sphere around the hole, looking at it: distance in Schwarzschild radii,
    -- inclination from the disk's axis @+y@, azimuth @atan2(z, x)@. At azimuth 90° the
    -- camera is at @r·(0, cos i, sin i)@ with @+x@ to its right.
    Around !Double !Degrees !Degrees
  | -- | At a position, looking at another point, with @+y@ upwards.
    LookAt !XYZ !XYZ
  deriving (Eq, Show)

-- | The camera's position in Schwarzschild radii.
posePosition :: Pose -> XYZ
posePosition (LookAt place _) = place
posePosition (Around r inclination azimuth) =
  r *^ XYZ (sin i * cos a) (cos i) (sin i * sin a)
  where
    Radians i = toRadians inclination
    Radians a = toRadians azimuth

-- | The camera's three axes, of unit length and mutually perpendicular.
data Frame = Frame
  { frameForward :: {-# UNPACK #-} !XYZ,
    frameRight :: {-# UNPACK #-} !XYZ,
    frameUp :: {-# UNPACK #-} !XYZ
  }
  deriving (Eq, Show)

-- | The axes of a camera. 'Nothing' if it looks along its own up vector or at its own
-- position, or if a number is not finite.
cameraFrame :: Camera -> Maybe Frame
cameraFrame (Camera pose roll _) = do
  forward <- XYZ.normalize sight
  right <- perpendicular (XYZ.cross forward up)
  pure (rolled forward right (XYZ.cross right forward))
  where
    (sight, up) = case pose of
      LookAt place target -> (target ^-^ place, XYZ 0 1 0)
      -- Up is the direction of decreasing inclination. In the picture this equals +y,
      -- and it is still defined when the camera is above the pole.
      Around _ inclination azimuth ->
        let Radians i = toRadians inclination
            Radians a = toRadians azimuth
         in ( XYZ.negated (posePosition (Around 1 inclination azimuth)),
              XYZ (negate (cos i * cos a)) (sin i) (negate (cos i * sin a))
            )
    -- The sine of the angle between the line of sight and up. Below this limit the
    -- picture's orientation would be rounding noise.
    perpendicular v
      | XYZ.norm v > 1e-9 * XYZ.norm sight = XYZ.normalize v
      | otherwise = Nothing
    rolled forward right above =
      Frame
        forward
        (cos t *^ right ^-^ sin t *^ above)
        (cos t *^ above ^+^ sin t *^ right)
    Radians t = toRadians roll

-- | Size of the picture in pixels.
data Picture = Picture
  { pictureWidth :: !Int,
    pictureHeight :: !Int
  }
  deriving (Eq, Show)

-- | The picture plane in front of the camera, which converts points of the picture to
-- directions.
data PicturePlane = PicturePlane
  { _planeFrame :: !Frame,
    -- | Half the width and height in pixels.
    _planeHalfWidth :: {-# UNPACK #-} !Double,
    _planeHalfHeight :: {-# UNPACK #-} !Double,
    -- | The size of a pixel at distance one.
    _planeScale :: {-# UNPACK #-} !Double
  }

-- | The picture plane of a camera.
picturePlane :: Camera -> Picture -> Frame -> PicturePlane
picturePlane camera (Picture width height) frame =
  PicturePlane frame halfWidth (0.5 * fromIntegral height) (tan (0.5 * fov) / halfWidth)
  where
    halfWidth = 0.5 * fromIntegral width
    Radians fov = toRadians (cameraFieldOfView camera)

-- | The viewing direction, of unit length, through a point of the picture, given in
-- pixels from the top left corner: @XY 0.5 0.5@ is the middle of the first pixel.
-- Pixels are square.
sightDirection :: PicturePlane -> XY -> XYZ
sightDirection (PicturePlane (Frame forward right up) halfWidth halfHeight scale) (XY px py) =
  (1 / XYZ.norm d) *^ d
  where
    d = forward ^+^ ((px - halfWidth) * scale) *^ right ^+^ ((halfHeight - py) * scale) *^ up
{-# INLINE sightDirection #-}

-- | The angle in radians that a pixel in the middle of the picture covers.
pixelAngle :: Camera -> Picture -> Double
pixelAngle camera picture = 2 * tan (0.5 * fov) / fromIntegral (pictureWidth picture)
  where
    Radians fov = toRadians (cameraFieldOfView camera)
