{-# LANGUAGE BangPatterns #-}

-- | Smooth functions of two variables as polynomials on rectangles that are halved until
-- the polynomials are accurate.
--
-- A polynomial of degree 7 in each variable goes through the function's values at 8 × 8
-- Chebyshev nodes. Along a line of nodes the values also give the last two of the
-- function's Chebyshev coefficients. These fall geometrically for a smooth function, so
-- that they bound the error of leaving out all further ones.
module BlackHole.Numeric.Patch
  ( Patch,
    Rectangle (..),
    patch,
    patchValue,
    Changing (..),
    patchChange,

    -- * One variable
    Curve,
    curve,
    curveValue,
  )
where

import BlackHole.Vector.XYZ (XYZ (..))
import Data.Foldable (for_)
import Data.Primitive.PrimArray

-- | The middle and half width of the range of each variable.
data Rectangle = Rectangle
  { middleX :: {-# UNPACK #-} !Double,
    halfX :: {-# UNPACK #-} !Double,
    middleY :: {-# UNPACK #-} !Double,
    halfY :: {-# UNPACK #-} !Double
  }

-- | A function on a rectangle. Parts of it are computed at their first use.
data Patch
  = -- | The coefficients of three polynomials, as powers of the variables, each of
    -- which runs from −1 to 1: those of @y@ for each power of @x@.
    Smooth {-# UNPACK #-} !Rectangle {-# UNPACK #-} !(PrimArray Double)
  | -- | The halves below and above the middle of the range of @x@.
    HalvesX {-# UNPACK #-} !Double Patch Patch
  | HalvesY {-# UNPACK #-} !Double Patch Patch
  | -- | Where no polynomial serves.
    Rough

-- | Number of nodes in each variable.
nodes :: Int
nodes = 8

-- | @patch tolerance depth f rectangle@ approximates a function where it has values. The
-- tolerance is for each component. A rectangle is halved this many times at most. Costs
-- 64 evaluations for each rectangle.
patch :: Double -> Int -> (Double -> Double -> Maybe XYZ) -> Rectangle -> Patch
patch tolerance = go
  where
    go depth f rectangle@(Rectangle mx hx my hy) = case traverse (uncurry f) places of
      Nothing -> Rough
      Just values
        | worst <= tolerance -> Smooth rectangle (polynomials samples)
        | depth <= 0 -> Rough
        | worstX >= worstY -> HalvesX mx (go (depth - 1) f rectangle {middleX = mx - 0.5 * hx, halfX = 0.5 * hx}) (go (depth - 1) f rectangle {middleX = mx + 0.5 * hx, halfX = 0.5 * hx})
        | otherwise -> HalvesY my (go (depth - 1) f rectangle {middleY = my - 0.5 * hy, halfY = 0.5 * hy}) (go (depth - 1) f rectangle {middleY = my + 0.5 * hy, halfY = 0.5 * hy})
        where
          samples = primArrayFromList (concat [[x, y, z] | XYZ x y z <- values])
          worst = max worstX worstY
          worstX = maximum [remainder nodes (\i -> sample i j component) | j <- [0 .. nodes - 1], component <- [0 .. 2]]
          worstY = maximum [remainder nodes (\j -> sample i j component) | i <- [0 .. nodes - 1], component <- [0 .. 2]]
          sample i j component = indexPrimArray samples ((i * nodes + j) * 3 + component)
      where
        places = [(mx + hx * node nodes i, my + hy * node nodes j) | i <- [0 .. nodes - 1], j <- [0 .. nodes - 1]]

-- | The value at a point of the rectangle; 'Nothing' where no polynomial is accurate.
patchValue :: Patch -> Double -> Double -> Maybe XYZ
patchValue whole !x !y = go whole
  where
    go p = case p of
      Smooth (Rectangle mx hx my hy) coefficients ->
        let !s = (x - mx) / hx
            !t = (y - my) / hy
            row k =
              let at l = indexPrimArray coefficients (k + l)
               in at 0 + t * (at 1 + t * (at 2 + t * (at 3 + t * (at 4 + t * (at 5 + t * (at 6 + t * at 7))))))
            {-# INLINE row #-}
            sums :: Int -> Double -> Double -> Double -> Maybe XYZ
            sums !k !a !b !c
              | k < 0 = Just (XYZ a b c)
              | otherwise = sums (k - nodes) (a * s + row k) (b * s + row (k + square)) (c * s + row (k + 2 * square))
         in sums (square - nodes) 0 0 0
      HalvesX middle low high -> go (if x < middle then low else high)
      HalvesY middle low high -> go (if y < middle then low else high)
      Rough -> Nothing

-- | Number of coefficients of a polynomial.
square :: Int
square = nodes * nodes

-- | Derivatives with respect to both variables.
data Changing = Changing !XYZ !XYZ

-- | The derivatives at a point of the rectangle.
patchChange :: Patch -> Double -> Double -> Maybe Changing
patchChange whole x y = go whole
  where
    go p = case p of
      Smooth (Rectangle mx hx my hy) coefficients ->
        let s = (x - mx) / hx
            t = (y - my) / hy
            at component k l = indexPrimArray coefficients (component * square + k * nodes + l)
            along power power' component =
              sum [at component k l * power s k * power' t l | k <- [0 .. nodes - 1], l <- [0 .. nodes - 1]]
            three f = XYZ (f 0) (f 1) (f 2)
         in Just (Changing (three (\c -> along slope (^) c / hx)) (three (\c -> along (^) slope c / hy)))
      HalvesX middle low high -> go (if x < middle then low else high)
      HalvesY middle low high -> go (if y < middle then low else high)
      Rough -> Nothing
    slope :: Double -> Int -> Double
    slope v k = if k == 0 then 0 else fromIntegral k * v ^ (k - 1)

-- | A function of one variable on an interval.
data Curve = Curve {-# UNPACK #-} !Double {-# UNPACK #-} !Double {-# UNPACK #-} !(PrimArray Double)

-- | @curve tolerance n f middle half@ is the polynomial through the values at @n@
-- Chebyshev nodes. 'Nothing' if it is not accurate.
curve :: Double -> Int -> (Double -> Double) -> Double -> Double -> Maybe Curve
curve tolerance count f middle half
  | remainder count (indexPrimArray samples) <= tolerance = Just (Curve middle half (transformed count samples))
  | otherwise = Nothing
  where
    samples = generatePrimArray count (\i -> f (middle + half * node count i))

-- | The value of the function at a point of the interval.
curveValue :: Curve -> Double -> Double
curveValue (Curve middle half coefficients) x = go (sizeofPrimArray coefficients - 1) 0
  where
    !t = (x - middle) / half
    go :: Int -> Double -> Double
    go !k !total
      | k < 0 = total
      | otherwise = go (k - 1) (total * t + indexPrimArray coefficients k)

-- | Chebyshev nodes in (−1, 1).
node :: Int -> Int -> Double
node count i = cos (angle count i)

angle :: Int -> Int -> Double
angle count i = pi * (fromIntegral i + 0.5) / fromIntegral count

-- | The sizes of the last two Chebyshev coefficients of the function with these values at
-- the nodes.
remainder :: Int -> (Int -> Double) -> Double
remainder count value = size (count - 1) + size (count - 2)
  where
    size k = 2 / fromIntegral count * abs (sum [value i * cos (fromIntegral k * angle count i) | i <- [0 .. count - 1]])

-- | The coefficients of the powers from the values at the nodes.
transformed :: Int -> PrimArray Double -> PrimArray Double
transformed count values =
  generatePrimArray count (\k -> sum [indexPrimArray matrix (k * count + i) * indexPrimArray values i | i <- [0 .. count - 1]])
  where
    matrix = powersOfValues count

-- | 'transformed' in both variables for three components.
polynomials :: PrimArray Double -> PrimArray Double
polynomials samples = runPrimArray $ do
  result <- newPrimArray (3 * square)
  for_ [0 .. 2] $ \component -> do
    half <- newPrimArray square
    for_ [0 .. nodes - 1] $ \i -> for_ [0 .. nodes - 1] $ \l ->
      writePrimArray half (i * nodes + l) (rowTimes (\j -> indexPrimArray samples ((i * nodes + j) * 3 + component)) l)
    halfway <- unsafeFreezePrimArray half
    for_ [0 .. nodes - 1] $ \k -> for_ [0 .. nodes - 1] $ \l ->
      writePrimArray result (component * square + k * nodes + l) (rowTimes (\i -> indexPrimArray halfway (i * nodes + l)) k)
  pure result
  where
    rowTimes :: (Int -> Double) -> Int -> Double
    rowTimes value k = go 0 0
      where
        go :: Int -> Double -> Double
        go !i !total
          | i >= nodes = total
          | otherwise = go (i + 1) (total + indexPrimArray patchMatrix (k * nodes + i) * value i)
    {-# INLINE rowTimes #-}

patchMatrix :: PrimArray Double
patchMatrix = powersOfValues nodes
{-# NOINLINE patchMatrix #-}

-- | The matrix that turns values at the nodes into coefficients of the powers, row by row.
powersOfValues :: Int -> PrimArray Double
powersOfValues count =
  primArrayFromList
    [ sum [c !! k * weight m * cos (fromIntegral m * angle count i) | (m, c) <- zip [0 :: Int ..] chebyshev, k < length c]
      | k <- [0 .. count - 1],
        i <- [0 .. count - 1]
    ]
  where
    weight m = (if m == 0 then 1 else 2) / fromIntegral count
    -- The Chebyshev polynomials by powers.
    chebyshev = take count (map fst (iterate (\(t, next) -> (next, minus (0 : map (2 *) next) t)) ([1], [0, 1])))
    minus (p : ps) (q : qs) = (p - q) : minus ps qs
    minus ps [] = ps
    minus [] qs = map negate qs
