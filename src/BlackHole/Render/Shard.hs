-- | Parts of a film or of a picture for several processes or machines.
module BlackHole.Render.Shard
  ( Shard (..),
    wholeShard,
    parseShard,
    renderShard,
    slurmShard,
    takeShard,
    shardRows,
  )
where

import Data.Char (isDigit)
import Text.Read (readMaybe)

-- | Part @i@ of @n@, counted from 1.
data Shard = Shard
  { shardIndex :: !Int,
    shardCount :: !Int
  }
  deriving (Eq, Ord, Show)

-- | The single part of one.
wholeShard :: Shard
wholeShard = Shard 1 1

-- | Parses @I\/N@ with 1 ≤ I ≤ N ≤ 1000000.
parseShard :: String -> Maybe Shard
parseShard text = case break (== '/') text of
  (i, '/' : n) -> do
    index <- whole i
    count <- whole n
    if index >= 1 && index <= count && count <= 1000000 then Just (Shard index count) else Nothing
  _ -> Nothing
  where
    whole digits@(_ : _) | all isDigit digits && length digits <= 7 = readMaybe digits
    whole _ = Nothing

-- | Formats a shard as 'parseShard' reads it.
renderShard :: Shard -> String
renderShard (Shard index count) = show index ++ "/" ++ show count

-- | The shard of a task of a Slurm array job, from the variables that Slurm sets: the
-- first task takes part 1, and there are as many parts as tasks. A single task, as in
-- @sbatch --array=7@, takes everything. That is how a user submits a lost task again;
-- frames that others have finished are not rendered twice. 'Left' holds the reason if
-- there is no shard: not an array job, or an array with gaps.
slurmShard :: (String -> Maybe String) -> Either String Shard
slurmShard variable = do
  task <- number "SLURM_ARRAY_TASK_ID"
  first <- number "SLURM_ARRAY_TASK_MIN"
  final <- number "SLURM_ARRAY_TASK_MAX"
  count <- number "SLURM_ARRAY_TASK_COUNT"
  let step = case variable "SLURM_ARRAY_TASK_STEP" >>= readMaybe of
        Just s | s >= 1 -> s
        _ -> 1
      (rank, off) = (task - first) `quotRem` step
  if count < 1 || task < first || task > final || off /= 0
    || (final - first) `quot` step + 1 /= count
    then Left "the job's array has gaps; use a range such as --array=1-8, or give --shard I/N"
    else Right (Shard (rank + 1) count)
  where
    number :: String -> Either String Int
    number name = case variable name of
      Nothing ->
        Left (name ++ " is not set: this is no task of a Slurm array job (sbatch --array=1-8 …)")
      Just text ->
        maybe
          (Left (name ++ " is '" ++ text ++ "', which is not a whole number"))
          Right
          (readMaybe text)

-- | The shard's members of a list: every n-th, which spreads the slow passages of a
-- film over all parts.
takeShard :: Shard -> [a] -> [a]
takeShard (Shard index count) = go . drop (index - 1)
  where
    go [] = []
    go (x : rest) = x : go (drop (count - 1) rest)

-- | The rows of a picture of a given height that belong to the shard: the first row and
-- their number. The bands of all shards are adjacent and differ by at most one row;
-- with more shards than rows some are empty.
shardRows :: Shard -> Int -> (Int, Int)
shardRows (Shard index count) height = (edge (index - 1), edge index - edge (index - 1))
  where
    -- In unbounded integers, so that no picture causes an overflow.
    edge i = fromInteger (toInteger i * toInteger height `quot` toInteger count)
