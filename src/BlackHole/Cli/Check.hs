-- | Checks of single option values, with problems in the words of
-- "BlackHole.Scene.Validate".
module BlackHole.Cli.Check
  ( checkNumber,
    checkWhole,
    requireNumber,
  )
where

import BlackHole.Cli.Json (showDouble)
import BlackHole.Scene.Validate (Problem (..))

-- | @checkNumber option good range value@: a problem unless the value is a
-- finite number that is good.
checkNumber :: String -> (Double -> Bool) -> String -> Double -> [Problem]
checkNumber option good range value
  | not (isNaN value || isInfinite value) && good value = []
  | otherwise = [Problem option (showDouble value) range]

-- | The same for a value that must be there.
requireNumber :: String -> (Double -> Bool) -> String -> Maybe Double -> [Problem]
requireNumber option good range = maybe [Problem option "nothing" range] (checkNumber option good range)

-- | @checkWhole option low high unit value@: a problem unless it lies between.
checkWhole :: String -> Int -> Int -> String -> Int -> [Problem]
checkWhole option low high unit value
  | value >= low && value <= high = []
  | otherwise = [Problem option (show value) ("a whole number from " ++ show low ++ " to " ++ show high ++ unit)]
