-- | Light orbits by brute force: the equation @u'' = (3\/2) u² − u@ integrated by
-- Taylor series of degree 30, with no use of invariants or elliptic functions
-- and no code of the library. Slow, and exact to a few units of rounding, which
-- the unstable orbits near the photon sphere amplify by @e^φ@.
module Support.IndependentOrbit
  ( IndependentFate (..),
    independentFate,
    independentOrbitAt,
    independentDeflection,
  )
where

-- | How an orbit ends, with the angle swept from the start.
data IndependentFate
  = -- | Reaches @u = 0@.
    LeavesAfter Double
  | -- | Reaches @u = 1@ with @u@ growing.
    FallsAfter Double
  | -- | Neither within 200 radians.
    Unfinished
  deriving (Eq, Show)

-- | One step: the angle at its start, its length, the Taylor coefficients.
data Segment = Segment Double Double [Double]

-- | The fate of the orbit with the given @u@ and @du\/dφ@ at the start.
independentFate :: Double -> Double -> IndependentFate
independentFate u0 w0 = search (takeWhile begins (segments u0 w0))
  where
    begins (Segment phi _ _) = phi < 200
    search [] = Unfinished
    search (Segment phi h cs : rest)
      | end <= 0 && end < start = LeavesAfter (phi + crossing 0 cs h)
      | end >= 1 && end > start = FallsAfter (if start >= 1 then phi else phi + crossing 1 cs h)
      | otherwise = search rest
      where
        start = polynomial cs 0
        end = polynomial cs h

-- | @u@ and @du\/dφ@ after a swept angle, from those at the start.
independentOrbitAt :: Double -> Double -> Double -> (Double, Double)
independentOrbitAt u0 w0 angle =
  case dropWhile endsBefore (segments u0 w0) of
    Segment phi _ cs : _ -> (polynomial cs (angle - phi), polynomial (derivative cs) (angle - phi))
    [] -> (u0, w0)
  where
    endsBefore (Segment phi h _) = phi + h < angle

-- | The deflection of light from infinity by its impact parameter; 'Nothing'
-- when it falls in.
independentDeflection :: Double -> Maybe Double
independentDeflection b = case independentFate 0 (1 / b) of
  LeavesAfter angle -> Just (angle - pi)
  _ -> Nothing

-- | Never empty, never ending.
segments :: Double -> Double -> [Segment]
segments = go 0
  where
    go phi u w = Segment phi h cs : go (phi + h) (polynomial cs h) (polynomial (derivative cs) h)
      where
        cs = taylor u w
        -- The last coefficients show the radius of convergence; a quarter of it
        -- leaves 4^-30.
        full =
          0.25
            * minimum
              (2 : [abs c ** (-1 / n) | (n, c) <- drop (degree - 4) (zip [0 ..] cs), c /= 0])
        -- A step ends where the orbit turns, so that u is monotonic in each: a
        -- path may cross u = 1 twice within one full step.
        slopes = derivative cs
        turns = w * polynomial slopes full < 0
        h = if turns then bisected (\x -> w * polynomial slopes x <= 0) full else full

degree :: Int
degree = 30

-- | Taylor coefficients of the solution, from the recurrence that the equation
-- gives them.
taylor :: Double -> Double -> [Double]
taylor u w = go 0 [w, u]
  where
    -- The coefficients so far, last one first.
    go :: Int -> [Double] -> [Double]
    go n known
      | n + 2 > degree = reverse known
      | otherwise = go (n + 1) (next : known)
      where
        ascending = take (n + 1) (reverse known)
        square = sum (zipWith (*) ascending (reverse ascending))
        order = fromIntegral n
        next = (1.5 * square - last ascending) / ((order + 1) * (order + 2))

polynomial :: [Double] -> Double -> Double
polynomial cs x = foldr (\c rest -> c + x * rest) 0 cs

derivative :: [Double] -> [Double]
derivative cs = zipWith (*) [1 ..] (drop 1 cs)

-- | Where the polynomial takes a value within a step at whose end it has passed
-- it: bisection, then Newton's method.
crossing :: Double -> [Double] -> Double -> Double
crossing target cs h = newton (4 :: Int) (bisected beyond h)
  where
    sideAtEnd = polynomial cs h >= target
    beyond x = (polynomial cs x >= target) == sideAtEnd
    newton 0 x = x
    newton n x = newton (n - 1) (x - (polynomial cs x - target) / polynomial (derivative cs) x)

-- | The first point beyond which a condition holds that fails at 0 and holds at
-- the given end.
bisected :: (Double -> Bool) -> Double -> Double
bisected beyond = go (52 :: Int) 0
  where
    go 0 _ high = high
    go n low high
      | beyond middle = go (n - 1) low middle
      | otherwise = go (n - 1) middle high
      where
        middle = 0.5 * (low + high)
