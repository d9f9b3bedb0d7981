-- | Numbers that accompany a picture, one for each pixel.
module BlackHole.Render.Layer (Layer (..)) where

import BlackHole.Render.PixelArray (PixelArray)

-- | A named array of one channel and the picture's size: redshift, deflection, …
-- Where there is nothing to say of a pixel, its value is NaN.
data Layer = Layer
  { -- | Up to 31 letters and digits of ASCII.
    layerName :: !String,
    layerValues :: !(PixelArray Float)
  }
