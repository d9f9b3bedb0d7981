-- | The frequency shifts that a picture shows.
module BlackHole.Scene.Shifts
  ( Shifts (..),
    shiftFactor,
    SkyShift,
    skyShiftAt,
    noSkyShift,
    skyShift,
  )
where

import BlackHole.Matter.Redshift (RedshiftParts (..))

-- | Physically, both shifts apply; a film may leave one out for artistic reasons.
data Shifts = Shifts
  { -- | Whether shifts due to motion are shown.
    shiftsDoppler :: !Bool,
    -- | Whether shifts due to gravity are shown.
    shiftsGravity :: !Bool
  }
  deriving (Eq, Show)

-- | The part of g that applies to light from the gas. The observer's own motion belongs
-- to the gravitational part ('RedshiftParts').
shiftFactor :: Shifts -> RedshiftParts -> Double
shiftFactor (Shifts doppler gravity) shift =
  (if gravity then redshiftGravitational shift else 1)
    * (if doppler then redshiftDoppler shift else 1)
{-# INLINE shiftFactor #-}

-- | The part of g that applies to light from the sky for an observer at one position: a
-- factor, and the divisor of the observer's ν_obs/E∞ if that applies.
data SkyShift
  = SteadyShift {-# UNPACK #-} !Double
  | ShiftByFrequency {-# UNPACK #-} !Double {-# UNPACK #-} !Double

-- | The shift from the ν_obs\/E∞ of an observer at rest at the same place, if there can be
-- one. Where nothing can be at rest, the gravitational part cannot be separated from that
-- of motion.
skyShiftAt :: Shifts -> Maybe Double -> SkyShift
skyShiftAt (Shifts doppler gravity) atRest = case atRest of
  Just static -> shift (if gravity then static else 1) static doppler
  Nothing -> shift 1 1 (doppler || gravity)
  where
    shift factor static moving
      | moving = ShiftByFrequency factor static
      | otherwise = SteadyShift factor

-- | No shift, as without gravity.
noSkyShift :: SkyShift
noSkyShift = SteadyShift 1

-- | The part of g, from the observer's ν_obs/E∞.
skyShift :: SkyShift -> Double -> Double
skyShift (SteadyShift factor) _ = factor
skyShift (ShiftByFrequency factor static) observed = factor * (observed / static)
{-# INLINE skyShift #-}
