-- | The dimensions of a pixel array, and the order of its numbers.
--
-- Pixels are stored row by row from the top, and each row from left to right. The
-- channels of one pixel are adjacent.
module BlackHole.Render.PixelShape
  ( PixelShape,
    pixelShape,
    shapeWidth,
    shapeHeight,
    shapeChannels,
    shapeRowLength,
    shapeLength,
  )
where

-- | Width, height and channels per pixel, each at least 1.
data PixelShape = PixelShape !Int !Int !Int
  deriving (Eq, Ord, Show)

-- | @pixelShape width height channels@; 'Nothing' if a dimension is below 1, or if the
-- size in bytes of an array of 64-bit numbers of this shape would overflow an 'Int'.
pixelShape :: Int -> Int -> Int -> Maybe PixelShape
pixelShape width height channels
  | all (>= 1) [width, height, channels] && bytes <= toInteger (maxBound :: Int) =
    Just (PixelShape width height channels)
  | otherwise = Nothing
  where
    bytes = 8 * product (map toInteger [width, height, channels])

-- | Number of pixels per row.
shapeWidth :: PixelShape -> Int
shapeWidth (PixelShape width _ _) = width

-- | Number of rows.
shapeHeight :: PixelShape -> Int
shapeHeight (PixelShape _ height _) = height

-- | Number of channels per pixel.
shapeChannels :: PixelShape -> Int
shapeChannels (PixelShape _ _ channels) = channels

-- | Number of array elements per row: width × channels.
shapeRowLength :: PixelShape -> Int
shapeRowLength (PixelShape width _ channels) = width * channels

-- | Total number of array elements: width × height × channels.
shapeLength :: PixelShape -> Int
shapeLength (PixelShape width height channels) = width * height * channels
