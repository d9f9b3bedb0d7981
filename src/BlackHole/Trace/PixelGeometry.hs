{-# LANGUAGE BangPatterns #-}

-- | The geometry of the light path through the middle of a pixel: its deflection, and
-- where it meets the disk's plane.
module BlackHole.Trace.PixelGeometry
  ( PixelGeometry (..),
    pixelGeometry,
  )
where

import BlackHole.Matter.GasFlow
import BlackHole.Matter.Redshift
import BlackHole.Scene.Camera
import BlackHole.Scene.Disk
import BlackHole.Scene.Scene
import BlackHole.Spacetime.Follow
import BlackHole.Spacetime.Observer
import BlackHole.Spacetime.PlaneCrossing
import Data.Maybe (listToMaybe)

-- | The geometry of one line of sight.
data PixelGeometry = PixelGeometry
  { -- | The deflection in radians of the path from the sky ('pathDeflection'). 'Nothing'
    -- for a path that does not come from the sky. Gas that hides the sky makes no
    -- difference.
    geometryDeflection :: !(Maybe Double),
    -- | The first crossing of the disk's plane between the disk's inner and outer radius,
    -- with ν_obs\/ν_em of light from gas there, due to gravity and motion, whether or not
    -- the scene shows these shifts.
    geometryDiskHit :: !(Maybe (PlaneCrossing Double))
  }
  deriving (Eq, Show)

-- | The geometry of a scene's pixels, by column and row. Uses the tabulated paths whatever
-- the scene's integrator. 'Nothing' if the camera has no direction of view
-- ('cameraFrame').
pixelGeometry :: Scene -> Maybe (Int -> Int -> PixelGeometry)
pixelGeometry scene = at <$> cameraFrame (sceneCamera scene)
  where
    !place = posePosition (cameraPose (sceneCamera scene))
    !seer = eye (sceneSpacetime scene) (sceneObserver scene) place
    !flow = gasFlow (sceneSpacetime scene)
    !traced = tracing (sceneSpacetime scene) ByTable place
    at frame = look
      where
        !plane =
          picturePlane (sceneProjection scene) (sceneCamera scene) (scenePicture scene) frame
        look column row =
          case sightDirection plane (pixelMiddle column row) >>= sightFrom seer of
            Nothing -> PixelGeometry Nothing Nothing
            Just sight ->
              PixelGeometry (pathDeflection traced sight) (sceneDisk scene >>= hit sight)
    hit sight disk =
      listToMaybe
        [ redshiftFactor shift <$ crossing
          | crossing <- planeCrossings traced sight,
            let r = crossingRadius crossing,
            r >= diskInnerRadius disk && r <= diskOuterRadius disk,
            Just shift <- [crossingRedshift flow sight crossing]
        ]
