-- | Parallel light rays that pass the hole, for a figure.
module BlackHole.Figure.RayFan
  ( RayFan (..),
    defaultRayFan,
    fanImpactParameters,
    fanCriticalParameters,
    RayClass (..),
    rayClass,
    equatorialClass,
    fanSight,
    aspect,
  )
where

import BlackHole.Numeric.Angle (Radians (..))
import BlackHole.Spacetime.Fate
import BlackHole.Spacetime.Kerr.EquatorialRay
import BlackHole.Spacetime.Kerr.Landmarks hiding (horizonRadius)
import qualified BlackHole.Spacetime.Kerr.Landmarks as Kerr
import BlackHole.Spacetime.Schwarzschild.Radii
import BlackHole.Spacetime.Schwarzschild.Trajectory

-- | The parameters of the figure.
data RayFan = RayFan
  { -- | Number of rays.
    fanRays :: !Int,
    -- | Half the figure's width in Schwarzschild radii, at least 4: the critical impact
    -- parameter must fit into three quarters of it.
    fanExtent :: !Double,
    -- | Width of the whole figure in pixels.
    fanWidth :: !Int,
    -- | The hole's spin. With spin the rays lie in the equatorial plane, seen from the
    -- side of the spin vector: a positive spin turns anticlockwise.
    fanSpin :: !Spin
  }
  deriving (Eq, Show)

-- | 31 rays, eight Schwarzschild radii to either side, 1200 pixels, and no spin.
defaultRayFan :: RayFan
defaultRayFan = RayFan 31 8 1200 noSpin

-- | The ratio of height to width of the plotted rectangle.
aspect :: Double
aspect = 0.75

-- | The impact parameters, signed as the height at which the light comes in, that lead
-- to the photon orbits: below the hole and above it. Light that passes below turns
-- anticlockwise.
fanCriticalParameters :: Spin -> (Double, Double)
fanCriticalParameters hole
  | hole == noSpin = (negate criticalImpactParameter, criticalImpactParameter)
  | otherwise =
    ( negate (criticalAngularMomentum RightHanded hole),
      negate (criticalAngularMomentum LeftHanded hole)
    )

-- | The signed impact parameters of the rays in ascending order. From eight rays on,
-- four of them lie within a thousandth of the critical impact parameters, on both sides
-- of them and of the hole. The others are evenly spaced over the figure's height.
fanImpactParameters :: RayFan -> [Double]
fanImpactParameters (RayFan count extent _ hole)
  | count < 8 = spread count
  | otherwise = merge (spread (count - 4)) critical
  where
    top = 0.96 * aspect * extent
    spread n
      | n <= 1 = [0 | n == 1]
      | otherwise = [top * (2 * fromIntegral k / fromIntegral (n - 1) - 1) | k <- [0 .. n - 1]]
    critical =
      [b * f | (b, f) <- [(below, 1.001), (below, 0.999), (above, 0.999), (above, 1.001)]]
    (below, above) = fanCriticalParameters hole
    merge (a : as) (b : bs)
      | a <= b = a : merge as (b : bs)
      | otherwise = b : merge (a : as) bs
    merge as bs = as ++ bs

-- | The classes of rays, which determine their colours.
data RayClass
  = -- | The ray leaves again.
    Escaping
  | -- | The ray falls in.
    Falling
  | -- | The ray goes around the hole at least once, whatever its end.
    Winding
  deriving (Eq, Show, Enum, Bounded)

-- | The class of a ray.
rayClass :: Trajectory -> RayClass
rayClass trajectory
  | trajectorySweep trajectory >= 2 * pi = Winding
  | otherwise = case trajectoryFate trajectory of
    Escaped _ -> Escaping
    _ -> Falling

-- | The class of a ray around a rotating hole, with its turns counted down to midway
-- between the horizon and the innermost photon orbit: farther in all light turns with
-- the hole.
equatorialClass :: Spin -> EquatorialRay -> RayClass
equatorialClass hole ray
  | abs (sum (zipWith turned azimuths (drop 1 azimuths))) >= 2 * pi = Winding
  | equatorialEscapes ray = Escaping
  | otherwise = Falling
  where
    azimuths = [phi | (r, phi) <- equatorialPoints ray, r > innermost]
    innermost =
      0.5
        * ( Kerr.horizonRadius hole
              + min (photonOrbitRadius RightHanded hole) (photonOrbitRadius LeftHanded hole)
          )
    turned from to = let d = to - from in d - 2 * pi * fromIntegral (round (d / (2 * pi)) :: Int)

-- | The line of sight whose plane contains the rays. It comes from +y, which the figure
-- turns to its left edge.
fanSight :: Sight
fanSight = Sight (Radians 0) (Radians 0)
