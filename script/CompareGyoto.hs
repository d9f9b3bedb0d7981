-- | Compares the first image of a thin disk with that of GYOTO, an independent code for
-- light around a Kerr hole (Vincent, Paumard, Gourgoulhon and Perrin 2011, "GYOTO: a new
-- general relativistic ray-tracing code"), pixel by pixel. The argument is a folder for
-- GYOTO's files; the table goes to standard output.
--
-- Both draw the disk of Page and Thorne from the innermost stable orbit outwards, seen by
-- an observer without angular momentum. A pixel's bolometric intensity is g⁴ F(r): only
-- a constant factor, the unit of the flux, is fitted.
module Main (main) where

import BlackHole.Matter.ThinDisk
import BlackHole.Numeric.Angle
import BlackHole.Scene.Camera
import BlackHole.Scene.Disk
import BlackHole.Scene.Preset (defaultScene)
import BlackHole.Scene.Scene
import BlackHole.Spacetime.Kerr.Landmarks
import BlackHole.Spacetime.Observer
import BlackHole.Spacetime.PlaneCrossing
import BlackHole.Spacetime.Types
import BlackHole.Trace.PixelGeometry
import Control.Monad (when)
import Data.Bits (shiftL, (.|.))
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Char8 as Characters
import Data.List (sort)
import Data.Maybe (isJust)
import Data.Word (Word64)
import GHC.Float (castWord64ToDouble)
import System.Environment (getArgs)
import System.Exit (ExitCode (..), die)
import System.FilePath ((</>))
import System.Process (readProcessWithExitCode)
import Text.Printf (printf)

-- | A comparison: the spin and the observer's inclination in degrees.
data Case = Case Double Double

main :: IO ()
main = do
  arguments <- getArgs
  case arguments of
    [folder] -> do
      putStrLn
        "| spin | inclination | pixels with gas | pixels with gas in one only | g: median | \
        \g: worst | intensity: median | 99 % | worst, over the brightest |"
      putStrLn "| --- | --- | --- | --- | --- | --- | --- | --- | --- |"
      worst <- mapM (compared folder) [Case s i | s <- [0, 0.5, 0.95], i <- [30, 80]]
      when (maximum worst > 2e-5) $ die "an intensity differs by more than 2e-5 of the brightest"
    _ -> die "usage: CompareGyoto FOLDER"

-- | Pixels along each side.
side :: Int
side = 48

-- | The observer's distance and the disk's outer radius in Schwarzschild radii.
distance, outerRadius :: Double
distance = 30
outerRadius = 12

fieldOfView :: Degrees
fieldOfView = Degrees 60

-- | Prints a row of the table and returns the greatest difference of an intensity, over
-- the brightest pixel's.
compared :: FilePath -> Case -> IO Double
compared folder (Case s inclination) = do
  hole <- maybe (die "no such spin") pure (spin s)
  theirs <- gyotoImage folder (Case s inclination)
  look <- maybe (die "the scene cannot be traced") pure (pixelGeometry (sceneOf hole))
  let disk = thinDisk hole
      -- GYOTO counts its columns from the left and its rows from the bottom.
      ours =
        [ geometryDiskHit (look column (side - 1 - row))
          | row <- [0 .. side - 1],
            column <- [0 .. side - 1]
        ]
      shift = crossingLight
      light hit = shift hit ^ (4 :: Int) * thinDiskFlux disk (crossingRadius hit)
      both = [(hit, g, flux) | (Just hit, (g, flux)) <- zip ours theirs, flux > 0]
      differ = length [() | (hit, (_, flux)) <- zip ours theirs, isJust hit /= (flux > 0)]
      unit = median [flux / light hit | (hit, _, flux) <- both]
      shifts = sort [abs (g / shift hit - 1) | (hit, g, _) <- both]
      fluxes = sort [abs (flux / (unit * light hit) - 1) | (hit, _, flux) <- both]
      brightest = maximum [flux | (_, _, flux) <- both]
      worst = maximum [abs (flux - unit * light hit) / brightest | (hit, _, flux) <- both]
  _ <-
    printf
      "| %.2f | %.0f° | %d | %d | %.1e | %.1e | %.1e | %.1e | %.1e |\n"
      s
      inclination
      (length both)
      differ
      (median shifts)
      (last shifts)
      (median fluxes)
      (fluxes !! ((99 * length fluxes) `div` 100))
      worst
  pure worst
  where
    sceneOf hole =
      defaultScene
        { scenePicture = Picture side side,
          sceneCamera =
            Camera (Around distance (Degrees inclination) (Degrees 90)) (Degrees 0) fieldOfView,
          sceneSpacetime = if s == 0 then Schwarzschild else Kerr hole,
          sceneObserver = Zamo,
          sceneDisk =
            (\d -> d {diskInnerRadius = iscoRadius RightHanded hole, diskOuterRadius = outerRadius})
              <$> sceneDisk defaultScene
        }

median :: [Double] -> Double
median values = sort values !! (length values `div` 2)

-- | GYOTO's pixels, each with g and the intensity in GYOTO's unit (0 without gas), row by
-- row from the bottom. GYOTO's lengths are in units of the hole's mass, half a
-- Schwarzschild radius.
gyotoImage :: FilePath -> Case -> IO [(Double, Double)]
gyotoImage folder (Case s inclination) = do
  writeFile scenery . unlines $
    [ "<?xml version=\"1.0\" encoding=\"UTF-8\" standalone=\"no\"?>",
      "<Scenery>",
      "<Metric kind=\"KerrBL\"><Spin>" ++ show s ++ "</Spin></Metric>",
      "<Screen>",
      "<ObserverKind>ZAMO</ObserverKind>",
      "<AngleKind>Rectilinear</AngleKind>",
      "<Position>0 " ++ show (2 * distance) ++ " " ++ radians inclination ++ " 0</Position>",
      "<FieldOfView>" ++ radians (inDegrees fieldOfView) ++ "</FieldOfView>",
      "<Resolution>" ++ show side ++ "</Resolution>",
      "</Screen>",
      "<Astrobj kind=\"PageThorneDisk\"><OuterRadius>" ++ show (2 * outerRadius)
        ++ "</OuterRadius></Astrobj>",
      "<Quantities>User4 Redshift</Quantities>",
      "<MinimumTime>-1000</MinimumTime>",
      "<Integrator>runge_kutta_fehlberg78</Integrator>",
      "<AbsTol>1e-12</AbsTol>",
      "<RelTol>1e-12</RelTol>",
      "<MaxIter>5000</MaxIter>",
      "</Scenery>"
    ]
  (code, _, complaint) <- readProcessWithExitCode "gyoto" ["--quiet", scenery, '!' : picture] ""
  when (code /= ExitSuccess) $ die ("gyoto: " ++ complaint)
  bytes <- Bytes.readFile picture
  planes <- maybe (die "gyoto's picture cannot be read") pure (fitsPlanes bytes)
  case planes of
    [redshift, flux] -> pure (zip redshift flux)
    _ -> die "gyoto's picture does not have two planes"
  where
    scenery = folder </> "scenery.xml"
    picture = folder </> "picture.fits"
    radians degrees = show (inRadians (toRadians (Degrees degrees)))

-- | The planes of the first array of a FITS file of 64-bit numbers.
fitsPlanes :: Bytes.ByteString -> Maybe [[Double]]
fitsPlanes bytes = do
  sizes <- mapM size ["NAXIS1", "NAXIS2", "NAXIS3"]
  let [width, height, depth] = sizes
      numbers = map (real . (8 *)) [0 .. width * height * depth - 1]
      body = Bytes.drop (blocks (80 * (length header + 1))) bytes
      real at =
        castWord64ToDouble
          ( Bytes.foldl'
              (\w b -> w `shiftL` 8 .|. fromIntegral b)
              (0 :: Word64)
              (Bytes.take 8 (Bytes.drop at body))
          )
  if Bytes.length body < 8 * width * height * depth
    then Nothing
    else Just (chunks (width * height) numbers)
  where
    header = takeWhile ((/= "END") . key) (cards bytes)
    cards rest =
      Bytes.take 80 rest : if Bytes.length rest > 80 then cards (Bytes.drop 80 rest) else []
    key = Characters.unpack . Characters.takeWhile (/= ' ') . Bytes.take 8
    size name =
      case [ n
             | card <- header,
               key card == name,
               Just (n, _) <-
                 [Characters.readInt (Characters.dropWhile (== ' ') (Bytes.drop 10 card))]
           ] of
        n : _ -> Just n
        [] -> Nothing
    -- Headers are filled up to a multiple of this many bytes.
    blocks n = (n + 2879) `div` 2880 * 2880
    chunks _ [] = []
    chunks n list = let (first, rest) = splitAt n list in first : chunks n rest
