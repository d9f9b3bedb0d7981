{-# LANGUAGE BangPatterns #-}

-- | Smooth functions of two variables as polynomials on rectangles that are halved until
-- the polynomials are accurate.
--
-- A polynomial of degree 7 in each variable goes through the function's values at 8 × 8
-- Chebyshev nodes. Along a line of nodes the values also give the last two of the
-- function's Chebyshev coefficients. These fall geometrically for a smooth function, so
-- that they bound the error of leaving out all further ones.
module BlackHole.Vector.Patch
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
patch tolerance depth f rectangle@(Rectangle mx hx my hy) = case traverse (uncurry f) points of
  Nothing -> Rough
  Just values
    | max restX restY <= tolerance -> Smooth rectangle (polynomials samples)
    | depth <= 0 -> Rough
    | restX >= restY -> HalvesX mx (alongX (mx - 0.5 * hx)) (alongX (mx + 0.5 * hx))
    | otherwise -> HalvesY my (alongY (my - 0.5 * hy)) (alongY (my + 0.5 * hy))
    where
      samples = primArrayFromList (concat [[x, y, z] | XYZ x y z <- values])
      restX = maximum [remainder nodes (\i -> sample i j part) | j <- places, part <- [0 .. 2]]
      restY = maximum [remainder nodes (\j -> sample i j part) | i <- places, part <- [0 .. 2]]
      sample i j part = indexPrimArray samples ((i * nodes + j) * 3 + part)
  where
    alongX middle = half rectangle {middleX = middle, halfX = 0.5 * hx}
    alongY middle = half rectangle {middleY = middle, halfY = 0.5 * hy}
    half = patch tolerance (depth - 1) f
    points = [(mx + hx * node nodes i, my + hy * node nodes j) | i <- places, j <- places]
    places = [0 .. nodes - 1]

-- | @onSmooth f whole x y@ applies a function to the rectangle that holds a point, its
-- coefficients, and the point's place in it, from −1 to 1 in each variable; 'Nothing' where
-- no polynomial is accurate.
onSmooth ::
  (Rectangle -> PrimArray Double -> Double -> Double -> a) -> Patch -> Double -> Double -> Maybe a
onSmooth f whole !x !y = go whole
  where
    go p = case p of
      Smooth rectangle@(Rectangle mx hx my hy) coefficients ->
        let !s = (x - mx) / hx
            !t = (y - my) / hy
            !found = f rectangle coefficients s t
         in Just found
      HalvesX middle low high -> go (if x < middle then low else high)
      HalvesY middle low high -> go (if y < middle then low else high)
      Rough -> Nothing
{-# INLINE onSmooth #-}

-- | The value at a point of the rectangle; 'Nothing' where no polynomial is accurate.
patchValue :: Patch -> Double -> Double -> Maybe XYZ
patchValue = onSmooth $ \_ coefficients !s !t ->
  let !t2 = t * t
      !t4 = t2 * t2
      -- Estrin's scheme: the terms do not wait for each other.
      row k =
        let at l = indexPrimArray coefficients (k + l)
         in (at 0 + t * at 1 + t2 * (at 2 + t * at 3))
              + t4 * (at 4 + t * at 5 + t2 * (at 6 + t * at 7))
      {-# INLINE row #-}
      sums :: Int -> Double -> Double -> Double -> XYZ
      sums !k !a !b !c
        | k < 0 = XYZ a b c
        | otherwise =
          sums
            (k - nodes)
            (a * s + row k)
            (b * s + row (k + square))
            (c * s + row (k + 2 * square))
   in sums (square - nodes) 0 0 0

-- | Number of coefficients of a polynomial.
square :: Int
square = nodes * nodes

-- | Derivatives with respect to both variables.
data Changing = Changing {-# UNPACK #-} !XYZ {-# UNPACK #-} !XYZ

-- | The derivatives at a point of the rectangle.
patchChange :: Patch -> Double -> Double -> Maybe Changing
patchChange = onSmooth $ \(Rectangle _ hx _ hy) coefficients !s !t ->
  let -- Values and derivatives by Horner's rule, in t for each power of s.
      inner :: Int -> Int -> Double -> Double -> Two
      inner !k !l !value !slope
        | l < 0 = Two value slope
        | otherwise =
          let !coefficient = indexPrimArray coefficients (k + l)
           in inner k (l - 1) (value * t + coefficient) (slope * t + value)
      outer :: Int -> Int -> Double -> Double -> Double -> Two
      outer !component !k !value !alongX !alongY
        | k < 0 = Two (alongX / hx) (alongY / hy)
        | otherwise =
          let !(Two v v') = inner (component * square + k * nodes) (nodes - 1) 0 0
           in outer component (k - 1) (value * s + v) (alongX * s + value) (alongY * s + v')
      !(Two ax ay) = outer 0 (nodes - 1) 0 0 0
      !(Two bx by) = outer 1 (nodes - 1) 0 0 0
      !(Two cx cy) = outer 2 (nodes - 1) 0 0 0
   in Changing (XYZ ax bx cx) (XYZ ay by cy)

data Two = Two {-# UNPACK #-} !Double {-# UNPACK #-} !Double

-- | A function of one variable on an interval.
data Curve = Curve {-# UNPACK #-} !Double {-# UNPACK #-} !Double {-# UNPACK #-} !(PrimArray Double)

-- | @curve tolerance n f middle half@ is the polynomial through the values at @n@
-- Chebyshev nodes, an even number. 'Nothing' if it is not accurate.
curve :: Double -> Int -> (Double -> Double) -> Double -> Double -> Maybe Curve
curve tolerance count f middle half
  | remainder count sample <= tolerance =
    Just (Curve middle half (generatePrimArray count (\k -> times count ofPowers k sample)))
  | otherwise = Nothing
  where
    ofPowers = snd (matrices count)
    sample = indexPrimArray samples
    samples = generatePrimArray count (\i -> f (middle + half * node count i))

-- | The value of the function at a point of the interval.
curveValue :: Curve -> Double -> Double
curveValue (Curve middle half coefficients) x = go (sizeofPrimArray coefficients - 2) 0 0
  where
    !t = (x - middle) / half
    !t2 = t * t
    -- Even and odd powers apart, which do not wait for each other.
    go :: Int -> Double -> Double -> Double
    go !k !even' !odd'
      | k < 0 = even' + t * odd'
      | otherwise =
        go
          (k - 2)
          (even' * t2 + indexPrimArray coefficients k)
          (odd' * t2 + indexPrimArray coefficients (k + 1))

-- | Chebyshev nodes in (−1, 1).
node :: Int -> Int -> Double
node count i = cos (angle count i)

angle :: Int -> Int -> Double
angle count i = pi * (fromIntegral i + 0.5) / fromIntegral count

-- | The sizes of the last two Chebyshev coefficients of the function with these values at
-- the nodes.
remainder :: Int -> (Int -> Double) -> Double
remainder count value = abs (row (count - 1)) + abs (row (count - 2))
  where
    !matrix = fst (matrices count)
    row k = times count matrix k value
{-# INLINE remainder #-}

-- | The product of a row of a square matrix with the values.
times :: Int -> PrimArray Double -> Int -> (Int -> Double) -> Double
times count matrix k value = go 0 0
  where
    go :: Int -> Double -> Double
    go !i !total
      | i >= count = total
      | otherwise = go (i + 1) (total + indexPrimArray matrix (k * count + i) * value i)
{-# INLINE times #-}

-- | The polynomials' coefficients, from the three components at all nodes.
polynomials :: PrimArray Double -> PrimArray Double
polynomials samples = generatePrimArray (3 * square) $ \at ->
  let (component, place) = quotRem at square
      (k, l) = quotRem place nodes
   in times nodes matrix k (\i -> indexPrimArray along ((component * nodes + i) * nodes + l))
  where
    !matrix = snd (matrices nodes)
    -- Powers of y at the nodes of x.
    !along = generatePrimArray (3 * square) $ \at ->
      let (component, place) = quotRem at square
          (i, l) = quotRem place nodes
       in times nodes matrix l (\j -> indexPrimArray samples ((i * nodes + j) * 3 + component))

-- | The matrices that turn values at the nodes into coefficients of the Chebyshev
-- polynomials and of the powers, row by row.
matrices :: Int -> (PrimArray Double, PrimArray Double)
matrices count
  | count == nodes = patchMatrices
  | otherwise = matricesOf count

patchMatrices :: (PrimArray Double, PrimArray Double)
patchMatrices = matricesOf nodes
{-# NOINLINE patchMatrices #-}

matricesOf :: Int -> (PrimArray Double, PrimArray Double)
matricesOf count = (primArrayFromList (concat ofChebyshev), primArrayFromList (concat ofPowers))
  where
    ofChebyshev =
      [ [weight m * cos (fromIntegral m * angle count i) | i <- places]
        | m <- places
      ]
    weight m = (if m == 0 then 1 else 2) / fromIntegral count
    ofPowers =
      [ [ sum [c !! k * row !! i | (c, row) <- zip chebyshev ofChebyshev, k < length c]
          | i <- places
        ]
        | k <- places
      ]
    places = [0 .. count - 1]
    -- The Chebyshev polynomials by powers.
    chebyshev = map fst (iterate (\(t, next) -> (next, minus (0 : map (2 *) next) t)) ([1], [0, 1]))
    minus (p : ps) (q : qs) = (p - q) : minus ps qs
    minus ps [] = ps
    minus [] qs = map negate qs
