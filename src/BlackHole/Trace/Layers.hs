{-# LANGUAGE BangPatterns #-}

-- | The layers of a picture: the gas in front, and the sky behind it.
--
-- The sky behind a pixel is known without noise, because its light is filtered for the
-- whole pixel. The gas is smooth nearly everywhere. So each pixel gets few rays or none,
-- and its light is a weighted mean of the gas at nine pixels, plus the light of the sky
-- times the share that passes the gas, averaged alike.
module BlackHole.Trace.Layers
  ( Layers (..),
    tracedThroughout,
    coarseness,
    layersBetween,
    pixelLayers,
    storedLayers,

    -- * Nine pixels
    Kernel,
    kernel,
    sharedLight,
    clearness,

    -- * Storage
    layerCount,
    forLayers,
    readLayers,
  )
where

import BlackHole.Light.Radiance
import BlackHole.Scene.Camera (Camera (..), Picture (..), posePosition)
import BlackHole.Scene.Disk (Disk (..))
import BlackHole.Scene.Filter
import BlackHole.Scene.Scene
import BlackHole.Spacetime.LightPath (halfHeightAt)
import BlackHole.Trace.Estimate (seenAs)
import BlackHole.Trace.PhotonRing
import BlackHole.Trace.Ray
import BlackHole.Trace.Sampling
import BlackHole.Trace.Sky
import BlackHole.Trace.SkySpan
import BlackHole.Trace.Tracer
import BlackHole.Vector.XYZ (XYZ (..))
import qualified BlackHole.Vector.XYZ as XYZ
import Data.Bits ((.&.))
import Data.Functor.Identity (Identity (..))
import Data.Maybe (fromMaybe)

-- | What the first rays of a pixel find.
data Layers = Layers
  { -- | The light of the gas.
    layersGas :: {-# UNPACK #-} !Radiance,
    -- | The share of the sky's light that gets through, 0 to 1.
    layersClear :: {-# UNPACK #-} !Double,
    -- | The number of rays, 0 if the layers are interpolated.
    layersRays :: {-# UNPACK #-} !Double
  }
  deriving (Eq, Show)

-- | Whether every pixel of the span that begins in a column of a row gets rays: where the
-- photon ring is near, whose images of the gas are thin, where the disk may be thinner than
-- four pixels, behind a lens, and in scenes of sharp edges.
tracedThroughout :: Tracer -> Int -> Int -> Bool
tracedThroughout traced column row =
  case (tracerLens traced, tracerMatter traced, tracerSky traced) of
    (Nothing, Gaseous _, ByDifferential _) ->
      thin || photonRingWithin traced 16 (spanMiddle column row)
    (Nothing, Vacuum, ByDifferential _) -> False
    _ -> True
  where
    scene = tracerScene traced
    place@(XYZ _ height _) = posePosition (cameraPose (sceneCamera scene))
    distance = XYZ.norm place
    inner = maybe 1 (max 1 . diskInnerRadius) (sceneDisk scene)
    -- Half the height of the gas's image at the disk's inner edge is less than two pixels.
    thin =
      halfHeightAt (tracerRegion traced) inner + inner * abs height / distance
        < 2 * pixelWidth scene * distance

-- | The coarseness of a column in a row, given whether its span is traced throughout: 4 for
-- columns that are always traced, as every fourth one, 2 for those in the middle between
-- two of these, and 1 for the others. Each of the latter lies between columns of a greater
-- coarseness at this distance on both sides, and at three times this distance. The columns
-- of one row are shifted against those of the next, and those near the borders are always
-- traced.
coarseness :: Tracer -> Bool -> Int -> Int -> Int
coarseness traced throughout column row
  | throughout || column < 6 || column + 6 >= pictureWidth (scenePicture (tracerScene traced)) = 4
  | otherwise = case (column + 2 * row) .&. 3 of
    0 -> 4
    2 -> 2
    _ -> 1
{-# INLINE coarseness #-}

-- | The layers in the middle of four equally spaced pixels of a row, interpolated
-- cubically, if both the light of the gas and the share of the sky's differ little between
-- the inner two and from what lies on a straight line.
layersBetween :: Tracer -> Layers -> Layers -> Layers -> Layers -> Maybe Layers
layersBetween traced a b c d
  | smooth seen (0.3 * sceneNoise (tracerScene traced)) && smooth layersClear 0.05 =
    Just (Layers (mapRadiance (max 0) gas) (max 0 (min 1 clear)) 0)
  | otherwise = Nothing
  where
    seen = seenAs . (tracerGain traced *) . luminance . layersGas
    -- The inner two differ by at most four tolerances, and the cubic through all four
    -- departs in the middle from the straight line between these by at most one.
    smooth value tolerance =
      abs (value c - value b) <= 4 * tolerance
        && abs (value a - value b - value c + value d) <= 16 * tolerance
    {-# INLINE smooth #-}
    gas =
      scaleRadiance inner (layersGas b <+> layersGas c)
        <+> scaleRadiance outer (layersGas a <+> layersGas d)
    clear = inner * (layersClear b + layersClear c) + outer * (layersClear a + layersClear d)
    inner = 9 / 16
    outer = -1 / 16

-- | The layers of a pixel, by column and row: the mean over its first rays.
tracedLayers :: Tracer -> Int -> Int -> Layers
tracedLayers traced column row = go 0 black 0
  where
    scene = tracerScene traced
    !count = sceneSamples scene
    go !index !gas !clear
      | index < count =
        let Sample place _ = sampleOf Box (sceneSeed scene) count column row index
            (light, through) = gasBeforeSky traced place
         in go (index + 1) (gas <+> light) (clear + through)
      | otherwise = Layers (scaleRadiance share gas) (share * clear) (fromIntegral count)
    share = 1 / fromIntegral count

-- | @pixelLayers traced apart at column row@ are the layers of a pixel of this
-- 'coarseness', interpolated or traced, from those at columns of a greater coarseness.
pixelLayers ::
  Applicative f => Tracer -> Int -> (Int -> f Layers) -> Int -> Int -> f Layers
pixelLayers traced apart at column row
  | apart == 4 = pure alone
  | otherwise = between <$> beside (-3) <*> beside (-1) <*> beside 1 <*> beside 3
  where
    alone = tracedLayers traced column row
    beside k = at (column + k * apart)
    between a b c d = fromMaybe alone (layersBetween traced a b c d)
{-# INLINE pixelLayers #-}

-- | The layers of a single pixel as a film stores them, by column and row.
storedLayers :: Tracer -> Int -> Int -> Layers
storedLayers traced column row =
  asStored (runIdentity (pixelLayers traced apart at column row))
  where
    apart = coarseness traced (tracedThroughout traced (spanStart column) row) column row
    at column' = Identity (storedLayers traced column' row)

-- | The layers rounded to what a film in single precision stores.
asStored :: Layers -> Layers
asStored (Layers gas clear rays) = Layers (mapRadiance single gas) (single clear) rays
  where
    single v = realToFrac (realToFrac v :: Float)

-- | The weights of a pixel, of its neighbours in the row and the column, and of those
-- across the corners.
data Kernel = Kernel !Double !Double !Double

-- | The values of a reconstruction filter at the middles of nine pixels. Their sum is 1.
kernel :: Filter -> Kernel
kernel reconstruction = Kernel (middle / whole) (beside / whole) (corner / whole)
  where
    middle = filterDensity reconstruction 0 0
    beside = filterDensity reconstruction 1 0
    corner = filterDensity reconstruction 1 1
    whole = middle + 4 * (beside + corner)

-- | Sums over nine pixels: the weighted gas and share of the sky, and both without weights;
-- and of what is seen, itself, its products with the offset in columns and in rows, and its
-- square.
data Sums = Sums !Radiance !Double !Radiance !Double !Double !Double !Double !Double

-- | @sharedLight kernel gain noise sky layersAt@ is the light of a pixel and its standard
-- error as a fraction of display white, from the light of the sky behind it and the layers
-- of nine pixels by their offset in columns and rows. The error follows from how far what is
-- seen departs from a plane, which the filter would reproduce. The smaller the error is
-- against @noise@, the more evenly the nine count: an even mean reproduces a plane, too, and
-- has the least noise.
sharedLight ::
  Kernel ->
  Double ->
  Double ->
  Radiance ->
  (Int -> Int -> Layers) ->
  (Radiance, Double)
sharedLight (Kernel middle beside corner) !gain !noise !sky layersAt = case nine of
  Sums gas clear allGas allClear s sx sy ss ->
    let residual = ss - s * s / 9 - (sx * sx + sy * sy) / 6
        uncertain = sqrt (max 0 residual / 6 * spread)
        sharp = if uncertain < noise then uncertain / noise else 1
        even' = (1 - sharp) / 9
        through = sharp * clear + even' * allClear
     in ( mapRadiance
            (max 0)
            (scaleRadiance sharp gas <+> scaleRadiance even' allGas <+> scaleRadiance through sky),
          uncertain
        )
  where
    nine = rowAt (-1) corner beside (rowAt 0 beside middle (rowAt 1 corner beside none))
    none = Sums black 0 black 0 0 0 0 0
    rowAt y atSides inMiddle = add atSides (-1) y . add inMiddle 0 y . add atSides 1 y
    {-# INLINE rowAt #-}
    add !w !x !y (Sums g c ag ac s sx sy ss) =
      let Layers light through _ = layersAt x y
          v = seenAs (gain * luminance (light <+> scaleRadiance through sky))
          vx = fromIntegral x * v
          vy = fromIntegral y * v
       in Sums
            (g <+> scaleRadiance w light)
            (c + w * through)
            (ag <+> light)
            (ac + through)
            (s + v)
            (sx + vx)
            (sy + vy)
            (ss + v * v)
    {-# INLINE add #-}
    spread = middle * middle + 4 * (beside * beside + corner * corner)
{-# INLINE sharedLight #-}

-- | The least and the greatest share of the sky's light that gets through in nine pixels.
clearness :: (Int -> Int -> Layers) -> (Double, Double)
clearness layersAt = case (inRow (-1), inRow 0, inRow 1) of
  ((a, a'), (b, b'), (c, c')) -> (least a (least b c), most a' (most b' c'))
  where
    inRow y = case (clear (-1) y, clear 0 y, clear 1 y) of
      (a, b, c) -> (least a (least b c), most a (most b c))
    {-# INLINE inRow #-}
    clear x y = layersClear (layersAt x y)
    least, most :: Double -> Double -> Double
    least a b = if a < b then a else b
    most a b = if a < b then b else a
{-# INLINE clearness #-}

-- | The number of numbers that 'forLayers' visits.
layerCount :: Int
layerCount = 5

-- | Runs an action for each of the numbers of layers and its index, counted from 0.
forLayers :: Applicative f => Layers -> (Int -> Double -> f ()) -> f ()
forLayers (Layers (Radiance r g b) clear rays) act =
  act 0 r *> act 1 g *> act 2 b *> act 3 clear *> act 4 rays
{-# INLINE forLayers #-}

-- | Layers from an action that returns the number with an index.
readLayers :: Applicative f => (Int -> f Double) -> f Layers
readLayers at = Layers <$> (Radiance <$> at 0 <*> at 1 <*> at 2) <*> at 3 <*> at 4
{-# INLINE readLayers #-}
