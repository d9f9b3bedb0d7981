{-# LANGUAGE BangPatterns #-}

-- | Where to search for the stars in a beam: windows on the faces of a cube around the
-- sphere.
module BlackHole.Trace.StarWindow
  ( Window (..),
    Windows (..),
    windowsThrough,
    kernelRadius,
  )
where

import BlackHole.Trace.RayDifferential
import BlackHole.Vector.XYZ (XYZ (..))
import qualified BlackHole.Vector.XYZ as XYZ

-- | Where 'pixelKernel' ends, in pixels.
kernelRadius :: Double
kernelRadius = 2.5

-- | A rectangle of a face of the cube: the face's number, and the least and
-- greatest of its two coordinates, which on the face are −1 … 1.
data Window = Window !Int !Double !Double !Double !Double
  deriving (Eq, Show)

-- | One window, and those on other faces for a beam that extends beyond one.
data Windows = Windows {-# UNPACK #-} !Window ![Window]
  deriving (Show)

-- | @windowsThrough reach differential@: the windows in which to search for the stars that
-- stand at most @reach@ pixels in each direction from the middle of a beam: one, or one on
-- each face that the beam reaches.
windowsThrough :: Double -> RayDifferential -> Windows
windowsThrough reach (RayDifferential (XYZ dx dy dz) a@(XYZ jx jy jz) b@(XYZ kx ky kz))
  | ax >= ay && ax >= az =
    onFace (if dx >= 0 then Face 0 1 else Face 1 (-1)) dx dy dz jx jy jz kx ky kz
  | ay >= az = onFace (if dy >= 0 then Face 2 1 else Face 3 (-1)) dy dz dx jy jz jx ky kz kx
  | otherwise = onFace (if dz >= 0 then Face 4 1 else Face 5 (-1)) dz dx dy jz jx jy kz kx ky
  where
    !ax = abs dx
    !ay = abs dy
    !az = abs dz
    -- A star lies within this many pixels on the tangent plane, on which it is farther out
    -- than on the sphere.
    !radius = reach * (1 + 2 * reach * reach * (XYZ.dot a a + XYZ.dot b b))
    -- The usual beam lies within one face.
    onFace face w u v jw ju jv kw ku kv = case rectangle face w u v jw ju jv kw ku kv of
      Just window@(Window _ u0 u1 v0 v1)
        | u0 >= -1 && u1 <= 1 && v0 >= -1 && v1 <= 1 -> Windows window []
      _ -> case [ w'
                  | Just w'@(Window _ u0 u1 v0 v1) <- map bounds faces,
                    u0 <= 1,
                    u1 >= -1,
                    v0 <= 1,
                    v1 >= -1
                ] of
        first : others -> Windows first others
        [] -> Windows (Window 0 1 (-1) 1 (-1)) []
    faces = [Face 0 1, Face 1 (-1), Face 2 1, Face 3 (-1), Face 4 1, Face 5 (-1)]
    bounds face@(Face n _)
      | n < 2 = rectangle face dx dy dz jx jy jz kx ky kz
      | n < 4 = rectangle face dy dz dx jy jz jx ky kz kx
      | otherwise = rectangle face dz dx dy jz jx jy kz kx ky
    rectangle (Face n sign) w u v jw ju jv kw ku kv
      | middle + slack <= 0 = Nothing
      | middle <= 1.05 * slack + 0.02 = Just (Window n (-1) 1 (-1) 1)
      | otherwise =
        let nearer = 1 / middle
            fu = u * nearer
            fv = v * nearer
            k = radius / (middle - slack)
            eu = k * (abs (ju - fu * sign * jw) + abs (ku - fu * sign * kw))
            ev = k * (abs (jv - fv * sign * jw) + abs (kv - fv * sign * kw))
         in Just (Window n (fu - eu) (fu + eu) (fv - ev) (fv + ev))
      where
        middle = sign * w
        slack = radius * (abs jw + abs kw)
    {-# INLINE rectangle #-}

-- | A face of the cube, and the sign of its axis.
data Face = Face !Int !Double
