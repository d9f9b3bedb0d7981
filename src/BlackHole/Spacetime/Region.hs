-- | The volume around the disk's plane in which light paths meet something.
module BlackHole.Spacetime.Region
  ( Region (..),
    emptyRegion,
    halfHeightAt,
    insideRegion,
  )
where

import BlackHole.Vector.XYZ (XYZ (..))

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
    -- from the plane the segments of a tabulated path
    -- ('BlackHole.Spacetime.Schwarzschild.TablePath.followTable') grow in proportion to the
    -- height.
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
