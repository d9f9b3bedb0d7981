-- | The frequency shifts that a picture shows.
module BlackHole.Scene.Shifts
  ( Shifts (..),
    SkyShift,
    skyShiftAt,
    skyShift,
  )
where

-- | Physically, both shifts apply; a film may leave one out for artistic reasons.
data Shifts = Shifts
  { -- | Whether shifts due to motion are shown.
    shiftsDoppler :: !Bool,
    -- | Whether shifts due to gravity are shown.
    shiftsGravity :: !Bool
  }
  deriving (Eq, Show)

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

-- | The part of g, from the observer's ν_obs/E∞.
skyShift :: SkyShift -> Double -> Double
skyShift (SteadyShift factor) _ = factor
skyShift (ShiftByFrequency factor static) observed = factor * (observed / static)
{-# INLINE skyShift #-}
