{-# LANGUAGE BangPatterns #-}

-- | The work that a picture took, estimated from a thousand lines of sight spread
-- evenly over it. The renderer itself counts nothing, because counting would slow it
-- down.
module BlackHole.Trace.RenderStatistics
  ( RenderStatistics (..),
    renderStatistics,
    Mean (..),
  )
where

import BlackHole.Scene.Camera (Picture (..), pixelMiddle)
import BlackHole.Scene.Scene
import BlackHole.Spacetime.Fate
import BlackHole.Spacetime.LightPath (Continue (..), Followed (..))
import BlackHole.Trace.Adaptive (Pixel (..), singlePixel)
import BlackHole.Trace.EnvironmentMap (EnvironmentMap)
import BlackHole.Trace.Explain (gatheredAlong)
import BlackHole.Trace.Ray
import BlackHole.Trace.Tracer
import BlackHole.Vector.XYZ (XYZ)
import qualified BlackHole.Vector.XYZ as XYZ
import Data.Maybe (isNothing)

-- | The mean of a number over the lines of sight, and its standard error.
data Mean = Mean !Double !Double
  deriving (Eq, Show)

-- | Statistics of a picture.
data RenderStatistics = RenderStatistics
  { -- | The number of lines of sight that were evaluated.
    statisticsLines :: !Int,
    -- | Rays per pixel. Exact unless sampling is adaptive.
    statisticsRays :: !Mean,
    -- | Steps of the integrator per ray: path segments handed to the gathering
    -- function, or the steps of the leapfrog. Rays through empty space by the table
    -- take none.
    statisticsSteps :: !Mean,
    -- | Path segments per ray that contained gas.
    statisticsGasSamples :: !Mean,
    -- | The greatest angle, in radians, between a ray's direction of escape and that of
    -- the closed form, over the rays that escape in both.
    statisticsDirectionError :: !Double,
    -- | The number of rays that end in the hole in only one of the two.
    statisticsOtherFates :: !Int
  }
  deriving (Eq, Show)

-- | Evaluates about a thousand lines of sight in a band (its first row and its number
-- of rows), or one per pixel in a smaller band. 'Nothing' for a scene that cannot be
-- traced ('tracerWithSky') and for an empty band. Each line of sight costs as much as
-- three rays, and with adaptive sampling as much as nine pixels.
renderStatistics :: Maybe EnvironmentMap -> Scene -> (Int, Int) -> Maybe RenderStatistics
renderStatistics picture scene (first, rows)
  | rows <= 0 || width <= 0 = Nothing
  | otherwise = do
    traced <- tracerWithSky picture scene
    exact <- tracerWithSky picture scene {sceneIntegrator = Exact, sceneDisk = Nothing}
    let looks =
          [ look traced exact column row
            | row <- spread first rows down,
              column <- spread 0 width across
          ]
    pure
      RenderStatistics
        { statisticsLines = length looks,
          statisticsRays =
            if adaptive
              then meanOf [fromIntegral (lookRays l) | l <- looks]
              else Mean (fromIntegral (sceneSamples scene)) 0,
          statisticsSteps = meanOf [fromIntegral (lookSteps l) | l <- looks],
          statisticsGasSamples = meanOf [fromIntegral (lookGas l) | l <- looks],
          statisticsDirectionError = maximum (0 : [e | Look _ _ _ (Apart e) <- looks]),
          statisticsOtherFates = length [() | Look _ _ _ Otherwise <- looks]
        }
  where
    Picture width _ = scenePicture scene
    adaptive = isAdaptive scene
    -- About a thousand, in squares.
    side = max 1 (sqrt (fromIntegral (width * rows) / 1000)) :: Double
    across = max 1 (min width (round (fromIntegral width / side)))
    down = max 1 (min rows (round (fromIntegral rows / side)))
    look traced exact !column !row =
      let point = pixelMiddle column row
          rays =
            if adaptive then pixelRays (singlePixel traced column row) else sceneSamples scene
       in case (tracedSight traced point, tracedSight exact point) of
            (Just sight, Just sight') ->
              let (fate, steps, gasSamples) = gatheredAlong traced point sight
                  right = followedFate (followSight exact point sight' (\() _ -> Continue ()) ())
               in Look rays (if direct then 0 else steps) gasSamples (apart fate right)
            _ -> Look rays 0 0 Alike
    -- The table gives the ends of such rays directly.
    direct = sceneIntegrator scene == Tabulated && isNothing (sceneDisk scene)

-- | The middles of this many equal parts of a row of pixels.
spread :: Int -> Int -> Int -> [Int]
spread first size parts = [first + ((2 * k + 1) * size) `quot` (2 * parts) | k <- [0 .. parts - 1]]

-- | The result of one line of sight: the rays of its pixel, steps, gas samples, and the
-- comparison of its end with that of the closed form.
data Look = Look {lookRays :: !Int, lookSteps :: !Int, lookGas :: !Int, _lookEnd :: !End}

data End = Alike | Apart !Double | Otherwise

apart :: Fate XYZ -> Fate XYZ -> End
apart (Escaped a) (Escaped b) = Apart (2 * asin (min 1 (0.5 * XYZ.norm (a XYZ.^-^ b))))
apart a b
  -- A hidden path has no end to compare.
  | Opaque `elem` [a, b] || a == b = Alike
  | otherwise = Otherwise

meanOf :: [Double] -> Mean
meanOf values = case length values of
  0 -> Mean 0 0
  n ->
    Mean
      mean
      ( if n < 2
          then 0
          else
            sqrt
              ( sum [(v - mean) ^ (2 :: Int) | v <- values]
                  / (fromIntegral n * fromIntegral (n - 1))
              )
      )
    where
      mean = sum values / fromIntegral n
