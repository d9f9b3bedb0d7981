-- | The mean effect of octaves of the gas's turbulence that are too fine to be resolved.
module BlackHole.Trace.TurbulenceDetail (turbulenceDetail) where

import BlackHole.Noise.Sheets
import BlackHole.Numeric.Exponential (exponential)
import BlackHole.Numeric.Floor (turnFraction)
import BlackHole.Scene.Disk
import qualified Data.Vector.Unboxed as U

-- | @turbulenceDetail disk noise woven first second len@ is the number of octaves of
-- turbulence that a length (over r) resolves, those whose cells are longer and a fraction
-- of the next; and the corrections to ln density and ln temperature for the mean effect of
-- the finer octaves. The two patterns are given by the angle in turns.
turbulenceDetail ::
  Disk ->
  Sheets ->
  Weave ->
  (Double -> Strand) ->
  (Double -> Strand) ->
  Double ->
  [Double]
turbulenceDetail disk noise woven first second = \len ->
  let count = max 1 (min full (0.4 - logBase 2 (max 1e-9 (diskTurbulenceFrequency disk * len))))
   in [count, density full - density count, heat count]
  where
    moments = turbulenceMoments disk noise woven first second
    full = fromIntegral (diskTurbulenceOctaves disk)
    density = between fst
    heat = between snd
    -- Four values for each octave.
    between part at = case drop (floor (4 * at) :: Int) moments of
      low : high : _ ->
        let t = 4 * at - fromIntegral (floor (4 * at) :: Int)
         in part low + t * (part high - part low)
      [end] -> part end
      [] -> 0

-- | For each number of octaves, in steps of a quarter from none to all: ln of the mean
-- density in turbulence of that many octaves, and a quarter of ln of the mean of T⁴.
-- The means are taken over the noise itself, at as many positions as its second octave
-- has cells.
turbulenceMoments ::
  Disk ->
  Sheets ->
  Weave ->
  (Double -> Strand) ->
  (Double -> Strand) ->
  [(Double, Double)]
turbulenceMoments disk noise woven first second =
  [moments (0.25 * fromIntegral k) | k <- [0 .. 4 * length (sheetsAmplitudes noise)]]
  where
    places = 1024 :: Int
    moments count = (meanOf 1 values, heat)
      where
        heat
          | diskTurbulenceHeat disk == 0 = 0
          | otherwise = 0.25 * meanOf (4 * diskTurbulenceHeat disk) values
        values = U.generate places (\i -> diskTurbulence disk * value count (fromIntegral i))
    meanOf power values = log (U.sum (U.map (exponential . (power *)) values) / fromIntegral places)
    -- Evenly spread (the additive recurrence of the plastic number).
    value count i =
      let turns = turnFraction (0.7548776662466927 * i)
          v = sheetsHeight * turnFraction (0.5698402909980532 * i)
       in weave noise woven count v (first turns) (second turns)
