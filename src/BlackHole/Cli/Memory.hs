-- | Estimates of the memory that a picture takes, compared with the available memory
-- before any work.
module BlackHole.Cli.Memory
  ( Making (..),
    Product (..),
    pictureMemory,
    availableMemory,
    memoryProblem,
    peakMemory,
  )
where

import BlackHole.Image.Coding (Format (..))
import BlackHole.Render.Film (rowsAtOnce)
import BlackHole.Scene.Camera (Picture (..))
import BlackHole.Scene.Scene
import Control.Exception (IOException, evaluate, try)
import Data.Char (isDigit)
import Data.List (isPrefixOf)
import Data.Maybe (catMaybes, listToMaybe, mapMaybe)
import System.Posix.Resource
import Text.Read (readMaybe)

-- | The product of a picture's light, which determines what is in memory at one time.
data Product
  = -- | A file that is written while its rows are coded.
    WholePicture !Format
  | -- | A tile file.
    Tile
  | -- | A frame, whose file is made in memory.
    Frame !Format
  | -- | A file of tiles, which are read while it is written.
    Joined !Format
  deriving (Eq, Show)

-- | How a picture is made.
data Making = Making
  { makingProduct :: !Product,
    -- | Whether its light is the mean of several scenes.
    makingBlurred :: !Bool,
    -- | Whether its rows are kept for the case of a signal.
    makingKept :: !Bool
  }
  deriving (Eq, Show)

-- | The memory in bytes that a number of rows of a scene's picture take at most from
-- light to file. The numbers are measured ("BlackHole.Cli.MemorySpec" measures them
-- again): at least 12 bytes a pixel of light, and what a stage holds beside it.
pictureMemory :: Making -> Scene -> Int -> Integer
pictureMemory (Making product' blurred kept) scene rows =
  50331648
    + layersOfRow * toInteger width * toInteger layerRows
    + toInteger width * toInteger rows
      * sum
        ( ofProduct :
            [ n
              | (True, n) <-
                  [ (sceneBeam scene > 0, 18),
                    (sceneBloom scene > 0, 18),
                    (sceneSpikes scene > 0, 18),
                    (blurred, 48),
                    (kept, 14),
                    (adaptive, 8)
                  ]
            ]
        )
  where
    Picture width _ = scenePicture scene
    adaptive = isAdaptive scene
    -- Two bands of layers with their neighbouring rows, and the finished pixels of one.
    layersOfRow = 64
    layerRows = if adaptive then min (rowsAtOnce + 2) rows else 0
    ofProduct = case product' of
      WholePicture format -> ofFormat format
      Tile -> 26
      Frame format -> ofFormat format + 16
      Joined Png -> 32
      Joined Jpeg -> 46
      Joined _ -> 12
    ofFormat format = case format of
      Jpeg -> 22
      Exr -> 26
      _ -> 14

-- | The bytes that this process may still take, as far as the system tells: the
-- least of what is free (@MemAvailable@), its group's limit (cgroup 2) and its
-- own (two thirds of @ulimit -v@, which is what GHC's run-time system reserves for the
-- heap then). 'Nothing' where nothing of it is known.
availableMemory :: IO (Maybe Integer)
availableMemory = do
  free <- firstLine "/proc/meminfo" "MemAvailable:"
  limit <- readSmall "/sys/fs/cgroup/memory.max"
  used <- readSmall "/sys/fs/cgroup/memory.current"
  own <-
    softLimit . either noLimits id
      <$> (try (getResourceLimit ResourceTotalMemory) :: IO (Either IOException ResourceLimits))
  let group = (\l u -> max 0 (l - u)) <$> (readMaybe =<< limit) <*> (readMaybe =<< used)
      known = catMaybes [free, group, (`quot` 3) . (* 2) <$> asNumber own]
  pure (if null known then Nothing else Just (minimum known))
  where
    noLimits _ = ResourceLimits ResourceLimitUnknown ResourceLimitUnknown
    asNumber (ResourceLimit n) = Just n
    asNumber _ = Nothing

-- | One line if a number of rows need more memory than is available.
memoryProblem :: Making -> Scene -> Int -> IO (Maybe String)
memoryProblem making scene rows = judge <$> availableMemory
  where
    Picture width _ = scenePicture scene
    needed = pictureMemory making scene rows
    judge (Just there)
      | needed > there =
        Just $
          "a picture of " ++ show width ++ " x " ++ show rows ++ " pixels needs "
            ++ mebibytes needed
            ++ " of memory, but only "
            ++ mebibytes there
            ++ " are available; make it smaller"
            ++ case makingProduct making of
              WholePicture _ -> ", or render it in tiles (--tile I/N)"
              Tile -> ", or divide the picture into more tiles"
              Frame _ -> ""
              Joined _ -> ", or join the tiles to a TIFF, HDR or OpenEXR file"
    judge _ = Nothing
    mebibytes n = show (n `quot` 1048576) ++ " MiB"

-- | The most memory in bytes that this process has had so far, where the system
-- tells it (Linux).
peakMemory :: IO (Maybe Integer)
peakMemory = firstLine "/proc/self/status" "VmHWM:"

-- | The number of kilobytes after a word that begins a line, in bytes.
firstLine :: FilePath -> String -> IO (Maybe Integer)
firstLine file word = do
  text <- readSmall file
  pure $ listToMaybe (mapMaybe kilobytes (maybe [] lines text))
  where
    kilobytes line
      | word `isPrefixOf` line =
        (* 1024)
          <$> readMaybe (takeWhile isDigit (dropWhile (not . isDigit) line))
      | otherwise = Nothing

readSmall :: FilePath -> IO (Maybe String)
readSmall file = do
  outcome <-
    try (readFile file >>= \text -> text <$ evaluate (length text)) ::
      IO
        (Either IOException String)
  pure (either (const Nothing) Just outcome)
