-- | Complete light paths in space around a hole without spin, in closed form or from the
-- table of paths. Paths start at infinity or at a camera, and run from the observer
-- outwards, against the light.
--
-- After the swept angle φ a path is at @r(φ) (cos φ e₁ + sin φ e₂)@ in its plane
-- ("BlackHole.Spacetime.PathPlane"), with @r(φ)@ from
-- "BlackHole.Spacetime.Schwarzschild.Orbit" or
-- "BlackHole.Spacetime.Schwarzschild.OrbitSeries".
module BlackHole.Spacetime.Schwarzschild.Trajectory
  ( Trajectory (..),
    trajectoryEndAngle,
    trajectoryFromInfinity,
    trajectoryFromCamera,
    trajectoryFromTable,
    trajectoryFromPhoton,
    trajectoryOnTable,
    trajectoryOnLine,
    Sight (..),
  )
where

import BlackHole.Numeric.Angle
import BlackHole.Numeric.Bisection (bisect)
import BlackHole.Spacetime.Fate
import BlackHole.Spacetime.Momentum (staticFrequency)
import BlackHole.Spacetime.PathPlane
import BlackHole.Spacetime.Photon
import BlackHole.Spacetime.Schwarzschild.Deflection
import BlackHole.Spacetime.Schwarzschild.LensTable
  ( LensTable,
    lensSeries,
    lensTable,
    lensTableRadius,
  )
import BlackHole.Spacetime.Schwarzschild.Orbit
import BlackHole.Spacetime.Schwarzschild.OrbitSeries
import BlackHole.Spacetime.Types (Spacetime (Flat, Schwarzschild), pullOfGravity)
import BlackHole.Vector.XY (XY (..))
import BlackHole.Vector.XYZ (XYZ (..), (*^), (^+^))
import qualified BlackHole.Vector.XYZ as XYZ

