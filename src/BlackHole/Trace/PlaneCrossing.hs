-- | The crossings of a line of sight with the disk's plane @y = 0@, and the shift of
-- light from gas there.
module BlackHole.Trace.PlaneCrossing
  ( PlaneCrossing (..),
    planeCrossings,
  )
where

import BlackHole.Matter.Redshift (RedshiftParts (..), gasRedshift)
import BlackHole.Scene.Scene
import BlackHole.Spacetime.Kerr.GasFlow
import BlackHole.Spacetime.Kerr.Landmarks (Spin)
import BlackHole.Spacetime.Kerr.Path
import BlackHole.Spacetime.Kerr.Sight (LightRay (..))
import BlackHole.Spacetime.LightPath
import BlackHole.Spacetime.Observer (SightLine (..))
import BlackHole.Spacetime.Photon
import BlackHole.Spacetime.Schwarzschild.ExactPath (straightImpact)
import BlackHole.Spacetime.Schwarzschild.Leapfrog (followLeapfrog)
import BlackHole.Spacetime.Schwarzschild.Trajectory (TrajectoryPoint (..), trajectoryFromPhoton, trajectoryPlanePoints)
import BlackHole.Spacetime.Types (Spacetime (..))
import BlackHole.Vector.XYZ (XYZ (..), (*^), (^+^))
import qualified BlackHole.Vector.XYZ as XYZ
import Data.Maybe (maybeToList)

-- | One crossing.
data PlaneCrossing = PlaneCrossing
  { -- | In Schwarzschild radii.
    crossingRadius :: !Double,
    -- | @atan2 z x@ in radians.
    crossingAzimuth :: !Double,
    -- | The shift of light from gas there on its way to the observer, as the renderer
    -- computes it; 'Nothing' at and inside the horizon.
    crossingShift :: !(Maybe RedshiftParts)
  }
  deriving (Eq, Show)

-- | All crossings along the whole path, in order from the camera, whether or not gas
-- hides them. The camera's own position does not count. Empty for a path that lies in
-- the plane.
--
-- For exact orbits the crossings follow in closed form. For the leapfrog they are
-- interpolated between its steps, with an error of the order of the leapfrog's own.
planeCrossings :: Scene -> SightLine -> [PlaneCrossing]
planeCrossings scene sight = case sight of
  RotatingSight hole azimuth ray -> map (rotatingCrossing hole ray) (kerrPlanePoints (kerrPath hole azimuth ray))
  SightLine photon observed ->
    map (crossingAt observed) $ case (sceneIntegrator scene, sceneSpacetime scene) of
      (Leapfrogging, _) -> leapfrogCrossings scene photon
      (_, Flat) -> maybeToList (straightCrossing photon)
      _ -> map pointPhoton (trajectoryPlanePoints (trajectoryFromPhoton observed photon))

-- | A crossing around a rotating hole. Gravity's part of the shift is that of gas without
-- angular momentum, which turns with space.
rotatingCrossing :: Spin -> LightRay -> KerrPoint -> PlaneCrossing
rotatingCrossing hole ray point =
  PlaneCrossing
    { crossingRadius = r,
      crossingAzimuth = atan2 (cos (pointAzimuth point)) (sin (pointAzimuth point)),
      crossingShift = shift <$> planeFrequency flow ray r (pointGrows point)
    }
  where
    r = pointRadius point
    flow = gasFlow hole
    beside = frequencyBeside (gasFrequencies flow ray r 0 (pointGrows point))
    shift emitted = RedshiftParts (rayObserved ray / beside) (beside / emitted)

crossingAt :: Double -> Photon -> PlaneCrossing
crossingAt observed (Photon place@(XYZ x _ z) velocity) =
  PlaneCrossing
    { crossingRadius = XYZ.norm place,
      crossingAzimuth = atan2 z x,
      -- The light travels the other way.
      crossingShift = gasRedshift observed place (XYZ.negated velocity)
    }

-- | The crossing of a straight ray, which crosses at most once and not behind the black
-- ball.
straightCrossing :: Photon -> Maybe Photon
straightCrossing photon@(Photon place@(XYZ _ y _) velocity@(XYZ _ climb _))
  | y * climb < 0 && t < straightImpact photon = Just (Photon (place ^+^ t *^ velocity) velocity)
  | otherwise = Nothing
  where
    t = negate y / climb

-- | Crossings interpolated between the middles of steps on either side of the plane.
leapfrogCrossings :: Scene -> Photon -> [Photon]
leapfrogCrossings scene start =
  reverse (snd (followedState (followLeapfrog (sceneLeapfrog scene) (sceneSpacetime scene) everywhere start gather (start, []))))
  where
    everywhere = Region (1 / 0) 0 (1 / 0) 0 1 1 1
    gather (before, found) segment =
      Continue (here, [between y0 y1 before here | y0 * y1 < 0 || (y1 == 0 && y0 /= 0)] ++ found)
      where
        here = Photon (segmentMiddle segment) (segmentVelocity segment)
        XYZ _ y0 _ = photonPosition before
        XYZ _ y1 _ = photonPosition here
    between y0 y1 (Photon x0 v0) (Photon x1 v1) =
      let t = y0 / (y0 - y1) in Photon (XYZ.lerp t x0 x1) (XYZ.lerp t v0 v1)
