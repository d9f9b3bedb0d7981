{-# LANGUAGE BangPatterns #-}

-- | Point stars seen through a beam, with their flux conserved.
--
-- A point star of flux F at pixel offset p from a sample adds F K(p) / A to the
-- sample's radiance. A is the solid angle of sky behind one pixel, and K, the
-- point-spread function, is a bell a few pixels wide whose values over the pixel grid
-- sum to 1 wherever the grid lies. The light of the star's image, summed over the
-- pixels and multiplied by the solid angle that a pixel covers as seen by the camera,
-- is thus F times the magnification, wherever the star lies between the pixels.
--
-- The stars are held in three tiers of decreasing brightness. As long as a beam is
-- narrow enough to contain only a few stars of a tier, they are added one by one. For
-- wider beams, as close to the photon ring, the tier's light comes from a blurred image
-- of it, and in between from both.
module BlackHole.Trace.StarField
  ( StarField,
    starField,
    starFieldRadiance,
    starlessBetween,
    shiftedMixture,
    pixelKernel,
  )
where

import BlackHole.Light.BlackBodyTable (tabulatedColour)
import BlackHole.Light.Radiance
import BlackHole.Trace.EnvironmentMap
import BlackHole.Trace.RayDifferential
import BlackHole.Trace.StarCatalogue
import BlackHole.Trace.StarWindow
import BlackHole.Trace.Tabulated
import BlackHole.Vector.XYZ (XYZ (..))
import qualified BlackHole.Vector.XYZ as XYZ
import Control.Monad (forM_)
import Data.Int (Int32)
import qualified Data.Vector.Unboxed as U
import qualified Data.Vector.Unboxed.Mutable as M
import GHC.Float (double2Float, float2Double)

-- | Stars in order of brightness, with an index of their directions. About 40 bytes a
-- star.
newtype StarField = StarField [Tier]

-- | Stars of similar brightness in the cells of a cube around the sphere.
data Tier = Tier
  { -- | Cells along an edge of the cube.
    tierSide :: !Int,
    -- | Extent of a beam, in radians, from which on only the blurred image counts.
    tierLimit :: !Double,
    -- | Number of each cell's first star, and one more entry at the end. Cells
    -- are in rows, rows in faces.
    tierCells :: !(U.Vector Int32),
    -- | Direction, flux and temperature of each star.
    tierStars :: !(U.Vector Float),
    -- | The same light, blurred.
    tierBlurred :: EnvironmentMap
  }

-- | Index a catalogue, given the flux (radiance times steradians) of a star of
-- magnitude 0. Takes 0.3 µs a star; the blurred images are made at their first use.
starField :: Double -> StarCatalogue -> StarField
starField unitFlux stars = foldr seq (StarField tiers) tiers
  where
    tiers =
      [ tier unitFlux stars side limit rings from (min to (starCount stars))
        | (from, to, side, limit, rings) <-
            [ (0, 400, 16, 0.6, 16),
              (400, 6000, 64, 0.23, 32),
              (6000, starCount stars, 160, 0.083, 64)
            ],
          from < min to (starCount stars)
      ]

-- | The stars with numbers from one to below another.
tier :: Double -> StarCatalogue -> Int -> Double -> Int -> Int -> Int -> Tier
tier unitFlux stars side limit rings from to =
  Tier
    { tierSide = side,
      tierLimit = limit,
      tierCells = U.map fromIntegral starts,
      tierStars = sorted,
      tierBlurred =
        environmentMapFromSources rings count (starDirection stars . (from +)) (light . (from +))
    }
  where
    count = to - from
    cells = U.generate count (cellOf side . starDirection stars . (from +))
    starts =
      U.scanl'
        (+)
        0
        (U.accumulate_ (+) (U.replicate (6 * side * side) 0) cells (U.replicate count 1))
    flux i = unitFlux * starFlux stars i
    light i = scaleRadiance (flux i) (tabulatedColour (starTemperature stars i))
    sorted = U.create $ do
      next <- U.thaw starts
      numbers <- M.new (starNumbers * count)
      forM_ [0 .. count - 1] $ \i -> do
        let cell = U.unsafeIndex cells i
            XYZ x y z = starDirection stars (from + i)
        at <- M.unsafeRead next cell
        M.unsafeWrite next cell (at + 1)
        let put k = M.unsafeWrite numbers (starNumbers * at + k) . double2Float
        put 0 x
        put 1 y
        put 2 z
        put 3 (flux (from + i))
        put 4 (starTemperature stars (from + i))
      pure numbers

-- | Numbers kept of a star in a tier.
starNumbers :: Int
starNumbers = 5

-- | The cell in which a direction lies, of a cube with this many cells along an edge.
cellOf :: Int -> XYZ -> Int
cellOf side (XYZ x y z)
  | ax >= ay && ax >= az = inFace (if x >= 0 then 0 else 1) (y / ax) (z / ax)
  | ay >= az = inFace (if y >= 0 then 2 else 3) (z / ay) (x / ay)
  | otherwise = inFace (if z >= 0 then 4 else 5) (x / az) (y / az)
  where
    ax = abs x
    ay = abs y
    az = abs z
    inFace face u v = (face * side + index side v) * side + index side u

-- | The row or column of a coordinate on a face, −1 … 1; those beyond count as
-- on the edge.
index :: Int -> Double -> Int
index side u = max 0 (min (side - 1) (truncate (0.5 * (u + 1) * fromIntegral side)))
{-# INLINE index #-}

-- | Weight of a star in one direction of the picture by its offset in pixels: the
-- B-spline of fourth degree, a bell of standard deviation 0.65 that is close to
-- Gauss's, so that the product of two is close to round, and sums to 1 over any grid
-- of unit spacing.
pixelKernel :: Double -> Double
pixelKernel p
  | a <= 0.5 = let s = a * a in 115 / 192 + s * (0.25 * s - 0.625)
  | a <= 1.5 = (55 + a * (20 + a * (a * (80 - 16 * a) - 120))) / 96
  | a < kernelRadius = let s = (kernelRadius - a) * (kernelRadius - a) in s * s / 24
  | otherwise = 0
  where
    a = abs p
{-# INLINE pixelKernel #-}

-- | The stars' light through a beam, for an observer who sees it at g times its
-- frequency: that of black bodies of g times their temperature, g⁴ times as bright.
--
-- A beam as wide as a pixel takes 80 ns without a star in it and 0.1 µs more for each
-- star.
starFieldRadiance :: StarField -> Double -> RayDifferential -> Radiance
starFieldRadiance (StarField tiers) g differential@(RayDifferential (XYZ dx dy dz) a b)
  | isNaN (extent + dx + dy + dz) || isInfinite extent =
    scaleRadiance g4 (foldMap (environmentMapMean . tierBlurred) tiers)
  | otherwise = scaleRadiance g4 (go black tiers)
  where
    !g4 = g * g * (g * g)
    !extent = kernelRadius * differentialExtent differential
    !area = abs (differentialSolidAngle differential)
    !breadth = XYZ.dot a a + XYZ.dot b b
    -- On a critical curve of the lens the beam is squeezed into a line, and the
    -- first-order magnification of a star is unbounded. The true value needs more than
    -- the Jacobian, and a wrong one would sparkle. So within about two pixels of the
    -- curve, a star is as bright as it is two pixels away.
    !weight = 1 / max area (breadth * min squeezed (4 * sqrt breadth))
    look = lookThrough g extent differential
    go !light [] = light
    go !light (t : rest)
      | share >= 1 = go (light <+> points t) rest
      | share <= 0 = go (light <+> blurred t) rest
      | otherwise =
        go (light <+> scaleRadiance share (points t) <+> scaleRadiance (1 - share) (blurred t)) rest
      where
        share = max 0 (min 1 (2 - 2 * extent / tierLimit t))
    points t
      | area > 1e-9 * breadth = scaleRadiance weight (tierPoints look t)
      | otherwise = black
    blurred t = shiftedStars g (environmentMapRadiance (tierBlurred t) differential)

-- | Whether no star shines through any of the beams along a line in the picture, from the
-- first and the last, whose directions must differ little. 'False' where beams are too wide
-- to tell.
starlessBetween :: StarField -> RayDifferential -> RayDifferential -> Bool
starlessBetween (StarField tiers) first final
  | wide first || wide final = False
  | otherwise = case (window first, window final) of
    (Just (Window face u0 u1 v0 v1), Just (Window face' u0' u1' v0' v1'))
      | face == face',
        let around = Window face (min u0 u0') (max u1 u1') (min v0 v0') (max v1 v1') ->
        all (noStar around) tiers
    _ -> False
  where
    extent differential = kernelRadius * differentialExtent differential
    wide differential = not (all (\t -> 2 * extent differential < tierLimit t) tiers)
    window differential = case lookThrough 1 (extent differential) differential of
      Look _ _ _ _ found [] -> Just found
      _ -> Nothing

-- | Whether no star of a tier stands in a window.
noStar :: Window -> Tier -> Bool
noStar (Window face u0 u1 v0 v1) (Tier side _ cells stars _) = rows (face * side + index side v0)
  where
    final = face * side + index side v1
    left = index side u0
    right = index side u1
    rows row
      | row > final = True
      | otherwise =
        none (start (row * side + left)) (start (row * side + right + 1)) && rows (row + 1)
    start i = fromIntegral (U.unsafeIndex cells i) :: Int
    none i end
      | i >= end = True
      | inside = False
      | otherwise = none (i + 1) end
      where
        at k = float2Double (U.unsafeIndex stars (starNumbers * i + k))
        (u, v) = case face `quot` 2 of
          0 -> (at 1 / abs (at 0), at 2 / abs (at 0))
          1 -> (at 2 / abs (at 1), at 0 / abs (at 1))
          _ -> (at 0 / abs (at 2), at 1 / abs (at 2))
        inside = u >= u0 && u <= u1 && v >= v0 && v <= v1

-- | The ratio of the beam ellipse's axes, shorter to longer, below which its area is no
-- longer trusted. For fine pixels the limit is lower: at δ pixels from an Einstein ring
-- with a radius of ρ pixels, the ratio is δ\/ρ.
squeezed :: Double
squeezed = 1 / 60

-- | The mixture of all stars, about 7000 K.
shiftedStars :: Double -> Radiance -> Radiance
shiftedStars = shiftedMixture 7000
{-# NOINLINE shiftedStars #-}

-- | @shiftedMixture temperature g light@: a mixture of stars of about this colour
-- temperature, in kelvin, in the colour in which it is seen at g times its frequency:
-- that of a black body of g times the temperature, relative to the one that it has.
-- The luminance stays. Bind the result of the first argument to prepare it once.
shiftedMixture :: Double -> Double -> Radiance -> Radiance
shiftedMixture temperature = \g light@(Radiance r0 g0 b0) ->
  if g == 1
    then light
    else
      let place = rowAt tints (g / (1 + g))
          tinted =
            Radiance
              (r0 * valueAt tints place 0)
              (g0 * valueAt tints place 1)
              (b0 * valueAt tints place 2)
       in if luminance tinted > 0
            then scaleRadiance (luminance light / luminance tinted) tinted
            else light
  where
    -- By g/(1 + g), which takes all shifts from 0 to ∞ into an interval.
    tints = tabulate 3 256 0 1 tint
    tint x =
      let Radiance r g b = tabulatedColour temperature
          Radiance r' g' b' = tabulatedColour (temperature * x / max 1e-9 (1 - x))
       in [r' / r, g' / g, b' / b]

-- | The stars of a tier in a beam: the sum of flux times kernel.
--
-- The beam is matched in the argument: a strict pattern of @where@ costs a picture with
-- one ray per pixel 5 % of its time.
tierPoints :: Look -> Tier -> Radiance
tierPoints
  (Look !g (XYZ dx dy dz) (XYZ px py pz) (XYZ qx qy qz) window others)
  (Tier side _ cells stars _) =
    case others of
      [] -> scanWindow window black
      _ -> foldr scanWindow (scanWindow window black) others
    where
      scanWindow (Window face u0 u1 v0 v1) = rows (face * side + index side v0)
        where
          !final = face * side + index side v1
          !left = index side u0
          !right = index side u1
          rows !row !light
            | row > final = light
            | otherwise =
              rows
                (row + 1)
                (scan (start (row * side + left)) (start (row * side + right + 1)) light)
      start i = fromIntegral (U.unsafeIndex cells i) :: Int
      scan :: Int -> Int -> Radiance -> Radiance
      scan !i !end !light
        | i >= end = light
        | abs p >= kernelRadius || abs q >= kernelRadius || dx * x + dy * y + dz * z <= 0 =
          scan (i + 1) end light
        | otherwise =
          let Radiance r' g' b' = tabulatedColour (g * at 4)
              k = at 3 * pixelKernel p * pixelKernel q
              Radiance r0 g0 b0 = light
           in scan (i + 1) end (Radiance (r0 + k * r') (g0 + k * g') (b0 + k * b'))
        where
          at k = float2Double (U.unsafeIndex stars (starNumbers * i + k))
          x = at 0
          y = at 1
          z = at 2
          p = px * x + py * y + pz * z
          q = qx * x + qy * y + qz * z
