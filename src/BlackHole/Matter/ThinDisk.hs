-- | The thin accretion disk of Page and Thorne around a hole of any spin: how much each
-- ring of right-handed gas radiates if no torque acts at the innermost stable orbit.
-- Radii are in Schwarzschild radii.
module BlackHole.Matter.ThinDisk
  ( ThinDisk,
    thinDisk,
    thinDiskFlux,
    thinDiskPeak,
    relativeTemperature,
  )
where

import BlackHole.Numeric.Bisection (bisect)
import BlackHole.Spacetime.Kerr.Landmarks
import Numeric (log1p)

-- | The disk around one hole.
data ThinDisk = ThinDisk
  { _diskSpin :: !Double,
    -- | The innermost stable orbit, and √(2r) there.
    _diskEdge :: !Double,
    _diskEdgeRoot :: !Double,
    -- | The roots of @x³ − 3x + 2s@ with the weights of their logarithms.
    _diskRoots :: ![(Double, Double)],
    -- | Radius and flux of the ring that radiates most.
    _diskPeak :: !(Double, Double)
  }

-- | The disk around a hole; finds the peak by bisection.
thinDisk :: Spin -> ThinDisk
thinDisk hole = disk (peak, thinDiskFlux unpeaked peak)
  where
    s = dimensionlessSpin hole
    edge = iscoRadius RightHanded hole
    disk = ThinDisk s edge (sqrt (2 * edge)) weighted
    unpeaked = disk (0, 0)
    x1 = 2 * cos ((acos s - pi) / 3)
    x3 = negate (2 * cos (acos s / 3))
    x2 = negate (2 * s / (x1 * x3))
    weighted =
      [ (root, weight root others)
        | (root, others) <- [(x1, (x2, x3)), (x2, (x1, x3)), (x3, (x1, x2))],
          root /= 0
      ]
    weight root (other, another) =
      3 * (root - s) * (root - s) / (root * (root - other) * (root - another))
    -- The flux is b/g; its derivative has the sign of b'g − bg'.
    peak = bisect rising edge (16 * edge)
    rising r = slope y * divisor s y > bracket unpeaked r * divisorSlope y
      where
        y = sqrt (2 * r)
    slope y = (((y * y - 6) * y + 8 * s) * y - 3 * s * s) / (y * ((y * y - 3) * y + 2 * s))
    divisorSlope y = y * y * y * ((7 * y * y - 15) * y + 8 * s)

-- | Energy flux from one face at a radius, as measured by the gas, in units of
-- @3Ṁ\/(8πM²)@, which makes it @1\/(8r³)@ far out; 0 at the innermost stable orbit, inside
-- it and for NaN (Page and Thorne 1974, equation 15n, with the equivalent sum of three
-- logarithms). With @x = √(2r)@ and @x₀@ its value at the edge it is
--
-- > [x − x₀ − (3s/2) ln(x/x₀) − Σ cᵢ ln((x − xᵢ)/(x₀ − xᵢ))] / (x⁴ (x³ − 3x + 2s))
--
-- in which the parts of the logarithms that are linear in @x − x₀@ cancel exactly;
-- they are left out on both sides. Without spin the sum is that of Page and Thorne's
-- logarithm with the factor √3\/2. (Some printed versions have √3\/3, with which the flux
-- would not vanish quadratically at r = 3.)
thinDiskFlux :: ThinDisk -> Double -> Double
thinDiskFlux disk r
  | r > _diskEdge disk && not (isInfinite r) =
    bracket disk r / divisor (_diskSpin disk) (sqrt (2 * r))
  | otherwise = 0

bracket :: ThinDisk -> Double -> Double
bracket (ThinDisk s edge x0 roots _) r =
  negate (1.5 * s * log1pMinus (d / x0))
    - sum [c * log1pMinus (d / (x0 - root)) | (root, c) <- roots]
  where
    -- x − x₀, without cancellation.
    d = 2 * (r - edge) / (sqrt (2 * r) + x0)

divisor :: Double -> Double -> Double
divisor s x = x * x * x * x * ((x * x - 3) * x + 2 * s)

-- | The radius of the ring that radiates most, and its flux.
thinDiskPeak :: ThinDisk -> (Double, Double)
thinDiskPeak = _diskPeak

-- | The temperature of the gas relative to the hottest ring, @(F\/F_peak)^¼@: 0 at and
-- inside the innermost stable orbit, 1 at the peak, and falling as r^(−3\/4) far out.
relativeTemperature :: ThinDisk -> Double -> Double
relativeTemperature disk r = min 1 (sqrt (sqrt (thinDiskFlux disk r / snd (_diskPeak disk))))

-- | ln(1+t) − t for t ≥ 0, with a small relative error for small t as well. There the
-- logarithm is 2 artanh w = 2w + 2w³/3 + 2w⁵/5 + … with w = t/(2+t), and 2w − t = −tw
-- removes the difference. The omitted terms are below 1e-17 of the sum where the two
-- branches meet.
log1pMinus :: Double -> Double
log1pMinus t
  | t > 0.25 = log1p t - t
  | otherwise = w * (2 * q * series - t)
  where
    w = t / (2 + t)
    q = w * w
    series = foldr (\n s -> 1 / n + q * s) 0 [3, 5, 7, 9, 11, 13, 15, 17]
