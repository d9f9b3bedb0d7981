-- | What some samples say about a pixel: its radiance, and how sure that is.
module BlackHole.Trace.Estimate
  ( Estimate (..),
    noSamples,
    addSample,
    estimatedRadiance,
    estimatedError,
    standardError,
    sumCount,
    seenPlace,
    forSums,
    estimateFromSums,
    asStored,
  )
where

import BlackHole.Light.Radiance

-- | Sums over samples.
data Estimate = Estimate
  { estimateCount :: {-# UNPACK #-} !Int,
    -- | Of the radiance.
    estimateSum :: {-# UNPACK #-} !Radiance,
    -- | Of weight times radiance.
    estimateWeighted :: {-# UNPACK #-} !Radiance,
    -- | Of the weights.
    estimateWeight :: {-# UNPACK #-} !Double,
    -- | Of 'seenAs', and of its square.
    estimateSeen :: {-# UNPACK #-} !Double,
    estimateSeenSquare :: {-# UNPACK #-} !Double
  }
  deriving (Eq, Show)

-- | None yet.
noSamples :: Estimate
noSamples = Estimate 0 black black 0 0 0

-- | @addSample gain weight radiance estimate@; the gain is the exposure's factor.
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

-- | Roughly what a display makes of an exposed luminance: the square root, and
-- no more than twice white.
seenAs :: Double -> Double
seenAs v = sqrt (max 0 (min 4 v))

-- | The weighted mean; black without samples. Weights may be negative; should
-- they nearly cancel, as they can among few samples, all count alike.
estimatedRadiance :: Estimate -> Radiance
estimatedRadiance (Estimate n plain weighted weights _ _)
  | n == 0 = black
  | weights >= 0.4 * fromIntegral n = mapRadiance (max 0) (scaleRadiance (1 / weights) weighted)
  | otherwise = scaleRadiance (1 / fromIntegral n) plain

-- | The standard error of the mean, as a part of white on a display; 0 for fewer
-- than two samples. Samples spread evenly do better than that.
estimatedError :: Estimate -> Double
estimatedError (Estimate n _ _ _ seen square) = standardError n seen square

-- | The same from the count, 'estimateSeen' and 'estimateSeenSquare'.
standardError :: Int -> Double -> Double -> Double
standardError n seen square
  | n < 2 = 0
  | otherwise = sqrt (max 0 (square - seen * seen / count) / (count * (count - 1)))
  where
    count = fromIntegral n
{-# INLINE standardError #-}

-- | How many numbers 'forSums' hands out.
sumCount :: Int
sumCount = 9

-- | The place of 'estimateSeen' among them; 'estimateSeenSquare' is the next.
seenPlace :: Int
seenPlace = 7

-- | Do something with each of an estimate's sums and its place, from 0; the count
-- is left out.
forSums :: Applicative f => Estimate -> (Int -> Double -> f ()) -> f ()
forSums (Estimate _ (Radiance r g b) (Radiance r' g' b') weights seen square) act =
  act 0 r *> act 1 g *> act 2 b *> act 3 r' *> act 4 g' *> act 5 b' *> act 6 weights *> act seenPlace seen *> act (seenPlace + 1) square
{-# INLINE forSums #-}

-- | From the count and a function from the place of a sum to its value.
estimateFromSums :: Int -> (Int -> Double) -> Estimate
estimateFromSums n at =
  Estimate n (Radiance (at 0) (at 1) (at 2)) (Radiance (at 3) (at 4) (at 5)) (at 6) (at seenPlace) (at (seenPlace + 1))
{-# INLINE estimateFromSums #-}

-- | What a film of single precision keeps of it.
asStored :: Estimate -> Estimate
asStored (Estimate n plain weighted weights seen square) =
  Estimate n (mapRadiance single plain) (mapRadiance single weighted) (single weights) (single seen) (single square)
  where
    single v = realToFrac (realToFrac v :: Float)
