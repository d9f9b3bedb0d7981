-- | The camera: its position, its orientation, and the viewing direction of each point
-- of the picture.
module BlackHole.Scene.Camera
  ( Camera (..),
    Pose (..),
    posePosition,
    Frame (..),
    cameraFrame,
    Picture (..),
    Projection (..),
    projectionName,
    projectionFieldOfView,
    projectionHeight,
    PicturePlane,
    picturePlane,
    shiftedPlane,
    sightDirection,
    sightBeside,
    closesAround,
    pixelAngle,
    pixelMiddle,
  )
where

import BlackHole.Numeric.Angle
import BlackHole.Vector.XY (XY (..))
import BlackHole.Vector.XYZ (XYZ (..), (*^), (^+^), (^-^))
import qualified BlackHole.Vector.XYZ as XYZ

-- | A camera: where it stands, which way is up, and how wide it sees.
data Camera = Camera
  { cameraPose :: !Pose,
    -- | Turns the camera clockwise about its line of sight.
    cameraRoll :: !Degrees,
    -- | Angle of view across the picture's width: (0, 180) in perspective, (0, 360]
    -- for the other projections.
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

-- | How directions of sight are laid out in the picture. Pixels are square in each.
data Projection
  = -- | On a flat plane before a pinhole: straight lines stay straight.
    Perspective
  | -- | The equidistant fisheye, which planetariums project onto their domes: the
    -- distance from the middle is proportional to the angle from the line of sight.
    -- The angle of view is the diameter of a circle as wide as the picture, outside
    -- of which the picture is black.
    Fisheye
  | -- | Longitude to the right and latitude upwards, both from the line of sight, in
    -- proportion: the format of VR pictures and of maps of the sky.
    Equirectangular
  deriving (Eq, Show, Read, Enum, Bounded)

-- | The name on the command line.
projectionName :: Projection -> String
projectionName projection = case projection of
  Perspective -> "perspective"
  Fisheye -> "fisheye"
  Equirectangular -> "equirectangular"

-- | The angle of view that a projection is usually made for: that of a lens, of a
-- dome, of the whole sphere.
projectionFieldOfView :: Projection -> Degrees
projectionFieldOfView projection = case projection of
  Perspective -> Degrees 50
  Fisheye -> Degrees 180
  Equirectangular -> Degrees 360

-- | The height that goes with a width: 9\/16 of it in perspective, the same for a
-- fisheye, half of it for a sphere. At least 1.
projectionHeight :: Projection -> Int -> Int
projectionHeight projection width = max 1 . round $ case projection of
  Perspective -> fromIntegral width * 9 / 16 :: Double
  Fisheye -> fromIntegral width
  Equirectangular -> fromIntegral width / 2

-- | The picture in front of the eye: how to get from its points to directions.
data PicturePlane = PicturePlane
  { _planeProjection :: !Projection,
    _planeFrame :: !Frame,
    -- | Half the width and height, in pixels.
    _planeHalfWidth :: {-# UNPACK #-} !Double,
    _planeHalfHeight :: {-# UNPACK #-} !Double,
    -- | Size of a pixel in the middle: at distance one, or in radians.
    _planeScale :: {-# UNPACK #-} !Double
  }

-- | The plane of a camera's picture.
picturePlane :: Projection -> Camera -> Picture -> Frame -> PicturePlane
picturePlane projection camera picture@(Picture width height) frame =
  PicturePlane
    projection
    frame
    (0.5 * fromIntegral width)
    (0.5 * fromIntegral height)
    (pixelScale projection camera picture)

-- | @shiftedPlane right up plane@: the plane of a picture in perspective, with each direction
-- so many pixels farther right and up. Other projections have no such shift.
shiftedPlane :: Double -> Double -> PicturePlane -> PicturePlane
shiftedPlane right up (PicturePlane projection frame halfWidth halfHeight scale) =
  PicturePlane projection frame (halfWidth + right) (halfHeight - up) scale

-- | The size of a pixel in the middle of the picture: at distance one in perspective,
-- else in radians.
pixelScale :: Projection -> Camera -> Picture -> Double
pixelScale projection camera (Picture width _) = case projection of
  Perspective -> tan (0.5 * fov) / halfWidth
  _ -> 0.5 * fov / halfWidth
  where
    halfWidth = 0.5 * fromIntegral width
    Radians fov = toRadians (cameraFieldOfView camera)

-- | The direction of sight (unit length) through a point of the picture,
-- given in pixels from its top left corner: @XY 0.5 0.5@ is the middle of the
-- first pixel. 'Nothing' outside a fisheye's circle. Beyond its left or right edge
-- an equirectangular picture goes on around the sphere, and beyond its upper and
-- lower edge over the pole.
sightDirection :: PicturePlane -> XY -> Maybe XYZ
sightDirection plane@(PicturePlane projection frame halfWidth halfHeight scale) (XY px py) =
  case projection of
    Perspective ->
      Just $! flatDirection frame ((px - halfWidth) * scale) ((halfHeight - py) * scale)
    _ -> curvedDirection plane (px - halfWidth) (py - halfHeight)
{-# INLINE sightDirection #-}

flatDirection :: Frame -> Double -> Double -> XYZ
flatDirection (Frame forward right up) x y = (1 / XYZ.norm d) *^ d
  where
    d = forward ^+^ x *^ right ^+^ y *^ up
{-# INLINE flatDirection #-}

-- Not for inlining: the flat picture's code would grow by it.
curvedDirection :: PicturePlane -> Double -> Double -> Maybe XYZ
curvedDirection plane x y = (\(Tangent direction _ _) -> direction) <$> curvedTangent plane x y
{-# NOINLINE curvedDirection #-}

-- | @sightBeside plane point offset@: the direction of sight at an offset in pixels
-- from a point, for what depends on a pixel's size. Where a projection stretches the
-- picture, as towards the poles of a map, such pixels keep the size and the shape that
-- they have in its middle: so a star is a round spot of light everywhere once the
-- picture is back on its sphere or dome. In perspective it is
-- 'sightDirection' of the sum.
sightBeside :: PicturePlane -> XY -> XY -> Maybe XYZ
sightBeside plane@(PicturePlane projection _ halfWidth halfHeight scale) (XY px py) (XY dx dy) =
  case projection of
    Perspective -> sightDirection plane (XY (px + dx) (py + dy))
    _ ->
      curvedTangent plane (px - halfWidth) (py - halfHeight) >>= \(Tangent d right down) ->
        XYZ.normalize (d ^+^ (scale * dx) *^ right ^+^ (scale * dy) *^ down)
{-# INLINE sightBeside #-}

-- | A direction, and the unit vectors across it that stand for the picture's
-- directions to the right and downwards.
data Tangent = Tangent !XYZ !XYZ !XYZ

-- | By the offset in pixels from the picture's middle, to the right and downwards.
curvedTangent :: PicturePlane -> Double -> Double -> Maybe Tangent
curvedTangent (PicturePlane projection (Frame forward right up) halfWidth _ scale) x y =
  case projection of
    Fisheye
      | radius > halfWidth -> Nothing
      | otherwise ->
        let -- In the middle no direction is outwards; any will do.
            (c, s) = if radius > 0 then (x / radius, y / radius) else (1, 0)
            theta = radius * scale
            outwards = c *^ right ^-^ s *^ up
            around = negate s *^ right ^-^ c *^ up
            away = cos theta *^ outwards ^-^ sin theta *^ forward
         in Just
              ( Tangent
                  (cos theta *^ forward ^+^ sin theta *^ outwards)
                  (c *^ away ^-^ s *^ around)
                  (s *^ away ^+^ c *^ around)
              )
    _ ->
      let longitude = x * scale
          latitude = negate y * scale
          level = cos longitude *^ forward ^+^ sin longitude *^ right
       in Just $
            Tangent
              (cos latitude *^ level ^+^ sin latitude *^ up)
              (cos longitude *^ right ^-^ sin longitude *^ forward)
              (sin latitude *^ level ^-^ cos latitude *^ up)
  where
    radius = sqrt (x * x + y * y)

-- | Whether the picture's left and right edge are the same line.
closesAround :: Projection -> Camera -> Bool
closesAround projection camera =
  projection == Equirectangular && cameraFieldOfView camera == Degrees 360

-- | The angle that a pixel in the middle of the picture covers, in radians.
pixelAngle :: Projection -> Camera -> Picture -> Double
pixelAngle Perspective camera picture = 2 * tan (0.5 * fov) / fromIntegral (pictureWidth picture)
  where
    Radians fov = toRadians (cameraFieldOfView camera)
pixelAngle projection camera picture = pixelScale projection camera picture

-- | The middle of the pixel in a column and a row, in pixels from the picture's top left
-- corner.
pixelMiddle :: Int -> Int -> XY
pixelMiddle column row = XY (fromIntegral column + 0.5) (fromIntegral row + 0.5)
{-# INLINE pixelMiddle #-}
