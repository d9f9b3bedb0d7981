-- | What a light path looks like to whoever gathers light along it: the one
-- interface between the geometry of space and everything that shines.
--
-- A path is handed out as a left fold over 'Stretch'es, in the order in which
-- they are met from the camera. The gatherer says after each one whether it
-- wants the next. Every way to follow light is a function of the shape
--
-- > Region -> Photon -> (a -> Stretch -> Onward a) -> a -> Followed a
module BlackHole.Physics.LightPath
  ( Stretch (..),
    stretchLength,
    Onward (..),
    Followed (..),
    Region (..),
    emptyRegion,
    halfHeightAt,
    insideRegion,
  )
where

import BlackHole.Physics.Fate (Fate)
import BlackHole.Vector.XYZ (XYZ (..))
import qualified BlackHole.Vector.XYZ as XYZ

-- | A piece of a path, short against the structure of the gas around it.
data Stretch = Stretch
  { -- | Its middle, where the gas is evaluated (Schwarzschild radii).
    stretchMiddle :: {-# UNPACK #-} !XYZ,
    -- | Backward pseudo-velocity there for unit energy at infinity: the
    -- radial part is @k^r@ and the tangential part @L/r@ of the real momentum,
    -- both with the sign reversed.
    stretchVelocity :: {-# UNPACK #-} !XYZ,
    -- | Affine length in the same scale. Somebody to whom the light has @ν@
    -- times its energy at infinity measures @ν@ times this length.
    stretchAffineLength :: {-# UNPACK #-} !Double
  }
  deriving (Eq, Show)

-- | Length in pseudo-space, in Schwarzschild radii.
stretchLength :: Stretch -> Double
stretchLength (Stretch _ v affine) = XYZ.norm v * affine
{-# INLINE stretchLength #-}

-- | A gatherer's answer to a stretch.
data Onward a
  = -- | Go on with this state.
    Onward !a
  | -- | What was gathered hides everything behind it.
    Hidden !a

-- | A path's end, what was gathered on the way, and the steps it took.
data Followed a = Followed
  { followedFate :: !Fate,
    followedState :: !a,
    followedSteps :: !Int
  }

-- | Where something shines or absorbs: around the plane @y = 0@, within a
-- radius, and between two heights that may grow outwards. Stretches outside it
-- need not be handed out.
data Region = Region
  { -- | Outer radius, from the axis.
    regionRadius :: !Double,
    -- | Nothing is closer to the hole than this, at least 0.
    regionInnerRadius :: !Double,
    -- | Half height on the axis; negative for an empty region.
    regionHalfHeight :: !Double,
    -- | Growth of the half height per radius, at least 0.
    regionFlare :: !Double,
    -- | Greatest change of height of one stretch, as a fraction of the half
    -- height there. The exact orbits obey this and the next; a step rule such
    -- as the report's has its own idea.
    regionVerticalStep :: !Double,
    -- | Greatest length of one stretch, as a fraction of the distance from the
    -- axis.
    regionLongestStep :: !Double,
    -- | The fraction of the half height within which the first of these two limits
    -- holds; further from the plane the stretches that 'followSwept' cuts grow in
    -- proportion to the height.
    regionCore :: !Double
  }
  deriving (Eq, Show)

-- | Nowhere at all.
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
