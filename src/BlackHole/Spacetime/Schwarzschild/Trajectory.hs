-- | Complete light paths in space, in closed form: their points, and their crossings of
-- the disk's plane with the redshift of gas there. Paths start at infinity or at a
-- camera at rest.
--
-- A path lies in the plane of two orthogonal unit vectors, the direction e₁ of its
-- start and the direction e₂ towards which it moves from there. After the swept angle φ
-- it is at @r(φ) (cos φ e₁ + sin φ e₂)@, with @r(φ)@ from "BlackHole.Spacetime.Schwarzschild.Orbit".
-- Paths run from the observer outwards, against the light.
module BlackHole.Spacetime.Schwarzschild.Trajectory
  ( -- * Paths
    Trajectory,
    trajectoryFromInfinity,
    trajectoryFromCamera,
    trajectoryFromTable,
    trajectoryFromPhoton,
    Sight (..),
    trajectoryFate,
    trajectoryImpactParameter,
    trajectoryClosestApproach,
    trajectoryDeflection,
    trajectoryStartRadius,
    trajectoryObserved,

    -- * Points along them
    TrajectoryPoint (..),
    trajectoryPoints,
    trajectoryEntry,

    -- * The disk's plane
    Crossing (..),
    trajectoryPlanePoints,
    trajectoryCrossings,
    trajectoryMeetsPlane,
    planeAzimuth,
  )
where

import BlackHole.Matter.Redshift
import BlackHole.Numeric.Angle
import BlackHole.Numeric.Bisection (bisect)
import BlackHole.Spacetime.Photon
import BlackHole.Spacetime.Schwarzschild.LensTable (lensSeries, lensTable)
import BlackHole.Spacetime.Schwarzschild.Orbit
import BlackHole.Spacetime.Schwarzschild.OrbitSeries
import BlackHole.Spacetime.Types (Spacetime (Schwarzschild), pullOfGravity)
import BlackHole.Vector.XYZ (XYZ (..), (*^), (^+^), (^-^))
import qualified BlackHole.Vector.XYZ as XYZ
import Data.Maybe (fromMaybe, mapMaybe)

-- | A light path from its start to its end.
data Trajectory = Trajectory
  { -- | e₁, of unit length.
    trajectoryOutset :: !XYZ,
    -- | e₂, of unit length and perpendicular to e₁.
    trajectoryOnward :: !XYZ,
    -- | Where the path ends, and the angle in radians swept from the start to infinity
    -- or to the horizon.
    trajectoryFate :: !OrbitFate,
    -- | In Schwarzschild radii; 0 for a radial path, which sweeps no angle.
    trajectoryImpactParameter :: !Double,
    -- | Radius at which the path turns from inward to outward; 'Nothing' if it never
    -- does.
    trajectoryClosestApproach :: !(Maybe Double),
    -- | Radians swept beyond the angle of a straight line in the same direction, which
    -- is π from infinity and π − ψ from a camera; 'Nothing' for a path that ends in the
    -- hole. For light from infinity this is the deflection.
    trajectoryDeflection :: !(Maybe Double),
    -- | Radius of the start; 'Nothing' for infinity.
    trajectoryStartRadius :: !(Maybe Double),
    -- | Swept angle of the turning point after the start, if there is one.
    trajectoryTurn :: !(Maybe Double),
    -- | Frequency at the observer over the frequency at infinity.
    trajectoryObserved :: !Double,
    -- | @1\/r@ and its derivative as functions of the swept angle.
    trajectoryInverse :: Double -> (Double, Double)
  }

-- | The observer's position relative to the disk, and the direction of the line of
-- sight around the hole's centre.
data Sight = Sight
  { -- | Angle i between the disk's axis @+y@ and the observer, who stands at @r (0, cos
    -- i, sin i)@ with @+x@ to the right.
    sightInclination :: !Radians,
    -- | Position angle of the line of sight about the hole's centre, from screen-right
    -- towards screen-up.
    sightPositionAngle :: !Radians
  }
  deriving (Eq, Show)

