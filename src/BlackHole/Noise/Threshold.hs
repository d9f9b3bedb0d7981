{-# LANGUAGE BangPatterns #-}
-- Places and their neighbours stay on the stack.
{-# OPTIONS_GHC -fmax-worker-args=32 #-}

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
import Data.Primitive.PrimArray
import GHC.Float (double2Float, float2Double)

-- | @perlin3Above seed profile least place@: 'perlin3', to the last bit, where it
-- is at least @least@, 'Nothing' elsewhere. Bind the result of the first two
-- arguments to work out once what they determine.
perlin3Above :: Seed -> Profile -> Double -> XYZ -> Maybe Double
perlin3Above seed p
  | count > 0 && all (\l -> levelNumber l >= 1 && levelNumber l <= 50) named = above
  | otherwise = \least v -> let value = perlin3 seed p v in if value >= least then Just value else Nothing
  where
    !count = length named
    named = map fst (layers p)
    !amplitudes = primArrayFromList (map snd (layers p))
    !edges = primArrayFromList (map cellsPerUnit named)
    !levels = primArrayFromList (map levelNumber named)

    above !least v = case onGrid3 v of
      Nothing -> if 0 >= least then Just 0 else Nothing
      -- The margin is for the rounding of the sums.
      Just place -> bounded least place 0 1e-9

    -- What all levels can add up to at the place.
    bounded :: Double -> GridPlace3 -> Int -> Double -> Maybe Double
    bounded !least place !i !bound
      | i < count = bounded least place (i + 1) (bound + reach i (nearestIn place i))
      | bound < least = Nothing
      | otherwise =
        let !corner = nearestIn place 0
         in screened least place bound 0 corner (bound - loss 0 corner Here Here Here)

    -- The corners that can contribute most are looked at, each of which lowers the
    -- bound: the nearest one of each level and, after that of the next level, the
    -- three beside it. (The nearest of the first level has been looked at.) The other
    -- four are left to 'summed': few places get there.
    screened :: Double -> GridPlace3 -> Double -> Int -> Nearest3 -> Double -> Maybe Double
    screened !least place !whole !i corner !bound
      | bound < least = Nothing
      | i' >= count = beside bound (\bound' -> if bound' < least then Nothing else summed least place 0 0 whole)
      | otherwise =
        let !next = nearestIn place i'
            !bound' = bound - loss i' next Here Here Here
         in if bound' < least then Nothing else beside bound' (screened least place whole i' next)
      where
        !i' = i + 1
        beside !bound0 onward
          | bound1 < least = Nothing
          | bound2 < least = Nothing
          | otherwise = onward (bound2 - loss i corner Here Here Beyond)
          where
            bound1 = bound0 - loss i corner Beyond Here Here
            bound2 = bound1 - loss i corner Here Beyond Here
        {-# INLINE beside #-}

    -- By how much the gradient of a corner falls short of the best one.
    loss :: Int -> Nearest3 -> Side -> Side -> Side -> Double
    loss !i (Nearest3 x y z) a b c =
      weight * (abs amplitude * XYZ.norm offset - amplitude * XYZ.dot (numberedGradient3 number) offset)
      where
        !amplitude = indexPrimArray amplitudes i
        !number = numberAt seed (indexPrimArray levels i) (pointOf a x) (pointOf b y) (pointOf c z)
        !offset = XYZ (offsetOf a x) (offsetOf b y) (offsetOf c z)
        !weight = noiseScale3 * (weightOf a x * weightOf b y * weightOf c z)
    {-# INLINE loss #-}

    -- The sum of the levels before this one, and what it and the others can add.
    summed :: Double -> GridPlace3 -> Int -> Double -> Double -> Maybe Double
    summed !least place@(GridPlace3 px py pz) !i !total !others
      | total + others < least = Nothing
      | i >= count = if total >= least then Just total else Nothing
      | otherwise =
        summed
          least
          place
          (i + 1)
          (total + indexPrimArray amplitudes i * noiseOf seed (indexPrimArray levels i) (XYZ px py pz))
          (others - reach i (nearestIn place i))

    reach !i (Nearest3 x y z) = abs (indexPrimArray amplitudes i) * tabulatedReach3 (distance x) (distance y) (distance z)
    {-# INLINE reach #-}

    nearestIn (GridPlace3 x y z) !i = Nearest3 (nearest (edge * x)) (nearest (edge * y)) (nearest (edge * z))
      where
        !edge = indexPrimArray edges i
    {-# INLINE nearestIn #-}

-- | The gradient's number at a lattice point, from the level's number and the point's
-- distances from the origin of space in cells.
numberAt :: Seed -> Int -> Double -> Double -> Double -> Int
numberAt !seed !number !x !y !z = gradientNumber3 (latticeHash3 seed (latticePoint3 l (index x) (index y) (index z)))
  where
    !l = clampedLevel number
    index n = middleIndex l + fromIntegral (truncate n :: Int)
{-# NOINLINE numberAt #-}

noiseOf :: Seed -> Int -> XYZ -> Double
noiseOf seed number = noise3 seed (clampedLevel number)
{-# NOINLINE noiseOf #-}

-- | The lattice point nearest to a place along one axis, in cells from the origin of
-- space, and how far beyond it the place is, −1\/2 … 1\/2.
data Nearest = Nearest {-# UNPACK #-} !Double {-# UNPACK #-} !Double

-- | Along all axes.
data Nearest3 = Nearest3 {-# UNPACK #-} !Nearest {-# UNPACK #-} !Nearest {-# UNPACK #-} !Nearest

-- | That lattice point, or the one beyond the place.
data Side = Here | Beyond

-- Half of all places are on either side of a lattice point, which no processor can
-- guess: what follows has no branches.

-- | Of a number within ±2^50.
nearest :: Double -> Nearest
nearest scaled = Nearest (scaled - rest) rest
  where
    !rest = turnFraction scaled
{-# INLINE nearest #-}

-- | From the nearest point to the place and on to the next: 1 or −1.
direction :: Nearest -> Double
direction (Nearest point rest) = 1 + 2 * (below - point)
  where
    shifted = point + rest - 0.5
    below = shifted - turnFraction shifted
{-# INLINE direction #-}

distance :: Nearest -> Double
distance (Nearest _ rest) = abs rest
{-# INLINE distance #-}

pointOf :: Side -> Nearest -> Double
pointOf Here (Nearest point _) = point
pointOf Beyond along@(Nearest point _) = point + direction along
{-# INLINE pointOf #-}

-- | From that point to the place.
offsetOf :: Side -> Nearest -> Double
offsetOf Here (Nearest _ rest) = rest
offsetOf Beyond along@(Nearest _ rest) = rest - direction along
{-# INLINE offsetOf #-}

-- | What that point counts at the place.
weightOf :: Side -> Nearest -> Double
weightOf Here = (1 -) . fade . distance
weightOf Beyond = fade . distance
{-# INLINE weightOf #-}

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
tabulatedReach3 x y z = float2Double (indexPrimArray reaches (field x + reachFields * (field y + reachFields * field z)))
  where
    field t = truncate (t * fromIntegral (2 * (reachFields - 1)))
{-# INLINE tabulatedReach3 #-}

-- | Fields of the table from a cell's border to its middle, which has one of its own.
reachFields :: Int
reachFields = 17

-- | In half the memory of doubles, and rounded up.
reaches :: PrimArray Float
reaches = primArrayFromList [double2Float (1.000001 * cellReach3 (inner i) (inner j) (inner k)) | k <- fields, j <- fields, i <- fields]
  where
    fields = [1 .. reachFields]
    inner i = min 0.5 (fromIntegral i / fromIntegral (2 * (reachFields - 1)))
{-# NOINLINE reaches #-}
