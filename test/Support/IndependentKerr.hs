-- | Light paths around a Kerr hole by brute force: the regular second-order
-- equations of motion in Mino time, integrated by extrapolation of the modified
-- midpoint rule (Gragg, Bulirsch and Stoer; order 16), with no use of roots,
-- elliptic functions or code of the library. @r_s = 1@, spin length @a@.
module Support.IndependentKerr
  ( KerrState (..),
    kerrStart,
    kerrAdvance,
    kerrDirection,
  )
where

-- | Inverse radius, its rate, the unit vector of the place in the dragged frame,
-- its rate, and the angle by which that frame has turned.
newtype KerrState = KerrState [Double]
  deriving (Show)

-- | @kerrStart r θ λ r' θ'@ at azimuth 0, with rates in Mino time along the backward
-- tracing.
kerrStart :: Double -> Double -> Double -> Double -> Double -> KerrState
kerrStart r theta lambda radialRate polarRate =
  KerrState
    [ 1 / r,
      negate radialRate / (r * r),
      0,
      cos theta,
      sin theta,
      negate lambda / sin theta,
      negate (sin theta) * polarRate,
      cos theta * polarRate,
      0
    ]

-- | @kerrAdvance a λ η time steps state@: the state after a Mino time, in equal steps.
kerrAdvance :: Double -> Double -> Double -> Double -> Int -> KerrState -> KerrState
kerrAdvance a lambda eta time steps (KerrState start) =
  KerrState (iterate (extrapolated rates (time / fromIntegral steps)) start !! steps)
  where
    kappa = eta + (lambda - a) * (lambda - a)
    rates state = case state of
      [w, w', x, y, z, x', y', z', _] ->
        let pull = eta + lambda * lambda + 2 * a * a * y * y
         in [ w',
              (a * a - lambda * lambda - eta) * w
                + 1.5 * kappa * w * w - 2 * a * a * eta * w * w * w,
              x',
              y',
              z',
              negate pull * x,
              (a * a - pull) * y,
              negate pull * z,
              a * w * (1 - a * lambda * w) / (1 - w + a * a * w * w)
            ]
      _ -> state

-- | Unit vector of the place, with Boyer–Lindquist's azimuth from +z towards +x.
kerrDirection :: KerrState -> (Double, Double, Double)
kerrDirection (KerrState state) = case state of
  -- Backwards the frame turns the other way.
  [_, _, x, y, z, _, _, _, turned] ->
    (x * cos turned - z * sin turned, y, z * cos turned + x * sin turned)
  _ -> (0, 0, 0)

extrapolated :: ([Double] -> [Double]) -> Double -> [Double] -> [Double]
extrapolated rates step start = neville [] counts
  where
    counts = [2, 4 .. 16] :: [Int]
    -- The row of the tableau, with the midpoint rule's own value first.
    neville row [] = if null row then start else last row
    neville row (n : rest) = neville (scanl refine (midpoint n) (zip row done)) rest
      where
        done = reverse (takeWhile (< n) counts)
        refine new (old, m) =
          let ratio = fromIntegral (n * n) / fromIntegral (m * m) - 1
           in zipWith (\p q -> p + (p - q) / ratio) new old
    midpoint n = go (n - 1) start (zipWith (\y k -> y + h * k) start (rates start))
      where
        h = step / fromIntegral n
        go :: Int -> [Double] -> [Double] -> [Double]
        go 0 before here = zipWith3 (\b y k -> 0.5 * (b + y + h * k)) before here (rates here)
        go k before here = go (k - 1) here (zipWith (\b s -> b + 2 * h * s) before (rates here))
