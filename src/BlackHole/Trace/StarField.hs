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
    starFieldBetween,
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
            [ (0, 400, 16, 0.43, 32),
              (400, 6000, 64, 0.166, 64),
              (6000, starCount stars, 160, 0.06, 128)
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
starFieldRadiance (StarField tiers) g differential@(RayDifferential (XYZ dx dy dz) _ _)
  | isNaN (extent + dx + dy + dz) || isInfinite extent =
    scaleRadiance (fourth g) (foldMap (environmentMapMean . tierBlurred) tiers)
  | otherwise = scaleRadiance (fourth g) (go black tiers)
  where
    !extent = kernelRadius * differentialExtent differential
    !weight = starWeight differential
    !windows = windowsThrough kernelRadius differential
    look = lookThrough g differential
    go !light [] = light
    go !light (t : rest)
      | share >= 1 = go (light <+> points t) rest
      | share <= 0 = go (light <+> blurred t) rest
      | otherwise =
        go (light <+> scaleRadiance share (points t) <+> scaleRadiance (1 - share) (blurred t)) rest
      where
        share = pointShare extent t
    points t
      | weight > 0 = scaleRadiance weight (tierPoints look windows t)
      | otherwise = black
    blurred t = shiftedStars g (environmentMapRadiance (tierBlurred t) differential)

-- | The share of a tier's stars that are seen as points in a beam of this extent; the others
-- come from the blurred image.
pointShare :: Double -> Tier -> Double
pointShare extent t = max 0 (min 1 (4 - 4 * extent / tierLimit t))
{-# INLINE pointShare #-}

-- | The light of the stars through all beams along a line in the picture, from the first
-- and the last, whose directions must differ little: 'Nothing' if no star stands there, and
-- else a shader that does not have to search for them.
starFieldBetween ::
  StarField ->
  RayDifferential ->
  RayDifferential ->
  Maybe (Double -> RayDifferential -> Radiance)
starFieldBetween field@(StarField tiers) first final
  | wide first || wide final = Just (starFieldRadiance field)
  | otherwise = case (windows first, windows final) of
    (Windows (Window face u0 u1 v0 v1) [], Windows (Window face' u0' u1' v0' v1') [])
      | face == face' ->
        let around = Window face (min u0 u0') (max u1 u1') (min v0 v0') (max v1 v1')
         in case foldr (starsWithin around) [] tiers of
              [] -> Nothing
              stars -> Just (fewStars stars)
    _ -> Just (starFieldRadiance field)
  where
    wide differential =
      any ((< 1) . pointShare (kernelRadius * differentialExtent differential)) tiers
    -- Between the two, beams may be wider or farther to the side.
    windows = windowsThrough (1.25 * kernelRadius)

-- | Adds the stars of a tier in a window to others.
starsWithin :: Window -> Tier -> [FieldStar] -> [FieldStar]
starsWithin window@(Window face u0 u1 v0 v1) t = overWindow t window add
  where
    add star@(FieldStar (XYZ x y z) _ _) stars
      | inside = star : stars
      | otherwise = stars
      where
        (u, v) = case face `quot` 2 of
          0 -> (y / abs x, z / abs x)
          1 -> (z / abs y, x / abs y)
          _ -> (x / abs z, y / abs z)
        inside = u >= u0 && u <= u1 && v >= v0 && v <= v1

-- | The light of these stars alone through a beam, as 'starFieldRadiance' has it.
fewStars :: [FieldStar] -> Double -> RayDifferential -> Radiance
fewStars stars g differential = scaleRadiance (fourth g * weight) (go black stars)
  where
    !weight = starWeight differential
    !look = lookThrough g differential
    go !light [] = light
    go !light (star : rest) = go (starThrough look star light) rest

-- | The radiance of a star of flux 1 where its point-spread function is 1; 0 in a
-- degenerate beam.
--
-- On a critical curve of the lens the beam is squeezed into a line, and the first-order
-- magnification of a star is unbounded. The true value needs more than the Jacobian, and a
-- wrong one would sparkle. So within about two pixels of the curve, a star is as bright as
-- it is two pixels away.
starWeight :: RayDifferential -> Double
starWeight differential@(RayDifferential _ a b)
  | area > 1e-9 * breadth = 1 / max area (breadth * min squeezed (4 * sqrt breadth))
  | otherwise = 0
  where
    area = abs (differentialSolidAngle differential)
    breadth = XYZ.dot a a + XYZ.dot b b

fourth :: Double -> Double
fourth g = g * g * (g * g)

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

-- | A beam prepared for all stars: the observed frequency over the star's, the direction,
-- and the two vectors of 'differentialAxes'.
data Look = Look !Double {-# UNPACK #-} !XYZ {-# UNPACK #-} !XYZ {-# UNPACK #-} !XYZ

lookThrough :: Double -> RayDifferential -> Look
lookThrough g differential = Look g (differentialDirection differential) p q
  where
    (p, q) = differentialAxes differential
{-# INLINE lookThrough #-}

-- | The stars of a tier in a beam: the sum of flux times kernel.
tierPoints :: Look -> Windows -> Tier -> Radiance
tierPoints !look (Windows window others) t = case others of
  [] -> inWindow window black
  _ -> foldr inWindow (inWindow window black) others
  where
    inWindow w = overWindow t w (starThrough look)

-- | A star's direction, flux and temperature.
data FieldStar = FieldStar {-# UNPACK #-} !XYZ !Double !Double

-- | Adds a star's flux times kernel to others in a beam.
starThrough :: Look -> FieldStar -> Radiance -> Radiance
starThrough (Look g d p q) (FieldStar place flux temperature) light
  | abs x >= kernelRadius || abs y >= kernelRadius || XYZ.dot d place <= 0 = light
  | otherwise =
    light <+> scaleRadiance share (tabulatedColour (g * temperature))
  where
    x = XYZ.dot p place
    y = XYZ.dot q place
    share = flux * pixelKernel x * pixelKernel y
{-# INLINE starThrough #-}

-- | Applies a function to all stars of a tier in the cells that a window touches, one after
-- the other.
overWindow :: Tier -> Window -> (FieldStar -> a -> a) -> a -> a
overWindow (Tier side _ cells stars _) (Window face u0 u1 v0 v1) add =
  rows (face * side + index side v0)
  where
    !final = face * side + index side v1
    !left = index side u0
    !right = index side u1
    rows !row !found
      | row > final = found
      | otherwise =
        rows (row + 1) (scan (start (row * side + left)) (start (row * side + right + 1)) found)
    start i = fromIntegral (U.unsafeIndex cells i) :: Int
    scan !i !end !found
      | i >= end = found
      | otherwise = scan (i + 1) end (add star found)
      where
        star = FieldStar (XYZ (at 0) (at 1) (at 2)) (at 3) (at 4)
        at k = float2Double (U.unsafeIndex stars (starNumbers * i + k))
{-# INLINE overWindow #-}
