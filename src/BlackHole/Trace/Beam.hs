-- | The beam of light that one sample of a picture represents: where on the celestial
-- sphere the line of sight ends, and how that point moves when the line of sight moves
-- by a pixel.
--
-- The two axes of a beam are the columns of the Jacobian from pixels to the sky. The
-- determinant of the Jacobian is the solid angle of sky behind a pixel. The
-- magnification is the solid angle of the pixel as seen from the camera divided by
-- that.
module BlackHole.Trace.Beam
  ( Beam (..),
    beamSolidAngle,
    beamAxes,
    beamExtent,
    beamWidths,
    beamByDifferences,
  )
where

import BlackHole.Vector.XY (XY (..))
import BlackHole.Vector.XYZ (XYZ (..), (*^), (^+^), (^-^))
import qualified BlackHole.Vector.XYZ as XYZ

-- | The end of a line of sight on the celestial sphere, with its neighbourhood.
data Beam = Beam
  { -- | Where the light comes from: the unit vector along which the path escapes when
    -- followed backwards.
    beamDirection :: {-# UNPACK #-} !XYZ,
    -- | The change of that direction per pixel to the right: a vector tangent to the
    -- sphere at 'beamDirection', in radians.
    beamAlongX :: {-# UNPACK #-} !XYZ,
    -- | The change per pixel downwards.
    beamAlongY :: {-# UNPACK #-} !XYZ
  }
  deriving (Eq, Show)

-- | Solid angle of the sky behind one pixel in steradians: negative where the image is
-- mirrored, 0 on a critical curve of the lens.
--
-- The cross product of "right" and "down" in the picture points away from the camera, so
-- an image that is not mirrored counts as positive.
beamSolidAngle :: Beam -> Double
beamSolidAngle (Beam d a b) = XYZ.dot d (XYZ.cross a b)
{-# INLINE beamSolidAngle #-}

-- | The two tangent vectors that measure an offset on the sky in pixels: the rows of
-- the inverse Jacobian. A nearby star in direction @s@ stands @dot x s@ pixels to the
-- right of the sample and @dot y s@ pixels below it. Not finite where 'beamSolidAngle'
-- is 0.
beamAxes :: Beam -> (XYZ, XYZ)
beamAxes beam@(Beam d a b) = (k *^ XYZ.cross b d, k *^ XYZ.cross d a)
  where
    k = 1 / beamSolidAngle beam
{-# INLINE beamAxes #-}

-- | An upper bound, in radians, on the distance from the middle of the beam of anything
-- within one pixel in both directions.
beamExtent :: Beam -> Double
beamExtent (Beam _ a b) = XYZ.norm a + XYZ.norm b
{-# INLINE beamExtent #-}

-- | The longer semi-axis of the beam's ellipse as a vector (radians per pixel), and the
-- length of the shorter one. A pixel offset of length 1 ends on that ellipse.
beamWidths :: Beam -> (XYZ, Double)
beamWidths beam@(Beam _ a b)
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
    minor = abs (beamSolidAngle beam) / sqrt size
{-# INLINE beamWidths #-}

-- | The beam through a point of the picture, in pixels, by finite differences of the
-- directions of escape there and beside it. 'Nothing' if no light arrives from the sky.
-- Where the neighbouring lines of sight on both sides end elsewhere, the beam is as
-- wide as the sky in that direction.
--
-- Costs three to five evaluations and is as accurate as the differences of the
-- directions. Meant for tests and for paths without a lens table.
beamByDifferences :: (XY -> Maybe XYZ) -> XY -> Maybe Beam
beamByDifferences escape (XY x y) = do
  d <- escape (XY x y)
  let change there back = case (escape there, escape back) of
        (Just e, _) -> tangent d ((1 / step) *^ (e ^-^ d))
        (Nothing, Just e) -> tangent d ((1 / step) *^ (d ^-^ e))
        (Nothing, Nothing) -> across d
  pure (Beam d (change (XY (x + step) y) (XY (x - step) y)) (change (XY x (y + step)) (XY x (y - step))))
  where
    step = 1e-3
    tangent d v = v ^-^ XYZ.dot d v *^ d
    -- A tangent vector of about one radian.
    across d@(XYZ dx _ dz) = XYZ.cross d (if abs dx > abs dz then XYZ 0 0 1 else XYZ 1 0 0)
