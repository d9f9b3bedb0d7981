-- | Whether a picture fits into the memory there is, asked before any work.
module BlackHole.Cli.Memory
  ( pictureMemory,
    availableMemory,
    memoryProblem,
    peakMemory,
  )
where

import BlackHole.Scene.Camera (Picture (..))
import BlackHole.Scene.Scene
import Control.Exception (IOException, evaluate, try)
import Data.Char (isDigit)
import Data.List (isPrefixOf)
import Data.Maybe (catMaybes, listToMaybe, mapMaybe)
import System.Posix.Resource
import Text.Read (readMaybe)

-- | The least memory in bytes that so many rows of a scene's picture take from
-- light to file: three floats a pixel, and with bloom half as many for a moment.
pictureMemory :: Scene -> Int -> Integer
pictureMemory scene rows = toInteger width * toInteger rows * (if sceneBloom scene > 0 then 12 + 6 else 12)
  where
    Picture width _ = scenePicture scene

-- | The bytes that this process may still take, as far as the system tells: the
-- least of what is free (@MemAvailable@), its group's limit (cgroup 2) and its
-- own (@ulimit -v@). 'Nothing' where nothing of it is known.
availableMemory :: IO (Maybe Integer)
availableMemory = do
  free <- firstLine "/proc/meminfo" "MemAvailable:"
  limit <- readSmall "/sys/fs/cgroup/memory.max"
  used <- readSmall "/sys/fs/cgroup/memory.current"
  own <- softLimit . either noLimits id <$> (try (getResourceLimit ResourceTotalMemory) :: IO (Either IOException ResourceLimits))
  let group = (\l u -> max 0 (l - u)) <$> (readMaybe =<< limit) <*> (readMaybe =<< used)
      known = catMaybes [free, group, asNumber own]
  pure (if null known then Nothing else Just (minimum known))
  where
    noLimits _ = ResourceLimits ResourceLimitUnknown ResourceLimitUnknown
    asNumber (ResourceLimit n) = Just n
    asNumber _ = Nothing

-- | One line if so many rows need more memory than there is.
memoryProblem :: Scene -> Int -> IO (Maybe String)
memoryProblem scene rows = judge <$> availableMemory
  where
    Picture width _ = scenePicture scene
    needed = pictureMemory scene rows
    judge (Just there)
      | needed > there =
        Just $
          "a picture of " ++ show width ++ " x " ++ show rows ++ " pixels needs " ++ mebibytes needed ++ " of memory, and there are "
            ++ mebibytes there
            ++ "; make it smaller, or render it in tiles (--tile I/N)"
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
      | word `isPrefixOf` line = (* 1024) <$> readMaybe (takeWhile isDigit (dropWhile (not . isDigit) line))
      | otherwise = Nothing

readSmall :: FilePath -> IO (Maybe String)
readSmall file = do
  outcome <- try (readFile file >>= \text -> text <$ evaluate (length text)) :: IO (Either IOException String)
  pure (either (const Nothing) Just outcome)
