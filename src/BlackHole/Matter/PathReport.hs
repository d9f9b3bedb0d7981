{-# LANGUAGE BangPatterns #-}

-- | A report on one light path, from the closed form or from the leapfrog, and the
-- difference between two reports.
module BlackHole.Matter.PathReport
  ( PathReport (..),
    exactReport,
    leapfrogReport,
    PathDifference (..),
    reportDifference,
    PathPoint (..),
  )
where

import BlackHole.Matter.GasFlow
import BlackHole.Matter.Redshift
import BlackHole.Spacetime.Fate
import BlackHole.Spacetime.Momentum
import BlackHole.Spacetime.PathPlane (meetsDiskPlane)
import BlackHole.Spacetime.Photon
import BlackHole.Spacetime.PlaneCrossing
import BlackHole.Spacetime.Schwarzschild.LeapfrogStep
import BlackHole.Spacetime.Schwarzschild.StepRule
import BlackHole.Spacetime.Schwarzschild.Trajectory
import BlackHole.Spacetime.Schwarzschild.TrajectoryPoints
import BlackHole.Spacetime.Types (Spacetime (Schwarzschild))
import BlackHole.Vector.XY (XY (..))
import BlackHole.Vector.XYZ (XYZ (..), (*^), (^+^))
import qualified BlackHole.Vector.XYZ as XYZ
import Data.Functor (void)
import Data.Maybe (mapMaybe)

-- | The report. Lengths are in Schwarzschild radii, angles in radians.
data PathReport = PathReport
  { -- | In the plane of the path.
    reportFate :: !(Fate XY),
    -- | For the leapfrog, the impact parameter of the last state.
    reportImpactParameter :: !(Maybe Double),
    -- | Angle swept from the start to infinity or to the horizon.
    reportSweptAngle :: !(Maybe Double),
    -- | See 'trajectoryDeflection'.
    reportDeflection :: !(Maybe Double),
    reportClosestApproach :: !(Maybe Double),
    -- | With ν_obs\/ν_em of light that gas there sends to the observer.
    reportCrossings :: ![PlaneCrossing Double],
    -- | Steps of the integrator, or the number of points at which the exact path was
    -- evaluated.
    reportSteps :: !Int,
    -- | Greatest @|h − h₀| \/ h₀@ along the path; 'Nothing' for a radial path.
    reportAngularMomentumDrift :: !(Maybe Double),
    -- | Greatest @|E − E₀| \/ E₀@ along the path.
    reportEnergyDrift :: !(Maybe Double),
    -- | Points from which to draw the path.
    reportPath :: ![PathPoint]
  }
  deriving (Eq, Show)

-- | A point of a path: swept angle in radians, and position.
data PathPoint = PathPoint !Double !XYZ
  deriving (Eq, Show)

-- | @exactReport drawn trajectory@ is the report from the closed form. Its points reach out
-- to the radius @drawn@, or to the start if that is farther. Its drifts show rounding
-- alone.
exactReport :: Double -> Trajectory -> PathReport
exactReport drawn trajectory =
  PathReport
    { reportFate = trajectoryFate trajectory,
      reportImpactParameter = Just (trajectoryImpactParameter trajectory),
      reportSweptAngle =
        if isInfinite (trajectorySweep trajectory)
          then Nothing
          else Just (trajectorySweep trajectory),
      reportDeflection = trajectoryDeflection trajectory,
      reportClosestApproach = trajectoryClosestApproach trajectory,
      reportCrossings = crossingsOf trajectory,
      reportSteps = length points,
      reportAngularMomentumDrift = driftOf (XYZ.norm . angularMomentum) photons,
      reportEnergyDrift = driftOf pseudoEnergy photons,
      reportPath = [PathPoint angle (photonPosition p) | TrajectoryPoint angle p <- points]
    }
  where
    points = trajectoryPoints drawn 0.02 trajectory
    photons = map pointPhoton points

-- | The crossings outside the horizon, with the shift of the gas there.
crossingsOf :: Trajectory -> [PlaneCrossing Double]
crossingsOf trajectory =
  mapMaybe (shifted (trajectoryObserved trajectory)) (trajectoryCrossings trajectory)

shifted :: Double -> PlaneCrossing (Maybe Momentum) -> Maybe (PlaneCrossing Double)
shifted observed crossing@(PlaneCrossing r _ light) = shift <$> light
  where
    shift momentum =
      redshiftFactor (redshift observed (gasFrequencies (gasFlow Schwarzschild) r 0 momentum))
        <$ crossing

driftOf :: (Photon -> Double) -> [Photon] -> Maybe Double
driftOf quantity photons = case map quantity photons of
  first : rest | first > 0 -> Just (foldl max 0 [abs (q - first) / first | q <- rest])
  _ -> Nothing

-- | The radius at which the leapfrog starts on a path from infinity and leaves a path
-- that escapes: the renderer's celestial sphere, or beyond the path's own start if that
-- is farther out.
leapfrogStartRadius :: Trajectory -> Double
leapfrogStartRadius trajectory =
  max (leapfrogSkyRadius defaultLeapfrog) (2 * trajectoryImpactParameter trajectory)

-- | The state of the loop.
data Walk = Walk
  { walkSteps :: !Int,
    walkPhoton :: !Photon,
    walkSwept :: !Double,
    walkMomentumDrift :: !Double,
    walkEnergyDrift :: !Double,
    walkClosest :: !(Maybe Double),
    -- | Latest first, like the path.
    walkCrossings :: ![PlaneCrossing Double],
    walkPath :: ![PathPoint]
  }

-- | @leapfrogReport rule drawn trajectory@ is the report from the leapfrog. A path from
-- infinity starts on the exact orbit at 'leapfrogStartRadius', and the rest of an
-- escaping path beyond that radius is added in closed form, so the difference from
-- 'exactReport' is the error of the integrator alone.
--
-- Crossings, the closest point and the horizon are located within a step on the cubic
-- through its ends, which is more accurate than the steps are.
--
-- With 'ReportSteps' the error stops falling at about 1e-5 radians whatever the base
-- length, because that rule's steps beyond @r = 40@ always have the length 10. Takes at
-- most twenty million steps of about 0.2 µs each.
--
-- The function is long because everything in the report comes from the one loop.
leapfrogReport :: StepRule -> Double -> Trajectory -> PathReport
leapfrogReport rule farthest trajectory = case trajectoryEntry radius trajectory of
  Nothing -> ended StepLimit Nothing (Walk 0 (Photon XYZ.zero XYZ.zero) 0 0 0 Nothing [] [])
  Just (TrajectoryPoint swept photon) -> follow swept photon
  where
    radius = leapfrogStartRadius trajectory
    stepLimit = 20000000
    drawnRadius = maybe farthest (max farthest) (trajectoryStartRadius trajectory)
    follow swept0 start =
      go (Walk 0 start swept0 0 0 Nothing [] [PathPoint swept0 (photonPosition start)])
      where
        !h0 = XYZ.norm (angularMomentum start)
        !h2 = XYZ.normSquared (angularMomentum start)
        !energy0 = pseudoEnergy start
        !normal = angularMomentum start
        !sky2 = radius * radius
        go !walk
          | XYZ.normSquared x > sky2 && XYZ.dot x v > 0 = escaped walk
          | walkSteps walk >= stepLimit = ended StepLimit Nothing walk
          | XYZ.normSquared x' <= 1 && XYZ.dot x' v' < 0 =
            let atHorizon = hermite (bisectStep (\p -> XYZ.norm (photonPosition p) > 1))
                swept = walkSwept walk + turned (photonPosition atHorizon)
             in ended Captured (Just swept) $
                  stepped {walkPath = PathPoint swept (photonPosition atHorizon) : walkPath walk}
          | otherwise = go stepped
          where
            photon@(Photon x v) = walkPhoton walk
            dt = stepLength rule x / XYZ.norm v
            photon'@(Photon x' v') = leapfrogStep Schwarzschild h2 dt photon
            hermite = alongStep dt photon photon'
            bisectStep holds = halve (holds . hermite) (60 :: Int) 0 1
            turned p = atan2 (signedCross x p) (XYZ.dot x p)
            signedCross a b
              | h0 > 0 = XYZ.dot (XYZ.cross a b) normal / h0
              | otherwise = 0
            swept' = walkSwept walk + turned x'
            stepped =
              Walk
                { walkSteps = walkSteps walk + 1,
                  walkPhoton = photon',
                  walkSwept = swept',
                  walkMomentumDrift =
                    max (walkMomentumDrift walk) (abs (XYZ.norm (angularMomentum photon') - h0)),
                  walkEnergyDrift =
                    max (walkEnergyDrift walk) (abs (pseudoEnergy photon' - energy0)),
                  walkClosest =
                    if XYZ.dot x v < 0 && XYZ.dot x' v' >= 0
                      then Just (XYZ.norm (photonPosition (hermite (bisectStep movesInward))))
                      else walkClosest walk,
                  walkCrossings = maybe id (:) crossing (walkCrossings walk),
                  walkPath = drawn (walkPath walk)
                }
            crossing
              | meetsDiskPlane (trajectoryPlane trajectory),
                height x * height x' < 0 || (height x /= 0 && height x' == 0) =
                shifted
                  (trajectoryObserved trajectory)
                  ( crossingOf
                      (hermite (bisectStep (\p -> height (photonPosition p) * height x > 0)))
                  )
              | otherwise = Nothing
            drawn path = case path of
              PathPoint _ p : _ | XYZ.distance p x' < 0.02 * XYZ.norm x' -> path
              _ -> PathPoint swept' x' : path
        escaped walk =
          let rest = trajectoryFromPhoton (trajectoryObserved trajectory) (walkPhoton walk)
              -- A radial path sweeps no angle; 'launch' takes its neighbour.
              angle = walkSwept walk + (if h0 > 0 then trajectorySweep rest else 0)
              final = walk {walkCrossings = reverse (crossingsOf rest) ++ walkCrossings walk}
           in case trajectoryFate rest of
                Escaped _ -> ended (Escaped (XY (cos angle) (sin angle))) (Just angle) final
                _ -> ended StepLimit Nothing final
    height (XYZ _ y _) = y
    ended fate swept walk =
      PathReport
        { reportFate = fate,
          reportImpactParameter = impactParameter (walkPhoton walk),
          reportSweptAngle = swept,
          reportDeflection = (-) <$> escapedAngle <*> straightAngle,
          reportClosestApproach = walkClosest walk,
          reportCrossings = reverse (walkCrossings walk),
          reportSteps = walkSteps walk,
          reportAngularMomentumDrift =
            if trajectoryImpactParameter trajectory > 0
              then Just (walkMomentumDrift walk / trajectoryImpactParameter trajectory)
              else Nothing,
          -- Paths have unit energy, so E is one half.
          reportEnergyDrift = Just (2 * walkEnergyDrift walk),
          reportPath =
            reverse (filter (\(PathPoint _ p) -> XYZ.norm p <= drawnRadius) (walkPath walk))
        }
      where
        escapedAngle = case fate of
          Escaped _ -> swept
          _ -> Nothing
    -- The angle of a straight line, taken from the exact path.
    straightAngle = case trajectoryFate trajectory of
      Escaped _ -> (trajectorySweep trajectory -) <$> trajectoryDeflection trajectory
      _ -> Nothing

-- | The cubic through the ends of a step, at a fraction of the step.
alongStep :: Double -> Photon -> Photon -> Double -> Photon
alongStep dt (Photon x v) (Photon x' v') s =
  Photon
    ( (1 - s2 * (3 - 2 * s)) *^ x ^+^ (s2 * (3 - 2 * s)) *^ x'
        ^+^ (dt * s * (1 - s) * (1 - s)) *^ v
        ^+^ (dt * s2 * (s - 1)) *^ v'
    )
    ( (6 * s * (1 - s) / dt) *^ (x' ^+^ (-1) *^ x)
        ^+^ ((1 - s) * (1 - 3 * s)) *^ v
        ^+^ (s * (3 * s - 2)) *^ v'
    )
  where
    s2 = s * s

-- | The point of an interval at which a condition stops holding.
halve :: (Double -> Bool) -> Int -> Double -> Double -> Double
halve holds = go
  where
    go n low high
      | n <= 0 = middle
      | holds middle = go (n - 1) middle high
      | otherwise = go (n - 1) low middle
      where
        middle = 0.5 * (low + high)

-- | The values of one report less those of another. A value missing from either report
-- has no difference; crossings are compared in order.
data PathDifference = PathDifference
  { differenceImpactParameter :: !(Maybe Double),
    differenceSweptAngle :: !(Maybe Double),
    differenceDeflection :: !(Maybe Double),
    differenceClosestApproach :: !(Maybe Double),
    differenceCrossings :: ![PlaneCrossing Double],
    differenceAngularMomentumDrift :: !(Maybe Double),
    differenceEnergyDrift :: !(Maybe Double)
  }
  deriving (Eq, Show)

-- | The first report less the second.
reportDifference :: PathReport -> PathReport -> PathDifference
reportDifference a b =
  PathDifference
    { differenceImpactParameter = by reportImpactParameter,
      differenceSweptAngle = sameEnd (by reportSweptAngle),
      differenceDeflection = by reportDeflection,
      differenceClosestApproach = by reportClosestApproach,
      differenceCrossings = zipWith crossingDifference (reportCrossings a) (reportCrossings b),
      differenceAngularMomentumDrift = by reportAngularMomentumDrift,
      differenceEnergyDrift = by reportEnergyDrift
    }
  where
    by field = (-) <$> field a <*> field b
    -- The angle to infinity and the angle to the horizon cannot be compared.
    sameEnd value = if void (reportFate a) == void (reportFate b) then value else Nothing
