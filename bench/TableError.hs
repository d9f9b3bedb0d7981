-- | The deviation of the tabulated light paths from the closed form.
module TableError
  ( TableError (..),
    tableError,
    kerrTableError,
  )
where

import BlackHole.Spacetime.Fate
import BlackHole.Spacetime.Kerr.Landmarks
import BlackHole.Spacetime.Kerr.Path
import BlackHole.Spacetime.Kerr.Sight
import BlackHole.Spacetime.Kerr.SkyTable
import BlackHole.Spacetime.Schwarzschild.LensTable
import BlackHole.Spacetime.Schwarzschild.Orbit
import BlackHole.Spacetime.Schwarzschild.OrbitSeries
import BlackHole.Spacetime.Schwarzschild.Radii (criticalImpactParameter)
import qualified BlackHole.Vector.XY as XY
import BlackHole.Vector.XYZ (XYZ (..))
import qualified BlackHole.Vector.XYZ as XYZ
import Data.Maybe (isNothing, mapMaybe)

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

-- | The errors of rays around a rotating hole, and the part of the rays for which the
-- table leaves the direction to the closed form. The rays are spread evenly, one half over
-- the whole sky and one over its part near the hole. Leaves out those within 1e-4 radians
-- of the edge of the shadow at 1 r_s, and in proportion farther away. Crossings are those
-- of the picture's precision at radii up to 30.
kerrTableError :: Int -> Spin -> Place -> (TableError, Double)
kerrTableError count hole place@(Place r _) =
  (foldMap errorOf rays, fromIntegral (length untabulated) / fromIntegral (length rays))
  where
    untabulated = filter (isNothing . tabulatedFate table azimuth) rays
    table = skyTable hole place
    azimuth = BoyerLindquist 0
    rays = mapMaybe (lightRay hole place ZeroAngularMomentum . direction) [0 .. count - 1]
    direction i = Direction (negate (cos psi)) (sin psi * sin around) (sin psi * cos around)
      where
        part = (fromIntegral (i `quot` 2) + 0.5) / fromIntegral (count `quot` 2)
        widest = if even i then pi else min pi (8 / r)
        psi = acos (1 - (1 - cos widest) * part)
        -- The golden angle.
        around = 2.399963229728653 * fromIntegral i :: Double
    errorOf ray
      | maybe True ((< 2.5e-5 / r) . abs) (tabulatedOffset table ray) = mempty
      | otherwise = case (tabulatedFate table azimuth ray, kerrFate path) of
        (Just (Escaped found), Escaped known) -> TableError (XYZ.distance found known) crossings 0
        (Just Captured, Captured) -> TableError 0 crossings 0
        (Nothing, _) -> TableError 0 crossings 0
        _ -> TableError 0 0 1
      where
        path = kerrPath hole azimuth ray
        quick = kerrPathWith PicturePrecision hole azimuth ray
        crossings =
          maximum
            ( 0 :
                [ XYZ.distance (placed known) (placed found)
                  | (known, found) <- zip (kerrPlanePoints path) (kerrPlanePoints quick),
                    pointRadius known < 30
                ]
            )
    placed (KerrPoint r' _ phi _ _) = XYZ (r' * sin phi) 0 (r' * cos phi)
