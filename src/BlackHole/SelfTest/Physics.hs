{-# LANGUAGE BangPatterns #-}

-- | Checks of the formulas for light paths, observers, gas, colour and noise against
-- published values, textbook closed forms, and values computed with thirty digits.
module BlackHole.SelfTest.Physics
  ( physicsChecks,
    deflectionReferences,
  )
where

import BlackHole.Light.BlackBody (blackBodyChromaticity, secondRadiationConstant)
import BlackHole.Matter.GasFlow
import BlackHole.Matter.Redshift
import BlackHole.Matter.ThinDisk (thinDisk, thinDiskPeak)
import BlackHole.Noise.SipHash (SipKey (..), sipHash2)
import BlackHole.Numeric.Bisection (bisect)
import BlackHole.SelfTest.Check
import BlackHole.Spacetime.Fate (Fate (..))
import BlackHole.Spacetime.Kerr.Landmarks (noSpin)
import BlackHole.Spacetime.LightPath
import BlackHole.Spacetime.Momentum
import BlackHole.Spacetime.Observer
import BlackHole.Spacetime.Photon
import BlackHole.Spacetime.Schwarzschild.Deflection
import BlackHole.Spacetime.Schwarzschild.Leapfrog
import BlackHole.Spacetime.Schwarzschild.LeapfrogStep
import BlackHole.Spacetime.Schwarzschild.Orbit (orbit, orbitFate, orbitSweep)
import BlackHole.Spacetime.Schwarzschild.StepRule
import BlackHole.Spacetime.Types (Spacetime (..))
import BlackHole.Vector.XYZ (XYZ (..))
import qualified BlackHole.Vector.XYZ as XYZ
import Data.Bits (popCount, xor)
import Data.Maybe (fromMaybe)

-- | All of these checks, computed lazily, in less than a second together.
physicsChecks :: [Check]
physicsChecks =
  concat
    [ criticalChecks,
      deflectionChecks,
      shadowAngleChecks,
      leapfrogChecks,
      redshiftChecks,
      [peakCheck],
      illuminantChecks,
      [sipHashCheck]
    ]

-- | Light from infinity falls in exactly below b_c = 3√3/2.
criticalChecks :: [Check]
criticalChecks =
  [ Check "critical impact parameter, closed form" (threshold capturedExactly) critical 1e-14,
    -- The error is 0.19 l² for steps of equal length l; 0.25 leaves a margin.
    Check "critical impact parameter, leapfrog, step 0.1" coarse critical (0.25 * 0.1 * 0.1),
    Check
      "critical impact parameter, leapfrog, limit of short steps"
      ((4 * fine - coarse) / 3)
      critical
      1e-5
  ]
  where
    critical = 1.5 * sqrt 3
    threshold captured = bisect captured 2 3
    coarse = threshold (capturedByLeapfrog 0.1)
    fine = threshold (capturedByLeapfrog 0.05)
    capturedExactly b =
      case orbitFate (orbit 30 (negate (sqrt (1 - b * b * (29 / 27000)))) (b / 30)) of
        Captured -> True
        _ -> False
    capturedByLeapfrog l b = case pathEnd (EqualSteps l) b of
      Captured -> True
      _ -> False

-- | Darwin's closed form at every impact parameter of the reference table.
deflectionChecks :: [Check]
deflectionChecks =
  [ Check ("deflection at b = " ++ show b ++ " (rad)") (orNaN (deflectionAngle b)) deflection 1e-10
    | (b, deflection) <- deflectionReferences
  ]

-- | Impact parameter and deflection in radians, from 30-digit arithmetic by two
-- independent methods.
deflectionReferences :: [(Double, Double)]
deflectionReferences =
  [ (2.5981, 11.20088384525815),
    (2.599, 7.542780068319542),
    (2.61, 4.99612017107373),
    (2.65, 3.557938042459651),
    (2.7, 2.91939633960956),
    (2.8, 2.299149732750071),
    (3, 1.719388310230169),
    (3.5, 1.127639104731336),
    (4, 0.8587300180790953),
    (5, 0.5903957876058273),
    (10, 0.2361359953884699),
    (20, 0.1081040765409205),
    (100, 0.02029996623954331),
    (1000, 0.00200295058709901)
  ]

-- | The angle at which the static observer's lines of sight begin to miss the hole,
-- against Synge 1966: sin²ψ = (27/4)(1−1/r)/r².
shadowAngleChecks :: [Check]
shadowAngleChecks =
  [ Check
      ("shadow half-angle of an observer at rest at r = " ++ place ++ " (deg)")
      (edge r)
      reference
      limit
    | (place, r, reference, limit) <-
        [("1.5", 1.5, 90, 1e-9), ("3", 3, 45, 1e-9), ("10", 10, 14.2690273, 5e-8)]
  ]
  where
    edge r = 180 / pi * bisect (dark r) 0 (0.9 * pi)
    dark r psi = case sightLine
      Schwarzschild
      Static
      (XYZ 0 0 r)
      (XYZ (sin psi) 0 (negate (cos psi)))
      >>= sightPhoton of
      Nothing -> True
      Just photon ->
        let Photon x v = photon
            radial = XYZ.dot x v / r
         in case orbitFate (orbit r radial (XYZ.norm (angularMomentum photon) / r)) of
              Escaped _ -> False
              _ -> True

-- | The integrator's order of convergence, and its conserved quantities.
leapfrogChecks :: [Check]
leapfrogChecks =
  [ Check
      "leapfrog: energy error, step 0.1 over step 0.05"
      (worstEnergy 0.1 / worstEnergy 0.05)
      4
      0.1,
    Check
      "leapfrog: direction error, step 0.1 over step 0.05"
      (directionError 0.1 / directionError 0.05)
      4
      0.1,
    Check "leapfrog: relative change of h, report's steps" momentumChange 0 1e-12
  ]
  where
    b = 3.2
    worstEnergy l = worst (\p -> abs (pseudoEnergy p - pseudoEnergy (aimedAt b))) (report l)
    momentumChange =
      worst (\p -> XYZ.distance (angularMomentum p) h / XYZ.norm h) (report 0.1)
      where
        h = angularMomentum (aimedAt b)
    report l = walk (ReportSteps l 0.01) b
    worst quantity = foldl (\most p -> max most (quantity p)) 0
    directionError l = case (pathEnd (EqualSteps l) 5, exactDirection 5) of
      (Escaped d, Just e) -> XYZ.distance d e
      _ -> notANumber

-- | The extremes of g for light from a ring of orbiting gas that reaches an observer in
-- the ring's plane at infinity.
redshiftChecks :: [Check]
redshiftChecks =
  concat
    [ [ Check
          ("greatest g from gas at r = " ++ place ++ ", seen edge-on")
          (maximum shifts)
          most
          5e-8,
        Check ("least g from gas at r = " ++ place ++ ", seen edge-on") (minimum shifts) least 5e-8
      ]
      | (place, r, most, least) <-
          [("4", 4, 1.3359816, 0.56138496), ("6", 6, 1.2665408, 0.65796014)],
        let shifts = ringShifts r
    ]

-- | g of light that leaves the ring at r within its plane, at every half degree. All of
-- it escapes, either outwards or around the hole past its closest point.
ringShifts :: Double -> [Double]
ringShifts r =
  [ redshiftFactor (redshift 1 (gasFrequencies (gasFlow Schwarzschild) r 0 (Momentum 0 lambda)))
    | i <- [-180 .. 180 :: Int],
      let lambda = r * sin (pi / 360 * fromIntegral i) / sqrt (1 - 1 / r)
  ]

-- | The radius at which the flux of the disk is greatest.
peakCheck :: Check
peakCheck =
  Check
    "radius of the disk's greatest flux (Page and Thorne)"
    (fst (thinDiskPeak (thinDisk noSpin)))
    4.7755
    5e-5

-- | CIE illuminant A is a black body at 2848 K on the scale of 1931, whose hc/k was
-- 1.435e-2 m K. Its published chromaticity is a sum over fewer wavelengths and differs
-- by 1e-5.
illuminantChecks :: [Check]
illuminantChecks =
  [ Check "chromaticity x of illuminant A" x 0.44757 1.5e-5,
    Check "chromaticity y of illuminant A" y 0.40745 1.5e-5
  ]
  where
    (x, y) = blackBodyChromaticity (2848 * secondRadiationConstant / 1.435e7)

-- | The published output for the key 00 … 0f and the message 00 … 0f, in little-endian
-- order.
sipHashCheck :: Check
sipHashCheck =
  Check "SipHash-2-4 of the published message, wrong bits" (fromIntegral wrong) 0 0
  where
    wrong = popCount (hash `xor` 0x3f2acc7f57c29bdb)
    hash = sipHash2 (SipKey low high) low high
    low = 0x0706050403020100
    high = 0x0f0e0d0c0b0a0908

-- | A photon of unit energy at r = 30, moving inwards with the impact parameter @b@ in
-- the plane y = 0.
aimedAt :: Double -> Photon
aimedAt b = Photon (XYZ p 0 (sqrt (900 - p * p))) (XYZ 0 0 (negate speed))
  where
    -- The squared speed is 1 + h²/r³ with h = b.
    speed = sqrt (1 + b * b / 27000)
    p = b / speed

-- | The end of that photon's path by leapfrog. The path runs in the plane of the gas,
-- where the rule of the design report (Will Yager, "Accurately Rendering a Black Hole")
-- takes short steps.
pathEnd :: StepRule -> Double -> Fate XYZ
pathEnd rule b =
  followedFate
    (followLeapfrog settings Schwarzschild emptyRegion (aimedAt b) (\() _ -> Continue ()) ())
  where
    settings = defaultLeapfrog {leapfrogSteps = rule, leapfrogSkyRadius = 400}

-- | The points of that photon's path by leapfrog until it has left r = 31.
walk :: StepRule -> Double -> [Photon]
walk rule b = takeWhile ((<= 31) . XYZ.norm . photonPosition) (iterate step start)
  where
    start = aimedAt b
    !h2 = XYZ.normSquared (angularMomentum start)
    step p =
      leapfrogStep
        Schwarzschild
        h2
        (stepLength rule (photonPosition p) / XYZ.norm (photonVelocity p))
        p

-- | The direction in which that photon escapes by the closed form.
exactDirection :: Double -> Maybe XYZ
exactDirection b = case orbitFate path of
  Escaped _ -> Just (XYZ (sin (alpha + orbitSweep path)) 0 (cos (alpha + orbitSweep path)))
  _ -> Nothing
  where
    path = orbit 30 (XYZ.dot x v / 30) (b / 30)
    Photon x@(XYZ px _ pz) v = aimedAt b
    alpha = atan2 px pz

orNaN :: Maybe Double -> Double
orNaN = fromMaybe notANumber

-- | The value of a quantity that could not be computed; no limit admits it.
notANumber :: Double
notANumber = 0 / 0
