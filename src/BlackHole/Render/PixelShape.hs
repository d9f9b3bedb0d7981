-- | The measures of an array of pixels and the order of its numbers.
--
-- Pixels lie row after row, the top row first, each row from left to right;
-- the channels of one pixel lie next to each other.
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

-- | @pixelShape width height channels@, or 'Nothing' if one of them is below 1
-- or an array of 64-bit numbers of this shape would have more bytes than an
-- 'Int' can count.
pixelShape :: Int -> Int -> Int -> Maybe PixelShape
pixelShape width height channels
  | all (>= 1) [width, height, channels] && bytes <= toInteger (maxBound :: Int) =
    Just (PixelShape width height channels)
  | otherwise = Nothing
  where
    bytes = 8 * product (map toInteger [width, height, channels])

-- | Pixels per row.
shapeWidth :: PixelShape -> Int
shapeWidth (PixelShape width _ _) = width

-- | Rows.
shapeHeight :: PixelShape -> Int
shapeHeight (PixelShape _ height _) = height

-- | Numbers per pixel.
shapeChannels :: PixelShape -> Int
shapeChannels (PixelShape _ _ channels) = channels

-- | Numbers per row: width × channels.
shapeRowLength :: PixelShape -> Int
shapeRowLength (PixelShape width _ channels) = width * channels

-- | Numbers in all: width × height × channels.
shapeLength :: PixelShape -> Int
shapeLength (PixelShape width height channels) = width * height * channels