-- | e₁ and e₂ of a line of sight. Rounding errors of right angles are removed, so that
-- an observer in the disk's plane is exactly in it.
sightPlane :: Sight -> (XYZ, XYZ)
sightPlane (Sight (Radians i) (Radians eta)) =
  (XYZ 0 (cosine i) (sine i), cosine eta *^ right ^+^ sine eta *^ up)
  where
    right = XYZ 1 0 0
    up = XYZ 0 (sine i) (negate (cosine i))
    cosine = withoutRounding . cos
    sine = withoutRounding . sin

-- | Replaces a sine or cosine that is zero up to rounding by 0.
withoutRounding :: Double -> Double
withoutRounding v = if abs v < 4e-16 then 0 else v

-- | The line of sight of a distant observer at rest that passes the hole at an impact
-- parameter of at least 0, in Schwarzschild radii. This is also the path of light from
-- infinity.
--
-- Two or three 'Double's next to @3√3\/2@ cannot be told from it by any formula. They
-- get the shape of the captured path of the next smaller number.
trajectoryFromInfinity :: Sight -> Double -> Trajectory
trajectoryFromInfinity sight b = case (closestApproach b, deflectionAngle b) of
  (Just nearest, Just deflection) ->
    -- The path is symmetric about its closest point.
    let half = orbit nearest 0 1
        series = pi + deflection
        inverse angle =
          let past = angle - 0.5 * series
              (u, slope) = orbitInverseRadiusAndSlope half (abs past)
           in (u, signum past * slope)
     in laidOut
          { trajectoryFate = Escapes series,
            trajectoryClosestApproach = Just nearest,
            trajectoryDeflection = Just deflection,
            trajectoryTurn = Just (0.5 * series),
            trajectoryInverse = inverse
          }
  _ ->
    -- Run backwards from the horizon, where the slope is exactly 1/b.
    let outgoing = orbit 1 1 (min b 2.598076211353314)
        series = case orbitFate outgoing of
          Escapes angle -> angle
          _ -> 0
        inverse angle =
          let (u, slope) = orbitInverseRadiusAndSlope outgoing (max 0 (series - angle))
           in (u, negate slope)
     in laidOut {trajectoryFate = Captured series, trajectoryInverse = inverse}
  where
    (e1, e2) = sightPlane sight
    laidOut =
      Trajectory
        { trajectoryOutset = e1,
          trajectoryOnward = e2,
          trajectoryFate = Circles,
          trajectoryImpactParameter = if b < 1e-150 then 0 else b,
          trajectoryClosestApproach = Nothing,
          trajectoryDeflection = Nothing,
          trajectoryStartRadius = Nothing,
          trajectoryTurn = Nothing,
          trajectoryObserved = distantObserver,
          trajectoryInverse = const (0, 0)
        }

-- | @courseFromCamera sight r ψ@ is the line of sight of an observer at rest at radius
-- @r@, at the angle ψ in [0, π] from the direction of the hole's centre. 'Nothing' at
-- and inside the horizon.
trajectoryFromCamera :: Sight -> Double -> Radians -> Maybe Trajectory
trajectoryFromCamera sight r (Radians psi) = do
  observed <- staticObserver r
  let path = orbit r (negate (withoutRounding (cos psi)) * sqrt ((r - 1) / r)) (sin (min psi (pi - psi)))
  pure (alongOrbit observed (sightPlane sight) r (pi - psi) path)

