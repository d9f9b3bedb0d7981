-- | The light path through a point of the picture, for drawing.
module BlackHole.Explore.SightPath
  ( sightPath,
  )
where

import BlackHole.Matter.KerrReport
import BlackHole.Scene.Scene
import BlackHole.Spacetime.Follow (Method (InClosedForm))
import BlackHole.Spacetime.Observer
import BlackHole.Spacetime.Photon
import BlackHole.Spacetime.Schwarzschild.Trajectory
import BlackHole.Spacetime.Schwarzschild.TrajectoryPoints
import BlackHole.Spacetime.Types (Spacetime (Flat))
import BlackHole.Trace.Tracer
import BlackHole.Vector.XY (XY)
import BlackHole.Vector.XYZ (XYZ (..), (*^), (^+^))
import qualified BlackHole.Vector.XYZ as XYZ

-- | @sightPath traced drawn point@: points of the light path that arrives at a point of
-- the picture, from the camera backwards, out to the radius @drawn@ or the camera's if
-- that is greater; at most 1000 of them. Empty if no light arrives. Gas does not end it.
sightPath :: Tracer -> Double -> XY -> [XYZ]
sightPath traced drawn point = thinned $ case tracedSight traced point of
  Nothing -> []
  Just (RotatingSight hole azimuth ray) ->
    [ place
      | KerrPathPoint _ place <- kerrReportPath (kerrReport InClosedForm hole drawn azimuth ray)
    ]
  Just (SightLine photon observed)
    | sceneSpacetime (tracerScene traced) == Flat -> straight photon
    | otherwise ->
      [ photonPosition (pointPhoton p)
        | p <- trajectoryPoints drawn 0.02 (trajectoryFromPhoton observed photon)
      ]
  where
    straight (Photon place velocity) =
      let reach = 2 * max drawn (XYZ.norm place)
       in [ place ^+^ (reach * fromIntegral k / 200 / XYZ.norm velocity) *^ velocity
            | k <- [0 .. 200 :: Int]
          ]
    thinned points = case length points of
      n | n > 1000 -> [p | (k, p) <- zip [0 ..] points, k `rem` (1 + n `quot` 1000) == (0 :: Int)]
      _ -> points
