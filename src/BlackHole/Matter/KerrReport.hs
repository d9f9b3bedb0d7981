-- | The numbers of one light path around a rotating hole: constants of motion, end,
-- crossings of the disk's plane with the shift of the gas there, and points to draw the
-- path from.
module BlackHole.Matter.KerrReport
  ( KerrReport (..),
    KerrPathPoint (..),
    kerrReport,
  )
where

import BlackHole.Matter.GasFlow
import BlackHole.Matter.Redshift
import BlackHole.Numeric.Bisection (bisect)
import BlackHole.Spacetime.Fate
import BlackHole.Spacetime.Follow
import BlackHole.Spacetime.Kerr.Landmarks
import BlackHole.Spacetime.Kerr.Path
import BlackHole.Spacetime.Kerr.Sight
import BlackHole.Spacetime.Observer (SightLine (..))
import BlackHole.Spacetime.PlaneCrossing
import BlackHole.Spacetime.Types (Spacetime (Kerr))
import BlackHole.Vector.XYZ (XYZ (..))

-- | One light path. Lengths are in Schwarzschild radii, angles in radians.
data KerrReport = KerrReport
  { kerrReportFate :: !(Fate XYZ),
    -- | λ, the angular momentum about the axis over the energy.
    kerrReportLambda :: !Double,
    -- | Carter's constant over the squared energy.
    kerrReportCarter :: !Double,
    -- | The Mino time from the observer to the end; infinite for a path that circles for
    -- ever.
    kerrReportMinoTime :: !Double,
    -- | The frequency that the observer measures over that at infinity.
    kerrReportObserved :: !Double,
    -- | With ν_obs\/ν_em of light from the gas there.
    kerrReportCrossings :: ![PlaneCrossing Double],
    -- | From the observer to the horizon, or to the radius out to which it is drawn.
    kerrReportPath :: [KerrPathPoint]
  }
  deriving (Eq, Show)

-- | A point of the path: Mino time and place.
data KerrPathPoint = KerrPathPoint !Double !XYZ
  deriving (Eq, Show)

-- | @kerrReport method hole drawn azimuth ray@: the report on the path of a ray from an
-- observer at an azimuth, with the path drawn out to a radius (or to the observer, if that
-- is farther), in the ingoing azimuth if that of the observer is one. The points are at
-- most a fiftieth of their radius apart, and at most 100 000. The method is 'InClosedForm',
-- or 'ByTable' for what the renderer takes from its table and from the closed form with
-- the precision of pictures.
kerrReport :: Method -> Spin -> Double -> Azimuth -> LightRay -> KerrReport
kerrReport method hole drawn azimuth ray =
  KerrReport
    { kerrReportFate = pathFate traced sight,
      kerrReportLambda = rayLambda ray,
      kerrReportCarter = rayEta ray,
      kerrReportMinoTime = kerrMinoTime path,
      kerrReportObserved = rayObserved ray,
      kerrReportCrossings =
        [ redshiftFactor shift <$ crossing
          | crossing <- planeCrossings traced sight,
            Just shift <- [crossingRedshift (gasFlow (Kerr hole)) sight crossing]
        ],
      kerrReportPath =
        [KerrPathPoint time (placed lead (kerrPoint path time)) | time <- take 100000 (times 0)]
    }
  where
    path = rotatingPath traced hole azimuth ray
    traced =
      tracing
        (Kerr hole)
        method
        (XYZ 0 (rayRadius ray * rayCosine ray) (rayRadius ray * raySine ray))
    sight = RotatingSight hole azimuth ray
    -- The path of light to a falling observer is smooth in the ingoing azimuth.
    lead r = case azimuth of
      Ingoing _ | r > horizonRadius hole -> ingoingLead hole r
      _ -> 0
    limit = max drawn (rayRadius ray)
    momentum2 = abs (rayEta ray) + rayLambda ray * rayLambda ray
    times time
      | time >= end = [end]
      | otherwise =
        let r = pointRadius (kerrPoint path time)
         in time : times (time + 0.02 / sqrt (r * r + momentum2))
    -- Where the path leaves the drawn sphere, if it escapes; a path that ends at the
    -- horizon stops just short of it, for the azimuth winds up there.
    end = case kerrFate path of
      Escaped _ -> lastBelow limit (kerrMinoTime path)
      Captured -> kerrMinoTime path * (1 - 1e-9)
      _ -> 20
    -- Outwards at the end, so that the radius grows beyond some time for good.
    lastBelow radius =
      bisect
        (\t -> let point = kerrPoint path t in not (pointGrows point) || pointRadius point < radius)
        0

-- | A point, with its azimuth advanced by a function of the radius.
placed :: (Double -> Double) -> KerrPoint -> XYZ
placed lead point = XYZ (r * s * sin phi) (r * c) (r * s * cos phi)
  where
    r = pointRadius point
    c = pointCosine point
    s = sqrt (max 0 ((1 - c) * (1 + c)))
    phi = pointAzimuth point + lead r
