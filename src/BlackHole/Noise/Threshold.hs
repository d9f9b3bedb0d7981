{-# LANGUAGE BangPatterns #-}

-- | Noise in space where it rises above a threshold, as rare things are scattered:
-- most places are dismissed before most of their lattice points are hashed.
--
-- A corner of a cell contributes at most its weight times its distance. So a few
-- numbers say beforehand how much the corners that are not hashed yet, and the
-- finer levels, can still add.
module BlackHole.Noise.Threshold
  ( perlin3Above,
    cellReach3,
    tabulatedReach3,
  )
where

import BlackHole.Noise.Lattice
import BlackHole.Noise.PerlinG
import BlackHole.Noise.Profile (Profile, layers)
import BlackHole.Numeric.Floor (turnFraction)
import BlackHole.Vector.XYZ (XYZ (..))
import qualified BlackHole.Vector.XYZ as XYZ
import Data.Bits (unsafeShiftL, unsafeShiftR, xor, (.&.), (.|.))
import Data.Primitive.PrimArray
import Data.Word (Word64, Word8)

-- | @perlin3Above seed profile least place@: 'perlin3', to the last bit, where it
-- is at least @least@, 'Nothing' elsewhere. Bind the result of the first two
-- arguments to work out once what they determine.
perlin3Above :: Seed -> Profile -> Double -> XYZ -> Maybe Double
perlin3Above seed p = above
  where
    !count = sizeofPrimArray amplitudes
    !amplitudes = primArrayFromList (map snd (layers p))
    !edges = primArrayFromList (map (cellsPerUnit . fst) (layers p))
    !levels = primArrayFromList named
    -- Whether a level's cells are those of the one before cut in half; not at the
    -- first two levels of the grid, nor so often that rounding adds up.
    !halving = primArrayFromList [if l == before + 1 && before > 0 && i `rem` 16 /= 0 then 1 else 0 | (i, before, l) <- zip3 [0 :: Int ..] ((-1) : named) named] :: PrimArray Word8
    named = map (levelNumber . fst) (layers p)
    cellOf place i = cellOfEdge3 (clampedLevel (indexPrimArray levels i)) (indexPrimArray edges i) place
    {-# INLINE cellOf #-}

    above !least v = case onGrid3 v of
      Nothing -> if 0 >= least then Just 0 else Nothing
      Just place
        | count <= 0 -> if 0 >= least then Just 0 else Nothing
        | otherwise -> case cellOf place 0 of
          -- The margin is for the rounding of the sums.
          Cell3 _ x y z -> bounded least place 0 1e-9 (fromBorder x) (fromBorder y) (fromBorder z)

    -- What all levels can add up to at the place, from its distances to the
    -- nearest borders of its cell, in the cell's edges.
    bounded :: Double -> GridPlace3 -> Int -> Double -> Double -> Double -> Double -> Maybe Double
    bounded !least place !i !bound !x !y !z
      | i' >= count = if bound' < least then Nothing else summed least place 0 0 bound'
      | indexPrimArray halving i' == 1 = bounded least place i' bound' (finer x) (finer y) (finer z)
      | otherwise = case cellOf place i' of
        Cell3 _ x' y' z' -> bounded least place i' bound' (fromBorder x') (fromBorder y') (fromBorder z')
      where
        !i' = i + 1
        !bound' = bound + abs (indexPrimArray amplitudes i) * tabulatedReach3 x y z

    -- The sum of the levels before this one, and the bound of the others.
    summed :: Double -> GridPlace3 -> Int -> Double -> Double -> Maybe Double
    summed !least place !i !total !bound
      | i >= count = if total >= least then Just total else Nothing
      | otherwise = case cellOf place i of
        Cell3 point x y z ->
          let !amplitude = indexPrimArray amplitudes i
              !reach = tabulatedReach3 (fromBorder x) (fromBorder y) (fromBorder z)
              !others = bound - abs amplitude * reach
              -- Distances from the nearest corner and their signs, so that which
              -- one that is makes no difference to the code that follows.
              !nearX = fromNearer x
              !nearY = fromNearer y
              !nearZ = fromNearer z
              !far = XYZ (fade (nearTo nearX)) (fade (nearTo nearY)) (fade (nearTo nearZ))
              -- One corner: 0 is the nearer along an axis, 1 the farther. The
              -- hashed ones' sum, what the others can add, and the gradients'
              -- numbers, a byte for each corner.
              corner :: Word64 -> Word64 -> Word64 -> (Double -> Double -> Word64 -> Maybe Double) -> Double -> Double -> Word64 -> Maybe Double
              corner a b c next !partial !rest !numbers
                | total + amplitude * partial + abs amplitude * rest + others < least = Nothing
                | otherwise =
                  let XYZ farX farY farZ = far
                      !dx = a `xor` nearest nearX
                      !dy = b `xor` nearest nearY
                      !dz = c `xor` nearest nearZ
                      !number = gradientNumber3 (latticeHash3 seed (latticePoint3 (pointLevel3 point) (pointX3 point + dx) (pointY3 point + dy) (pointZ3 point + dz)))
                      offset = XYZ (offsetTo a nearX) (offsetTo b nearY) (offsetTo c nearZ)
                      weight = noiseScale3 * side a farX * side b farY * side c farZ
                   in next
                        (partial + weight * XYZ.dot (numberedGradient3 number) offset)
                        (rest - weight * XYZ.norm offset)
                        (numbers .|. (fromIntegral number `unsafeShiftL` fromIntegral (8 * (dx + 2 * dy + 4 * dz))))
              {-# INLINE corner #-}
              value _ _ numbers =
                let v = interpolateGradients3 x y z (\i' j k -> byteOf numbers (i' + 2 * j + 4 * k))
                 in summed least place (i + 1) (total + amplitude * v) others
           in ( corner 0 0 0
                  . corner 1 0 0
                  . corner 0 1 0
                  . corner 0 0 1
                  . corner 1 1 0
                  . corner 1 0 1
                  . corner 0 1 1
                  . corner 1 1 1
              )
                value
                0
                reach
                0

    side a t = if a == 0 then 1 - t else t
    {-# INLINE side #-}
    offsetTo a (Nearer _ sign d) = if a == 0 then sign * d else sign * (d - 1)
    {-# INLINE offsetTo #-}
    nearest (Nearer n _ _) = n
    nearTo (Nearer _ _ d) = d
    byteOf numbers k = fromIntegral ((numbers `unsafeShiftR` (8 * k)) .&. 255)

-- Half of all places are on either side of a middle, which no processor can guess:
-- what follows has no branches.

-- | Which end of an edge is the nearer, 0 or 1; the direction from it to a place on
-- the edge, ±1; and the distance.
data Nearer = Nearer {-# UNPACK #-} !Word64 {-# UNPACK #-} !Double {-# UNPACK #-} !Double

fromNearer :: Double -> Nearer
fromNearer t = Nearer (fromIntegral (truncate end :: Int)) (1 - 2 * end) (abs rest)
  where
    rest = turnFraction t
    end = t - rest
{-# INLINE fromNearer #-}

-- | The most that 'noise3' can be in modulus at a place of a cell (each fraction
-- 0 … 1), whatever the gradients.
cellReach3 :: Double -> Double -> Double -> Double
cellReach3 x y z =
  noiseScale3
    * sum
      [ wx * wy * wz * sqrt (dx * dx + dy * dy + dz * dz)
        | (wx, dx) <- sides x,
          (wy, dy) <- sides y,
          (wz, dz) <- sides z
      ]
  where
    sides t = [(1 - fade t, t), (fade t, 1 - t)]

-- | Little more than 'cellReach3', from a table, by the distances to the nearest
-- borders, 0 … 1\/2. It grows towards the cell's middle, so that a field of the
-- table has it at its innermost corner.
tabulatedReach3 :: Double -> Double -> Double -> Double
tabulatedReach3 x y z = indexPrimArray reaches (field x + reachFields * (field y + reachFields * field z))
  where
    field t = min (reachFields - 1) (truncate (t * fromIntegral (2 * reachFields)))
{-# INLINE tabulatedReach3 #-}

-- | The distance to the nearer end of an edge, 0 … 1\/2, from the fraction.
fromBorder :: Double -> Double
fromBorder t = abs (turnFraction t)
{-# INLINE fromBorder #-}

-- | The same on cells half as large, in their edges.
finer :: Double -> Double
finer d = fromBorder (d + d)
{-# INLINE finer #-}

-- | Fields of the table from a cell's border to its middle.
reachFields :: Int
reachFields = 16

reaches :: PrimArray Double
reaches = primArrayFromList [cellReach3 (inner i) (inner j) (inner k) | k <- fields, j <- fields, i <- fields]
  where
    fields = [1 .. reachFields]
    inner i = fromIntegral i / fromIntegral (2 * reachFields)
{-# NOINLINE reaches #-}
