-- | The table of the program's time and memory, its scaling, and the accuracy of its
-- approximations. The pictures are rendered by the program itself, as users run it.
module Table (printTable, printSpinTable) where

import BlackHole.Scene.Preset
import BlackHole.Scene.Scene (Scene (..))
import BlackHole.Spacetime.Kerr.Landmarks (dimensionlessSpin, spin)
import BlackHole.Spacetime.Kerr.Sight (Place (..))
import Control.Concurrent (threadDelay)
import Control.Exception (evaluate, finally)
import Control.Monad (forM, replicateM, unless, void, when)
import Data.List (sort)
import Data.Maybe (mapMaybe)
import GHC.Clock (getMonotonicTime)
import GasPlaces
import System.Directory (doesFileExist, getTemporaryDirectory, removeFile)
import System.Exit (ExitCode (..))
import System.FilePath ((</>))
import System.IO
import System.IO.Error (catchIOError)
import System.Process
import TableError
import Text.Printf (printf)
import Text.Read (readMaybe)

-- | Renders a picture with additional options and measures it.
data Drawing = Drawing
  { -- | Seconds, without observing the process.
    drawingTime :: [String] -> Work -> IO Double,
    -- | Seconds of processor time, by one worker.
    drawingProcessorTime :: [String] -> Work -> IO Double,
    -- | Greatest resident memory in megabytes; 'Nothing' if the system does not report
    -- it.
    drawingMemory :: [String] -> Work -> IO (Maybe Double)
  }

-- | A picture to render.
data Work = Work
  { workName :: String,
    workOptions :: [String],
    workWidth :: Int,
    workSamples :: Int,
    workTarget :: String
  }

-- | @printTable program huge@ prints the whole table to standard output, including a
-- picture of 7680 × 4320 if @huge@. Takes six minutes on two idle cores.
printTable :: FilePath -> Bool -> IO ()
printTable program huge = do
  withDrawing program $ \drawing -> do
    printf "%-46s %8s %8s %6s  %s\n" "picture" "s" "Mray/s" "MB" "target"
    tabulated <- reportWork drawing 3 reportTable
    mapM_ (reportWork drawing 3) works
    leapfrog <- reportWork drawing 1 reportLeapfrog
    printf "the table against the leapfrog: %.1f times as fast\n\n" (leapfrog / tabulated)
    printf
      "%-46s %8s %8s %6s\n"
      "price of a feature, default scene, 960 × 540"
      "without"
      "with"
      "ratio"
    mapM_ (reportPrice drawing) prices
    printf "\n%-46s %8s %8s %6s  %s\n" "two workers against one" "1, s" "2, s" "ratio" "target 1.85"
    mapM_ (reportScaling drawing) scalings
    putStrLn ""
    reportSpins drawing
    printf "\n%-46s %8s %8s %6s\n" "cost per pixel, default scene" "s" "µs/pixel" "MB"
    mapM_ (reportSize drawing) ([320, 640, 1280, 1920, 3840] ++ [7680 | huge])
  putStrLn ""
  reportErrors
  putStrLn ""
  reportKerrErrors
  putStrLn ""
  reportNoise "default" defaultScene
  reportNoise "report" reportScene
  putStrLn ""
  mapM_ (reportStart program) ["--version", "--help"]

-- | @printSpinTable program@ prints the part of the table about rotating holes.
printSpinTable :: FilePath -> IO ()
printSpinTable program = do
  withDrawing program reportSpins
  putStrLn ""
  reportKerrErrors

-- | Draws pictures by a program into a file that is removed in the end.
withDrawing :: FilePath -> (Drawing -> IO a) -> IO a
withDrawing program action = do
  hSetBuffering stdout LineBuffering
  folder <- getTemporaryDirectory
  let output = folder </> "blackhole-bench.png"
  action
    Drawing
      { drawingTime = timeToDraw program output,
        drawingProcessorTime = processorTimeToDraw program output,
        drawingMemory = memoryToDraw program output
      }
    `finally` (removeFile output `catchIOError` const (pure ()))

