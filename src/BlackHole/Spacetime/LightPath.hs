-- | The interface between the geometry of space, which produces light paths, and
-- everything that shines or absorbs along them.
--
-- A light path is a left fold over its segments ('PathSegment'es), in order from the
-- camera. After each segment the gathering function says whether it wants the next one.
-- Every way to follow light has the type
--
-- > Region -> Photon -> (a -> PathSegment -> Continue a) -> a -> Followed a
module BlackHole.Spacetime.LightPath
  ( PathSegment (..),
    planarSegment,
    Continue (..),
    Followed (..),
    module BlackHole.Spacetime.Region,
  )
where

import BlackHole.Spacetime.Fate (Fate)
import BlackHole.Spacetime.Momentum
import BlackHole.Spacetime.Photon
import BlackHole.Spacetime.Region
import BlackHole.Vector.XYZ (XYZ (..))
import qualified BlackHole.Vector.XYZ as XYZ

-- | A path segment, short compared with the structure of the gas around it.
data PathSegment = PathSegment
  { -- | The middle of the segment, where the gas is evaluated, in Schwarzschild radii.
    segmentMiddle :: {-# UNPACK #-} !XYZ,
    -- | The distance of the middle from the hole.
    segmentRadius :: {-# UNPACK #-} !Double,
    -- | Affine length for unit energy at infinity. An observer for whom the light has
    -- @ν@ times its energy at infinity measures @ν@ times this length.
    segmentAffineLength :: {-# UNPACK #-} !Double,
    -- | Length in space as a picture draws it, in Schwarzschild radii.
    segmentLength :: {-# UNPACK #-} !Double,
    -- | The change of the radius along the segment, backwards in time.
    segmentRadialStep :: {-# UNPACK #-} !Double,
    -- | The change of the height above the disk's plane along the segment.
    segmentVerticalStep :: {-# UNPACK #-} !Double,
    -- | The momentum of the real photon at the middle.
    segmentMomentum :: {-# UNPACK #-} !Momentum
  }
  deriving (Eq, Show)

-- | The segment of a photon of unit energy around a hole without spin: from its place
-- and backward pseudo-velocity in the middle of the segment, and the affine length.
planarSegment :: Photon -> Double -> PathSegment
planarSegment (Photon middle@(XYZ x _ z) velocity@(XYZ vx vy vz)) affine =
  PathSegment
    { segmentMiddle = middle,
      segmentRadius = r,
      segmentAffineLength = affine,
      segmentLength = affine * XYZ.norm velocity,
      segmentRadialStep = affine * radial / r,
      segmentVerticalStep = affine * vy,
      segmentMomentum = Momentum (negate radial / (r - 1)) (x * vz - z * vx)
    }
  where
    r = XYZ.norm middle
    radial = XYZ.dot middle velocity
{-# INLINE planarSegment #-}

-- | The gathering function's answer to a segment.
data Continue a
  = -- | Continue with this state.
    Continue !a
  | -- | Stop: what was gathered hides everything behind it.
    Stop !a

-- | The end of a path, the state gathered along it, and the number of steps taken.
data Followed a = Followed
  { followedFate :: !(Fate XYZ),
    followedState :: !a,
    followedSteps :: !Int
  }
