{-# LANGUAGE BangPatterns #-}

-- | The geometry of the light path through the middle of a pixel: its deflection, and
-- where it meets the disk's plane.
module BlackHole.Trace.PixelGeometry
  ( PixelGeometry (..),
    DiskHit (..),
    pixelGeometry,
  )
where

import BlackHole.Matter.Redshift
import BlackHole.Scene.Camera
import BlackHole.Scene.Disk
import BlackHole.Scene.Scene
import BlackHole.Spacetime.Kerr.GasFlow
import BlackHole.Spacetime.Kerr.Landmarks (Spin)
import BlackHole.Spacetime.Kerr.Path
import BlackHole.Spacetime.Kerr.Sight (LightRay (..))
import BlackHole.Spacetime.Observer
import BlackHole.Spacetime.Photon
import BlackHole.Spacetime.Schwarzschild.LensTable
import BlackHole.Spacetime.Schwarzschild.OrbitSeries
import BlackHole.Spacetime.Types
import BlackHole.Vector.XY (XY (..))
import BlackHole.Vector.XYZ (XYZ (..), (*^), (^+^), (^-^))
import qualified BlackHole.Vector.XYZ as XYZ
import Data.Maybe (fromMaybe, listToMaybe, mapMaybe)

-- | The geometry of one line of sight.
data PixelGeometry = PixelGeometry
  { -- | The deflection in radians of the path from the sky, as defined by
    -- 'BlackHole.Spacetime.Schwarzschild.Trajectory.courseDeflection': 0 without gravity, above 2π for
    -- light that went all around the hole. 'Nothing' for a path that does not come from
    -- the sky. Gas that hides the sky makes no difference.
    geometryDeflection :: !(Maybe Double),
    -- | The first hit from the camera.
    geometryDiskHit :: !(Maybe DiskHit)
  }
  deriving (Eq, Show)

-- | A point where a line of sight passes through the disk's plane between the disk's
-- inner and outer radius.
data DiskHit = DiskHit
  { -- | In Schwarzschild radii.
    hitRadius :: !Double,
    -- | ν_obs\/ν_em of light from gas there, due to gravity and motion, whether or not
    -- the scene shows these shifts.
    hitRedshift :: !Double
  }
  deriving (Eq, Show)

-- | The geometry of a scene's pixels, by column and row, at about 200 ns each. Uses the
-- tabulated paths whatever the scene's integrator. 'Nothing' if the camera has no
-- direction of view ('cameraFrame').
pixelGeometry :: Scene -> Maybe (Int -> Int -> PixelGeometry)
pixelGeometry scene = at <$> cameraFrame (sceneCamera scene)
  where
    !place = posePosition (cameraPose (sceneCamera scene))
    !seer = eye (sceneSpacetime scene) (sceneObserver scene) place
    !r = XYZ.norm place
    !outset = (1 / r) *^ place
    table = lensTable r
    at frame = look
      where
        !plane = picturePlane (sceneProjection scene) (sceneCamera scene) (scenePicture scene) frame
        look column row =
          case sightDirection plane (XY (fromIntegral column + 0.5) (fromIntegral row + 0.5)) >>= sightFrom seer of
            Nothing -> PixelGeometry Nothing Nothing
            Just sight -> along sight
    along (RotatingSight hole azimuth ray) = rotatingGeometry scene hole azimuth ray
    along (SightLine (Photon _ velocity) observed) =
      PixelGeometry
        { geometryDeflection = case seriesEnd series of
            Leaves _ _ -> Just (seriesAngle series - straight)
            _ -> Nothing,
          geometryDiskHit = sceneDisk scene >>= \disk -> listToMaybe (mapMaybe (hit disk) crossings)
        }
      where
        !radial = XYZ.dot velocity outset
        across = velocity ^-^ radial *^ outset
        -- A radial path sweeps no angle, so its neighbour in an arbitrary plane
        -- replaces it.
        !tangential = max (1e-9 * XYZ.norm velocity) (XYZ.norm across)
        !onward = fromMaybe (XYZ.perpendicular outset) (XYZ.normalize across)
        straight = atan2 tangential radial
        !b = r * tangential
        (!series, !pull) = case sceneSpacetime scene of
          Flat -> (lineSeries (1 / r) (negate radial / b), 0)
          _ -> (lensSeries table radial tangential, 1.5)
        !spacing = seriesSpacing series
        !(XYZ _ height1 _) = outset
        !(XYZ _ height2 _) = onward
        -- The height is r (height1 cos φ + height2 sin φ).
        crossings
          | max (abs height1) (abs height2) <= 1e-12 = []
          | otherwise = takeWhile (< seriesAngle series) (take 1000 (iterate (+ pi) firstCrossing))
        firstCrossing =
          let angle = atan2 (negate height1) height2
              upward = if angle < 0 then angle + pi else angle
           in if upward < 1e-12 then upward + pi else upward
        hit disk angle
          | radius >= diskInnerRadius disk && radius <= diskOuterRadius disk = do
            shift <- gasRedshift observed (radius *^ outward) (XYZ.negated velocity')
            pure (DiskHit radius (redshiftGravitational shift * redshiftDoppler shift))
          | otherwise = Nothing
          where
            cell = max 0 (min (seriesCells series - 1) (truncate (angle / spacing)))
            (u0, slope0) = waypoint (seriesWaypoints series) spacing cell
            path = expand pull u0 slope0
            offset = angle - (fromIntegral cell + 0.5) * spacing
            u = expansionValue path offset
            slope = expansionSlope path offset
            radius = 1 / u
            outward = cos angle *^ outset ^+^ sin angle *^ onward
            forward = cos angle *^ onward ^-^ sin angle *^ outset
            velocity' = (negate b * slope) *^ outward ^+^ (b * u) *^ forward

-- | The geometry of a ray around a rotating hole. Its deflection is the angle swept along
-- the great circle that precesses, less that of a straight line.
rotatingGeometry :: Scene -> Spin -> Azimuth -> LightRay -> PixelGeometry
rotatingGeometry scene hole azimuth ray =
  PixelGeometry
    { geometryDeflection = case kerrFate path of
        Escapes _ -> subtract (kerrStraightAngle ray) <$> kerrSweptAngle path
        _ -> Nothing,
      geometryDiskHit = sceneDisk scene >>= \disk -> listToMaybe (mapMaybe (hit disk) (kerrPlanePoints path))
    }
  where
    path = kerrPath hole azimuth ray
    hit disk point
      | r >= diskInnerRadius disk && r <= diskOuterRadius disk =
        DiskHit r . (rayObserved ray /) <$> planeFrequency (gasFlow hole) ray r (pointGrows point)
      | otherwise = Nothing
      where
        r = pointRadius point