-- | The line of sight of 'trajectoryFromCamera' as the renderer follows it by default:
-- along the table of paths for the camera's distance ("BlackHole.Spacetime.Schwarzschild.LensTable").
-- Takes some ten milliseconds for the table.
trajectoryFromTable :: Sight -> Double -> Radians -> Maybe Trajectory
trajectoryFromTable sight r (Radians psi) = do
  closed <- trajectoryFromCamera sight r (Radians psi)
  let lapse = sqrt ((r - 1) / r)
      OrbitSeries ending angle cells waypoints = lensSeries (lensTable r) (negate (cos psi)) (sin (min psi (pi - psi)) / lapse)
      spacing = angle / fromIntegral cells
      inverse at =
        let cell = max 0 (min (cells - 1) (floor (at / spacing)))
            (u, slope) = waypoint waypoints spacing cell
            path = expand (pullOfGravity Schwarzschild) u slope
            offset = at - (fromIntegral cell + 0.5) * spacing
         in (expansionValue path offset, expansionSlope path offset)
      -- The renderer takes the direction from its sine and cosine.
      swept = case ending of
        Leaves c s -> let off = atan2 s c - angle in angle + off - 2 * pi * fromIntegral (round (off / (2 * pi)) :: Int)
        _ -> angle
      -- The closest point lies where the path turns from inward to outward.
      turn
        | snd (inverse 0) > 0 && snd (inverse angle) < 0 = Just (bisect ((> 0) . snd . inverse) 0 angle)
        | otherwise = Nothing
  pure $
    if trajectoryImpactParameter closed == 0
      then closed
      else
        closed
          { trajectoryFate = case ending of
              Leaves _ _ -> Escapes swept
              FallsIn -> Captured angle
              CirclesOn -> Circles,
            trajectoryClosestApproach = (1 /) . fst . inverse <$> turn,
            trajectoryDeflection = case ending of
              Leaves _ _ -> Just (swept - (pi - psi))
              _ -> Nothing,
            trajectoryInverse = inverse
          }

-- | The rest of a photon's path from its present position. The first argument is the
-- observed frequency over the frequency at infinity. The deflection counts from the
-- present pseudo-velocity.
trajectoryFromPhoton :: Double -> Photon -> Trajectory
trajectoryFromPhoton observed (Photon place velocity) =
  alongOrbit observed (e1, e2) r (atan2 tangential radial) (orbit r radial tangential)
  where
    r = XYZ.norm place
    e1 = (1 / r) *^ place
    radial = XYZ.dot velocity e1
    across = velocity ^-^ radial *^ e1
    tangential = XYZ.norm across
    -- A radial path sweeps no angle, so any direction serves.
    e2 = fromMaybe (XYZ 1 0 0) (XYZ.normalize across)

-- | A path from its starting radius. The fourth argument is the angle that a straight
-- line would sweep.
alongOrbit :: Double -> (XYZ, XYZ) -> Double -> Double -> Orbit -> Trajectory
alongOrbit observed (e1, e2) r straight path =
  Trajectory
    { trajectoryOutset = e1,
      trajectoryOnward = e2,
      trajectoryFate = orbitFate path,
      trajectoryImpactParameter = orbitImpactParameter path,
      trajectoryClosestApproach = orbitClosestApproach path,
      trajectoryDeflection = case orbitFate path of
        Escapes angle -> Just (angle - straight)
        _ -> Nothing,
      trajectoryStartRadius = Just r,
      trajectoryTurn = turningAngle <$> orbitTurningPoint path,
      trajectoryObserved = observed,
      trajectoryInverse = orbitInverseRadiusAndSlope path
    }

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
    c = cos angle
    s = sin angle
    outward = c *^ trajectoryOutset trajectory ^+^ s *^ trajectoryOnward trajectory
    onward = c *^ trajectoryOnward trajectory ^-^ s *^ trajectoryOutset trajectory

-- | @coursePoints farthest step trajectory@ returns points along the part of the path
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
      Captured angle -> Just angle
      Circles -> Just (endAngle trajectory)
      Escapes angle ->
        let outward = fromMaybe 0 (trajectoryTurn trajectory)
         in if radius outward > limit
              then Nothing
              else Just (bisect (\a -> radius a < limit && fst (trajectoryInverse trajectory a) > 0) outward angle)
    radialPoints = case trajectoryFate trajectory of
      Escapes _ -> [radialPoint r 1 | r <- ladder start limit]
      _ -> [radialPoint r (-1) | r <- reverse (ladder 1 start)]
    start = fromMaybe limit (trajectoryStartRadius trajectory)
    radialPoint r v = TrajectoryPoint 0 (Photon (r *^ trajectoryOutset trajectory) (v *^ trajectoryOutset trajectory))
    ladder low high =
      let n = max 1 (ceiling (log (high / low) / step)) :: Int
       in [low * (high / low) ** (fromIntegral k / fromIntegral n) | k <- [0 .. n]]

