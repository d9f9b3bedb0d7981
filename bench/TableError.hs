-- | The deviation of the tabulated light paths from the closed form.
module TableError
  ( TableError (..),
    tableError,
  )
where

import BlackHole.Spacetime.Fate
import BlackHole.Spacetime.Schwarzschild.LensTable
import BlackHole.Spacetime.Schwarzschild.Orbit
import BlackHole.Spacetime.Schwarzschild.OrbitSeries
import BlackHole.Spacetime.Schwarzschild.Radii (criticalImpactParameter)
import qualified BlackHole.Vector.XY as XY

-- | The greatest errors found.
data TableError = TableError
  { -- | Error of the direction to the sky, in radians.
    skyError :: !Double,
    -- | Error of the radius at a given angle, and thus of crossings of the disk's
    -- plane, in Schwarzschild radii, for radii up to 30.
    crossingError :: !Double,
    -- | Number of paths with a different fate.
    wrongFates :: !Int
  }

instance Semigroup TableError where
  TableError a b c <> TableError a' b' c' = TableError (max a a') (max b b') (c + c')

instance Monoid TableError where
  mempty = TableError 0 0 0

-- | The errors of the paths from a radius in this many evenly spread directions. Leaves
-- out @|b − b_c| < 1e-4@ and, for the crossings, b < 1e-3, where light moves along the
-- radius.
tableError :: Int -> Double -> TableError
tableError count r = foldMap (errorOf . part) [0 .. count - 1]
  where
    table = lensTable r
    part i = (fromIntegral i + 0.5) / fromIntegral count
    errorOf along
      | abs (b - criticalImpactParameter) < 1e-4 = mempty
      | otherwise = case (seriesFate series, orbitFate path) of
        (Escaped found, Escaped known) -> TableError (XY.norm (found XY.^-^ known)) crossings 0
        (Captured, Captured) -> TableError 0 crossings 0
        (Circles, Circles) -> mempty
        _ -> TableError 0 0 1
      where
        path = orbit r radial tangential
        series = lensSeries table radial tangential
        spacing = seriesSpacing series
        b = r * tangential
        (radial, tangential)
          | r > 1 = (cos (pi * along), sin (pi * along) / sqrt (1 - 1 / r))
          | otherwise = let t = tan (0.5 * pi * along) / r in (sqrt (1 + (1 / r - 1) * t * t), t)
        crossings =
          maximum $
            0 :
              [ abs (1 / exactly - 1 / expansionValue (expand 1.5 u slope) (phi - middle))
                | b > 1e-3,
                  k <- [0 .. 10 :: Int],
                  let phi = seriesAngle series * (fromIntegral k + along) / 11
                      exactly = orbitInverseRadius path phi
                      cell = max 0 (min (seriesCells series - 1) (truncate (phi / spacing)))
                      middle = (fromIntegral cell + 0.5) * spacing
                      (u, slope) = waypoint (seriesWaypoints series) spacing cell,
                  exactly > 1 / 30
              ]