works :: [Work]
works =
  [ Work "default, 1280 × 720, 1 sample" ["--noise", "0"] 1280 1 "1 Mray/s",
    lensing,
    Work "default, 1920 × 1080, own sampling" [] 1920 1 "200 MB",
    Work "default, 1920 × 1080, 4 samples" ["--noise", "0"] 1920 4 "9 s, 200 MB"
  ]

-- | The additional cost of features: options without and with each of them.
prices :: [(String, [String], [String])]
prices =
  [ ("T = 0.015 instead of 0.06", [], ["--noise", "0.015"]),
    ("bloom", [], ["--bloom", "0.1"]),
    ("16 bits", [], ["--bits", "16"]),
    ("the real stars and the Milky Way", ["--sky", "none"], []),
    ("Gaussian filter instead of box", ["--filter", "box"], ["--filter", "gaussian"]),
    ("exact orbits without the table", ["--integrator", "table"], ["--integrator", "exact"])
  ]

reportTable, reportLeapfrog, lensing :: Work
reportTable =
  Work
    "report, 1280 × 720, exact orbits (table)"
    ["--preset", "report", "--integrator", "table"]
    1280
    1
    "2 Mray/s"
reportLeapfrog = Work "report, 1280 × 720, leapfrog" ["--preset", "report"] 1280 1 "0.105 Mray/s"
lensing =
  Work
    "lensing alone, 1920 × 1080, grid sky"
    ["--no-disk", "--sky", "grid", "--noise", "0"]
    1920
    1
    "8 Mray/s"

-- | Large enough that the program's start and the camera's table do not count.
scalings :: [Work]
scalings =
  [ reportTable {workName = "report, 2560 × 1440, exact orbits (table)", workWidth = 2560},
    reportLeapfrog {workName = "report, 480 × 270, leapfrog", workWidth = 480},
    Work "default, 1920 × 1080, 1 sample" ["--noise", "0"] 1920 1 "",
    lensing {workName = "lensing alone, 3840 × 2160, grid sky", workWidth = 3840}
  ]

-- | What a spin costs. The last two pictures are so small that they show how much longer
-- the first pixel takes: their rays need most parts of the table.
spins :: [Work]
spins =
  [ Work "default, 960 × 540" [] 960 1 "1.6",
    Work "lensing alone, point stars, 960 × 540" ["--no-disk", "--sky", "random-stars"] 960 1 "3",
    setUp
      { workName = "set-up: lensing alone, 48 × 27",
        workOptions = ["--no-disk", "--sky", "grid"]
      },
    setUp
  ]
  where
    setUp = Work "set-up: default, 48 × 27" [] 48 1 "0.15 s more"

-- | Rays of a picture, in millions.
megarays :: Work -> Double
megarays work =
  fromIntegral (workWidth work * (workWidth work * 9 `quot` 16) * workSamples work) / 1e6

-- | Prints one row with the median of this many runs, and returns the median.
reportWork :: Drawing -> Int -> Work -> IO Double
reportWork drawing count work = do
  seconds <- median <$> replicateM count (drawingTime drawing [] work)
  memory <- drawingMemory drawing [] work
  printf
    "%-46s %8.2f %8.2f %6s  %s\n"
    (workName work)
    seconds
    (megarays work / seconds)
    (megabytes memory)
    (workTarget work)
  pure seconds

megabytes :: Maybe Double -> String
megabytes = maybe "-" (printf "%.0f")

-- | Measured in turns, so that other load on the machine affects both alike.
reportScaling :: Drawing -> Work -> IO ()
reportScaling drawing work = do
  (ones, twos) <-
    inTurns
      median
      5
      (drawingTime drawing ["--threads", "1"] work)
      (drawingTime drawing ["--threads", "2"] work)
  printf "%-46s %8.2f %8.2f %6.2f\n" (workName work) ones twos (ones / twos)

reportSpins :: Drawing -> IO ()
reportSpins drawing = do
  printf
    "%-46s %8s %8s %6s  %s\n"
    "a spin of 0.9 against none, processor time"
    "0, s"
    "0.9, s"
    "ratio"
    "target"
  mapM_ (reportSpin drawing) spins

