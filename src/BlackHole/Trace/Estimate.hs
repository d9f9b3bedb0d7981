-- | The estimate of a pixel's radiance from its samples, and the uncertainty of that
-- estimate.
module BlackHole.Trace.Estimate
  ( Estimate (..),
    noSamples,
    addSample,
    estimatedRadiance,
    estimatedError,
    seenAs,
  )
where

import BlackHole.Light.Radiance

-- | Sums over samples.
data Estimate = Estimate
  { estimateCount :: {-# UNPACK #-} !Int,
    -- | Sum of the radiances.
    estimateSum :: {-# UNPACK #-} !Radiance,
    -- | Sum of weight times radiance.
    estimateWeighted :: {-# UNPACK #-} !Radiance,
    -- | Sum of the weights.
    estimateWeight :: {-# UNPACK #-} !Double,
    -- | Sum of 'seenAs', and of its square.
    estimateSeen :: {-# UNPACK #-} !Double,
    estimateSeenSquare :: {-# UNPACK #-} !Double
  }
  deriving (Eq, Show)

-- | The estimate without samples.
noSamples :: Estimate
noSamples = Estimate 0 black black 0 0 0

-- | @addSample gain weight radiance estimate@ adds a sample. The gain is the exposure's
-- factor.
addSample :: Double -> Double -> Radiance -> Estimate -> Estimate
addSample gain weight light (Estimate n plain weighted weights seen square) =
  Estimate
    (n + 1)
    (plain <+> light)
    (weighted <+> scaleRadiance weight light)
    (weights + weight)
    (seen + v)
    (square + v * v)
  where
    v = seenAs (gain * luminance light)
{-# INLINE addSample #-}

-- | An approximation to the display's response to an exposed luminance: its square
-- root, limited to twice white.
seenAs :: Double -> Double
seenAs v = sqrt (max 0 (min 4 v))

-- | The weighted mean; black without samples. Weights may be negative. If they nearly
-- cancel, as they can among few samples, all samples count equally.
estimatedRadiance :: Estimate -> Radiance
estimatedRadiance (Estimate n plain weighted weights _ _)
  | n == 0 = black
  | weights >= 0.4 * fromIntegral n = mapRadiance (max 0) (scaleRadiance (1 / weights) weighted)
  | otherwise = scaleRadiance (1 / fromIntegral n) plain

-- | The standard error of the mean, as a fraction of display white; 0 for fewer than
-- two samples. It overestimates the error of evenly spread samples.
estimatedError :: Estimate -> Double
estimatedError (Estimate n _ _ _ seen square)
  | n < 2 = 0
  | otherwise = sqrt (max 0 (square - seen * seen / count) / (count * (count - 1)))
  where
    count = fromIntegral n
