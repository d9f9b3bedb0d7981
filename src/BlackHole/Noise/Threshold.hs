{-# LANGUAGE BangPatterns #-}
-- Positions and their neighbours stay on the stack.
{-# OPTIONS_GHC -fmax-worker-args=32 #-}

-- | Noise in space above a threshold, for sparsely scattered objects such as stars:
-- most positions are rejected before most of their lattice points have been hashed.
--
-- A corner of a cell contributes at most its weight times its distance. A few numbers
-- therefore bound what the corners not yet hashed, and the finer levels, can still add.
module BlackHole.Noise.Threshold
  ( perlin3Above,
    cellReach3,
    tabulatedReach3,
  )
where

import BlackHole.Noise.Gradient
import BlackHole.Noise.Lattice
import BlackHole.Noise.PerlinG
import BlackHole.Noise.Profile (Profile, layers)
import BlackHole.Numeric.Floor (turnFraction)
import BlackHole.Vector.XYZ (XYZ (..))
import qualified BlackHole.Vector.XYZ as XYZ
import Data.Primitive.PrimArray
import GHC.Float (double2Float, float2Double)

-- | @perlin3Above seed profile least place@ is 'perlin3', to the last bit, where it is
-- at least @least@, and 'Nothing' elsewhere. Bind the result of the first two arguments
-- to compute only once what depends on them alone.
--
-- The function is long because its loops share the tables that are made once.
perlin3Above :: Seed -> Profile -> Double -> XYZ -> Maybe Double
perlin3Above seed p
  | count > 0 && all (\l -> levelNumber l >= 1 && levelNumber l <= 50) named = above
  | otherwise =
    \least v -> let value = perlin3 seed p v in if value >= least then Just value else Nothing
  where
    !count = length named
    named = map fst (layers p)
    !amplitudes = primArrayFromList (map snd (layers p))
    !edges = primArrayFromList (map cellsPerUnit named)
    !levels = primArrayFromList (map levelNumber named)

    above !least v = case onGrid3 v of
      Nothing -> if 0 >= least then Just 0 else Nothing
      -- The margin allows for the rounding of the sums.
      Just place -> bounded least place 0 1e-9

    -- The bound on the sum of all levels at this position.
    bounded :: Double -> GridPlace3 -> Int -> Double -> Maybe Double
    bounded !least place !i !bound
      | i < count = bounded least place (i + 1) (bound + reach i (nearestIn place i))
      | bound < least = Nothing
      | otherwise =
        let !corner = nearestIn place 0
         in screened least place bound 0 corner (bound - loss 0 corner Here Here Here)

    -- Hashes the corners that can contribute most, each of which lowers the bound: the
    -- nearest one of each level and then, before the next level, the three beside it.
    -- (The nearest corner of the first level has been hashed already.) The other four
    -- are left to 'summed', because few positions get there.
    screened :: Double -> GridPlace3 -> Double -> Int -> Nearest3 -> Double -> Maybe Double
    screened !least place !whole !i corner !bound
      | bound < least = Nothing
      | i' >= count =
        beside bound (\bound' -> if bound' < least then Nothing else summed least place 0 0 whole)
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

    -- By how much the gradient of a corner falls short of the best possible one.
    loss :: Int -> Nearest3 -> Side -> Side -> Side -> Double
    loss !i (Nearest3 x y z) a b c =
      weight
        * (abs amplitude * XYZ.norm offset - amplitude * XYZ.dot (numberedGradient3 number) offset)
      where
        !amplitude = indexPrimArray amplitudes i
        !number = numberAt seed (indexPrimArray levels i) (pointOf a x) (pointOf b y) (pointOf c z)
        !offset = XYZ (offsetOf a x) (offsetOf b y) (offsetOf c z)
        !weight = noiseScale3 * (weightOf a x * weightOf b y * weightOf c z)
    {-# INLINE loss #-}

    -- The sum of the levels before this one, and the bound on what this one and the
    -- others can add.
    summed :: Double -> GridPlace3 -> Int -> Double -> Double -> Maybe Double
    summed !least place@(GridPlace3 px py pz) !i !total !others
      | total + others < least = Nothing
      | i >= count = if total >= least then Just total else Nothing
      | otherwise =
        summed
          least
          place
          (i + 1)
          ( total
              + indexPrimArray amplitudes i * noiseOf seed (indexPrimArray levels i) (XYZ px py pz)
          )
          (others - reach i (nearestIn place i))

    reach !i (Nearest3 x y z) =
      abs (indexPrimArray amplitudes i) * tabulatedReach3 (distance x) (distance y) (distance z)
    {-# INLINE reach #-}

    nearestIn (GridPlace3 x y z) !i =
      Nearest3 (nearest (edge * x)) (nearest (edge * y)) (nearest (edge * z))
      where
        !edge = indexPrimArray edges i
    {-# INLINE nearestIn #-}

-- | The number of the gradient at a lattice point, from the level's number and the
-- point's distances from the origin of space in cells.
numberAt :: Seed -> Int -> Double -> Double -> Double -> Int
numberAt !seed !number !x !y !z =
  gradientNumber3 (latticeHash3 seed (latticePoint3 l (index x) (index y) (index z)))
  where
    !l = clampedLevel number
    index n = middleIndex l + fromIntegral (truncate n :: Int)
{-# NOINLINE numberAt #-}

noiseOf :: Seed -> Int -> XYZ -> Double
noiseOf seed number = noise3 seed (clampedLevel number)
{-# NOINLINE noiseOf #-}

-- | The lattice point nearest to a position along one axis, in cells from the origin of
-- space, and the offset of the position from it, −1\/2 to 1\/2.
data Nearest = Nearest {-# UNPACK #-} !Double {-# UNPACK #-} !Double

-- | The nearest points along all three axes.
data Nearest3 = Nearest3 {-# UNPACK #-} !Nearest {-# UNPACK #-} !Nearest {-# UNPACK #-} !Nearest

-- | The nearest lattice point, or the one on the other side of the position.
data Side = Here | Beyond

-- Half of all positions lie on either side of a lattice point, which defeats branch
-- prediction, so the following functions have no branches.

-- | The nearest lattice point of a coordinate within ±2^50.
nearest :: Double -> Nearest
nearest scaled = Nearest (scaled - rest) rest
  where
    !rest = turnFraction scaled
{-# INLINE nearest #-}

-- | The direction from the nearest point through the position to the next point: 1 or
-- −1.
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

-- | The offset of the position from that point.
offsetOf :: Side -> Nearest -> Double
offsetOf Here (Nearest _ rest) = rest
offsetOf Beyond along@(Nearest _ rest) = rest - direction along
{-# INLINE offsetOf #-}

-- | The weight of that point at the position.
weightOf :: Side -> Nearest -> Double
weightOf Here = (1 -) . fade . distance
weightOf Beyond = fade . distance
{-# INLINE weightOf #-}

-- | An upper bound on the modulus of 'noise3' at a position in a cell (each fraction 0
-- to 1), for any gradients.
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

-- | A slightly larger bound than 'cellReach3', from a table indexed by the distances to
-- the nearest borders, 0 to 1\/2. The bound grows towards the cell's middle, so each
-- field of the table holds the value at its innermost corner.
tabulatedReach3 :: Double -> Double -> Double -> Double
tabulatedReach3 x y z =
  float2Double (indexPrimArray reaches (field x + reachFields * (field y + reachFields * field z)))
  where
    field t = truncate (t * fromIntegral (2 * (reachFields - 1)))
{-# INLINE tabulatedReach3 #-}

-- | The number of fields of the table from a cell's border to its middle, which has a
-- field of its own.
reachFields :: Int
reachFields = 17

-- | Rounded up, in single precision to halve the memory.
reaches :: PrimArray Float
reaches =
  primArrayFromList
    [ double2Float (1.000001 * cellReach3 (inner i) (inner j) (inner k))
      | k <- fields,
        j <- fields,
        i <- fields
    ]
  where
    fields = [1 .. reachFields]
    inner i = min 0.5 (fromIntegral i / fromIntegral (2 * (reachFields - 1)))
{-# NOINLINE reaches #-}
