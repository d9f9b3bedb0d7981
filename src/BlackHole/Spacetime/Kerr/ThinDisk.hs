-- | The thin accretion disk of Page and Thorne around a Kerr hole: how much each
-- ring of right-handed gas radiates if no torque acts at the innermost stable orbit.
module BlackHole.Spacetime.Kerr.ThinDisk
  ( ThinDisk,
    thinDisk,
    thinDiskFlux,
    thinDiskPeak,
    relativeTemperature,
  )
where

import BlackHole.Matter.ThinDisk (log1pMinus)
import BlackHole.Numeric.Bisection (bisect)
import BlackHole.Spacetime.Kerr.Landmarks

-- | The disk around one hole.
data ThinDisk = ThinDisk
  { _diskSpin :: !Double,
    -- | √(2r) at the innermost stable orbit.
    _diskEdge :: !Double,
    -- | The roots of @x³ − 3x + 2s@ with the weights of their logarithms.
    _diskRoots :: ![(Double, Double)],
    -- | Radius and flux of the ring that radiates most.
    _diskPeak :: !(Double, Double)
  }

-- | The disk around a hole; finds the peak by bisection.
thinDisk :: Spin -> ThinDisk
thinDisk hole = disk (x * x / 2, bracket unpeaked x / divisor unpeaked x)
  where
    s = dimensionlessSpin hole
    x0 = sqrt (2 * iscoRadius RightHanded hole)
    disk = ThinDisk s x0 weighted
    unpeaked = disk (0, 0)
    x1 = 2 * cos ((acos s - pi) / 3)
    x3 = negate (2 * cos (acos s / 3))
    x2 = negate (2 * s / (x1 * x3))
    weighted = [(root, weight root others) | (root, others) <- [(x1, (x2, x3)), (x2, (x1, x3)), (x3, (x1, x2))], root /= 0]
    weight root (other, another) = 3 * (root - s) * (root - s) / (root * (root - other) * (root - another))
    -- The flux is b/g; its derivative has the sign of b'g − bg'.
    x = bisect rising x0 (4 * x0)
    rising y = slope y * divisor unpeaked y > bracket unpeaked y * divisorSlope y
    slope y = (((y * y - 6) * y + 8 * s) * y - 3 * s * s) / (y * ((y * y - 3) * y + 2 * s))
    divisorSlope y = y * y * y * ((7 * y * y - 15) * y + 8 * s)

-- | Energy flux from one face at a radius, as measured by the gas, in units of
-- @3Ṁ\/(8πM²)@, which makes it @1\/(8r³)@ far out; 0 at the innermost stable orbit and
-- inside it (Page and Thorne 1974, equation 15n, with the equivalent sum of three
-- logarithms). With @x = √(2r)@ and @x₀@ its value at the edge it is
--
-- > [x − x₀ − (3s/2) ln(x/x₀) − Σ cᵢ ln((x − xᵢ)/(x₀ − xᵢ))] / (x⁴ (x³ − 3x + 2s))
--
-- in which the parts of the logarithms that are linear in @x − x₀@ cancel exactly;
-- they are left out on both sides.
thinDiskFlux :: ThinDisk -> Double -> Double
thinDiskFlux disk r
  | x > _diskEdge disk && not (isInfinite r) = bracket disk x / divisor disk x
  | otherwise = 0
  where
    x = sqrt (2 * r)

bracket, divisor :: ThinDisk -> Double -> Double
bracket (ThinDisk s x0 roots _) x =
  negate (1.5 * s * log1pMinus (d / x0)) - sum [c * log1pMinus (d / (x0 - root)) | (root, c) <- roots]
  where
    d = x - x0
divisor disk x = x * x * x * x * ((x * x - 3) * x + 2 * _diskSpin disk)

-- | The radius of the ring that radiates most, and its flux.
thinDiskPeak :: ThinDisk -> (Double, Double)
thinDiskPeak = _diskPeak

-- | The temperature of the gas relative to the hottest ring, @(F\/F_peak)^¼@, in
-- [0, 1].
relativeTemperature :: ThinDisk -> Double -> Double
relativeTemperature disk r = min 1 (sqrt (sqrt (thinDiskFlux disk r / snd (_diskPeak disk))))
