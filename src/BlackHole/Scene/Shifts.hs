-- | Which shifts of frequency a picture shows.
module BlackHole.Scene.Shifts
  ( Shifts (..),
    shiftFactor,
    skyShift,
  )
where

import BlackHole.Physics.Redshift (RedshiftParts (..), staticObserver)

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

-- | The part of g that counts for light from the sky: by the observer's
-- distance from the hole and his ν_obs/E∞. Inside the horizon nobody is at
-- rest, and gravity's part is not to be told from motion's.
skyShift :: Shifts -> Double -> Double -> Double
skyShift (Shifts doppler gravity) r = case staticObserver r of
  Just static -> \observed ->
    (if gravity then static else 1) * (if doppler then observed / static else 1)
  Nothing -> \observed -> if doppler || gravity then observed else 1
