{-# LANGUAGE DeriveFunctor #-}

-- | Points at which light paths cross the disk's plane @y = 0@.
module BlackHole.Spacetime.PlaneCrossing
  ( PlaneCrossing (..),
    crossingOf,
    planeAzimuth,
    wrappedAngle,
    crossingDifference,
  )
where

import BlackHole.Spacetime.Momentum
import BlackHole.Spacetime.Photon
import BlackHole.Vector.XYZ (XYZ (..))
import qualified BlackHole.Vector.XYZ as XYZ

-- | A crossing, with what is known of the light there: its momentum or, once the gas is
-- known, its shift.
data PlaneCrossing light = PlaneCrossing
  { -- | In Schwarzschild radii.
    crossingRadius :: !Double,
    -- | @atan2 z x@ in [−π, π), in radians.
    crossingAzimuth :: !Double,
    crossingLight :: !light
  }
  deriving (Eq, Show, Functor)

-- | The crossing of a photon that is followed backwards around a hole without spin and
-- stands in the plane. At and inside the horizon it has no momentum.
crossingOf :: Photon -> PlaneCrossing (Maybe Momentum)
crossingOf (Photon place velocity) =
  PlaneCrossing
    { crossingRadius = XYZ.norm place,
      crossingAzimuth = planeAzimuth place,
      -- The light itself travels the other way.
      crossingLight = momentumOf (Photon place (XYZ.negated velocity))
    }

-- | The azimuth of a position in the disk's plane, in [−π, π). Positions on the seam up
-- to rounding have −π.
planeAzimuth :: XYZ -> Double
planeAzimuth (XYZ x _ z)
  | angle > 3.141592653589792 = -pi
  | otherwise = angle
  where
    angle = atan2 z x

-- | An angle between −3π and 3π as one between −π and π.
wrappedAngle :: Double -> Double
wrappedAngle angle
  | angle > pi = angle - 2 * pi
  | angle <= -pi = angle + 2 * pi
  | otherwise = angle

-- | The differences of radius, azimuth and shift between two crossings.
crossingDifference :: PlaneCrossing Double -> PlaneCrossing Double -> PlaneCrossing Double
crossingDifference (PlaneCrossing r azimuth g) (PlaneCrossing r' azimuth' g') =
  PlaneCrossing (r - r') (wrappedAngle (azimuth - azimuth')) (g - g')
