-- | How exactly the closed form of a light path is evaluated.
module BlackHole.Spacetime.Kerr.Precision (Precision (..)) where

-- | The accuracy of azimuths and latitudes.
data Precision
  = -- | To rounding.
    FullPrecision
  | -- | To about 1e-8, in half the time.
    PicturePrecision
