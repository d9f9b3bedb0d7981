-- | A line drawing as data, which the SVG and PNG writers draw.
--
-- Lengths and positions are in pixels from the top left corner, with y downwards.
module BlackHole.Figure.Figure
  ( Figure (..),
    Shape (..),
    Box (..),
    Stroke (..),
    Colour (..),
    Label (..),
    Anchor (..),
    Run (..),
    circleOutline,
    dashes,
  )
where

import BlackHole.Vector.XY (XY (..))
import qualified BlackHole.Vector.XY as XY
import Data.Word (Word8)

-- | A drawing: its size, a sentence that describes it, and its shapes from back to
-- front on white.
data Figure = Figure
  { figureWidth :: !Int,
    figureHeight :: !Int,
    figureTitle :: !String,
    figureShapes :: ![Shape]
  }
  deriving (Eq, Show)

-- | An element of a drawing.
data Shape
  = -- | A line through points.
    Polyline !Stroke ![XY]
  | -- | The outline of a circle with this centre and radius.
    Ring !Stroke !XY !Double
  | -- | A filled circle.
    Disc !Colour !XY !Double
  | -- | A filled convex polygon.
    Polygon !Colour ![XY]
  | -- | Text.
    Words !Label
  | -- | Shapes clipped to a box.
    Clipped !Box ![Shape]
  deriving (Eq, Show)

-- | Left, top, width and height of a rectangle.
data Box = Box
  { boxLeft :: !Double,
    boxTop :: !Double,
    boxWidth :: !Double,
    boxHeight :: !Double
  }
  deriving (Eq, Show)

-- | The style of a line. Ends and corners are round.
data Stroke = Stroke
  { strokeColour :: !Colour,
    strokeWidth :: !Double,
    -- | Lengths of dash and gap; 'Nothing' for a continuous line.
    strokeDashes :: !(Maybe (Double, Double))
  }
  deriving (Eq, Show)

-- | An sRGB colour.
data Colour = Colour !Word8 !Word8 !Word8
  deriving (Eq, Show)

-- | A line of text.
data Label = Label
  { -- | A point on the baseline.
    labelPlace :: !XY,
    labelAnchor :: !Anchor,
    -- | Font size.
    labelSize :: !Double,
    labelColour :: !Colour,
    -- | Whether a white outline keeps the text legible on top of lines.
    labelRim :: !Bool,
    labelRuns :: ![Run]
  }
  deriving (Eq, Show)

-- | The part of the text that is at its position.
data Anchor = AtStart | AtMiddle | AtEnd
  deriving (Eq, Show, Enum, Bounded)

-- | A part of a text.
data Run
  = Plain !String
  | -- | Lowered and smaller.
    Subscript !String
  deriving (Eq, Show)

-- | A circle as a closed polygon whose sides deviate from it by less than a fiftieth of
-- a pixel.
circleOutline :: XY -> Double -> [XY]
circleOutline (XY x y) r =
  [ XY (x + r * cos a) (y + r * sin a)
    | k <- [0 .. n],
      let a = 2 * pi * fromIntegral k / fromIntegral n
  ]
  where
    n = max 24 (ceiling (16 * sqrt (max 0 r))) :: Int

-- | @dashes dash gap points@ cuts a line into dashes, starting with a dash. If a length
-- is not positive, the line stays whole.
dashes :: Double -> Double -> [XY] -> [[XY]]
dashes dash gap points
  | not (dash > 0 && gap > 0) = [points]
  | otherwise = case points of
    [] -> []
    p : rest -> filter (not . null) (drawing dash [p] p rest)
  where
    drawing _ done _ [] = [reverse done]
    drawing left done p (q : rest)
      | len < left = drawing (left - len) (q : done) q rest
      | otherwise =
        let cut = XY.lerp (left / len) p q
         in reverse (cut : done) : skipping gap cut (q : rest)
      where
        len = XY.norm (q XY.^-^ p)
    skipping _ _ [] = []
    skipping left p (q : rest)
      | len <= left = skipping (left - len) q rest
      | otherwise =
        let cut = XY.lerp (left / len) p q
         in drawing dash [cut] cut (q : rest)
      where
        len = XY.norm (q XY.^-^ p)
