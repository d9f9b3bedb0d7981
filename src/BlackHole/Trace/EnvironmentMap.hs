{-# LANGUAGE BangPatterns #-}

-- | An image of the whole celestial sphere, prepared for beams of any width.
--
-- The sphere is cut into rings of equal height, and every ring into fields
-- about as wide as they are high, so that a field is nearly square everywhere
-- and the poles are no different from the equator. The finest level is followed by
-- coarser ones of half as many rings each, down to one field for the whole sky.
-- Every field is the mean, by solid angle, of what it covers, so all levels
-- send the same light.
--
-- The image's centre is the direction −z, its upper edge the pole +y, and its right
-- half lies towards +x: an observer on the +z axis who looks at the hole sees the
-- centre straight behind it, not mirrored.
module BlackHole.Trace.EnvironmentMap
  ( EnvironmentMap,
    environmentMapFromPixels,
    environmentMapFromDirections,
    environmentMapFromSources,
    environmentMapMean,
    environmentMapRadiance,
    Evenness (..),
    evennessBetween,
  )
where

import BlackHole.Light.Radiance
import BlackHole.Numeric.Angle (arcTangent2)
import BlackHole.Numeric.Parallel (inParallel)
import BlackHole.Trace.RayDifferential
import BlackHole.Vector.XYZ (XYZ (..), (*^), (^+^))
import qualified BlackHole.Vector.XYZ as XYZ
import Control.Monad (forM_)
import Control.Monad.ST (ST)
import qualified Data.Vector.Unboxed as U
import qualified Data.Vector.Unboxed.Mutable as M
import GHC.Float (double2Float, float2Double)

-- | All levels of the picture, finest first. Immutable and strict: 12 bytes a
-- field, some 1.7 fields per pixel of a picture twice as wide as high.
data EnvironmentMap = EnvironmentMap
  { -- | Rings of each level.
    imageRings :: !(U.Vector Int),
    -- | Number of each level's first ring among the rings of all levels.
    imageFirstRing :: !(U.Vector Int),
    -- | Number of each ring's first field among all fields, and one more entry
    -- at the end.
    imageRingStart :: !(U.Vector Int),
    -- | Red, green and blue of each field.
    imageFields :: !(U.Vector Float)
  }

-- | The rings of a level, as the number of fields in each, from the pole +y.
ringsOf :: Int -> U.Vector Int
ringsOf 1 = U.singleton 1
ringsOf rings = U.generate rings fieldsIn
  where
    fieldsIn i =
      max
        4
        ( ceiling
            ( 2 * fromIntegral rings * sin (pi * (fromIntegral i + 0.5) / fromIntegral rings)
                - 1e-9 ::
                Double
            )
        )

-- | Number of rings of all levels, finest first.
ladder :: Int -> [Int]
ladder rings
  | rings <= 1 = [1]
  | otherwise = rings : ladder ((rings + 1) `quot` 2)

-- | An equirectangular picture of the given width and height in pixels, by the
-- radiance of a column and a row from the top left. 'Nothing' for an empty one.
-- Each pixel is asked for about once, by all processors that are idle.
environmentMapFromPixels :: Int -> Int -> (Int -> Int -> Radiance) -> Maybe EnvironmentMap
environmentMapFromPixels width height pixel
  | width < 1 || height < 1 = Nothing
  | otherwise = Just (withCoarser height finest)
  where
    finest = U.concat (inParallel [ring i n | (i, n) <- zip [0 ..] (U.toList (ringsOf height))])
    -- A single field has to take its ring as a whole; elsewhere too a field may
    -- cover several pixels of its row.
    ring i n = U.create $ do
      fields <- M.replicate (3 * n) 0
      spread 1 width n (`pixel` i) fields 0
      pure fields

-- | A map with this many rings (at least 1), from the radiance of each direction,
-- asked for in the middle of every field, by all processors that are idle.
environmentMapFromDirections :: Int -> (XYZ -> Radiance) -> EnvironmentMap
environmentMapFromDirections wanted radiance =
  withCoarser rings (U.concat (inParallel (map band [0, ringsAtOnce .. rings - 1])))
  where
    rings = max 1 wanted
    ringsAtOnce = 8
    band first = U.create $ do
      let final = min rings (first + ringsAtOnce)
          starts = U.scanl' (+) 0 (U.slice first (final - first) counts)
      fields <- M.replicate (3 * U.last starts) 0
      forM_ [first .. final - 1] $ \i ->
        let n = U.unsafeIndex counts i
            start = U.unsafeIndex starts (i - first)
            go !j
              | j >= n = pure ()
              | otherwise = addTo fields (start + j) 1 (radiance (middle i n j)) >> go (j + 1)
         in go 0
      pure fields
    counts = ringsOf rings
    middle :: Int -> Int -> Int -> XYZ
    middle i n j =
      directionAt
        ((fromIntegral j + 0.5) / fromIntegral n)
        ((fromIntegral i + 0.5) / fromIntegral rings)

-- | A map with this many rings (at least 1) of point sources, numbered from 0:
-- each one's direction (unit length) and flux (radiance times steradians). Its
-- light fills the field in which it stands.
environmentMapFromSources :: Int -> Int -> (Int -> XYZ) -> (Int -> Radiance) -> EnvironmentMap
environmentMapFromSources wanted count place flux = withCoarser rings $
  U.create $ do
    fields <- M.replicate (3 * U.sum counts) 0
    forM_ [0 .. count - 1] $ \source -> do
      let Place u v = placeOf (place source)
          i = min (rings - 1) (truncate (v * fromIntegral rings))
          n = counts U.! i
          j = min (n - 1) (truncate (u * fromIntegral n))
          area = 2 * pi * (cosineAt rings i - cosineAt rings (i + 1)) / fromIntegral n
      addTo fields (starts U.! i + j) (1 / area) (flux source)
    pure fields
  where
    rings = max 1 wanted
    counts = ringsOf rings
    starts = U.scanl' (+) 0 counts

-- | Cosine of the angle from the pole at which a ring begins.
cosineAt :: Int -> Int -> Double
cosineAt rings i = cos (pi * fromIntegral i / fromIntegral rings)

-- | Add light to one field.
addTo :: M.MVector s Float -> Int -> Double -> Radiance -> ST s ()
addTo fields field weight (Radiance r g b) = do
  add 0 r
  add 1 g
  add 2 b
  where
    add channel value =
      M.unsafeModify fields (+ double2Float (weight * value)) (3 * field + channel)
{-# INLINE addTo #-}

-- | @spread weight m n source fields start@ adds a ring of @m@ fields to a ring
-- of @n@ that begins at field @start@: each gets the mean of what it covers.
spread :: Double -> Int -> Int -> (Int -> Radiance) -> M.MVector s Float -> Int -> ST s ()
spread weight m n source fields start = go 0 0 0
  where
    -- Positions in units of 1/(m n) of the circle, all whole numbers.
    go !at !i !j
      | i >= m || j >= n = pure ()
      | otherwise = do
        let endI = (i + 1) * n
            endJ = (j + 1) * m
            end = min endI endJ
        addTo fields (start + j) (weight * fromIntegral (end - at) / fromIntegral m) (source i)
        go end (if endI == end then i + 1 else i) (if endJ == end then j + 1 else j)
{-# INLINE spread #-}

-- | Build all coarser levels over the finest.
withCoarser :: Int -> U.Vector Float -> EnvironmentMap
withCoarser rings finest =
  EnvironmentMap
    { imageRings = U.fromList heights,
      imageFirstRing = U.fromList (scanl (+) 0 heights),
      imageRingStart = U.scanl' (+) 0 (U.concat (map ringsOf heights)),
      imageFields = U.concat (climb heights finest)
    }
  where
    heights = ladder rings
    climb (h : k : rest) level = level : climb (k : rest) (coarser h k level)
    climb _ level = [level]

-- | The means of a level of @h@ rings in a level of @k@.
coarser :: Int -> Int -> U.Vector Float -> U.Vector Float
coarser h k level = U.create $ do
  fields <- M.replicate (3 * U.sum toCounts) 0
  forM_ [0 .. k - 1] $ \i -> do
    let top = i * h `quot` k
        bottom = min (h - 1) (((i + 1) * h - 1) `quot` k)
        whole = edge k i - edge k (i + 1)
    forM_ [top .. bottom] $ \ring -> do
      let overlap = min (edge k i) (edge h ring) - max (edge k (i + 1)) (edge h (ring + 1))
      spread
        (overlap / whole)
        (fromCounts U.! ring)
        (toCounts U.! i)
        (fieldRadiance level . (fromStarts U.! ring +))
        fields
        (toStarts U.! i)
  pure fields
  where
    edge = cosineAt
    fromCounts = ringsOf h
    toCounts = ringsOf k
    fromStarts = U.scanl' (+) 0 fromCounts
    toStarts = U.scanl' (+) 0 toCounts

-- | One field's light.
fieldRadiance :: U.Vector Float -> Int -> Radiance
fieldRadiance fields field = Radiance (channel 0) (channel 1) (channel 2)
  where
    channel c = float2Double (U.unsafeIndex fields (3 * field + c))
{-# INLINE fieldRadiance #-}

-- | The mean radiance over the sphere: the one field of the coarsest level.
environmentMapMean :: EnvironmentMap -> Radiance
environmentMapMean image = fieldRadiance (imageFields image) (U.last (imageRingStart image) - 1)

-- | A place in the picture: turns from the left edge, and half turns from the
-- pole +y, both 0 … 1.
data Place = Place !Double !Double

-- | Where a direction (of any length) stands in the picture.
placeOf :: XYZ -> Place
placeOf (XYZ x y z) =
  Place
    (0.5 + arcTangent2 x (negate z) / (2 * pi))
    (arcTangent2 (sqrt (x * x + z * z)) y / pi)
{-# INLINE placeOf #-}

-- | The direction of a point of the map.
directionAt :: Double -> Double -> XYZ
directionAt u v = XYZ (sin longitude * s) (cos (pi * v)) (negate (cos longitude * s))
  where
    longitude = 2 * pi * (u - 0.5)
    s = sin (pi * v)

-- | The light of one level at a point, linear between the middles of the fields.
-- The ring beyond a pole is the first ring on the far side.
levelRadiance :: EnvironmentMap -> Int -> Place -> Radiance
levelRadiance image level (Place u v) = mixRadiance t (ringAt above) (ringAt (above + 1))
  where
    rings = U.unsafeIndex (imageRings image) level
    first = U.unsafeIndex (imageFirstRing image) level
    row = v * fromIntegral rings - 0.5
    above = if row < 0 then -1 else truncate row
    t = row - fromIntegral above
    ringAt i
      | i < 0 = ringRadiance image first (if u < 0.5 then u + 0.5 else u - 0.5)
      | i >= rings = ringRadiance image (first + rings - 1) (if u < 0.5 then u + 0.5 else u - 0.5)
      | otherwise = ringRadiance image (first + i) u
{-# INLINE levelRadiance #-}

-- | Light along one ring, linear between the fields' middles, round the seam.
ringRadiance :: EnvironmentMap -> Int -> Double -> Radiance
ringRadiance image ring u = mixRadiance t (at left) (at right)
  where
    start = U.unsafeIndex (imageRingStart image) ring
    n = U.unsafeIndex (imageRingStart image) (ring + 1) - start
    column = u * fromIntegral n + (fromIntegral n - 0.5)
    whole = truncate column :: Int
    t = column - fromIntegral whole
    left = whole `rem` n
    right = if left + 1 >= n then left + 1 - n else left + 1
    at j = fieldRadiance (imageFields image) (start + j)

-- | The light at a point, blurred to fields of a given size in radians, from the
-- two levels nearest to it.
blurredRadiance :: EnvironmentMap -> Double -> XYZ -> Radiance
blurredRadiance image size direction
  | size <= finestField || top <= 0 = levelRadiance image 0 place
  | level >= top = levelRadiance image top place
  | otherwise =
    mixRadiance
      (height - fromIntegral level)
      (levelRadiance image level place)
      (levelRadiance image (level + 1) place)
  where
    place = placeOf direction
    finestField = pi / fromIntegral (U.unsafeIndex (imageRings image) 0)
    top = U.length (imageRings image) - 1
    height = min 64 (logBase 2 (size / finestField))
    level = truncate height

-- | The picture's light through a beam: the mean over an ellipse about as wide
-- as the pixel's, by a bell-shaped weight of standard deviation half a pixel.
--
-- The coarseness follows the ellipse's shorter axis, and up to 'maximumTaps'
-- places along its longer axis are looked at; a yet longer ellipse is seen
-- coarser. About 0.1 µs per point. Returns the mean of the sky for a degenerate beam.
environmentMapRadiance :: EnvironmentMap -> RayDifferential -> Radiance
environmentMapRadiance image differential
  -- Most beams are narrower than the finest field either way.
  | differentialExtent differential <= fieldSize image && directed d =
    levelRadiance image 0 (placeOf d)
  | isNaN (XYZ.norm d) || isNaN wholeLength || isInfinite wholeLength = environmentMapMean image
  | taps <= 1 = blurredRadiance image long d
  | otherwise = gather 0 0 black
  where
    d = differentialDirection differential
    directed (XYZ x y z) = let size = abs x + abs y + abs z in size > 0 && size < 1 / 0
    (wholeAxis, narrow) = differentialWidths differential
    wholeLength = XYZ.norm wholeAxis
    -- Past a radian the tangent plane says nothing of the sphere any more.
    long = min 1.2 wholeLength
    axis = (long / wholeLength) *^ wholeAxis
    short = max (max narrow (fieldSize image)) (long / longestRatio)
    -- What the blurred fields lack of the ellipse's length, as a variance in
    -- units of its longer axis.
    lack = max 0 (1 - short * short / (long * long))
    reach = 0.9 * sqrt lack
    taps =
      if long <= 1.1 * short
        then 1
        else min maximumTaps (2 + truncate (2 * reach * long / short)) :: Int
    gather :: Int -> Double -> Radiance -> Radiance
    gather !i !total !light
      | i >= taps = scaleRadiance (1 / total) light
      | otherwise =
        let t = reach * (2 * fromIntegral i / fromIntegral (taps - 1) - 1)
            -- The standard deviation is half the axis; cut at 1.8 of them, the
            -- bell keeps 0.8 of its variance, hence the wider one.
            weight = exp (-(t * t) / (0.65 * lack))
         in gather
              (i + 1)
              (total + weight)
              (light <+> scaleRadiance weight (blurredRadiance image short (d ^+^ t *^ axis)))

-- | How a map's light changes through the beams between two.
data Evenness
  = -- | Nearly linearly from one to the other, as between directions in one of the finest
    -- fields.
    Linear
  | -- | Nearly linearly from each to the middle.
    LinearByHalves
  | Uneven
  deriving (Eq, Show)

-- | How the light changes through the beams between two.
evennessBetween :: EnvironmentMap -> RayDifferential -> RayDifferential -> Evenness
evennessBetween image first final
  | any ((> field) . differentialExtent) [first, final] = Uneven
  | apart <= field = Linear
  | apart <= 2 * field = LinearByHalves
  | otherwise = Uneven
  where
    field = fieldSize image
    apart = XYZ.distance (differentialDirection first) (differentialDirection final)

-- | Height of the finest fields, in radians.
fieldSize :: EnvironmentMap -> Double
fieldSize image = pi / fromIntegral (U.unsafeIndex (imageRings image) 0)

-- | The most places looked at for one beam.
maximumTaps :: Int
maximumTaps = 16

-- | The most slender ellipse that the permitted number of points covers without gaps.
longestRatio :: Double
longestRatio = 8
