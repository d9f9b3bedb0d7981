-- | Generates the table of BlackHole.Light.Dither: blue noise by the void-and-cluster
-- method (Ulichney 1993, "The void-and-cluster method for dither array generation").
-- Prints the table's lines; runs for about a second when compiled with -O1.
module Main (main) where

import Control.Monad (forM_, when)
import Control.Monad.ST (ST, runST)
import Data.List (sortOn)
import qualified Data.Vector.Unboxed as U
import qualified Data.Vector.Unboxed.Mutable as MU
import Data.Word (Word64)

main :: IO ()
main =
  putStr
    ( unlines
        [ [digits !! (rank * 64 `quot` cells) | rank <- U.toList (U.slice (y * side) side ranks)]
          | y <- [0 .. side - 1]
        ]
    )
  where
    digits = ['A' .. 'Z'] ++ ['a' .. 'z'] ++ ['0' .. '9'] ++ "+-"

side, cells :: Int
side = 64
cells = side * side

-- | The influence of a point at this offset in columns and rows, on a torus: a Gaussian
-- of 1.9 pixels.
influence :: U.Vector Double
influence = U.generate cells $ \i ->
  let (y, x) = i `quotRem` side
      square n = let d = fromIntegral (min n (side - n)) :: Double in d * d
   in exp (negate (square x + square y) / (2 * 1.9 * 1.9))

-- | The rank of every cell: the number of cells set before it.
ranks :: U.Vector Int
ranks = runST $ do
  set <- MU.replicate cells False
  energy <- MU.replicate cells 0
  forM_ scattered (put set energy True)
  settle set energy
  firstSet <- U.freeze set
  firstEnergy <- U.freeze energy
  order <- MU.replicate cells 0
  -- Downwards: remove the point in the tightest cluster first.
  forM_ [count - 1, count - 2 .. 0] $ \rank -> do
    cell <- extreme True set energy
    put set energy False cell
    MU.write order cell rank
  -- Upwards: fill the widest void first.
  U.copy set firstSet
  U.copy energy firstEnergy
  forM_ [count .. cells - 1] $ \rank -> do
    cell <- extreme False set energy
    put set energy True cell
    MU.write order cell rank
  U.unsafeFreeze order
  where
    count = cells `quot` 10
    -- A tenth of the cells, in pseudo-random order.
    scattered = take count (map snd (sortOn fst (zip (iterate next 20260101) [0 .. cells - 1])))
    next :: Word64 -> Word64
    next n = n * 6364136223846793005 + 1442695040888963407

-- | Moves points from clusters to voids until nothing changes.
settle :: MU.MVector s Bool -> MU.MVector s Double -> ST s ()
settle set energy = do
  from <- extreme True set energy
  put set energy False from
  to <- extreme False set energy
  put set energy True to
  when (from /= to) $ settle set energy

-- | Sets or clears a cell, and updates its influence on all others.
put :: MU.MVector s Bool -> MU.MVector s Double -> Bool -> Int -> ST s ()
put set energy on cell = do
  MU.write set cell on
  forM_ [0 .. cells - 1] $ \i -> do
    let (y, x) = i `quotRem` side
        (cellY, cellX) = cell `quotRem` side
        away = influence U.! (((y - cellY) `mod` side) * side + (x - cellX) `mod` side)
    MU.modify energy (if on then (+ away) else subtract away) i

-- | The set cell with the most energy, or the clear cell with the least; the first if
-- there are several.
extreme :: Bool -> MU.MVector s Bool -> MU.MVector s Double -> ST s Int
extreme among set energy = go 0 0 (-1 / 0)
  where
    go i best value
      | i >= cells = pure best
      | otherwise = do
        inside <- MU.read set i
        e <- MU.read energy i
        let v = if among then e else negate e
        if inside == among && v > value then go (i + 1) i v else go (i + 1) best value