-- | The start of a path or, if that is at infinity, the point where the path first
-- comes within the given radius. 'Nothing' for a path from infinity that never does.
trajectoryEntry :: Double -> Trajectory -> Maybe TrajectoryPoint
trajectoryEntry limit trajectory = case (trajectoryStartRadius trajectory, trajectoryImpactParameter trajectory == 0) of
  (Just r, True) -> Just (radial r)
  (Nothing, True) -> Just (radial limit)
  (Just _, False) -> Just (pointAt trajectory 0)
  (Nothing, False) -> pointAt trajectory <$> entryAngle limit trajectory
  where
    radial r =
      TrajectoryPoint 0 (Photon (r *^ trajectoryOutset trajectory) (direction *^ trajectoryOutset trajectory))
    direction = case trajectoryFate trajectory of
      Escapes _ -> 1
      _ -> -1

-- | The swept angle at which a path from infinity first comes within a radius.
entryAngle :: Double -> Trajectory -> Maybe Double
entryAngle limit trajectory
  | within inmost = Just (bisect (not . within) 0 inmost)
  | otherwise = Nothing
  where
    within angle = fst (trajectoryInverse trajectory angle) * limit >= 1
    inmost = fromMaybe (endAngle trajectory) (trajectoryTurn trajectory)

-- | The swept angle of the end; for a path without end, that of four turns.
endAngle :: Trajectory -> Double
endAngle trajectory = case trajectoryFate trajectory of
  Escapes angle -> angle
  Captured angle -> angle
  Circles -> 8 * pi

-- | A crossing of the disk's plane @y = 0@ outside the horizon.
data Crossing = Crossing
  { -- | In Schwarzschild radii.
    crossingRadius :: !Double,
    -- | @atan2 z x@ in [−π, π), in radians.
    crossingAzimuth :: !Double,
    -- | @ν_obs\/ν_em@ of light that gas at the crossing sends to the observer.
    crossingRedshift :: !Double
  }
  deriving (Eq, Show)

-- | The azimuth of a position in the disk's plane, in [−π, π). Positions on the seam up
-- to rounding have −π.
planeAzimuth :: XYZ -> Double
planeAzimuth (XYZ x _ z)
  | angle > 3.141592653589792 = -pi
  | otherwise = angle
  where
    angle = atan2 z x

-- | Whether the path crosses the disk's plane rather than lying in it.
trajectoryMeetsPlane :: Trajectory -> Bool
trajectoryMeetsPlane trajectory = max (abs a) (abs b) > 1e-12
  where
    XYZ _ a _ = trajectoryOutset trajectory
    XYZ _ b _ = trajectoryOnward trajectory

-- | The points at which the path crosses the disk's plane, in order from the observer,
-- not counting the start. Empty for a path that lies in the plane; limited to four
-- turns for a path that never ends. The height is @r (e₁ cos φ + e₂ sin φ)·y@, so the
-- crossings are half a turn apart.
trajectoryPlanePoints :: Trajectory -> [TrajectoryPoint]
trajectoryPlanePoints trajectory
  | not (trajectoryMeetsPlane trajectory) || trajectoryImpactParameter trajectory == 0 = []
  | otherwise = map (pointAt trajectory) (takeWhile (< endAngle trajectory) (take 1000 (iterate (+ pi) firstAngle)))
  where
    XYZ _ height1 _ = trajectoryOutset trajectory
    XYZ _ height2 _ = trajectoryOnward trajectory
    firstAngle =
      let angle = atan2 (negate height1) height2
          upward = if angle < 0 then angle + pi else angle
       in if upward < 1e-12 then upward + pi else upward

-- | The crossings at those points outside the horizon, with the redshift of gas there.
trajectoryCrossings :: Trajectory -> [Crossing]
trajectoryCrossings trajectory = mapMaybe crossing (trajectoryPlanePoints trajectory)
  where
    crossing (TrajectoryPoint _ (Photon place velocity)) = do
      -- The light itself travels the other way.
      shift <- gasRedshift (trajectoryObserved trajectory) place (XYZ.negated velocity)
      pure . Crossing (XYZ.norm place) (planeAzimuth place) $
        redshiftGravitational shift * redshiftDoppler shift
