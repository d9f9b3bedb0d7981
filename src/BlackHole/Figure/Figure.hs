-- | A line drawing as data: what the SVG and the PNG writer both draw.
--
-- Lengths and places are in pixels from the top left corner, y downwards.
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

-- | A drawing: its size, what it shows in a sentence, and its shapes from back
-- to front on white.
data Figure = Figure
  { figureWidth :: !Int,
    figureHeight :: !Int,
    figureTitle :: !String,
    figureShapes :: ![Shape]
  }
  deriving (Eq, Show)

-- | One thing to draw.
data Shape
  = -- | A line through points.
    Polyline !Stroke ![XY]
  | -- | A circle's outline: centre and radius.
    Ring !Stroke !XY !Double
  | -- | A filled circle.
    Disc !Colour !XY !Double
  | -- | A filled polygon, convex.
    Polygon !Colour ![XY]
  | -- | Text.
    Words !Label
  | -- | Shapes of which only the part within the box is drawn.
    Clipped !Box ![Shape]
  deriving (Eq, Show)

-- | Left, top, width and height.
data Box = Box
  { boxLeft :: !Double,
    boxTop :: !Double,
    boxWidth :: !Double,
    boxHeight :: !Double
  }
  deriving (Eq, Show)

-- | How a line is drawn. Ends and corners are round.
data Stroke = Stroke
  { strokeColour :: !Colour,
    strokeWidth :: !Double,
    -- | Lengths of dash and gap; 'Nothing' for a continuous line.
    strokeDashes :: !(Maybe (Double, Double))
  }
  deriving (Eq, Show)

-- | sRGB.
data Colour = Colour !Word8 !Word8 !Word8
  deriving (Eq, Show)

-- | A line of text.
data Label = Label
  { -- | A point on the base line.
    labelPlace :: !XY,
    labelAnchor :: !Anchor,
    -- | Height of the font.
    labelSize :: !Double,
    labelColour :: !Colour,
    -- | Whether a white rim keeps it legible on top of lines.
    labelRim :: !Bool,
    labelRuns :: ![Run]
  }
  deriving (Eq, Show)

-- | Which part of the text is at its place.
data Anchor = AtStart | AtMiddle | AtEnd
  deriving (Eq, Show, Enum, Bounded)

-- | A part of a text.
data Run
  = Plain !String
  | -- | Lowered and smaller.
    Subscript !String
  deriving (Eq, Show)

-- | A circle as a closed polygon whose sides are off by less than a fiftieth
-- of a pixel.
circleOutline :: XY -> Double -> [XY]
circleOutline (XY x y) r =
  [ XY (x + r * cos a) (y + r * sin a)
    | k <- [0 .. n],
      let a = 2 * pi * fromIntegral k / fromIntegral n
  ]
  where
    n = max 24 (ceiling (16 * sqrt (max 0 r))) :: Int

-- | @dashes dash gap points@: a line cut into dashes, the first one at its
-- start. Lengths that are not positive leave it whole.
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
