-- | Huffman codes of limited length in the canonical form of RFC 1951.
module BlackHole.Image.Huffman
  ( codeLengths,
    canonicalCodes,
  )
where

import Data.Bits (shiftL, shiftR, (.&.), (.|.))
import Data.List (sortOn)
import qualified Data.Vector.Unboxed as U

-- | A tree over the symbols, with the sum of their counts.
data Tree = Tree !Int !CodeTree

data CodeTree = Leaf !Int | Fork Tree Tree

weight :: Tree -> Int
weight (Tree w _) = w

-- | @codeLengths limit counts@ are the lengths in bits of the codes of the symbols 0,
-- 1, …: 0 for those that never occur, and at most the limit for the others. The mean
-- length is minimal, except that if a code would be too long, the counts are halved
-- until none is. A single symbol that occurs gets one bit. The limit must suffice for
-- the symbols: at most 2^limit of them.
codeLengths :: Int -> U.Vector Int -> U.Vector Int
codeLengths limit counts
  | U.all (<= limit) lengths = lengths
  | otherwise = codeLengths limit (U.map (\n -> (n + 1) `quot` 2) counts)
  where
    lengths = freeLengths counts

-- | Code lengths without a limit.
freeLengths :: U.Vector Int -> U.Vector Int
freeLengths counts = U.replicate (U.length counts) 0 U.// depths
  where
    leaves =
      sortOn
        weight
        [Tree n (Leaf symbol) | (symbol, n) <- U.toList (U.indexed counts), n > 0]
    depths = case leaves of
      [Tree _ (Leaf symbol)] -> [(symbol, 1)]
      _ -> maybe [] leafDepths (merge leaves (Queue [] []))

-- | A first-in, first-out queue: the front in order, the back reversed.
data Queue = Queue [Tree] [Tree]

-- | Joins the two lightest trees until one is left. Single symbols wait in one queue
-- and joined trees in another; both are ordered by weight, because later joins are
-- heavier.
merge :: [Tree] -> Queue -> Maybe Tree
merge leaves joined = do
  (first, leaves', joined') <- lightest leaves joined
  case lightest leaves' joined' of
    Nothing -> Just first
    Just (second, leaves'', Queue front back) ->
      merge leaves'' (Queue front (Tree (weight first + weight second) (Fork first second) : back))

lightest :: [Tree] -> Queue -> Maybe (Tree, [Tree], Queue)
lightest leaves (Queue [] back@(_ : _)) = lightest leaves (Queue (reverse back) [])
lightest (a : as) (Queue (b : bs) back)
  | weight a <= weight b = Just (a, as, Queue (b : bs) back)
  | otherwise = Just (b, a : as, Queue bs back)
lightest (a : as) joined = Just (a, as, joined)
lightest [] (Queue (b : bs) back) = Just (b, [], Queue bs back)
lightest [] (Queue [] []) = Nothing

leafDepths :: Tree -> [(Int, Int)]
leafDepths = go 0 []
  where
    go :: Int -> [(Int, Int)] -> Tree -> [(Int, Int)]
    go depth rest (Tree _ shape) = case shape of
      Leaf symbol -> (symbol, depth) : rest
      Fork a b -> go (depth + 1) (go (depth + 1) rest b) a

-- | The canonical codes of these lengths (RFC 1951, 3.2.2), each with its bits in the
-- order in which they are sent, first bit lowest; 0 for absent symbols.
canonicalCodes :: U.Vector Int -> U.Vector Int
canonicalCodes lengths = U.replicate (U.length lengths) 0 U.// go 0 1
  where
    longest = U.foldl' max 0 lengths
    go first n
      | n > longest = []
      | otherwise =
        [(symbol, reversed n (first + i)) | (i, symbol) <- zip [0 ..] (U.toList symbols)]
          ++ go ((first + U.length symbols) * 2) (n + 1)
      where
        symbols = U.findIndices (== n) lengths

-- | The lowest @n@ bits in reverse order.
reversed :: Int -> Int -> Int
reversed n code = foldl (\done i -> done `shiftL` 1 .|. (code `shiftR` i) .&. 1) 0 [0 .. n - 1]
