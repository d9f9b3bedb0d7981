{-# LANGUAGE BangPatterns #-}

-- | Integrals of functions of @sin² x@, as the Fourier series of the function.
--
-- Such a function is even and has the period π. Its Fourier coefficients follow from its
-- values at equally spaced places within a quarter period. They fall geometrically for an
-- analytic function, and the error of these sums as fast.
module BlackHole.Numeric.Periodic
  ( Periodic,
    periodicIntegral,
    integralTo,
    integralPerRadian,
    Resolution,
    resolution,
  )
where

import Data.Primitive.PrimArray

-- | The integral from 0 of a function of @sin² x@.
data Periodic
  = -- | The function's mean, and the coefficients of @sin 2x@, @sin 4x@ ….
    Periodic {-# UNPACK #-} !Double {-# UNPACK #-} !(PrimArray Double)

-- | A number of terms, with the places at which to evaluate a function, as values of
-- @sin² x@, and the weights of the values in each coefficient.
data Resolution
  = Resolution
      {-# UNPACK #-} !Int
      {-# UNPACK #-} !(PrimArray Double)
      {-# UNPACK #-} !(PrimArray Double)

-- | @resolution n@ takes the mean and n − 1 further terms from n + 1 values.
resolution :: Int -> Resolution
resolution n =
  Resolution
    n
    (generatePrimArray (n + 1) (\j -> sin (half * fromIntegral j) * sin (half * fromIntegral j)))
    (generatePrimArray (n * (n + 1)) (\i -> uncurry weight (quotRem i (n + 1))))
  where
    weight k j =
      ends j * cos (2 * half * fromIntegral (k * j))
        / (if k == 0 then 1 else fromIntegral k)
        / fromIntegral n
    half = pi / (2 * fromIntegral n) :: Double
    ends j = if j == 0 || j == n then 0.5 else 1 :: Double

-- | The integral of a function, given by @sin² x@.
periodicIntegral :: Resolution -> (Double -> Double) -> Periodic
periodicIntegral (Resolution n places weights) f =
  Periodic (coefficient 0) (generatePrimArray (n - 1) (\k -> coefficient (k + 1)))
  where
    !values = generatePrimArray (n + 1) (f . indexPrimArray places)
    coefficient k = go 0 0
      where
        go :: Int -> Double -> Double
        go !j !total
          | j > n = total
          | otherwise =
            go
              (j + 1)
              (total + indexPrimArray weights (k * (n + 1) + j) * indexPrimArray values j)
{-# INLINE periodicIntegral #-}

-- | @integralTo integral x (sin x) (cos x)@.
integralTo :: Periodic -> Double -> Double -> Double -> Double
integralTo (Periodic mean coefficients) !x !s !c = go (sizeofPrimArray coefficients - 1) 0 0
  where
    -- Clenshaw's recurrence.
    !twice = 2 * (1 - 2 * s * s)
    go :: Int -> Double -> Double -> Double
    go !k !b1 !b2
      | k < 0 = mean * x + 2 * s * c * b1
      | otherwise = go (k - 1) (indexPrimArray coefficients k + twice * b1 - b2) b1

-- | The function's mean, by which the integral grows per radian.
integralPerRadian :: Periodic -> Double
integralPerRadian (Periodic mean _) = mean
