{-# LANGUAGE BangPatterns #-}

-- | The beam of light that one sample of a picture represents: where on the celestial
-- sphere the line of sight ends, and how that point moves when the line of sight moves
-- by a pixel.
--
-- The two axes of a beam are the columns of the Jacobian from pixels to the sky. The
-- determinant of the Jacobian is the solid angle of sky behind a pixel. The
-- magnification is the solid angle of the pixel as seen from the camera divided by
-- that.
module BlackHole.Trace.RayDifferential
  ( RayDifferential (..),
    differentialSolidAngle,
    differentialAxes,
    differentialExtent,
    differentialWidths,
    differentialByDifferences,
    turned,
  )
where

import BlackHole.Vector.XY (XY (..))
import BlackHole.Vector.XYZ (XYZ (..), (*^), (^+^), (^-^))
import qualified BlackHole.Vector.XYZ as XYZ

-- | The end of a line of sight on the celestial sphere, with its neighbourhood.
data RayDifferential = RayDifferential
  { -- | Where the light comes from: the unit vector along which the path escapes when
    -- followed backwards.
    differentialDirection :: {-# UNPACK #-} !XYZ,
    -- | The change of that direction per pixel to the right: a vector tangent to the
    -- sphere at 'differentialDirection', in radians.
    differentialAlongX :: {-# UNPACK #-} !XYZ,
    -- | The change per pixel downwards.
    differentialAlongY :: {-# UNPACK #-} !XYZ
  }
  deriving (Eq, Show)

-- | Solid angle of the sky behind one pixel in steradians: negative where the image is
-- mirrored, 0 on a critical curve of the lens.
--
-- The cross product of "right" and "down" in the picture points away from the camera, so
-- an image that is not mirrored counts as positive.
differentialSolidAngle :: RayDifferential -> Double
differentialSolidAngle (RayDifferential d a b) = XYZ.dot d (XYZ.cross a b)
{-# INLINE differentialSolidAngle #-}

-- | The two tangent vectors that measure an offset on the sky in pixels: the rows of
-- the inverse Jacobian. A nearby star in direction @s@ stands @dot x s@ pixels to the
-- right of the sample and @dot y s@ pixels below it. Not finite where 'differentialSolidAngle'
-- is 0.
differentialAxes :: RayDifferential -> (XYZ, XYZ)
differentialAxes differential@(RayDifferential d a b) = (k *^ XYZ.cross b d, k *^ XYZ.cross d a)
  where
    k = 1 / differentialSolidAngle differential
{-# INLINE differentialAxes #-}

-- | An upper bound, in radians, on the distance from the middle of the beam of anything
-- within one pixel in both directions.
differentialExtent :: RayDifferential -> Double
differentialExtent (RayDifferential _ a b) = XYZ.norm a + XYZ.norm b
{-# INLINE differentialExtent #-}

-- | The longer semi-axis of the beam's ellipse as a vector (radians per pixel), and the
-- length of the shorter one. A pixel offset of length 1 ends on that ellipse.
differentialWidths :: RayDifferential -> (XYZ, Double)
differentialWidths differential@(RayDifferential _ a b)
  | size > 0 = (major, minor)
  | otherwise = (a, 0)
  where
    aa = XYZ.dot a a
    bb = XYZ.dot b b
    ab = XYZ.dot a b
    -- The larger eigenvalue of the metric that the beam induces on pixels.
    half = 0.5 * (aa - bb)
    swing = sqrt (half * half + ab * ab)
    size = 0.5 * (aa + bb) + swing
    -- Its eigenvector, from the row without cancellation.
    (p, q)
      | half >= 0 = (half + swing, ab)
      | otherwise = (ab, swing - half)
    n = sqrt (p * p + q * q)
    major
      | n > 0 = (1 / n) *^ (p *^ a ^+^ q *^ b)
      | otherwise = a
    minor = abs (differentialSolidAngle differential) / sqrt size
{-# INLINE differentialWidths #-}

-- | The beam through a point of the picture, in pixels, by finite differences of the
-- directions of escape there and beside it. 'Nothing' if no light arrives from the sky.
-- Where the neighbouring lines of sight on both sides end elsewhere, the beam is as
-- wide as the sky in that direction.
--
-- Costs three to five evaluations and is as accurate as the differences of the
-- directions. Meant for tests and for paths without a lens table.
differentialByDifferences :: (XY -> Maybe XYZ) -> XY -> Maybe RayDifferential
differentialByDifferences escape (XY x y) = do
  d <- escape (XY x y)
  let change there back = case (escape there, escape back) of
        (Just e, _) -> tangent d ((1 / step) *^ (e ^-^ d))
        (Nothing, Just e) -> tangent d ((1 / step) *^ (d ^-^ e))
        (Nothing, Nothing) -> across d
  pure
    ( RayDifferential
        d
        (change (XY (x + step) y) (XY (x - step) y))
        (change (XY x (y + step)) (XY x (y - step)))
    )
  where
    step = 1e-3
    tangent d v = v ^-^ XYZ.dot d v *^ d
    -- A tangent vector of about one radian.
    across d@(XYZ dx _ dz) = XYZ.cross d (if abs dx > abs dz then XYZ 0 0 1 else XYZ 1 0 0)

-- | The beam under which a picture turned about the axis +y by an angle in
-- radians shows what it shows at this one unturned. A positive angle moves the
-- picture's middle from −z towards +x.
turned :: Double -> RayDifferential -> RayDifferential
turned angle
  | angle == 0 = id
  | otherwise = \(RayDifferential d a b) -> RayDifferential (back d) (back a) (back b)
  where
    !c = cos angle
    !s = sin angle
    back (XYZ x y z) = XYZ (c * x + s * z) y (c * z - s * x)
