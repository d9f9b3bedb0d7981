-- | The interface between the geometry of space, which produces light paths, and
-- everything that shines or absorbs along them.
--
-- A light path is a left fold over its segments ('PathSegment'es), in order from the
-- camera. After each segment the gathering function says whether it wants the next one.
-- Every way to follow light has the type
--
-- > Region -> Photon -> (a -> Stretch -> Onward a) -> a -> Followed a
module BlackHole.Spacetime.LightPath
  ( PathSegment (..),
    segmentLength,
    Continue (..),
    Followed (..),
    Region (..),
    emptyRegion,
    halfHeightAt,
    insideRegion,
  )
where

import BlackHole.Spacetime.Fate (Fate)
import BlackHole.Vector.XYZ (XYZ (..))
import qualified BlackHole.Vector.XYZ as XYZ

-- | A path segment, short compared with the structure of the gas around it.
data PathSegment = PathSegment
  { -- | The middle of the segment, where the gas is evaluated, in Schwarzschild radii.
    segmentMiddle :: {-# UNPACK #-} !XYZ,
    -- | Backward pseudo-velocity at the middle, for unit energy at infinity. Its radial
    -- component is @−k^r@ and its tangential component @−L/r@ of the real momentum.
    segmentVelocity :: {-# UNPACK #-} !XYZ,
    -- | Affine length on the same scale. An observer for whom the light has @ν@ times
    -- its energy at infinity measures @ν@ times this length.
    segmentAffineLength :: {-# UNPACK #-} !Double
  }
  deriving (Eq, Show)

-- | Length in pseudo-space, in Schwarzschild radii.
segmentLength :: PathSegment -> Double
segmentLength (PathSegment _ v affine) = XYZ.norm v * affine
{-# INLINE segmentLength #-}

-- | The gathering function's answer to a segment.
data Continue a
  = -- | Continue with this state.
    Continue !a
  | -- | Stop: what was gathered hides everything behind it.
    Stop !a

-- | The end of a path, the state gathered along it, and the number of steps taken.
data Followed a = Followed
  { followedFate :: !Fate,
    followedState :: !a,
    followedSteps :: !Int
  }

-- | The volume in which something shines or absorbs: around the plane @y = 0@, within a
-- radius, and between two heights that may grow outwards. An integrator need not report
-- segments outside it.
data Region = Region
  { -- | Outer radius, measured from the axis.
    regionRadius :: !Double,
    -- | Distance from the hole inside which there is nothing, at least 0.
    regionInnerRadius :: !Double,
    -- | Half height on the axis; negative for an empty region.
    regionHalfHeight :: !Double,
    -- | Growth of the half height per radius, at least 0.
    regionFlare :: !Double,
    -- | Greatest change of height within one segment, as a fraction of the half height
    -- there. The exact integrators obey this and the next field; the leapfrog has its
    -- own step rule.
    regionVerticalStep :: !Double,
    -- | Greatest length of one segment, as a fraction of the distance from the axis.
    regionLongestStep :: !Double,
    -- | The fraction of the half height within which 'regionVerticalStep' holds. Further
    -- from the plane the segments of 'BlackHole.Spacetime.Schwarzschild.TablePath.followSwept' grow in
    -- proportion to the height.
    regionCore :: !Double
  }
  deriving (Eq, Show)

-- | The empty region.
emptyRegion :: Region
emptyRegion = Region 0 0 (-1) 0 1 1 1

-- | The half height at a distance from the axis.
halfHeightAt :: Region -> Double -> Double
halfHeightAt region rho = regionHalfHeight region + regionFlare region * rho
{-# INLINE halfHeightAt #-}

-- | Whether a point lies in the region.
insideRegion :: Region -> XYZ -> Bool
insideRegion region (XYZ x y z) =
  rho <= regionRadius region
    && abs y <= halfHeightAt region rho
    && rho2 + y * y >= inner * inner
  where
    rho2 = x * x + z * z
    rho = sqrt rho2
    inner = regionInnerRadius region
{-# INLINE insideRegion #-}
