-- | Tracing for @blackhole render@, with progress and with what an interruption leaves.
module BlackHole.Cli.Render.Trace
  ( Traced (..),
    tracing,
    untraceable,
    warnOfFaults,
  )
where

import BlackHole.Animation.Exposure
import BlackHole.Cli.Console (say)
import BlackHole.Cli.ExitStatus
import BlackHole.Cli.PictureOutput (timed)
import BlackHole.Cli.Progress (withProgress)
import BlackHole.Cli.RunOptions
import BlackHole.Cli.Signals (Stopped)
import BlackHole.Render.Exposed
import BlackHole.Render.PixelArray (fromPixelVector, pixelArrayShape, toPixelVector)
import BlackHole.Render.PixelShape (pixelShape, shapeHeight)
import BlackHole.Render.Workers
import BlackHole.Scene.Camera (Picture (..))
import BlackHole.Scene.Scene
import BlackHole.Trace.EnvironmentMap (EnvironmentMap)
import Control.Exception (catch, throwIO, try)
import Control.Monad (forM_)
import Data.IORef
import Data.List.NonEmpty (NonEmpty (..))
import qualified Data.Vector.Storable as Vector
import GHC.Clock (getMonotonicTime)

-- | The result of tracing.
data Traced = Traced
  { tracedFilm :: !Exposed,
    -- | The number of finished rows; the others are black.
    tracedRows :: !Int,
    tracedSeconds :: !Double
  }

-- | @tracing how sky workers scenes band output finish@ traces a band of some scenes with
-- reports of progress, and continues with the film. With @--keep-partial@ it traces
-- smaller bands one after the other; after a signal it continues with a film of the
-- finished ones and then ends by that signal.
tracing ::
  RunOptions ->
  Maybe EnvironmentMap ->
  Workers ->
  NonEmpty Scene ->
  (Int, Int) ->
  FilePath ->
  (Traced -> IO ExitStatus) ->
  IO ExitStatus
tracing how sky workers scenes@(scene :| others) (first, rows) output finish
  | runKeepPartial how = do
    kept <- newIORef []
    start <- getMonotonicTime
    outcome <- try . timed . reported $ \report -> forM_ bands $ \(from, count) -> do
      band <-
        exposeMotionBlur
          sky
          workers
          (report . (from +) . rowsOf count)
          scenes
          (first + from, count)
      modifyIORef' kept (maybe id (:) band)
    done <- reverse <$> readIORef kept
    let rowsDone = sum (map (shapeHeight . pixelArrayShape . exposedLight) done)
    case (joined done rowsDone, outcome) of
      (Nothing, _) -> untraceable
      (Just film, Right ((), seconds)) ->
        let traced = Traced film rows seconds
         in finish traced `catch` \stop -> finish traced >> throwIO (stop :: Stopped)
      (Just film, Left stop)
        | rowsDone > 0 -> do
          say
            ( output ++ ": " ++ show rowsDone ++ " of " ++ show rows
                ++ " rows are finished, the others are black"
            )
          end <- getMonotonicTime
          _ <- finish (Traced film rowsDone (end - start))
          throwIO (stop :: Stopped)
        | otherwise -> throwIO stop
  | otherwise = do
    (exposed, seconds) <-
      timed
        ( reported
            (\report -> exposeMotionBlur sky workers (report . rowsOf rows) scenes (first, rows))
        )
    maybe untraceable (\film -> finish (Traced film rows seconds)) exposed
  where
    width = pictureWidth (scenePicture scene)
    reported =
      withProgress
        (progressMode (runReporting how))
        rows
        (width * sceneSamples scene * (1 + length others))
    rowsOf count part = floor (part * fromIntegral count + 1e-6 :: Double)
    -- Enough to keep all workers busy, and at most some thirty bands.
    bandRows = max (4 * workersCount workers) ((rows + 31) `quot` 32)
    bands = [(from, min bandRows (rows - from)) | from <- [0, bandRows .. rows - 1]]
    -- The film of the finished bands and black rows without samples.
    joined done rowsDone = Exposed <$> padded 3 (map (toPixelVector . exposedLight) done) <*> counts
      where
        counts
          | rowsDone == rows && all (null . exposedCounts) done = Just Nothing
          | otherwise =
            Just
              <$> padded
                1
                [ countsRow scene band y
                  | band <- done,
                    y <- [0 .. shapeHeight (pixelArrayShape (exposedLight band)) - 1]
                ]
        padded channels arrays =
          pixelShape width rows channels
            >>= ( `fromPixelVector`
                    Vector.concat
                      (arrays ++ [Vector.replicate (channels * width * (rows - rowsDone)) 0])
                )

-- | The complaint about a scene without light paths, which validation should prevent.
untraceable :: IO ExitStatus
untraceable = complain InternalFault "the scene is valid but cannot be traced"

-- | Warns of pixels without finite radiance in a film whose first row is this row of the
-- picture. Returns their number, and the column and row of the first one in the picture.
warnOfFaults :: Workers -> Int -> Film -> IO (Int, Maybe (Int, Int))
warnOfFaults workers first film = faultyPixels workers film >>= warn
  where
    warn (n, Just (x, y)) = do
      say
        ( "warning: " ++ show n ++ " pixels have no finite radiance, the first at "
            ++ show x
            ++ ","
            ++ show (first + y)
        )
      pure (n, Just (x, first + y))
    warn _ = pure (0, Nothing)
