{-# LANGUAGE BangPatterns #-}

-- | Everything worth knowing about one light path, from the closed form and
-- from the leapfrog, so that one can be held against the other.
module BlackHole.Physics.PathReport
  ( PathReport (..),
    exactReport,
    leapfrogReport,
    PathDifference (..),
    reportDifference,
    PathPoint (..),
    leapfrogStartRadius,
  )
where

import BlackHole.Physics.Course
import BlackHole.Physics.Leapfrog
import BlackHole.Physics.Orbit (OrbitFate (..))
import BlackHole.Physics.Photon
import BlackHole.Physics.Redshift (RedshiftParts (..), gasRedshift)
import BlackHole.Physics.Spacetime (Spacetime (Schwarzschild))
import BlackHole.Vector.XYZ (XYZ (..), (*^), (^+^))
import qualified BlackHole.Vector.XYZ as XYZ

-- | One light path. Lengths in Schwarzschild radii, angles in radians.
data PathReport = PathReport
  { -- | @captured@, @escaped@, @circles@ (critical in every bit), or
    -- @step limit@.
    reportFate :: !String,
    -- | The leapfrog's is that of the last state.
    reportImpactParameter :: !(Maybe Double),
    -- | From the start to infinity or to the horizon.
    reportSweptAngle :: !(Maybe Double),
    -- | See 'courseDeflection'.
    reportDeflection :: !(Maybe Double),
    reportClosestApproach :: !(Maybe Double),
    reportCrossings :: ![Crossing],
    -- | Steps of the integrator, or points at which the exact path was
    -- evaluated.
    reportSteps :: !Int,
    -- | Greatest @|h − h₀| \/ h₀@ along the path; 'Nothing' for a radial one.
    reportAngularMomentumDrift :: !(Maybe Double),
    -- | Greatest @|E − E₀| \/ E₀@ along the path.
    reportEnergyDrift :: !(Maybe Double),
    -- | Points to draw the path from.
    reportPath :: ![PathPoint]
  }
  deriving (Eq, Show)

-- | A point of a path: swept angle and place.
data PathPoint = PathPoint !Double !XYZ
  deriving (Eq, Show)

-- | @exactReport drawn course@, the path drawn out to a radius (or to the
-- start, if that is farther). What the drifts show is rounding.
exactReport :: Double -> Course -> PathReport
exactReport drawn course =
  PathReport
    { reportFate = fate,
      reportImpactParameter = Just (courseImpactParameter course),
      reportSweptAngle = swept,
      reportDeflection = courseDeflection course,
      reportClosestApproach = courseClosestApproach course,
      reportCrossings = courseCrossings course,
      reportSteps = length points,
      reportAngularMomentumDrift = driftOf (XYZ.norm . angularMomentum) photons,
      reportEnergyDrift = driftOf pseudoEnergy photons,
      reportPath = [PathPoint angle (photonPosition p) | CoursePoint angle p <- points]
    }
  where
    points = coursePoints drawn 0.02 course
    photons = map pointPhoton points
    (fate, swept) = case courseFate course of
      Escapes angle -> ("escaped", Just angle)
      Captured angle -> ("captured", Just angle)
      Circles -> ("circles", Nothing)

driftOf :: (Photon -> Double) -> [Photon] -> Maybe Double
driftOf quantity photons = case map quantity photons of
  first : rest | first > 0 -> Just (foldl max 0 [abs (q - first) / first | q <- rest])
  _ -> Nothing

-- | Where the leapfrog takes up a path from infinity and where it leaves one
-- that escapes: the renderer's celestial sphere, unless the path itself is
-- farther out.
leapfrogStartRadius :: Course -> Double
leapfrogStartRadius course =
  max (leapfrogSkyRadius defaultLeapfrog) (2 * courseImpactParameter course)

-- | What the loop carries along.
data Walk = Walk
  { walkSteps :: !Int,
    walkPhoton :: !Photon,
    walkSwept :: !Double,
    walkMomentumDrift :: !Double,
    walkEnergyDrift :: !Double,
    walkClosest :: !(Maybe Double),
    -- | Latest first, as the path.
    walkCrossings :: ![Crossing],
    walkPath :: ![PathPoint]
  }

-- | The same path followed with the leapfrog, @leapfrogReport rule drawn
-- course@. The path from infinity is taken up on the exact orbit at
-- 'leapfrogStartRadius', and what is left of an escaping path beyond that
-- radius is again added in closed form: the difference to 'exactReport' is the
-- integrator's error alone.
--
-- Crossings, the closest point and the horizon are found within a step on the
-- cubic through its ends, which is more accurate than the steps are.
--
-- With 'ReportSteps' the error stops to fall at about 1e-5 radians, whatever
-- the base length: beyond @r = 40@ that rule's steps are always 10. At most
-- twenty million steps, about 0.2 µs each.
leapfrogReport :: StepRule -> Double -> Course -> PathReport
leapfrogReport rule farthest course = case courseEntry radius course of
  Nothing -> ended "step limit" Nothing (Walk 0 (Photon XYZ.zero XYZ.zero) 0 0 0 Nothing [] [])
  Just (CoursePoint swept photon) -> follow swept photon
  where
    radius = leapfrogStartRadius course
    stepLimit = 20000000
    drawnRadius = maybe farthest (max farthest) (courseStartRadius course)
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
          | walkSteps walk >= stepLimit = ended "step limit" Nothing walk
          | XYZ.normSquared x' <= 1 && XYZ.dot x' v' < 0 =
            let atHorizon = hermite (bisectStep (\p -> XYZ.norm (photonPosition p) > 1))
                swept = walkSwept walk + turned (photonPosition atHorizon)
             in ended "captured" (Just swept) $
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
                  walkMomentumDrift = max (walkMomentumDrift walk) (abs (XYZ.norm (angularMomentum photon') - h0)),
                  walkEnergyDrift = max (walkEnergyDrift walk) (abs (pseudoEnergy photon' - energy0)),
                  walkClosest =
                    if XYZ.dot x v < 0 && XYZ.dot x' v' >= 0
                      then Just (XYZ.norm (photonPosition (hermite (bisectStep movesInward))))
                      else walkClosest walk,
                  walkCrossings = maybe id (:) crossing (walkCrossings walk),
                  walkPath = drawn (walkPath walk)
                }
            crossing
              | courseMeetsPlane course,
                height x * height x' < 0 || (height x /= 0 && height x' == 0) =
                crossingAt (hermite (bisectStep (\p -> height (photonPosition p) * height x > 0)))
              | otherwise = Nothing
            drawn path = case path of
              PathPoint _ p : _ | XYZ.distance p x' < 0.02 * XYZ.norm x' -> path
              _ -> PathPoint swept' x' : path
        escaped walk =
          let rest = courseFromPhoton (courseObserved course) (walkPhoton walk)
              final = walk {walkCrossings = reverse (courseCrossings rest) ++ walkCrossings walk}
           in case courseFate rest of
                Escapes angle -> ended "escaped" (Just (walkSwept walk + angle)) final
                _ -> ended "step limit" Nothing final
    height (XYZ _ y _) = y
    crossingAt (Photon p v) = do
      RedshiftParts gravity doppler <- gasRedshift (courseObserved course) p (XYZ.negated v)
      pure (Crossing (XYZ.norm p) (planeAzimuth p) (gravity * doppler))
    ended fate swept walk =
      PathReport
        { reportFate = fate,
          reportImpactParameter = impactParameter (walkPhoton walk),
          reportSweptAngle = swept,
          reportDeflection = (-) <$> escapedSweep <*> straightSweep,
          reportClosestApproach = walkClosest walk,
          reportCrossings = reverse (walkCrossings walk),
          reportSteps = walkSteps walk,
          reportAngularMomentumDrift =
            if courseImpactParameter course > 0
              then Just (walkMomentumDrift walk / courseImpactParameter course)
              else Nothing,
          -- Paths have unit energy, and so E is one half.
          reportEnergyDrift = Just (2 * walkEnergyDrift walk),
          reportPath = reverse (filter (\(PathPoint _ p) -> XYZ.norm p <= drawnRadius) (walkPath walk))
        }
      where
        escapedSweep = if fate == "escaped" then swept else Nothing
    -- What a straight line sweeps, which the exact path knows.
    straightSweep = case courseFate course of
      Escapes angle -> (angle -) <$> courseDeflection course
      _ -> Nothing

-- | The cubic through the ends of a step, at a fraction of it.
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

-- | Where in an interval a condition stops to hold.
halve :: (Double -> Bool) -> Int -> Double -> Double -> Double
halve holds = go
  where
    go n low high
      | n <= 0 = middle
      | holds middle = go (n - 1) middle high
      | otherwise = go (n - 1) low middle
      where
        middle = 0.5 * (low + high)

-- | One report's values less another's. A value that one of them lacks has no
-- difference, and crossings are compared in their order.
data PathDifference = PathDifference
  { differenceImpactParameter :: !(Maybe Double),
    differenceSweptAngle :: !(Maybe Double),
    differenceDeflection :: !(Maybe Double),
    differenceClosestApproach :: !(Maybe Double),
    differenceCrossings :: ![Crossing],
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
      differenceCrossings = zipWith crossing (reportCrossings a) (reportCrossings b),
      differenceAngularMomentumDrift = by reportAngularMomentumDrift,
      differenceEnergyDrift = by reportEnergyDrift
    }
  where
    by field = (-) <$> field a <*> field b
    -- The way to infinity and the way to the horizon don't compare.
    sameEnd value = if reportFate a == reportFate b then value else Nothing
    crossing (Crossing r azimuth g) (Crossing r' azimuth' g') =
      Crossing (r - r') (wrapped (azimuth - azimuth')) (g - g')
    wrapped angle
      | angle > pi = angle - 2 * pi
      | angle <= -pi = angle + 2 * pi
      | otherwise = angle
