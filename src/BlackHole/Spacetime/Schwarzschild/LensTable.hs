{-# LANGUAGE BangPatterns #-}

-- | A table of all light paths through one point.
--
-- Schwarzschild space is spherically symmetric, so all paths that end at one camera are
-- rotations of a family with one parameter: the angle ψ between the line of sight and
-- the outward radius. The table holds the closed form
-- ("BlackHole.Spacetime.Schwarzschild.Orbit") for about 3000 members: the swept angle, the
-- direction at infinity, and @u@ at waypoints in between. The other members are
-- interpolated.
--
-- /The parameter/ is that of "BlackHole.Spacetime.Schwarzschild.LensFamily".
--
-- /The nodes./ Near the critical value @w_c@, where light winds around the photon
-- sphere for ever, everything varies as the logarithm of @|w − w_c|@. The table
-- therefore divides each octave of that distance into 64 intervals, with cubics that
-- match the exact value and slope at both ends. Closer than 2⁻²⁴ the closed form is
-- used directly.
module BlackHole.Spacetime.Schwarzschild.LensTable
  ( LensTable,
    lensTable,
    lensTableRadius,
    lensTableSize,
    lensSeries,
    lensFate,
    lensSlope,
    lensOffset,
  )
where

import BlackHole.Numeric.Parallel (inParallel)
import BlackHole.Spacetime.Fate
import BlackHole.Spacetime.Schwarzschild.LensFamily
import BlackHole.Spacetime.Schwarzschild.Orbit
import BlackHole.Spacetime.Schwarzschild.OrbitSeries
import BlackHole.Vector.XY (XY (..))
import Control.Monad (when)
import Control.Monad.ST (ST)
import Data.Bits (unsafeShiftL, unsafeShiftR, (.&.))
import Data.Foldable (for_)
import Data.Primitive.PrimArray
import GHC.Float (castDoubleToWord64)

-- | The tabulated paths through a point.
data LensTable = LensTable
  { tableFamily :: {-# UNPACK #-} !Family,
    -- | For each block, the index of its first row and the number of its cells. Lazy, like
    -- the numbers: flat space and the edge of the shadow need the family alone.
    tableBlocks :: PrimArray Int,
    tableNumbers :: PrimArray Double
  }

-- | The table of a point at the distance r > 0 from the hole, in Schwarzschild radii.
-- Evaluates about 10 000 orbits, which takes some 14 milliseconds on one core
-- (docs/performance.md).
lensTable :: Double -> LensTable
lensTable r =
  LensTable
    { tableFamily = family,
      tableBlocks = primArrayFromList (concat (zipWith (\o b -> [o, blockCells b]) offsets blocks)),
      tableNumbers = mconcat (inParallel (map (blockNumbers family) blocks))
    }
  where
    family = familyAt r
    blocks = [block family side octave | side <- [minBound ..], octave <- [0 .. octaveCount - 1]]
    offsets = scanl (+) 0 (map blockSize blocks)

-- | The distance of the table's point from the hole, in Schwarzschild radii.
lensTableRadius :: LensTable -> Double
lensTableRadius = familyRadius . tableFamily

-- | The number of 'Double's in the table, 8 bytes each.
lensTableSize :: LensTable -> Int
lensTableSize = sizeofPrimArray . tableNumbers

-- | The side of the critical direction.
data Side = Escaping | Falling
  deriving (Eq, Enum, Bounded)

-- | Number of octaves of the distance from the critical parameter, from 1 downwards.
octaveCount :: Int
octaveCount = 24

-- | Number of intervals per octave.
segmentCount :: Int
segmentCount = 64

-- | One octave on one side.
data Block = Block
  { -- | The parameter at the node nearest to the critical one, and the difference
    -- between successive nodes.
    blockFirst :: !Double,
    blockStep :: !Double,
    -- | Number of cells of its paths; 0 if the octave lies beyond the family's range.
    blockCells :: !Int
  }

blockSize :: Block -> Int
blockSize b
  | blockCells b == 0 = 0
  | otherwise = (segmentCount + 1) * rowSize (blockCells b)

-- | How many numbers a row has: three, and two for each waypoint, each of them with its
-- slope.
rowSize :: Int -> Int
rowSize cells = 2 * (headSize + 2 * cells)

headSize :: Int
headSize = 3

block :: Family -> Side -> Int -> Block
block family side octave = case side of
  Escaping -> within critical (critical - nearest) (negate step)
  Falling -> within (if familyRadius family > 1 then 1 - critical else 0) (critical + nearest) step
  where
    critical = familyCritical family
    nearest = 0.5 ^^ (octave + 1)
    step = nearest / fromIntegral segmentCount
    within range first by
      | nearest > range = Block first by 0
      | otherwise =
        Block first by (max (cellsAt first) (cellsAt (first + by * fromIntegral segmentCount)))
    cellsAt w = let Member _ path = memberAt family w in seriesCells (orbitSeries path)

-- | A path, with the sign of its tangential velocity.
data Member = Member !Double !Orbit

memberAt :: Family -> Double -> Member
memberAt family w = Member (signum t) (orbit (familyRadius family) radial (abs t))
  where
    (radial, tangential) = velocityAt family w
    -- A radial photon sweeps no angle, so this takes its neighbour.
    t = if abs tangential < 1e-12 then 1e-12 else tangential

-- | The rows of a block in order.
blockNumbers :: Family -> Block -> PrimArray Double
blockNumbers family b = runPrimArray $ do
  numbers <- newPrimArray (blockSize b)
  numbers <$ when (cells > 0) (for_ [0 .. segmentCount] (row numbers))
  where
    !cells = blockCells b
    row :: MutablePrimArray s Double -> Int -> ST s ()
    row numbers i = do
      let at t = memberAt family (blockFirst b + (fromIntegral i + t) * blockStep b)
          before@(Member sign0 path0) = at (negate apart)
          here@(Member sign1 path1) = at 0
          after@(Member sign2 path2) = at apart
          first = i * rowSize cells
          put k v0 v1 v2 = do
            writePrimArray numbers (first + 2 * k) v1
            writePrimArray numbers (first + 2 * k + 1) ((v2 - v0) / (2 * apart))
          sweep0 = orbitSeries path0
          sweep1 = orbitSeries path1
          sweep2 = orbitSeries path2
          (c0, s0) = leaving sweep0
          (c1, s1) = leaving sweep1
          (c2, s2) = leaving sweep2
      put 0 (angleOf before) (angleOf here) (angleOf after)
      put 1 c0 c1 c2
      put 2 (sign0 * s0) (sign1 * s1) (sign2 * s2)
      let spacingOf series = seriesAngle series / fromIntegral cells
          !d0 = spacingOf sweep0
          !d1 = spacingOf sweep1
          !d2 = spacingOf sweep2
      for_ [0 .. cells - 1] $ \j -> do
        let (u0, slope0) = waypoint (OfOrbit path0) d0 j
            (u1, slope1) = waypoint (OfOrbit path1) d1 j
            (u2, slope2) = waypoint (OfOrbit path2) d2 j
        put (headSize + 2 * j) u0 u1 u2
        put (headSize + 2 * j + 1) (slope0 * d0) (slope1 * d1) (slope2 * d2)
    angleOf (Member sign path) = sign * seriesAngle (orbitSeries path)
    leaving series = case seriesFate series of
      Escaped (XY c s) -> (c, s)
      _ -> (0, 0)
    -- In units of an interval. The error of the cubic far exceeds that of this
    -- difference.
    apart = 0.01

-- | The result of looking up a photon.
data Found
  = -- | Between two rows: the start of the first row, the number of its cells, the
    -- fraction of the way from one row to the next, the octave, and whether the photon
    -- falls in.
    Between !Int !Int {-# UNPACK #-} !Double !Int !Bool
  | -- | Too close to the critical path, or on a path that the table does not cover.
    Beyond

-- | Looks up a photon of unit energy by its radial and tangential velocity.
find :: LensTable -> Double -> Double -> Found
find (LensTable family blocks _) !radial !tangential
  -- Inside the horizon the table covers only light from outside.
  | distance < closest || (falling && familyRadius family <= 1) = Beyond
  | otherwise = Between (begin + segment * rowSize cells) cells t octave falling
  where
    !offset = parameterOf family radial tangential - familyCritical family
    !falling = offset > 0
    !distance = abs offset
    -- A distance of 2⁻⁽ᵒ⁺¹⁾ (1 + s/64) is a Double with the exponent −(o+1) whose
    -- fraction begins with the six bits of s.
    !bits = castDoubleToWord64 distance
    !octave = max 0 (1022 - fromIntegral (bits `unsafeShiftR` 52)) :: Int
    !segment = fromIntegral ((bits `unsafeShiftR` 46) .&. 63) :: Int
    !t = fromIntegral (bits .&. 0x3fffffffffff) / 70368744177664
    !place = 2 * (octave + if falling then octaveCount else 0)
    begin = indexPrimArray blocks place
    cells = indexPrimArray blocks (place + 1)
{-# INLINE find #-}

-- | Hermite weights of the values and slopes at the two ends of an interval.
data Weights
  = Weights
      {-# UNPACK #-} !Double
      {-# UNPACK #-} !Double
      {-# UNPACK #-} !Double
      {-# UNPACK #-} !Double

weightsAt :: Double -> Weights
weightsAt t =
  Weights
    ((1 + 2 * t) * (1 - t) * (1 - t))
    (t * (1 - t) * (1 - t))
    (t * t * (3 - 2 * t))
    (t * t * (t - 1))
{-# INLINE weightsAt #-}

-- | The interpolated number at the index @k@ of the rows that start at two indices.
mixed :: PrimArray Double -> Weights -> Int -> Int -> Int -> Double
mixed numbers (Weights v0 d0 v1 d1) row row' k =
  v0 * indexPrimArray numbers (row + 2 * k)
    + d0 * indexPrimArray numbers (row + 2 * k + 1)
    + v1 * indexPrimArray numbers (row' + 2 * k)
    + d1 * indexPrimArray numbers (row' + 2 * k + 1)
{-# INLINE mixed #-}

-- | The path of a photon of unit energy, from its radial and tangential velocity. The
-- tangential velocity must be at least 0.
lensSeries :: LensTable -> Double -> Double -> OrbitSeries
lensSeries table !radial !tangential = case find table radial tangential of
  Beyond -> closedForm table radial tangential
  Between row cells t _ falling ->
    let row' = row + rowSize cells
        weights@(Weights v0 d0 v1 d1) = weightsAt t
        at = mixed numbers weights row row'
        end
          | falling = Captured
          | otherwise = Escaped (XY (at 1) (at 2))
     in OrbitSeries
          end
          (max 0 (at 0))
          cells
          (BetweenRows numbers (row + 2 * headSize) (row' + 2 * headSize) v0 d0 v1 d1)
  where
    numbers = tableNumbers table
{-# INLINE lensSeries #-}

-- | The fate of the path that 'lensSeries' returns, without the path.
lensFate :: LensTable -> Double -> Double -> Fate XY
lensFate table !radial !tangential = case find table radial tangential of
  Beyond -> seriesFate (closedForm table radial tangential)
  Between row cells t _ falling
    | falling -> Captured
    | otherwise ->
      let at = mixed (tableNumbers table) (weightsAt t) row (row + rowSize cells)
       in Escaped (XY (at 1) (at 2))
{-# INLINE lensFate #-}

closedForm :: LensTable -> Double -> Double -> OrbitSeries
closedForm table radial tangential = orbitSeries (orbit (lensTableRadius table) radial tangential)
{-# NOINLINE closedForm #-}

-- | The distance from the critical parameter below which the table does not apply.
closest :: Double
closest = 0.5 ^^ octaveCount

-- | The derivative of the angle swept up to infinity with respect to the 'lensOffset',
-- for a photon of unit energy with this radial and tangential velocity. 'Nothing' if
-- the photon does not escape or is closer to the critical path than the table reaches.
lensSlope :: LensTable -> Double -> Double -> Maybe Double
lensSlope table radial tangential = case find table radial tangential of
  Between row cells t octave False ->
    let row' = row + rowSize cells
        at = indexPrimArray (tableNumbers table)
     in -- The derivative of Hermite's interpolation, divided by the length of an
        -- interval: an octave is 2^-(octave + 1) long.
        Just $
          negate
            ( 6 * t * (t - 1) * (at row - at row') + (1 - t) * (1 - 3 * t) * at (row + 1)
                + t * (3 * t - 2) * at (row' + 1)
            )
            * fromIntegral (segmentCount * 2 `unsafeShiftL` octave)
  _ -> Nothing
{-# INLINE lensSlope #-}

-- | The difference between the parameter of a photon of unit energy, given by its
-- radial and tangential velocity, and the critical parameter. For an observer at rest
-- it is about a quarter of the angle between the two directions, in radians. Positive
-- if the photon comes from the horizon.
lensOffset :: LensTable -> Double -> Double -> Double
lensOffset (LensTable family _ _) radial tangential =
  parameterOf family radial tangential - familyCritical family
{-# INLINE lensOffset #-}