-- | Processor time only ever grows by other load, so the least time is nearest to the
-- program's own.
reportSpin :: Drawing -> Work -> IO ()
reportSpin drawing work = do
  (without, with) <- inTurns minimum 5 (timeWith "0") (timeWith "0.9")
  printf
    "%-46s %8.3f %8.3f %6.2f  %s\n"
    (workName work)
    without
    with
    (with / without)
    (workTarget work)
  where
    timeWith s = drawingProcessorTime drawing ["--spin", s] work

reportPrice :: Drawing -> (String, [String], [String]) -> IO ()
reportPrice drawing (name, before, after) = do
  (without, with) <- inTurns median 3 (timeWith before) (timeWith after)
  printf "%-46s %8.2f %8.2f %6.2f\n" name without with (with / without)
  where
    timeWith options = drawingTime drawing options work
    work = Work name [] 960 4 ""

-- | A summary of each of two measurements that are taken this many times in turns.
inTurns :: ([Double] -> Double) -> Int -> IO Double -> IO Double -> IO (Double, Double)
inTurns summary count one two = do
  pairs <- replicateM count ((,) <$> one <*> two)
  pure (summary (map fst pairs), summary (map snd pairs))

reportSize :: Drawing -> Int -> IO ()
reportSize drawing width = do
  let work = Work (show width ++ " × " ++ show (width * 9 `quot` 16)) [] width 1 ""
  seconds <- median <$> replicateM (if width > 1920 then 1 else 3) (drawingTime drawing [] work)
  memory <- drawingMemory drawing [] work
  printf
    "%-46s %8.2f %8.2f %6s\n"
    (workName work)
    seconds
    (seconds / megarays work)
    (megabytes memory)

-- | Prints the errors relative to the closed form.
reportErrors :: IO ()
reportErrors = do
  printf "%-46s %8s %8s %6s\n" "error of the table (targets: 1e-6, 1e-5)" "sky" "crossing" "fates"
  worst <- forM [0.3, 0.9, 1.0001, 1.2, 1.5, 2, 3, 10, 30, 1000, 1e6] $ \r -> do
    let found = tableError 3000 r
    printf
      "%-46s %8.1e %8.1e %6d\n"
      ("r = " ++ show r)
      (skyError found)
      (crossingError found)
      (wrongFates found)
    pure found
  let TableError sky crossing fates = mconcat worst
  printf "%-46s %8.1e %8.1e %6d\n" "all" sky crossing fates

-- | Prints the errors of the table around a rotating hole, relative to the closed form.
reportKerrErrors :: IO ()
reportKerrErrors = do
  printf
    "%-46s %8s %8s %6s %12s\n"
    "error around a rotating hole (1e-6, 1e-5)"
    "sky"
    "crossing"
    "fates"
    "closed form"
  sequence_
    [ printf
        "%-46s %8.1e %8.1e %6d %10.2f %%\n"
        (printf "spin %.3f, r = %.1f, inclination %.0f°" s r inclination :: String)
        (skyError found)
        (crossingError found)
        (wrongFates found)
        (100 * closed)
      | Just hole <- map spin [0.01, 0.5, 0.9, 0.998, -0.998],
        (r, inclination) <- [(1.5, 60), (5, 20), (30, 80), (54, 77), (1000, 89)],
        let s = dimensionlessSpin hole
            (found, closed) = kerrTableError 20000 hole (Place r (inclination * pi / 180))
    ]

-- | Prints the speed of noise from tables relative to hashing every lattice point.
reportNoise :: String -> Scene -> IO ()
reportNoise name scene = mapM_ (mapM_ one . fields) (sceneDisk scene)
  where
    places = placesOf 20000 scene
    one field = do
      remembered <- secondsOf (fieldCached field)
      hashed <- secondsOf (fieldHashed field)
      printf
        "noise, %s: %s: %.0f ns, hashed %.0f ns, %.1f times (target 5), %s\n"
        name
        (fieldName field)
        (perPlace remembered)
        (perPlace hashed)
        (hashed / remembered)
        (if agreeing field places then "bit-equal" else "NOT EQUAL")
    perPlace seconds = 1e9 * seconds / fromIntegral (placeCount places)
    secondsOf noise = do
      void (evaluate (total noise places 0))
      median <$> mapM (fmap fst . timed . evaluate . total noise places) [1 .. 7]

