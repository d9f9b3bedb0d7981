-- | Points along the trajectories of light, and their crossings of the disk's plane.
module BlackHole.Spacetime.Schwarzschild.TrajectoryPoints
  ( TrajectoryPoint (..),
    trajectoryPoints,
    trajectoryEntry,
    trajectoryCrossings,
  )
where

import BlackHole.Numeric.Bisection (bisect)
import BlackHole.Spacetime.Fate
import BlackHole.Spacetime.Momentum
import BlackHole.Spacetime.PathPlane
import BlackHole.Spacetime.Photon
import BlackHole.Spacetime.PlaneCrossing
import BlackHole.Spacetime.Schwarzschild.Trajectory
import BlackHole.Vector.XY (XY (..))
import BlackHole.Vector.XYZ ((*^), (^+^))
import Data.Maybe (fromMaybe)

-- | A point on a path.
data TrajectoryPoint = TrajectoryPoint
  { -- | Angle in radians swept from the start of the path.
    pointSweptAngle :: !Double,
    -- | Position, and pseudo-velocity for unit energy at infinity.
    pointPhoton :: !Photon
  }
  deriving (Eq, Show)

pointAt :: Trajectory -> Double -> TrajectoryPoint
pointAt trajectory angle =
  TrajectoryPoint angle $
    Photon ((1 / u) *^ outward) (negate (b * slope) *^ outward ^+^ (b * u) *^ onward)
  where
    (u, slope) = trajectoryInverse trajectory angle
    b = trajectoryImpactParameter trajectory
    outward = inSpace (trajectoryPlane trajectory) (XY (cos angle) (sin angle))
    onward = onwardAt (trajectoryPlane trajectory) (cos angle) (sin angle)

-- | @trajectoryPoints farthest step trajectory@ returns points along the part of the path
-- within the radius @farthest@ (or within the start's radius, if that is greater), from
-- one end to the other. Neighbouring points are at most @step@ times their radius
-- apart. The list is empty if the path stays outside. A path that never ends is
-- followed for four turns. The number of points is about @ln (farthest) \/ step@ plus
-- @2π \/ step@ per turn, and at most 100 000; the cost is linear in it.
trajectoryPoints :: Double -> Double -> Trajectory -> [TrajectoryPoint]
trajectoryPoints farthest step trajectory
  | trajectoryImpactParameter trajectory == 0 = radialPoints
  | otherwise = case range of
    Just (from, to) | to > from -> take 100000 (go from to)
    _ -> []
  where
    limit = maybe farthest (max farthest) (trajectoryStartRadius trajectory)
    radius angle = 1 / fst (trajectoryInverse trajectory angle)
    go angle to
      | angle >= to = [pointAt trajectory to]
      | otherwise =
        let (u, slope) = trajectoryInverse trajectory angle
         in pointAt trajectory angle : go (angle + step * u / sqrt (u * u + slope * slope)) to
    range = (,) <$> rangeStart <*> rangeEnd
    rangeStart = case trajectoryStartRadius trajectory of
      Just _ -> Just 0
      Nothing -> entryAngle limit trajectory
    rangeEnd = case trajectoryFate trajectory of
      Escaped _ ->
        let outward = fromMaybe 0 (trajectoryTurn trajectory)
         in if radius outward > limit
              then Nothing
              else
                Just
                  ( bisect
                      (\a -> radius a < limit && fst (trajectoryInverse trajectory a) > 0)
                      outward
                      (trajectorySweep trajectory)
                  )
      _ -> Just (trajectoryEndAngle trajectory)
    radialPoints = case trajectoryFate trajectory of
      Escaped _ -> [radialPoint r 1 | r <- ladder start limit]
      _ -> [radialPoint r (-1) | r <- reverse (ladder 1 start)]
    start = fromMaybe limit (trajectoryStartRadius trajectory)
    radialPoint r v = TrajectoryPoint 0 (Photon (r *^ outset) (v *^ outset))
    PathPlane outset _ = trajectoryPlane trajectory
    ladder low high =
      let n = max 1 (ceiling (log (high / low) / step)) :: Int
       in [low * (high / low) ** (fromIntegral k / fromIntegral n) | k <- [0 .. n]]

-- | The start of a path or, if that is at infinity, the point where the path first
-- comes within the given radius. 'Nothing' for a path from infinity that never does.
trajectoryEntry :: Double -> Trajectory -> Maybe TrajectoryPoint
trajectoryEntry limit trajectory =
  case (trajectoryStartRadius trajectory, trajectoryImpactParameter trajectory == 0) of
    (Just r, True) -> Just (radial r)
    (Nothing, True) -> Just (radial limit)
    (Just _, False) -> Just (pointAt trajectory 0)
    (Nothing, False) -> pointAt trajectory <$> entryAngle limit trajectory
  where
    radial r =
      TrajectoryPoint 0 (Photon (r *^ outset) (direction *^ outset))
    PathPlane outset _ = trajectoryPlane trajectory
    direction = case trajectoryFate trajectory of
      Escaped _ -> 1
      _ -> -1

-- | The swept angle at which a path from infinity first comes within a radius.
entryAngle :: Double -> Trajectory -> Maybe Double
entryAngle limit trajectory
  | within inmost = Just (bisect (not . within) 0 inmost)
  | otherwise = Nothing
  where
    within angle = fst (trajectoryInverse trajectory angle) * limit >= 1
    inmost = fromMaybe (trajectoryEndAngle trajectory) (trajectoryTurn trajectory)

-- | The crossings of the disk's plane, in order from the observer, not counting the
-- start. Empty for a path that lies in the plane; limited to four turns for a path that
-- never ends.
trajectoryCrossings :: Trajectory -> [PlaneCrossing (Maybe Momentum)]
trajectoryCrossings trajectory
  | not (meetsDiskPlane plane) || trajectoryImpactParameter trajectory == 0 = []
  | otherwise = map (crossingOf . pointPhoton . pointAt trajectory) angles
  where
    plane = trajectoryPlane trajectory
    angles =
      takeWhile (< trajectoryEndAngle trajectory) (take 1000 (iterate (+ pi) (firstCrossing plane)))
