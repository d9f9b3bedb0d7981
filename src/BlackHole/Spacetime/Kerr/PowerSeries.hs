-- | Light paths around a Kerr hole as power series in Mino time: for the few rays
-- that the closed form leaves out, those nearly along the principal null direction
-- of an observer off the plane (η ≤ 0, or close to it). Such a ray never turns: it
-- runs into the hole or straight out to the sky.
--
-- With @w = 1\/r@ and @m@ the unit vector towards the place in a frame that is
-- dragged along, the equations of motion are polynomials,
--
-- > w'' = (a² − λ² − η) w + (3/2) κ w² − 2a²η w³
-- > m'' = −(η + λ² + 2a² m_y²) m + a² m_y ŷ
--
-- regular at turning points, on the axis, at the horizon and at infinity, so that
-- their Taylor coefficients follow from each other; a series is a lazy list that
-- refers to itself (McIlroy 1999, "Power series, power serious"). The azimuth of the
-- frame is the one that stays regular at the horizon the ray comes from.
module BlackHole.Spacetime.Kerr.PowerSeries
  ( SeriesPath,
    seriesPath,
    SeriesPoint (..),
    seriesPoint,
    seriesEnd,
    seriesCrossingTimes,
    seriesCosineRate,
    seriesPassages,
  )
where

import BlackHole.Numeric.Bisection (bisect)
import BlackHole.Spacetime.Kerr.Landmarks
import BlackHole.Spacetime.Kerr.Sight

-- | Taylor coefficients of the quantities along a part of the path, which lasts for
-- the given Mino time.
data Part = Part
  { partStart :: !Double,
    partLength :: !Double,
    partInverse :: [Double],
    partX :: [Double],
    partY :: [Double],
    partZ :: [Double],
    -- | The azimuth of the frame, right-handed and for the real photon.
    partFrame :: [Double]
  }

-- | A path, part by part, up to where it ends.
newtype SeriesPath = SeriesPath [Part]

-- | A point of such a path.
data SeriesPoint = SeriesPoint
  { seriesRadius :: !Double,
    seriesCosine :: !Double,
    -- | Cosine and sine, times sin θ, of the azimuth gained since the start in the
    -- frame, and how far the frame has turned in regular azimuth.
    seriesHorizontal :: !(Double, Double),
    seriesFrame :: !Double
  }

-- | Enough terms that a step reaches far into the radius of convergence.
order :: Int
order = 28

-- | The path of a ray that moves inwards or outwards without turning.
seriesPath :: Spin -> LightRay -> SeriesPath
seriesPath hole ray =
  SeriesPath (go 0 (1 / r) (negate (rayRadialRate ray) / (r * r)) start velocity 0)
  where
    r = rayRadius ray
    a = spinLength hole
    a2 = a * a
    lambda = rayLambda ray
    eta = rayEta ray
    kappa = rayKappa ray
    edge = if rayRadialRate ray > 0 then 0 else 1 / horizonRadius hole
    s = raySine ray
    c = rayCosine ray
    start = (0, c, s)
    velocity = (negate (lambda / s), negate (s * rayPolarRate ray), c * rayPolarRate ray)
    go begun w0 w1 (x0, y0, z0) (x1, y1, z1) frame0
      | done = [part {partLength = bisect (not . past) 0 step}]
      | otherwise =
        part :
        go
          (begun + step)
          (at w)
          (at (derivative w))
          (at x, at y, at z)
          (at (derivative x), at (derivative y), at (derivative z))
          (at frame)
      where
        part = Part begun step w x y z frame
        at series = evaluate series step
        done = past step
        past t = (evaluate w t - edge) * (w0 - edge) <= 0
        w = take order (w0 : integral (w1 : integral wForce))
        wForce =
          scale (a2 - lambda * lambda - eta) w
            .+ scale (1.5 * kappa) w2
            .+ scale (-2 * a2 * eta) (w2 .* w)
        w2 = w .* w
        x = take order (x0 : integral (x1 : integral (negated (stiffness .* x))))
        y = take order (y0 : integral (y1 : integral (scale a2 y .+ negated (stiffness .* y))))
        z = take order (z0 : integral (z1 : integral (negated (stiffness .* z))))
        stiffness = scale (2 * a2) (y .* y) `plus` (eta + lambda * lambda)
        -- −a + aκ/(P + √R), with √R = |w'|/w².
        frame = take order (frame0 : integral (scale (a * kappa) (w2 ./ energy) `plus` negate a))
        energy = scale (a * (a - lambda)) w2 `plus` 1 .+ speed
        speed = scale (if rayRadialRate ray > 0 then -1 else 1) (derivative w)
        step =
          minimum $
            2 :
              [ (1e-17 / size) ** (1 / fromIntegral n)
                | series <- [w, x, y, z, frame],
                  n <- [order - 2, order - 3],
                  let size = abs (series !! n),
                  size > 0
              ]

