{-# LANGUAGE BangPatterns #-}

-- | The plane of a light path around a hole that does not rotate, the start of the path
-- in it, and where it crosses the disk's plane.
module BlackHole.Spacetime.PathPlane
  ( PathPlane (..),
    inSpace,
    onwardAt,
    Launch (..),
    launch,
    firstCrossing,
    meetsDiskPlane,
  )
where

import BlackHole.Numeric.Angle (arcTangent2)
import BlackHole.Spacetime.Photon
import BlackHole.Vector.XY (XY (..))
import BlackHole.Vector.XYZ (XYZ (..), (*^), (^+^), (^-^))
import qualified BlackHole.Vector.XYZ as XYZ

-- | Two orthogonal unit vectors: e₁ from the hole to the start of the path, and e₂ in
-- the direction in which the path goes round the hole. After the swept angle φ the path
-- is at @r(φ) (cos φ e₁ + sin φ e₂)@.
data PathPlane
  = PathPlane
      {-# UNPACK #-} !XYZ
      {-# UNPACK #-} !XYZ
  deriving (Eq, Show)

-- | The vector with these components along e₁ and e₂.
inSpace :: PathPlane -> XY -> XYZ
inSpace (PathPlane e1 e2) (XY a b) = a *^ e1 ^+^ b *^ e2
{-# INLINE inSpace #-}

-- | The unit vector around the hole, from the cosine and sine of the swept angle.
onwardAt :: PathPlane -> Double -> Double -> XYZ
onwardAt (PathPlane e1 e2) c s = c *^ e2 ^-^ s *^ e1
{-# INLINE onwardAt #-}

-- | The start of a photon: its plane, and its velocity along e₁ and e₂.
data Launch = Launch
  { launchPlane :: {-# UNPACK #-} !PathPlane,
    launchRadial :: {-# UNPACK #-} !Double,
    -- | Above 0.
    launchTangential :: {-# UNPACK #-} !Double
  }

-- | @launch r photon@ is the start of a photon at the distance @r@ from the hole. A
-- photon that moves straight towards the hole or away from it sweeps no angle, so its
-- neighbour within 1e-9 radians, in an arbitrary plane, replaces it.
launch :: Double -> Photon -> Launch
launch !r (Photon place velocity)
  | across2 > 1e-18 * XYZ.normSquared velocity =
    let t = sqrt across2 in Launch (PathPlane e1 ((1 / t) *^ across)) radial t
  | otherwise = Launch (PathPlane e1 (XYZ.perpendicular e1)) radial (1e-9 * XYZ.norm velocity)
  where
    !e1 = (1 / r) *^ place
    !radial = XYZ.dot velocity e1
    !across = velocity ^-^ radial *^ e1
    !across2 = XYZ.normSquared across
{-# INLINE launch #-}

-- | The first swept angle after the start, in radians, at which a path crosses the
-- disk's plane @y = 0@; the crossings are half a turn apart, because the height is
-- @r (e₁ cos φ + e₂ sin φ)·y@. A start in the plane does not count.
firstCrossing :: PathPlane -> Double
firstCrossing (PathPlane (XYZ _ height1 _) (XYZ _ height2 _))
  | ahead < 1e-12 = ahead + pi
  | otherwise = ahead
  where
    angle = arcTangent2 (negate height1) height2
    ahead = if angle < 0 then angle + pi else angle
{-# INLINE firstCrossing #-}

-- | Whether the path crosses the disk's plane rather than lying in it.
meetsDiskPlane :: PathPlane -> Bool
meetsDiskPlane (PathPlane (XYZ _ height1 _) (XYZ _ height2 _)) =
  max (abs height1) (abs height2) > 1e-12
