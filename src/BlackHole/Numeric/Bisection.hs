-- | Bisection of an interval.
module BlackHole.Numeric.Bisection
  ( bisect,
  )
where

-- | @bisect holds low high@ returns the greatest number between @low@ and @high@ at
-- which the condition still holds. The condition must hold at @low@ and stop holding
-- once before @high@. Takes about sixty evaluations.
bisect :: (Double -> Bool) -> Double -> Double -> Double
bisect holds low high
  -- Negated so that NaN ends the search as well.
  | not (middle > low && middle < high) = low
  | holds middle = bisect holds middle high
  | otherwise = bisect holds low middle
  where
    middle = 0.5 * (low + high)
