-- | Which shifts of frequency a picture shows.
module BlackHole.Scene.Shifts
  ( Shifts (..),
    shiftFactor,
    SkyShift,
    skyShiftAt,
    noSkyShift,
    skyShift,
  )
where

import BlackHole.Physics.Redshift (RedshiftParts (..))

-- | Nature shows both; a film may leave one out.
data Shifts = Shifts
  { -- | Shifts by motion.
    shiftsDoppler :: !Bool,
    -- | Shifts by gravity.
    shiftsGravity :: !Bool
  }
  deriving (Eq, Show)

-- | The part of g that counts for light from the gas. The observer's own
-- motion goes with gravity's part ('RedshiftParts').
shiftFactor :: Shifts -> RedshiftParts -> Double
shiftFactor (Shifts doppler gravity) shift =
  (if gravity then redshiftGravitational shift else 1)
    * (if doppler then redshiftDoppler shift else 1)
{-# INLINE shiftFactor #-}

-- | The part of g that counts for light from the sky, for an observer at one place:
-- a factor, and by what his ν_obs/E∞ is divided if that counts.
data SkyShift
  = SteadyShift {-# UNPACK #-} !Double
  | ShiftByFrequency {-# UNPACK #-} !Double {-# UNPACK #-} !Double

-- | From the ν_obs/E∞ of an observer at rest at the same place, if one can be there. Inside the horizon nobody is at
-- rest, and gravity's part is not to be told from motion's.
skyShiftAt :: Shifts -> Maybe Double -> SkyShift
skyShiftAt (Shifts doppler gravity) atRest = case atRest of
  Just static -> shift (if gravity then static else 1) static doppler
  Nothing -> shift 1 1 (doppler || gravity)
  where
    shift factor static moving
      | moving = ShiftByFrequency factor static
      | otherwise = SteadyShift factor

-- | None, as where there is no gravity.
noSkyShift :: SkyShift
noSkyShift = SteadyShift 1

-- | The part of g, by the observer's ν_obs/E∞.
skyShift :: SkyShift -> Double -> Double
skyShift (SteadyShift factor) _ = factor
skyShift (ShiftByFrequency factor static) observed = factor * (observed / static)
{-# INLINE skyShift #-}
