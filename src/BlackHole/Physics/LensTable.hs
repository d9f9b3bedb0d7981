{-# LANGUAGE BangPatterns #-}

-- | All light paths through one place, tabulated.
--
-- Space is the same in all directions from the hole, so the paths that end in
-- one camera are rotations of a family with one parameter, the angle ψ between
-- the line of sight and the outward radius. The table holds the closed form
-- ("BlackHole.Physics.Orbit") for some 1500 members: the swept angle, the
-- direction at infinity, and @u@ at waypoints in between. The others are
-- interpolated.
--
-- /The parameter/ is @w = tan(ψ\/4)@: smooth and monotone from 0 (outwards) to 1
-- (inwards) and rational in the components of the velocity. Inside the horizon,
-- where nobody is at rest to measure ψ, it is that of somebody who falls in from
-- rest at infinity.
--
-- /The nodes./ At the critical @w_c@, where light winds round the photon sphere
-- for ever, everything varies as the logarithm of @|w − w_c|@. So each octave of
-- that distance is cut into the same number of segments, with cubics that have
-- the exact value and slope at both ends. Closer than 2⁻²⁴ the closed form
-- answers.
module BlackHole.Physics.LensTable
  ( LensTable,
    lensTable,
    lensTableRadius,
    lensTableSize,
    lensSweep,
    lensEnd,
    lensTurning,
  )
where

import BlackHole.Numeric.Parallel (inParallel)
import BlackHole.Physics.Orbit
import BlackHole.Physics.Radii (criticalImpactParameter)
import BlackHole.Physics.Sweep
import Control.Monad (when)
import Control.Monad.ST (ST)
import Data.Bits (unsafeShiftR, (.&.))
import Data.Foldable (for_)
import Data.Primitive.PrimArray
import GHC.Float (castDoubleToWord64)

-- | What the parameter of a place's paths depends on.
data Family = Family
  { familyRadius :: {-# UNPACK #-} !Double,
    -- | √(1 − 1/r), the lapse of an observer at rest there; inside the horizon
    -- √(1/r), the speed of one who falls in from rest at infinity.
    _familyLapse :: {-# UNPACK #-} !Double,
    familyCritical :: {-# UNPACK #-} !Double
  }

-- | The paths through a place.
data LensTable = LensTable
  { tableFamily :: {-# UNPACK #-} !Family,
    -- | For each block where its rows begin and how many cells they have.
    tableBlocks :: !(PrimArray Int),
    tableNumbers :: !(PrimArray Double)
  }

-- | The table of a place at a distance r > 0 from the hole, in Schwarzschild
-- radii. Costs some 6000 orbits, ten milliseconds.
lensTable :: Double -> LensTable
lensTable r =
  LensTable
    { tableFamily = family,
      tableBlocks = primArrayFromList (concat (zipWith (\o b -> [o, blockCells b]) offsets blocks)),
      tableNumbers = mconcat (inParallel (map (blockNumbers family) blocks))
    }
  where
    family = Family r (if r > 1 then sqrt (1 - 1 / r) else sqrt (1 / r)) (criticalParameter r)
    blocks = [block family side octave | side <- [minBound ..], octave <- [0 .. octaveCount - 1]]
    offsets = scanl (+) 0 (map blockSize blocks)

-- | The place's distance from the hole, in Schwarzschild radii.
lensTableRadius :: LensTable -> Double
lensTableRadius = familyRadius . tableFamily

-- | How many numbers the table holds, 8 bytes each.
lensTableSize :: LensTable -> Int
lensTableSize = sizeofPrimArray . tableNumbers

-- | Which side of the critical direction.
data Side = Escaping | Falling
  deriving (Eq, Enum, Bounded)

-- | The parameter of the photon that winds round for ever. With u = 1/r,
-- cos ψ_c is −(1 − 3u/2)√(1 + 3u), free of cancellation at r = 3/2.
criticalParameter :: Double -> Double
criticalParameter r
  | r <= 1 =
    let infall = sqrt (1 / r)
        t = criticalImpactParameter / r
     in fallingParameter infall (sqrt (1 + (infall * infall - 1) * t * t)) t
  | otherwise = quarterTangent cosine (criticalImpactParameter * sqrt (1 - u) * u)
  where
    u = 1 / r
    cosine = (1.5 * u - 1) * sqrt (1 + 3 * u)

-- | tan(ψ/4) from cos ψ and sin ψ.
quarterTangent :: Double -> Double -> Double
quarterTangent cosine sine = sine / (high + sqrt (2 * high))
  where
    -- 1 + cos ψ.
    high
      | cosine < 0 = sine * sine / (1 - cosine)
      | otherwise = 1 + cosine
{-# INLINE quarterTangent #-}

-- | tan(ψ/4) for somebody who falls at this speed (the aberration of what
-- somebody at rest would see, where there is one), from the velocity of a photon
-- of unit energy.
fallingParameter :: Double -> Double -> Double -> Double
fallingParameter infall radial tangential = half / (1 + sqrt (1 + half * half))
  where
    half = tangential * (1 + infall) / (1 + radial)
{-# INLINE fallingParameter #-}

-- | The parameter of a photon of unit energy.
parameterOf :: Family -> Double -> Double -> Double
parameterOf (Family r lapse _) radial tangential
  | r > 1 = quarterTangent radial (tangential * lapse)
  | otherwise = fallingParameter lapse radial tangential
{-# INLINE parameterOf #-}

-- | A member of the family: its pseudo-velocity, radial and tangential. The
-- tangential part is negative beyond both ends of the parameter's range, where
-- the family begins again, mirrored.
velocityAt :: Family -> Double -> (Double, Double)
velocityAt (Family r lapse _) w
  | r > 1 =
    let halfCosine = (1 - w * w) / (1 + w * w)
        halfSine = 2 * w / (1 + w * w)
     in ( (halfCosine - halfSine) * (halfCosine + halfSine),
          2 * halfSine * halfCosine / lapse
        )
  | otherwise =
    let half = 2 * w / (1 - w * w)
        t = 2 * half / ((1 + lapse) - (lapse - 1) * half * half)
     in (sqrt (1 + (lapse * lapse - 1) * t * t), t)

-- | Octaves of the distance from the critical parameter, from 1 down.
octaveCount :: Int
octaveCount = 24

-- | Segments of an octave.
segmentCount :: Int
segmentCount = 64

-- | One octave on one side.
data Block = Block
  { -- | The parameter at its nodes: that of the node nearest to the critical
    -- one, and the difference from each to the next.
    blockFirst :: !Double,
    blockStep :: !Double,
    -- | Cells of its paths; 0 if the octave lies beyond the family's range.
    blockCells :: !Int
  }

blockSize :: Block -> Int
blockSize b
  | blockCells b == 0 = 0
  | otherwise = (segmentCount + 1) * rowSize (blockCells b)

-- | The numbers of a row: three and two for each waypoint, all with their
-- slopes.
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
      | otherwise = Block first by (max (cellsAt first) (cellsAt (first + by * fromIntegral segmentCount)))
    cellsAt w = let Member _ path = memberAt family w in sweepCells (orbitSweep path)

-- | A path with the sign of its tangential velocity.
data Member = Member !Double !Orbit

memberAt :: Family -> Double -> Member
memberAt family w = Member (signum t) (orbit (familyRadius family) radial (abs t))
  where
    (radial, tangential) = velocityAt family w
    -- A radial photon sweeps no angle to speak of; its neighbour does.
    t = if abs tangential < 1e-12 then 1e-12 else tangential

-- | The rows of a block, one after the other.
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
          sweep0 = orbitSweep path0
          sweep1 = orbitSweep path1
          sweep2 = orbitSweep path2
          (c0, s0) = leaving sweep0
          (c1, s1) = leaving sweep1
          (c2, s2) = leaving sweep2
      put 0 (angleOf before) (angleOf here) (angleOf after)
      put 1 c0 c1 c2
      put 2 (sign0 * s0) (sign1 * s1) (sign2 * s2)
      let spacingOf sweep = sweepAngle sweep / fromIntegral cells
          !d0 = spacingOf sweep0
          !d1 = spacingOf sweep1
          !d2 = spacingOf sweep2
      for_ [0 .. cells - 1] $ \j -> do
        let (u0, slope0) = waypoint (OfOrbit path0) d0 j
            (u1, slope1) = waypoint (OfOrbit path1) d1 j
            (u2, slope2) = waypoint (OfOrbit path2) d2 j
        put (headSize + 2 * j) u0 u1 u2
        put (headSize + 2 * j + 1) (slope0 * d0) (slope1 * d1) (slope2 * d2)
    angleOf (Member sign path) = sign * sweepAngle (orbitSweep path)
    leaving sweep = case sweepEnd sweep of
      Leaves c s -> (c, s)
      FallsIn -> (0, 0)
      CirclesOn -> (0, 0)
    -- Of a segment. The cubic's own error is far larger than that of this
    -- difference.
    apart = 0.01

-- | Where in the table a photon's path lies.
data Found
  = -- | Between two rows: where they begin, their cells, the part of the way from
    -- one to the other, the octave, and whether the photon falls in.
    Between !Int !Int {-# UNPACK #-} !Double !Int !Bool
  | -- | Too close to the critical path, or of no use there.
    Beyond

-- | Look up a photon of unit energy by its radial and tangential velocity.
find :: LensTable -> Double -> Double -> Found
find (LensTable family blocks _) !radial !tangential
  -- Inside the horizon only light from outside is worth a table.
  | distance < closest || (falling && familyRadius family <= 1) = Beyond
  | otherwise = Between (begin + segment * rowSize cells) cells t octave falling
  where
    !offset = parameterOf family radial tangential - familyCritical family
    !falling = offset > 0
    !distance = abs offset
    -- A distance of 2⁻⁽ᵒ⁺¹⁾ (1 + s/64) is a Double with the exponent
    -- −(o+1) whose fraction begins with the six bits of s.
    !bits = castDoubleToWord64 distance
    !octave = max 0 (1022 - fromIntegral (bits `unsafeShiftR` 52)) :: Int
    !segment = fromIntegral ((bits `unsafeShiftR` 46) .&. 63) :: Int
    !t = fromIntegral (bits .&. 0x3fffffffffff) / 70368744177664
    !place = 2 * (octave + if falling then octaveCount else 0)
    begin = indexPrimArray blocks place
    cells = indexPrimArray blocks (place + 1)
{-# INLINE find #-}

-- | Hermite's weights of the values and slopes at the two ends of a segment.
data Weights
  = Weights
      {-# UNPACK #-} !Double
      {-# UNPACK #-} !Double
      {-# UNPACK #-} !Double
      {-# UNPACK #-} !Double

weightsAt :: Double -> Weights
weightsAt t = Weights ((1 + 2 * t) * (1 - t) * (1 - t)) (t * (1 - t) * (1 - t)) (t * t * (3 - 2 * t)) (t * t * (t - 1))
{-# INLINE weightsAt #-}

-- | The number of this place in the rows that begin at two indices.
mixed :: PrimArray Double -> Weights -> Int -> Int -> Int -> Double
mixed numbers (Weights v0 d0 v1 d1) row row' k =
  v0 * indexPrimArray numbers (row + 2 * k)
    + d0 * indexPrimArray numbers (row + 2 * k + 1)
    + v1 * indexPrimArray numbers (row' + 2 * k)
    + d1 * indexPrimArray numbers (row' + 2 * k + 1)
{-# INLINE mixed #-}

-- | The path of a photon of unit energy from its radial and tangential
-- velocity, the tangential one at least 0.
lensSweep :: LensTable -> Double -> Double -> Sweep
lensSweep table !radial !tangential = case find table radial tangential of
  Beyond -> closedForm table radial tangential
  Between row cells t _ falling ->
    let row' = row + rowSize cells
        weights@(Weights v0 d0 v1 d1) = weightsAt t
        at = mixed numbers weights row row'
        end
          | falling = FallsIn
          | otherwise = Leaves (at 1) (at 2)
     in Sweep end (max 0 (at 0)) cells (BetweenRows numbers (row + 2 * headSize) (row' + 2 * headSize) v0 d0 v1 d1)
  where
    numbers = tableNumbers table
{-# INLINE lensSweep #-}

-- | The end of that path alone.
lensEnd :: LensTable -> Double -> Double -> SweepEnd
lensEnd table !radial !tangential = case find table radial tangential of
  Beyond -> sweepEnd (closedForm table radial tangential)
  Between row cells t _ falling
    | falling -> FallsIn
    | otherwise ->
      let at = mixed (tableNumbers table) (weightsAt t) row (row + rowSize cells)
       in Leaves (at 1) (at 2)
{-# INLINE lensEnd #-}

closedForm :: LensTable -> Double -> Double -> Sweep
closedForm table radial tangential = orbitSweep (orbit (lensTableRadius table) radial tangential)
{-# NOINLINE closedForm #-}

-- | The distance from the critical parameter below which the table ends.
closest :: Double
closest = 0.5 ^^ octaveCount

-- | How the angle swept up to infinity changes between two neighbouring photons
-- of unit energy, each given by its radial and tangential velocity: the
-- difference of their parameters times the slope at the first. 'Nothing' where
-- the first does not escape or is closer to the critical one than the table.
lensTurning :: LensTable -> (Double, Double) -> (Double, Double) -> Maybe Double
lensTurning table (radial, tangential) (radial', tangential') = case find table radial tangential of
  Between row cells t octave False ->
    let row' = row + rowSize cells
        at = indexPrimArray (tableNumbers table)
        change = parameter radial tangential - parameter radial' tangential'
        -- The derivative of Hermite's interpolation, over the length of a segment.
        slope =
          (6 * t * (t - 1) * (at row - at row') + (1 - t) * (1 - 3 * t) * at (row + 1) + t * (3 * t - 2) * at (row' + 1))
            * fromIntegral segmentCount
            * 2 ^^ (octave + 1)
     in Just (slope * change)
  _ -> Nothing
  where
    parameter = parameterOf (tableFamily table)
