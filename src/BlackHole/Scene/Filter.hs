-- | Reconstruction filters: the weights of the samples around a pixel.
module BlackHole.Scene.Filter
  ( Filter (..),
    filterName,
  )
where

-- | A reconstruction filter. All are normalised; lengths are in pixels.
data Filter
  = -- | The mean over the pixel's own square.
    Box
  | -- | A Gaussian with a standard deviation of 1\/2, cut off at a distance of 3\/2.
    Gaussian
  | -- | The cubic of Mitchell and Netravali (1988) with B = C = 1\/3 and radius 2. Its
    -- negative lobes keep edges sharp.
    Mitchell
  deriving (Eq, Show, Read, Enum, Bounded)

-- | The filter's name on the command line.
filterName :: Filter -> String
filterName f = case f of
  Box -> "box"
  Gaussian -> "gaussian"
  Mitchell -> "mitchell"
