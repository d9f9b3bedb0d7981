{-# LANGUAGE BangPatterns #-}

-- | Jacobi's elliptic functions of a real argument, and Legendre's integrals of the
-- first kind.
--
-- All functions take the /complementary parameter/ @m₁ = 1 − m@ (in Abramowitz and
-- Stegun's notation, @m = k²@). For light that nearly circles the hole, @m₁@ falls to
-- 1e-30; computing it as @1 − m@ would lose it.
--
-- A 'Modulus' holds everything that depends on the parameter alone, so that evaluating
-- many points of one light path is cheap: each costs one sine or one exponential and
-- about forty multiplications.
--
-- /Method./ Quotients of theta series (Whittaker and Watson 1927, chapters 21 and 22).
-- For @m ≤ 1\/2@ the nome is at most @e^(−π) = 0.0432@. For @m > 1\/2@ Jacobi's
-- imaginary transformation exchanges @m@ and @m₁@, which keeps the nome that small and
-- turns circular functions into hyperbolic ones. Terms of order @nome¹²@ (4e-17) are
-- omitted.
module BlackHole.Numeric.Elliptic
  ( -- * Functions
    Modulus,
    modulus,
    quarterPeriod,
    Jacobi (..),
    jacobi,
    snSquared,
    tanHalfAmplitude,

    -- * Integrals
    completeK,
    incompleteF,
    firstQuadrantF,
    firstQuadrantFWithin,
    seriesRadius,
    carlsonRF,
  )
where

import GHC.Exts (lazy)
import Numeric (expm1)

-- | Whether the theta series use circular or hyperbolic functions.
data Kernel = Circular | Hyperbolic

-- | The elliptic functions of one parameter, prepared for evaluation by 'modulus'.
data Modulus = Modulus
  { modulusKernel :: !Kernel,
    -- | @K@, see 'quarterPeriod'.
    modulusQuarterPeriod :: {-# UNPACK #-} !Double,
    -- | Nome of the series in use.
    modulusNome :: {-# UNPACK #-} !Double,
    -- | Converts the argument to the variable of the theta functions.
    modulusScale :: {-# UNPACK #-} !Double,
    -- | Factors that normalise the quotients at the argument 0.
    modulusSnFactor :: {-# UNPACK #-} !Double,
    modulusCnFactor :: {-# UNPACK #-} !Double,
    modulusDnFactor :: {-# UNPACK #-} !Double,
    modulusTanFactor :: {-# UNPACK #-} !Double,
    modulusSeries :: {-# UNPACK #-} !Series
  }

-- | Coefficients of the theta series as polynomials in @p = 2q cos 2ζ@ (or
-- @2q cosh 2z@). With @θ₁ ∝ sin ζ · b(−p)@, @θ₂ ∝ cos ζ · b(p)@,
-- @θ₃ = t(p)@ and @θ₄ = t(−p)@, two cubic polynomials serve all four.
data Series
  = Series
      {-# UNPACK #-} !Double -- b₀
      {-# UNPACK #-} !Double -- b₁
      {-# UNPACK #-} !Double -- b₂
      {-# UNPACK #-} !Double -- b₃
      {-# UNPACK #-} !Double -- t₀
      {-# UNPACK #-} !Double -- t₁
      {-# UNPACK #-} !Double -- t₂
      {-# UNPACK #-} !Double -- t₃

series :: Double -> Series
series q =
  Series
    (1 - q2 - q6)
    (q - q5 - 2 * q5 * q6)
    (q4 - q4 * q6)
    (q4 * q5)
    (1 - 2 * q4)
    (1 - 3 * q4 * q4)
    q2
    q6
  where
    q2 = q * q
    q4 = q2 * q2
    q5 = q4 * q
    q6 = q4 * q2

bMinus, bPlus, tMinus, tPlus :: Series -> Double -> Double
bMinus (Series b0 b1 b2 b3 _ _ _ _) p = b0 + b2 * p * p - p * (b1 + b3 * p * p)
bPlus (Series b0 b1 b2 b3 _ _ _ _) p = b0 + b2 * p * p + p * (b1 + b3 * p * p)
tMinus (Series _ _ _ _ t0 t1 t2 t3) p = t0 + t2 * p * p - p * (t1 + t3 * p * p)
tPlus (Series _ _ _ _ t0 t1 t2 t3) p = t0 + t2 * p * p + p * (t1 + t3 * p * p)
{-# INLINE bMinus #-}
{-# INLINE bPlus #-}
{-# INLINE tMinus #-}
{-# INLINE tPlus #-}

-- | Prepares the functions of the complementary parameter @m₁@. Values outside [0, 1]
-- are replaced by the nearer end. Costs two arithmetic-geometric means and one
-- exponential.
modulus :: Double -> Modulus
modulus complement =
  Modulus
    { modulusKernel = kernel,
      modulusQuarterPeriod = period,
      modulusNome = q,
      modulusScale = scale,
      modulusSnFactor = b0Plus / (scale * b0Minus) * snBase,
      modulusCnFactor = cnBase,
      modulusDnFactor = dnBase,
      modulusTanFactor = tanBase,
      modulusSeries = s
    }
  where
    m1 = max 0 (min 1 complement)
    period = completeK m1
    conjugatePeriod = completeK (1 - m1)
    kernel = if m1 < 0.5 then Hyperbolic else Circular
    (own, other) = case kernel of
      Circular -> (period, conjugatePeriod)
      Hyperbolic -> (conjugatePeriod, period)
    q = exp (-(pi * other / own))
    scale = pi / (2 * own)
    s = series q
    p0 = 2 * q
    b0Minus = bMinus s p0
    b0Plus = bPlus s p0
    t0Minus = tMinus s p0
    t0Plus = tPlus s p0
    -- sn' = 1, cn = dn = 1 and tan (am/2)' = 1/2 at the argument 0.
    snBase = case kernel of
      Circular -> t0Minus / b0Plus
      Hyperbolic -> 1
    cnBase = case kernel of
      Circular -> t0Minus / b0Plus
      Hyperbolic -> b0Plus / t0Minus
    dnBase = case kernel of
      Circular -> t0Minus / t0Plus
      Hyperbolic -> b0Plus / t0Plus
    tanBase = b0Plus * t0Minus / (scale * b0Minus * t0Plus)

-- | The quarter period @K(m)@; infinite for @m₁ = 0@.
quarterPeriod :: Modulus -> Double
quarterPeriod = modulusQuarterPeriod

-- | @sn@, @cn@ and @dn@ of one argument.
data Jacobi = Jacobi
  { jacobiSn :: {-# UNPACK #-} !Double,
    jacobiCn :: {-# UNPACK #-} !Double,
    jacobiDn :: {-# UNPACK #-} !Double
  }
  deriving (Eq, Show)

-- | @sn@, @cn@ and @dn@ of any finite real argument. The absolute error is a few 1e-16
-- within the first period; beyond it, the rounding of the argument's reduction adds to
-- that. @sn@ keeps its relative accuracy near 0.
jacobi :: Modulus -> Double -> Jacobi
jacobi md x
  | abs x <= k = jacobiReduced md x
  | even halfPeriods = reduced
  | otherwise = Jacobi (-sn) (-cn) dn
  where
    k = modulusQuarterPeriod md
    halfPeriods = round (x / (2 * k)) :: Int
    reduced@(Jacobi sn cn dn) = jacobiReduced md (x - 2 * k * fromIntegral halfPeriods)

-- | 'jacobi' for arguments within one quarter period of 0.
jacobiReduced :: Modulus -> Double -> Jacobi
jacobiReduced md x = case modulusKernel md of
  Circular ->
    let sine = sin (modulusScale md * x)
        p = 2 * modulusNome md * (1 - 2 * sine * sine)
        r = 1 / tMinus s p
     in Jacobi
          (modulusSnFactor md * sine * bMinus s p * r)
          (modulusCnFactor md * cos (modulusScale md * x) * bPlus s p * r)
          (modulusDnFactor md * tPlus s p * r)
  Hyperbolic ->
    let z = modulusScale md * abs x
        v = max tiny (exp (-2 * z))
        p = hyperbolicVariable md v
        sech = 2 * sqrt v / (1 + v)
        tanhZ = signum x * tanhFrom z v
        r = 1 / bPlus s p
     in Jacobi
          (modulusSnFactor md * tanhZ * bMinus s p * r)
          (modulusCnFactor md * sech * tMinus s p * r)
          (modulusDnFactor md * sech * tPlus s p * r)
  where
    s = modulusSeries md

-- | @2q cosh 2z@ from @v = e^(−2z)@.
hyperbolicVariable :: Modulus -> Double -> Double
hyperbolicVariable md v = modulusNome md / v + modulusNome md * v
{-# INLINE hyperbolicVariable #-}

-- | @tanh z@ from @z ≥ 0@ and @v = e^(−2z)@. Near 0, 'expm1' replaces the difference
-- @1 − v@, which would lose all digits.
tanhFrom :: Double -> Double -> Double
tanhFrom z v
  | z < 0.25 = -expm1 (-2 * z) / (1 + v)
  | otherwise = (1 - v) / (1 + v)
{-# INLINE tanhFrom #-}

-- | Keeps @nome \/ e^(−2z)@ from becoming 0\/0 where both underflow (@m₁ = 0@ and an
-- argument beyond 350).
tiny :: Double
tiny = 1e-305

-- | @sn²@ of an argument in @[−2K, 2K]@, with an absolute error of a few 1e-16. This is
-- the inner loop for light that comes from infinity and leaves again.
--
-- 'lazy' keeps the 'Modulus' behind a pointer: it has more fields than GHC unpacks for
-- a call, and GHC would otherwise leave the argument and the result boxed too. Inlining
-- the function doubles its time.
snSquared :: Modulus -> Double -> Double
snSquared prepared !x = case modulusKernel md of
  Circular ->
    let sine = sin (modulusScale md * x)
        sine2 = sine * sine
        p = 2 * modulusNome md * (1 - 2 * sine2)
        ratio = modulusSnFactor md * bMinus s p / tMinus s p
     in sine2 * ratio * ratio
  Hyperbolic ->
    let a = abs x
        k = modulusQuarterPeriod md
        z = modulusScale md * (if a > k then 2 * k - a else a)
        v = max tiny (exp (-2 * z))
        p = hyperbolicVariable md v
        root = modulusSnFactor md * (1 - v) * bMinus s p / ((1 + v) * bPlus s p)
     in root * root
  where
    md = lazy prepared
    s = modulusSeries md

-- | @tan (am(x) \/ 2) = sn \/ (1 + cn)@ for an argument in @[−2K, 2K]@, with full
-- relative accuracy near 0 and near the poles @±2K@. Near the poles @1 + cn@ loses all
-- digits; the half-argument form @sn dn \/ cn@ of @x\/2@, used here, is a quotient of
-- theta functions without cancellation. See 'snSquared' for 'lazy'.
tanHalfAmplitude :: Modulus -> Double -> Double
tanHalfAmplitude prepared !x = case modulusKernel md of
  Circular ->
    let t = tan (0.5 * modulusScale md * x)
        p = 2 * modulusNome md * (2 / (1 + t * t) - 1)
     in t * quotient p
  Hyperbolic ->
    let z = 0.5 * modulusScale md * abs x
        v = max tiny (exp (-2 * z))
     in signum x * tanhFrom z v * quotient (hyperbolicVariable md v)
  where
    md = lazy prepared
    s = modulusSeries md
    quotient p = modulusTanFactor md * bMinus s p * tPlus s p / (bPlus s p * tMinus s p)
    {-# INLINE quotient #-}

-- | The complete integral @K(m)@ from @m₁ ∈ [0, 1]@, by the arithmetic-geometric mean
-- (Abramowitz and Stegun 1964, 17.6.3); infinite for @m₁ = 0@. Takes at most fifteen
-- square roots, usually five.
completeK :: Double -> Double
completeK m1
  | m1 > 0 = go 1 (sqrt m1)
  | otherwise = 1 / 0
  where
    -- One further step from a relative gap of 1e-8 would change the mean by
    -- 1e-17.
    go !a !g
      | abs (a - g) <= 1e-8 * a = pi / (a + g)
      | otherwise = go (0.5 * (a + g)) (sqrt (a * g))

-- | The incomplete integral @F(φ|m)@ from @m₁@ and the amplitude @φ@ in radians, any
-- real number. Infinite for @m₁ = 0@ and @|φ| ≥ π\/2@.
incompleteF :: Double -> Double -> Double
incompleteF m1 phi
  | halfTurns == 0 = inFirst
  | otherwise = inFirst + 2 * fromIntegral halfTurns * completeK m1
  where
    halfTurns = round (phi / pi) :: Int
    rest = phi - pi * fromIntegral halfTurns
    s = sin rest
    c = cos rest
    inFirst = signum rest * firstQuadrantF m1 (s * s) (c * c)

-- | @F(φ|m)@ for @0 ≤ φ ≤ π\/2@ from @m₁@ and two numbers /proportional/ to @sin² φ@
-- and @cos² φ@ (their sum need not be 1). A caller that knows both without
-- cancellation, however close φ is to 0 or π\/2, loses no accuracy.
firstQuadrantF :: Double -> Double -> Double -> Double
firstQuadrantF = firstQuadrantFWithin seriesRadius

-- | 'firstQuadrantF' with fewer duplications: a relative error of about @(radius \/ 1.6)⁸@
-- instead of that of the 'seriesRadius'.
firstQuadrantFWithin :: Double -> Double -> Double -> Double -> Double
firstQuadrantFWithin radius m1 sine2 cosine2 =
  sqrt sine2 * carlsonWithin radius cosine2 (cosine2 + m1 * sine2) (cosine2 + sine2)

-- | Carlson's symmetric integral @R_F(x, y, z)@ for @x, y, z ≥ 0@, by duplication and
-- then the series of degree 7 (DLMF 19.36.1). Infinite if more than one argument is 0.
-- The relative error is a few 1e-16.
carlsonRF :: Double -> Double -> Double -> Double
carlsonRF = carlsonWithin seriesRadius

-- | The greatest relative spread of the arguments for the series in 'carlsonRF'. The
-- first omitted term is of degree 8 in the spread, with a coefficient below 0.02: 1e-18
-- here.
seriesRadius :: Double
seriesRadius = 0.007

-- | 'carlsonRF' with another 'seriesRadius'.
carlsonWithin :: Double -> Double -> Double -> Double -> Double
carlsonWithin !radius x0 y0 z0
  | min (x0 + y0) (min (y0 + z0) (z0 + x0)) <= 0 = 1 / 0
  | otherwise = go x0 y0 z0
  where
    go !x !y !z
      | spread > radius * mean = go (next x) (next y) (next z)
      | otherwise = polynomial / sqrt mean
      where
        mean = (x + y + z) / 3
        spread = max (abs (mean - x)) (max (abs (mean - y)) (abs (mean - z)))
        rx = sqrt x
        ry = sqrt y
        rz = sqrt z
        next w = 0.25 * (w + rx * (ry + rz) + ry * rz)
        dx = (mean - x) / mean
        dy = (mean - y) / mean
        dz = -(dx + dy)
        e2 = dx * dy - dz * dz
        e3 = dx * dy * dz
        polynomial =
          1 - e2 / 10 + e3 / 14 + e2 * e2 / 24 - 3 * e2 * e3 / 44
            - 5 * e2 * e2 * e2 / 208
            + 3 * e3 * e3 / 104
            + e2 * e2 * e3 / 16
