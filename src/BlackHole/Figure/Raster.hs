{-# LANGUAGE BangPatterns #-}

-- | Rasterisation of figures. The coverage of a pixel by a line follows from the
-- distance between the pixel's middle and the line, which antialiases the line.
module BlackHole.Figure.Raster
  ( rasterise,
  )
where

import BlackHole.Figure.Figure
import BlackHole.Figure.StrokeFont (textLines, textWidth)
import BlackHole.Vector.XY (XY (..), (^+^))
import Codec.Picture (Image (..), PixelRGB8)
import Control.Monad (forM_, when)
import Control.Monad.ST (ST)
import qualified Data.Vector.Storable as Storable
import qualified Data.Vector.Unboxed.Mutable as Unboxed
import GHC.Float (double2Float)

-- | The figure on white. The time is proportional to the area of its shapes, where a
-- line counts with the bounding boxes of its segments. Takes 16 bytes per pixel.
rasterise :: Figure -> Image PixelRGB8
rasterise figure = Image width height pixels
  where
    width = max 1 (figureWidth figure)
    height = max 1 (figureHeight figure)
    everything = Box 0 0 (fromIntegral width) (fromIntegral height)
    pixels = Storable.create $ do
      canvas <-
        Canvas width height <$> Unboxed.replicate (3 * width * height) 255
          <*> Unboxed.replicate (width * height) 0
      mapM_ (draw canvas everything) (figureShapes figure)
      Storable.unsafeThaw
        =<< Storable.generateM
          (3 * width * height)
          (fmap (round . min 255 . max 0) . Unboxed.read (canvasColours canvas))

-- | Encoded colour values, and the coverage of each pixel by the shape being drawn,
-- which is zero between shapes.
data Canvas s = Canvas
  { canvasWidth :: !Int,
    canvasHeight :: !Int,
    canvasColours :: !(Unboxed.MVector s Float),
    canvasCover :: !(Unboxed.MVector s Float)
  }

draw :: Canvas s -> Box -> Shape -> ST s ()
draw canvas clip shape = case shape of
  Polyline (Stroke colour width gaps) points ->
    strokeLines
      canvas
      clip
      colour
      width
      (maybe [points] (\(dash, gap) -> dashes dash gap points) gaps)
  Ring stroke centre r -> draw canvas clip (Polyline stroke (circleOutline centre r))
  Disc colour (XY x y) r ->
    fill canvas clip colour (Box (x - r) (y - r) (2 * r) (2 * r)) $ \px py ->
      r - sqrt ((px - x) * (px - x) + (py - y) * (py - y))
  Polygon colour points -> polygon canvas clip colour points
  Words label -> drawText canvas clip label
  Clipped box inner -> mapM_ (draw canvas (intersection clip box)) inner

intersection :: Box -> Box -> Box
intersection (Box l t w h) (Box l' t' w' h') =
  Box left top (min (l + w) (l' + w') - left) (min (t + h) (t' + h') - top)
  where
    left = max l l'
    top = max t t'

drawText :: Canvas s -> Box -> Label -> ST s ()
drawText canvas clip (Label place anchor size colour rim runs) = do
  when rim $ strokeLines canvas clip (Colour 255 255 255) (0.4 * size) strokes
  strokeLines canvas clip colour (max 1 (0.085 * size)) strokes
  where
    strokes = map (map (^+^ (place ^+^ XY back 0))) (textLines size runs)
    back = case anchor of
      AtStart -> 0
      AtMiddle -> -0.5 * textWidth size runs
      AtEnd -> negate (textWidth size runs)

-- | Draws lines as one shape, so that pixels where they meet or cross are painted only
-- once.
strokeLines :: Canvas s -> Box -> Colour -> Double -> [[XY]] -> ST s ()
strokeLines canvas clip colour width pieces = do
  forM_ segments $ \(a, b) -> cover canvas (ranges canvas clip (reach a b)) (distanceCover a b)
  blend canvas clip colour (concatMap (\(a, b) -> [a, b]) segments) (half + 1)
  where
    half = 0.5 * width
    segments = concatMap pairs pieces
    pairs points = case points of
      [p] -> [(p, p)]
      _ -> zip points (drop 1 points)
    reach (XY x y) (XY x' y') =
      Box
        (min x x' - half - 1)
        (min y y' - half - 1)
        (abs (x - x') + width + 2)
        (abs (y - y') + width + 2)
    -- Lines thinner than a pixel become paler instead of narrower.
    strength = min 1 width
    distanceCover (XY x y) (XY x' y') =
      let !dx = x' - x
          !dy = y' - y
          !len2 = dx * dx + dy * dy
       in \px py ->
            let along =
                  if len2 > 0
                    then max 0 (min 1 (((px - x) * dx + (py - y) * dy) / len2))
                    else 0
                ex = px - x - along * dx
                ey = py - y - along * dy
             in strength * (max 0.5 half + 0.5 - sqrt (ex * ex + ey * ey))

-- | Fills a convex polygon of either orientation. Inside, the depth is the distance to
-- the nearest side.
polygon :: Canvas s -> Box -> Colour -> [XY] -> ST s ()
polygon canvas clip colour points
  | area == 0 = pure ()
  | otherwise = fill canvas clip colour (boundsOf points) depth
  where
    sides = zip points (drop 1 points ++ take 1 points)
    area = sum [x * y' - x' * y | (XY x y, XY x' y') <- sides]
    depth px py =
      foldr
        min
        1e9
        [ signum area * ((x' - x) * (py - y) - (y' - y) * (px - x)) / len
          | (XY x y, XY x' y') <- sides,
            let len = sqrt ((x' - x) * (x' - x) + (y' - y) * (y' - y)),
            len > 0
        ]

-- | Fills the pixels whose depth below the shape's edge, in pixels, is positive.
fill :: Canvas s -> Box -> Colour -> Box -> (Double -> Double -> Double) -> ST s ()
fill canvas clip colour box@(Box l t w h) depth = do
  cover
    canvas
    (ranges canvas clip (Box (l - 1) (t - 1) (w + 2) (h + 2)))
    (\px py -> depth px py + 0.5)
  blend canvas clip colour [XY l t, XY (l + boxWidth box) (t + boxHeight box)] 1

boundsOf :: [XY] -> Box
boundsOf points = Box left top (right - left) (bottom - top)
  where
    (left, top, right, bottom) = foldr widened (1e9, 1e9, -1e9, -1e9) points
    widened (XY x y) (l, t, r, b) = (min l x, min t y, max r x, max b y)

-- | First and last column, first and last row.
data Range = Range !Int !Int !Int !Int

-- | The pixels of a box that are inside the clipping box.
ranges :: Canvas s -> Box -> Box -> Range
ranges canvas clip box =
  Range
    (from l)
    (min (canvasWidth canvas) (to (l + w)) - 1)
    (from t)
    (min (canvasHeight canvas) (to (t + h)) - 1)
  where
    Box l t w h = intersection clip box
    from = max 0 . floor . bounded
    to = ceiling . bounded
    bounded = max (-1e6) . min 1e6

-- | Raises the coverage of the pixels in a range to the function's value at their
-- middles.
cover :: Canvas s -> Range -> (Double -> Double -> Double) -> ST s ()
cover canvas (Range x0 x1 y0 y1) share =
  forM_ [y0 .. y1] $ \y -> forM_ [x0 .. x1] $ \x -> do
    let part = double2Float (min 1 (share (fromIntegral x + 0.5) (fromIntegral y + 0.5)))
        at = y * canvasWidth canvas + x
    when (part > 0) $ Unboxed.modify (canvasCover canvas) (max part) at

-- | Blends the colour into the pixels covered around some points, and clears the
-- coverage.
blend :: Canvas s -> Box -> Colour -> [XY] -> Double -> ST s ()
blend canvas clip (Colour r g b) points margin
  | null points = pure ()
  | otherwise =
    forM_ [y0 .. y1] $ \y -> forM_ [x0 .. x1] $ \x -> do
      let at = y * canvasWidth canvas + x
      part <- Unboxed.read (canvasCover canvas) at
      when (part > 0) $ do
        Unboxed.write (canvasCover canvas) at 0
        forM_ (zip [0 ..] [r, g, b]) $ \(channel, value) ->
          Unboxed.modify
            (canvasColours canvas)
            (\old -> old + part * (fromIntegral value - old))
            (3 * at + channel)
  where
    Box l t w h = boundsOf points
    Range x0 x1 y0 y1 =
      ranges
        canvas
        clip
        (Box (l - margin) (t - margin) (w + 2 * margin) (h + 2 * margin))