-- | The Mino time of the whole path.
seriesEnd :: SeriesPath -> Double
seriesEnd (SeriesPath parts) = sum (map partLength parts)

-- | The point after a Mino time.
seriesPoint :: SeriesPath -> Double -> SeriesPoint
seriesPoint path time = let (part, t) = partAt path time in pointOf part t

-- | The part of the path at a Mino time, and the time since it began.
partAt :: SeriesPath -> Double -> (Part, Double)
partAt (SeriesPath parts) time = go parts
  where
    go (part : rest@(_ : _)) | partStart part + partLength part < time = go rest
    go (part : _) = (part, time - partStart part)
    -- A path has at least one part.
    go [] = (Part 0 0 [] [] [] [] [], 0)

pointOf :: Part -> Double -> SeriesPoint
pointOf part t =
  SeriesPoint
    { seriesRadius = 1 / evaluate (partInverse part) t,
      seriesCosine = evaluate (partY part) t,
      seriesHorizontal = (evaluate (partZ part) t, evaluate (partX part) t),
      seriesFrame = evaluate (partFrame part) t
    }

-- | The Mino times at which the path crosses the plane after its start.
seriesCrossingTimes :: SeriesPath -> [Double]
seriesCrossingTimes (SeriesPath parts) =
  [ partStart part + bisect (\t -> height part t * before > 0) 0 (partLength part)
    | part <- parts,
      let before = height part (1e-12 * partLength part),
      height part (partLength part) * before < 0
  ]
  where
    height part = evaluate (partY part)

-- | d(cos θ)\/dτ after a Mino time.
seriesCosineRate :: SeriesPath -> Double -> Double
seriesCosineRate path time =
  let (part, t) = partAt path time in evaluate (derivative (partY part)) t

-- | The Mino times between which the path may be within a radius and have at most this
-- @|cos θ|@: whole parts, of which one with neither at its ends nor in its middle is
-- left out.
seriesPassages :: SeriesPath -> Double -> Double -> [(Double, Double)]
seriesPassages (SeriesPath parts) limit steepest =
  [ (partStart part, partStart part + partLength part)
    | part <- parts,
      any (within part) [0, 0.25, 0.5, 0.75, 1]
  ]
  where
    within part t =
      evaluate (partInverse part) (t * partLength part) * limit > 0.9
        && abs (evaluate (partY part) (t * partLength part)) <= 1.2 * steepest

evaluate :: [Double] -> Double -> Double
evaluate series t = foldr (\coefficient rest -> coefficient + t * rest) 0 series

infixl 6 .+

infixl 7 .*, ./

(.+), (.*), (./) :: [Double] -> [Double] -> [Double]
(.+) = zipWith (+)
(p : ps) .* series@(q : qs) = p * q : zipWith (+) (map (p *) qs) (ps .* series)
_ .* _ = []
(p : ps) ./ divisor@(q : qs) = first : zipWith (-) ps (map (first *) qs) ./ divisor
  where
    first = p / q
_ ./ _ = []

plus :: [Double] -> Double -> [Double]
plus (p : ps) v = p + v : ps
plus [] _ = []

scale :: Double -> [Double] -> [Double]
scale v = map (v *)

negated :: [Double] -> [Double]
negated = map negate

integral, derivative :: [Double] -> [Double]
integral series = zipWith (/) series [1 ..]
derivative series = zipWith (*) (drop 1 series) [1 ..]
