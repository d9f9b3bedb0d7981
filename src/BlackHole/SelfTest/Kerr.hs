-- | Checks of light, gas and landmarks of rotating holes against values computed with 34
-- and 50 digits.
module BlackHole.SelfTest.Kerr
  ( kerrChecks,
  )
where

import BlackHole.Matter.KerrReport
import BlackHole.Matter.ThinDisk
import BlackHole.SelfTest.Check
import BlackHole.Spacetime.Fate
import BlackHole.Spacetime.Follow (Method (InClosedForm))
import BlackHole.Spacetime.Kerr.Landmarks
import BlackHole.Spacetime.Kerr.Shadow
import BlackHole.Spacetime.Kerr.Sight
import BlackHole.Spacetime.PlaneCrossing
import BlackHole.Vector.XYZ (XYZ (..))
import qualified BlackHole.Vector.XYZ as XYZ

-- | All of these checks, in milliseconds.
kerrChecks :: [Check]
kerrChecks = landmarkChecks ++ shadowChecks ++ rayChecks ++ [fluxCheck]

-- | Radii of circular orbits (Bardeen, Press and Teukolsky 1972).
landmarkChecks :: [Check]
landmarkChecks =
  [ at 0.9 "horizon at spin 0.9" horizonRadius 0.71794494717703368,
    at
      0.9
      "innermost stable orbit with the hole at spin 0.9"
      (iscoRadius RightHanded)
      1.1604415208809436,
    at
      0.9
      "innermost stable orbit against the hole at spin 0.9"
      (iscoRadius LeftHanded)
      4.3586761398032447,
    at
      0.9
      "photon orbit with the hole at spin 0.9"
      (photonOrbitRadius RightHanded)
      0.7789273137116914
  ]
  where
    at s name radius reference = Check name (withSpin s radius) reference 1e-12

-- | The extent of the shadow that an observer at rest sees, on both sides of the centre.
shadowChecks :: [Check]
shadowChecks =
  [ Check
      "shadow at spin 0.9, r = 30, inclination 82: left edge (deg)"
      (edge minimum)
      (-2.7166244836136827)
      1e-6,
    Check
      "shadow at spin 0.9, r = 30, inclination 82: right edge (deg)"
      (edge maximum)
      6.3818614502107871
      1e-6
  ]
  where
    -- Close to the middle of the edge's upper and lower half the angle is stationary.
    edge side = withSpin 0.9 $ \hole -> case shadow hole (Place 30 (82 * pi / 180)) of
      Just rim ->
        side
          [ 180 / pi * atan2 nphi (negate nr)
            | k <- [0 .. 20000 :: Int],
              let Direction nr _ nphi = shadowEdge rim (pi * fromIntegral k / 20000)
          ]
      Nothing -> notANumber

-- | A line of sight that winds around a fast hole: its constants, its end, and the gas
-- where it first crosses the plane.
rayChecks :: [Check]
rayChecks =
  [ Check
      "light at spin 0.999, 2 r_s from the hole: lambda"
      (along kerrReportLambda)
      (-0.11419099438266608)
      1e-13,
    Check
      "light at spin 0.999, 2 r_s from the hole: Carter's constant"
      (along kerrReportCarter)
      5.8640010489074874
      1e-13,
    Check
      "light at spin 0.999, 2 r_s from the hole: Mino time"
      (along kerrReportMinoTime)
      3.528770788870398
      1e-11,
    Check
      "light at spin 0.999, 2 r_s from the hole: error of its direction (rad)"
      (along (missed . kerrReportFate))
      0
      1e-11,
    Check
      "light at spin 0.999, 2 r_s from the hole: first crossing's radius"
      (along (first crossingRadius))
      1.3619046375019687
      1e-12,
    Check
      "light at spin 0.999, 2 r_s from the hole: first crossing's g"
      (along (first crossingLight))
      0.6365990646497606
      1e-12
  ]
  where
    along value = withSpin 0.999 $ \hole ->
      maybe notANumber (value . kerrReport InClosedForm hole 100 (BoyerLindquist 0)) $
        lightRay
          hole
          (Place 2 (pi / 6))
          AtRest
          (Direction (negate (cos (pi / 3))) (negate (sin (pi / 3))) (sin (pi / 3) * cos (pi / 2)))
    missed fate = case fate of
      Escaped direction ->
        XYZ.distance direction (XYZ 0.43260127730495184 (-0.26621387449028123) 0.86138627102072909)
      _ -> notANumber
    first value report = case kerrReportCrossings report of
      crossing : _ -> value crossing
      [] -> notANumber

-- | Page and Thorne's flux.
fluxCheck :: Check
fluxCheck =
  Check
    "radius of the disk's greatest flux at spin 0.9"
    (withSpin 0.9 (fst . thinDiskPeak . thinDisk))
    1.7209216811787638
    1e-12

withSpin :: Double -> (Spin -> Double) -> Double
withSpin s value = maybe notANumber value (spin s)

-- | The value of a quantity that could not be computed; no limit admits it.
notANumber :: Double
notANumber = 0 / 0
