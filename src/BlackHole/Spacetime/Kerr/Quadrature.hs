{-# LANGUAGE BangPatterns #-}

-- | Gauss–Legendre quadrature of functions whose singularities are known.
module BlackHole.Spacetime.Kerr.Quadrature
  ( integrate,
    integrateBeside,
  )
where

import BlackHole.Spacetime.Kerr.Precision
import Data.Primitive.PrimArray

-- | @integrate n f x y@: the integral of a function from @x@ to @y@ by the
-- Gauss–Legendre rule with 16 nodes in each of @n ≥ 1@ equal panels (Abramowitz
-- and Stegun, table 25.4). A function without a singularity within a panel's
-- width of the panel is integrated to rounding.
integrate :: Int -> (Double -> Double) -> Double -> Double -> Double
integrate panels f from to = go 0 0
  where
    !half = 0.5 * (to - from) / fromIntegral panels
    go :: Int -> Double -> Double
    go !k !total
      | k >= panels = half * total
      | otherwise = go (k + 1) (total + panel (from + half * (2 * fromIntegral k + 1)))
    -- The nodes on both sides of the middle, with their weights.
    panel !middle =
      pair 0.0950125098376374402 0.1894506104550684963
        + pair 0.2816035507792589132 0.1826034150449235888
        + pair 0.4580167776572273863 0.1691565193950025382
        + pair 0.6178762444026437484 0.1495959888165767321
        + pair 0.7554044083550030339 0.1246289712555338720
        + pair 0.8656312023878317439 0.0951585116824927848
        + pair 0.9445750230732325761 0.0622535239386478929
        + pair 0.9894009349916499326 0.0271524594117540949
      where
        pair x w = w * (f (middle - half * x) + f (middle + half * x))
{-# INLINE integrate #-}

-- | @integrateBeside precision distance f x y@: the integral over @v@ from @x@ to @y@ of a
-- function that is given by @e^v@ and smooth on the scale of 1, but for poles outside that
-- range, of which the nearest is at the given distance from a point. The range is halved
-- until every panel is at most 2 wide and lies at least its half width from a pole: the
-- cost grows with the logarithm of the distance. What lies within 1e-18 of the range from
-- a pole, where the integral may diverge, is left out.
integrateBeside ::
  Precision -> (Double -> Double) -> (Double -> Double) -> Double -> Double -> Double
integrateBeside precision distance f = go (60 :: Int)
  where
    -- The positive nodes, each followed by its weight.
    !rule = case precision of
      FullPrecision -> sixteenNodes
      PicturePrecision -> eightNodes
    go !depth !from !to
      | depth <= 0 = 0
      | abs half <= 1 && distance middle >= 2 * abs half = half * panel (exp middle) half 0 0
      | otherwise = go (depth - 1) from middle + go (depth - 1) middle to
      where
        !middle = 0.5 * (from + to)
        !half = 0.5 * (to - from)
    panel :: Double -> Double -> Int -> Double -> Double
    panel !centre !half !i !total
      | i >= sizeofPrimArray rule = total
      | otherwise =
        let !apart = exp (half * indexPrimArray rule i)
            !weight = indexPrimArray rule (i + 1)
         in panel centre half (i + 2) (total + weight * (f (centre * apart) + f (centre / apart)))
{-# INLINE integrateBeside #-}

eightNodes, sixteenNodes :: PrimArray Double
eightNodes =
  primArrayFromList
    [ 0.1834346424956498049,
      0.3626837833783619830,
      0.5255324099163289858,
      0.3137066458778872874,
      0.7966664774136267396,
      0.2223810344533744706,
      0.9602898564975362317,
      0.1012285362903762592
    ]
sixteenNodes =
  primArrayFromList
    [ 0.0950125098376374402,
      0.1894506104550684963,
      0.2816035507792589132,
      0.1826034150449235888,
      0.4580167776572273863,
      0.1691565193950025382,
      0.6178762444026437484,
      0.1495959888165767321,
      0.7554044083550030339,
      0.1246289712555338720,
      0.8656312023878317439,
      0.0951585116824927848,
      0.9445750230732325761,
      0.0622535239386478929,
      0.9894009349916499326,
      0.0271524594117540949
    ]
{-# NOINLINE eightNodes #-}
{-# NOINLINE sixteenNodes #-}
