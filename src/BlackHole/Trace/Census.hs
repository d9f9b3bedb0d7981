{-# LANGUAGE BangPatterns #-}

-- | What the light of a picture took, estimated from lines of sight that are spread
-- evenly over it. The rendering itself counts nothing, since that would slow it down.
module BlackHole.Trace.Census
  ( Census (..),
    census,
    Mean (..),
  )
where

import BlackHole.Physics.Fate
import BlackHole.Physics.LightPath (Followed (..), Onward (..))
import BlackHole.Scene.Camera (Picture (..))
import BlackHole.Scene.Scene
import BlackHole.Trace.Adaptive (pixelEstimate)
import BlackHole.Trace.Estimate (estimateCount)
import BlackHole.Trace.Explain (gatheredAlong)
import BlackHole.Trace.Pixel
import BlackHole.Trace.SkyImage (SkyImage)
import BlackHole.Vector.XY (XY (..))
import qualified BlackHole.Vector.XYZ as XYZ
import Data.Maybe (isNothing)

-- | The mean of a number over the lines of sight looked at, and its standard error.
data Mean = Mean !Double !Double
  deriving (Eq, Show)

-- | Numbers of a picture.
data Census = Census
  { -- | How many lines of sight were looked at.
    censusLines :: !Int,
    -- | Rays of a pixel. Exact unless their number follows the uncertainty.
    censusRays :: !Mean,
    -- | Steps of the integrator on a ray: stretches handed to the gatherer, or the
    -- leapfrog's steps. Rays through empty space by the table take none.
    censusSteps :: !Mean,
    -- | Stretches of a ray in which there was gas.
    censusGasSamples :: !Mean,
    -- | The greatest angle in radians between the direction in which a ray leaves
    -- and that of the closed form, over the rays that leave in both.
    censusDirectionError :: !Double,
    -- | Rays that end in the hole in one of the two alone.
    censusOtherFates :: !Int
  }
  deriving (Eq, Show)

-- | Look at a thousand lines of sight, or at every pixel's of a smaller band: the
-- first row and the number of rows. 'Nothing' for a scene that cannot be traced
-- ('tracerUnder') and for an empty band. As much work as three rays for each, and with
-- adaptive sampling as nine pixels.
census :: Maybe SkyImage -> Scene -> (Int, Int) -> Maybe Census
census picture scene (first, rows)
  | rows <= 0 || width <= 0 = Nothing
  | otherwise = do
    traced <- tracerUnder picture scene
    exact <- tracerUnder picture scene {sceneIntegrator = Exact, sceneDisk = Nothing}
    let looks = [look traced exact column row | row <- spread first rows down, column <- spread 0 width across]
    pure
      Census
        { censusLines = length looks,
          censusRays = if adaptive then meanOf [fromIntegral (lookRays l) | l <- looks] else Mean (fromIntegral (sceneSamples scene)) 0,
          censusSteps = meanOf [fromIntegral (lookSteps l) | l <- looks],
          censusGasSamples = meanOf [fromIntegral (lookGas l) | l <- looks],
          censusDirectionError = maximum (0 : [e | Look _ _ _ (Apart e) <- looks]),
          censusOtherFates = length [() | Look _ _ _ Otherwise <- looks]
        }
  where
    Picture width _ = scenePicture scene
    adaptive = mostSamples scene > sceneSamples scene
    -- About a thousand, in squares.
    side = max 1 (sqrt (fromIntegral (width * rows) / 1000)) :: Double
    across = max 1 (min width (round (fromIntegral width / side)))
    down = max 1 (min rows (round (fromIntegral rows / side)))
    look traced exact !column !row =
      let point = XY (fromIntegral column + 0.5) (fromIntegral row + 0.5)
          rays = if adaptive then estimateCount (pixelEstimate traced column row) else sceneSamples scene
       in case (tracedSight traced point, tracedSight exact point) of
            (Just sight, Just sight') ->
              let (fate, steps, gasSamples) = gatheredAlong traced point sight
                  right = followedFate (followSight exact point sight' (\() _ -> Onward ()) ())
               in Look rays (if direct then 0 else steps) gasSamples (apart fate right)
            _ -> Look rays 0 0 Alike
    -- The table tells the ends of such rays at once.
    direct = sceneIntegrator scene == Tabulated && isNothing (sceneDisk scene)

-- | The middles of so many equal parts of a row of pixels.
spread :: Int -> Int -> Int -> [Int]
spread first size parts = [first + ((2 * k + 1) * size) `quot` (2 * parts) | k <- [0 .. parts - 1]]

-- | One line of sight: rays of its pixel, steps, gas samples, and how its end
-- compares with that of the closed form.
data Look = Look {lookRays :: !Int, lookSteps :: !Int, lookGas :: !Int, _lookEnd :: !End}

data End = Alike | Apart !Double | Otherwise

apart :: Fate -> Fate -> End
apart (Escaped a) (Escaped b) = Apart (2 * asin (min 1 (0.5 * XYZ.norm (a XYZ.^-^ b))))
apart a b
  -- What is hidden has no end to compare.
  | Opaque `elem` [a, b] || a == b = Alike
  | otherwise = Otherwise

meanOf :: [Double] -> Mean
meanOf values = case length values of
  0 -> Mean 0 0
  n -> Mean mean (if n < 2 then 0 else sqrt (sum [(v - mean) ^ (2 :: Int) | v <- values] / (fromIntegral n * fromIntegral (n - 1))))
    where
      mean = sum values / fromIntegral n