-- | A light path from its start to its end.
data Trajectory = Trajectory
  { trajectoryPlane :: !PathPlane,
    trajectoryFate :: !(Fate XY),
    -- | The angle in radians swept from the start to infinity or to the horizon; infinite
    -- for a path without end.
    trajectorySweep :: !Double,
    -- | In Schwarzschild radii; 0 for a radial path, which sweeps no angle.
    trajectoryImpactParameter :: !Double,
    -- | Radius at which the path turns from inward to outward; 'Nothing' if it never
    -- does.
    trajectoryClosestApproach :: Maybe Double,
    -- | Radians swept beyond the angle of a straight line in the same direction, which
    -- is π from infinity and π − ψ from a camera; 'Nothing' for a path that ends in the
    -- hole. For light from infinity this is the deflection.
    trajectoryDeflection :: !(Maybe Double),
    -- | Radius of the start; 'Nothing' for infinity.
    trajectoryStartRadius :: !(Maybe Double),
    -- | Swept angle of the turning point after the start, if there is one.
    trajectoryTurn :: Maybe Double,
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

-- | The plane of a line of sight. Rounding errors of right angles are removed, so that
-- an observer in the disk's plane is exactly in it.
sightPlane :: Sight -> PathPlane
sightPlane (Sight (Radians i) (Radians eta)) =
  PathPlane (XYZ 0 (cosine i) (sine i)) (cosine eta *^ right ^+^ sine eta *^ up)
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
        swept = pi + deflection
        inverse angle =
          let past = angle - 0.5 * swept
              (u, slope) = orbitInverseRadiusAndSlope half (abs past)
           in (u, signum past * slope)
     in laidOut
          { trajectoryFate = escapesAfter swept,
            trajectorySweep = swept,
            trajectoryClosestApproach = Just nearest,
            trajectoryDeflection = Just deflection,
            trajectoryTurn = Just (0.5 * swept),
            trajectoryInverse = inverse
          }
  _ ->
    -- Run backwards from the horizon, where the slope is exactly 1/b.
    let outgoing = orbit 1 1 (min b 2.598076211353314)
        swept = orbitSweep outgoing
        inverse angle =
          let (u, slope) = orbitInverseRadiusAndSlope outgoing (max 0 (swept - angle))
           in (u, negate slope)
     in laidOut {trajectoryFate = Captured, trajectorySweep = swept, trajectoryInverse = inverse}
  where
    laidOut =
      Trajectory
        { trajectoryPlane = sightPlane sight,
          trajectoryFate = Circles,
          trajectorySweep = 1 / 0,
          trajectoryImpactParameter = if b < 1e-150 then 0 else b,
          trajectoryClosestApproach = Nothing,
          trajectoryDeflection = Nothing,
          trajectoryStartRadius = Nothing,
          trajectoryTurn = Nothing,
          trajectoryObserved = 1,
          trajectoryInverse = const (0, 0)
        }

-- | The fate of a path that escapes after this swept angle.
escapesAfter :: Double -> Fate XY
escapesAfter angle = Escaped (XY (cos angle) (sin angle))

-- | @trajectoryFromCamera sight r ψ@ is the line of sight of an observer at rest at radius
-- @r@, at the angle ψ in [0, π] from the direction of the hole's centre. 'Nothing' at
-- and inside the horizon.
trajectoryFromCamera :: Sight -> Double -> Radians -> Maybe Trajectory
trajectoryFromCamera sight r (Radians psi) = do
  observed <- staticFrequency r
  let path =
        orbit r (negate (withoutRounding (cos psi)) * sqrt ((r - 1) / r)) (sin (min psi (pi - psi)))
  pure (alongOrbit observed (sightPlane sight) r (pi - psi) path)

-- | The line of sight of 'trajectoryFromCamera' as the renderer follows it by default:
-- along the table of paths for the camera's distance
-- ("BlackHole.Spacetime.Schwarzschild.LensTable"). Takes some ten milliseconds for the table.
trajectoryFromTable :: Sight -> Double -> Radians -> Maybe Trajectory
trajectoryFromTable sight r (Radians psi) = do
  closed <- trajectoryFromCamera sight r (Radians psi)
  let start =
        Launch (sightPlane sight) (negate (cos psi)) (sin (min psi (pi - psi)) / sqrt ((r - 1) / r))
      tabulated =
        alongSeries
          (trajectoryObserved closed)
          r
          Schwarzschild
          start
          (lensSeries (lensTable r) (launchRadial start) (launchTangential start))
      -- The renderer takes the direction from its sine and cosine.
      turnedTo (XY c s) =
        let off =
              atan2 s c - trajectorySweep tabulated
         in trajectorySweep tabulated + off - 2 * pi * fromIntegral (round (off / (2 * pi)) :: Int)
  pure $ case trajectoryFate tabulated of
    _ | trajectoryImpactParameter closed == 0 -> closed
    Escaped direction ->
      tabulated
        { trajectorySweep = turnedTo direction,
          trajectoryImpactParameter = trajectoryImpactParameter closed,
          trajectoryDeflection = Just (turnedTo direction - (pi - psi))
        }
    _ -> tabulated {trajectoryImpactParameter = trajectoryImpactParameter closed}

-- | 'trajectoryFromPhoton' from the table's radius along the table of paths.
trajectoryOnTable :: LensTable -> Double -> Photon -> Trajectory
trajectoryOnTable table observed photon =
  alongSeries
    observed
    r
    Schwarzschild
    start
    (lensSeries table (launchRadial start) (launchTangential start))
  where
    r = lensTableRadius table
    start = launch r photon

-- | 'trajectoryFromPhoton' without gravity.
trajectoryOnLine :: Double -> Photon -> Trajectory
trajectoryOnLine observed photon =
  (alongSeries observed r Flat start (lineSeries u slope)) {trajectoryInverse = along}
  where
    u = 1 / r
    slope = negate radial / (r * tangential)
    -- Exact, where the series is good to 1e-11.
    along angle = let (c, s) = (cos angle, sin angle) in (u * c + slope * s, slope * c - u * s)
    r = XYZ.norm (photonPosition photon)
    start@(Launch _ radial tangential) = launch r photon

-- | The rest of a photon's path from its present position. The first argument is the
-- observed frequency over the frequency at infinity. The deflection counts from the
-- present pseudo-velocity.
trajectoryFromPhoton :: Double -> Photon -> Trajectory
trajectoryFromPhoton observed photon =
  alongOrbit observed plane r (atan2 tangential radial) (orbit r radial tangential)
  where
    r = XYZ.norm (photonPosition photon)
    Launch plane radial tangential = launch r photon

-- | A path from its starting radius. The fourth argument is the angle that a straight
-- line would sweep.
alongOrbit :: Double -> PathPlane -> Double -> Double -> Orbit -> Trajectory
alongOrbit observed plane r straight path =
  Trajectory
    { trajectoryPlane = plane,
      trajectoryFate = orbitFate path,
      trajectorySweep = orbitSweep path,
      trajectoryImpactParameter = orbitImpactParameter path,
      trajectoryClosestApproach = orbitClosestApproach path,
      trajectoryDeflection = case orbitFate path of
        Escaped _ -> Just (orbitSweep path - straight)
        _ -> Nothing,
      trajectoryStartRadius = Just r,
      trajectoryTurn = turningAngle <$> orbitTurningPoint path,
      trajectoryObserved = observed,
      trajectoryInverse = orbitInverseRadiusAndSlope path
    }

-- | A path from its start along a series of cells.
alongSeries :: Double -> Double -> Spacetime -> Launch -> OrbitSeries -> Trajectory
alongSeries
  observed
  r
  space
  (Launch plane radial tangential)
  (OrbitSeries fate angle cells waypoints) =
    Trajectory
      { trajectoryPlane = plane,
        trajectoryFate = fate,
        trajectorySweep = if fate == Circles then 1 / 0 else angle,
        trajectoryImpactParameter = r * tangential,
        trajectoryClosestApproach = (1 /) . fst . inverse <$> turn,
        trajectoryDeflection = case fate of
          Escaped _ -> Just (angle - atan2 tangential radial)
          _ -> Nothing,
        trajectoryStartRadius = Just r,
        trajectoryTurn = turn,
        trajectoryObserved = observed,
        trajectoryInverse = inverse
      }
    where
      spacing = angle / fromIntegral cells
      inverse at =
        let cell = max 0 (min (cells - 1) (truncate (at / spacing)))
            (u, slope) = waypoint waypoints spacing cell
            path = expand (pullOfGravity space) u slope
            offset = at - (fromIntegral cell + 0.5) * spacing
         in (expansionValue path offset, expansionSlope path offset)
      -- The closest point lies where the path turns from inward to outward.
      turn
        | snd (inverse 0) > 0 && snd (inverse angle) < 0 =
          Just (bisect ((> 0) . snd . inverse) 0 angle)
        | otherwise = Nothing

-- | The swept angle of the end; for a path without end, that of four turns.
trajectoryEndAngle :: Trajectory -> Double
trajectoryEndAngle trajectory
  | isInfinite (trajectorySweep trajectory) = 8 * pi
  | otherwise = trajectorySweep trajectory