reportStart :: FilePath -> String -> IO ()
reportStart program option = do
  times <- replicateM 15 (fst <$> timed (readProcess program [option] ""))
  printf "blackhole %s: %.0f ms (target 30)\n" option (1000 * median times)

timeToDraw :: FilePath -> FilePath -> [String] -> Work -> IO Double
timeToDraw program output more work =
  fst <$> timed (drawn output (callProcess program (arguments output more work)))

-- | As the shell's @times@ reports it, so that other load on the machine counts little.
processorTimeToDraw :: FilePath -> FilePath -> [String] -> Work -> IO Double
processorTimeToDraw program output more work =
  drawn output (readProcess "sh" (["-c", "\"$@\" && times", "sh", program] ++ options) "")
    >>= \report -> case mapMaybe shellSeconds (concatMap words (drop 1 (lines report))) of
      [inProgram, inKernel] -> pure (inProgram + inKernel)
      _ -> ioError (userError ("times: " ++ report))
  where
    options = arguments output (["--threads", "1"] ++ more) work
    -- Minutes and seconds, as in 0m1.25s.
    shellSeconds word = case break (== 'm') word of
      (minutes, _ : rest) ->
        (\m t -> 60 * m + t) <$> readMaybe minutes <*> readMaybe (takeWhile (/= 's') rest)
      _ -> Nothing

memoryToDraw :: FilePath -> FilePath -> [String] -> Work -> IO (Maybe Double)
memoryToDraw program output more work =
  drawn output (watched program (arguments output more work))

-- | Runs an action that must create the file.
drawn :: FilePath -> IO a -> IO a
drawn output act = do
  doesFileExist output >>= \there -> when there (removeFile output)
  result <- act
  made <- doesFileExist output
  unless made $ ioError (userError (output ++ ": no picture"))
  pure result

arguments :: FilePath -> [String] -> Work -> [String]
arguments output more work =
  ["render", "--quiet"] ++ workOptions work
    ++ ["--width", show (workWidth work), "--samples", show (workSamples work), "-o", output]
    ++ more

-- | Runs a program to its end and returns its greatest resident memory in megabytes.
-- Reads @/proc@ about a hundred times a second, which takes time away from a second
-- worker.
watched :: FilePath -> [String] -> IO (Maybe Double)
watched program options =
  withCreateProcess (proc program options) {std_out = CreatePipe, std_err = Inherit} $
    \_ _ _ process -> do
      let follow greatest = do
            now <- getPid process >>= maybe (pure Nothing) residentMegabytes
            ended <- getProcessExitCode process
            case ended of
              Nothing -> threadDelay 4000 >> follow (max greatest now)
              Just ExitSuccess -> pure (max greatest now)
              Just code -> ioError (userError (program ++ ": " ++ show code))
      follow Nothing

-- | The memory high-water mark of a running process.
residentMegabytes :: Pid -> IO (Maybe Double)
residentMegabytes pid = highest `catchIOError` const (pure Nothing)
  where
    highest = do
      text <- readFile ("/proc/" ++ show pid ++ "/status")
      pure $! case mapMaybe kilobytes (lines text) of
        (k : _) -> Just $! k / 1024
        [] -> Nothing
    kilobytes line = case words line of
      ["VmHWM:", amount, _] -> readMaybe amount
      _ -> Nothing

timed :: IO a -> IO (Double, a)
timed action = do
  start <- getMonotonicTime
  result <- action
  end <- getMonotonicTime
  pure (end - start, result)

-- | The median; of two middle values the higher one; 0 for an empty list.
median :: [Double] -> Double
median values = case drop (length values `quot` 2) (sort values) of
  middle : _ -> middle
  [] -> 0
