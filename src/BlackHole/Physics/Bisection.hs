-- | Finding where something changes.
module BlackHole.Physics.Bisection
  ( bisect,
  )
where

-- | @bisect holds low high@: the greatest number in between at which a
-- condition still holds that holds at the lower end and stops to hold
-- somewhere before the upper one. About sixty trials.
bisect :: (Double -> Bool) -> Double -> Double -> Double
bisect holds low high
  -- Also true for what is no number.
  | not (middle > low && middle < high) = low
  | holds middle = bisect holds middle high
  | otherwise = bisect holds low middle
  where
    middle = 0.5 * (low + high)
