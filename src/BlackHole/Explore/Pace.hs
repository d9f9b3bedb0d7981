-- | How large a picture can be while the camera moves.
module BlackHole.Explore.Pace
  ( Pace,
    initialPace,
    paced,
    movingSize,
    targetSeconds,
    smallestMoving,
  )
where

import BlackHole.Scene.Camera (Picture (..))

-- | What the latest pictures have taken: seconds per pixel, and the number of pixels
-- chosen for the next one.
data Pace = Pace
  { paceCost :: !Double,
    pacePixels :: !Double
  }
  deriving (Eq, Show)

-- | Before the first picture.
initialPace :: Pace
initialPace = Pace 1.3e-6 32400

-- | How long a picture should take from the input to the last byte, in seconds: nineteen
-- pictures a second, of which the slower ones still reach fifteen.
targetSeconds :: Double
targetSeconds = 0.053

-- | The least number of pixels of a picture, however long it takes.
smallestMoving :: Int
smallestMoving = 2304

-- | The pace after a picture with a number of pixels that took a number of seconds. The size
-- changes only by steps of an eighth, so that it does not flicker.
paced :: Int -> Double -> Pace -> Pace
paced pixels seconds (Pace before chosen) =
  Pace cost (if wanted > 1.2 * chosen || wanted < chosen / 1.15 then wanted else chosen)
  where
    cost = 0.7 * before + 0.3 * (seconds / fromIntegral (max 1 pixels))
    wanted = targetSeconds / cost

-- | The size of the next picture in the shape of a window, which it does not exceed.
movingSize :: Pace -> Picture -> Picture
movingSize pace (Picture width height)
  | share >= 1 = Picture width height
  | otherwise = Picture (scaled width) (scaled height)
  where
    pixels = max (fromIntegral smallestMoving) (pacePixels pace)
    share = sqrt (pixels / (fromIntegral width * fromIntegral height)) :: Double
    scaled side = max 1 (min side (round (share * fromIntegral side)))
