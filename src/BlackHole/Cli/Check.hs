-- | Range checks for the values of single options.
module BlackHole.Cli.Check
  ( checkNumber,
    checkWhole,
    checkThreads,
  )
where

import BlackHole.Cli.Json (showDouble)
import BlackHole.Render.Workers (maximumWorkers, workersFromCount)
import BlackHole.Scene.Validate (Problem (..))

-- | @checkNumber option good range value@: a problem unless the value is a finite number
-- that satisfies the predicate. The range is a noun phrase.
checkNumber :: String -> (Double -> Bool) -> String -> Double -> [Problem]
checkNumber option good range value
  | not (isNaN value || isInfinite value) && good value = []
  | otherwise = [Problem option (showDouble value) range]

-- | @checkWhole option low high unit value@: a problem unless @low <= value <= high@.
checkWhole :: String -> Int -> Int -> String -> Int -> [Problem]
checkWhole option low high unit value
  | value >= low && value <= high = []
  | otherwise =
    [ Problem
        option
        (show value)
        ("a whole number from " ++ show low ++ " to " ++ show high ++ unit)
    ]

-- | The problems of a value of @--threads@.
checkThreads :: Maybe Int -> [Problem]
checkThreads threads =
  [ Problem "--threads" (show n) ("a whole number from 1 to " ++ show maximumWorkers)
    | Just n <- [threads],
      Nothing <- [workersFromCount n]
  ]
