-- | SVG 1.1 output for figures.
module BlackHole.Figure.Svg
  ( renderSvg,
  )
where

import BlackHole.Figure.Figure
import BlackHole.Vector.XY (XY (..))
import qualified Data.ByteString.Builder as Builder
import qualified Data.ByteString.Lazy as Lazy
import Data.Char (intToDigit)
import Data.List (intercalate)
import Data.Word (Word8)
import Numeric (showFFloat)

-- | The figure as an SVG document in UTF-8, in time linear in its number of points.
renderSvg :: Figure -> Lazy.ByteString
renderSvg figure =
  Builder.toLazyByteString . Builder.stringUtf8 . unlines $
    [ "<?xml version=\"1.0\" encoding=\"UTF-8\"?>",
      open
        "svg"
        [ ("xmlns", "http://www.w3.org/2000/svg"),
          ("width", show width),
          ("height", show height),
          ("viewBox", unwords ["0 0", show width, show height]),
          ("font-family", "Helvetica, Arial, 'Liberation Sans', 'DejaVu Sans', sans-serif"),
          ("stroke-linecap", "round"),
          ("stroke-linejoin", "round")
        ],
      element "title" [] (escape (figureTitle figure)),
      empty "rect" [("width", show width), ("height", show height), ("fill", "#ffffff")]
    ]
      ++ shapes "c" (figureShapes figure)
      ++ ["</svg>"]
  where
    width = figureWidth figure
    height = figureHeight figure

-- | The lines of the document for some shapes. The name keeps the clipping paths of
-- nested groups apart.
shapes :: String -> [Shape] -> [String]
shapes name = concat . zipWith (\n -> shape (name ++ show n)) [1 :: Int ..]

shape :: String -> Shape -> [String]
shape name drawn = case drawn of
  Polyline _ [] -> []
  Polyline stroke points ->
    [empty "path" (("d", pathData points) : ("fill", "none") : strokeOf stroke)]
  Ring stroke centre r -> [empty "circle" (circle centre r ++ ("fill", "none") : strokeOf stroke)]
  Disc colour centre r -> [empty "circle" (circle centre r ++ [("fill", code colour)])]
  Polygon colour points ->
    [empty "polygon" [("points", unwords (map pair points)), ("fill", code colour)]]
  Words label -> text label
  Clipped (Box left top width height) inner ->
    [ element "clipPath" [("id", name)] $
        empty
          "rect"
          [ ("x", decimal left),
            ("y", decimal top),
            ("width", decimal width),
            ("height", decimal height)
          ],
      open "g" [("clip-path", "url(#" ++ name ++ ")")]
    ]
      ++ shapes (name ++ "-") inner
      ++ ["</g>"]
  where
    circle (XY x y) r = [("cx", decimal x), ("cy", decimal y), ("r", decimal r)]
    pair (XY x y) = decimal x ++ "," ++ decimal y
    pathData points = 'M' : intercalate " L" (map pair points)

strokeOf :: Stroke -> [(String, String)]
strokeOf (Stroke colour width gaps) =
  [("stroke", code colour), ("stroke-width", decimal width)]
    ++ [("stroke-dasharray", decimal dash ++ " " ++ decimal gap) | Just (dash, gap) <- [gaps]]

-- | A label. Its white outline is a copy of the text below it in wide white strokes,
-- because older viewers do not support the property that would draw both at once.
text :: Label -> [String]
text (Label (XY x y) anchor size colour rim runs) =
  [ element
      "text"
      ( place
          ++ [("fill", "#ffffff"), ("stroke", "#ffffff"), ("stroke-width", decimal (0.3 * size))]
      )
      content
    | rim
  ]
    ++ [element "text" (place ++ [("fill", code colour)]) content]
  where
    place =
      [ ("xml:space", "preserve"),
        ("x", decimal x),
        ("y", decimal y),
        ("font-size", decimal size),
        ("text-anchor", case anchor of AtStart -> "start"; AtMiddle -> "middle"; AtEnd -> "end")
      ]
    content = go 0 runs
    -- A shift applies to the following text too, until it is undone.
    go :: Double -> [Run] -> String
    go _ [] = ""
    go lowered (run : rest) = case run of
      Plain s ->
        element "tspan" [("dy", decimal (negate lowered)) | lowered /= 0] (escape s)
          ++ go 0 rest
      Subscript s ->
        let depth = 0.22 * size
         in element
              "tspan"
              [("dy", decimal (depth - lowered)), ("font-size", decimal (0.7 * size))]
              (escape s)
              ++ go depth rest

open :: String -> [(String, String)] -> String
open name attributes = "<" ++ name ++ concatMap attribute attributes ++ ">"

empty :: String -> [(String, String)] -> String
empty name attributes = "<" ++ name ++ concatMap attribute attributes ++ "/>"

element :: String -> [(String, String)] -> String -> String
element name attributes content = open name attributes ++ content ++ "</" ++ name ++ ">"

attribute :: (String, String) -> String
attribute (name, value) = " " ++ name ++ "=\"" ++ escape value ++ "\""

escape :: String -> String
escape = concatMap $ \c -> case c of
  '&' -> "&amp;"
  '<' -> "&lt;"
  '>' -> "&gt;"
  '"' -> "&quot;"
  _ -> [c]

-- | Formats a number to a hundredth of a pixel, which is finer than the eye can see.
decimal :: Double -> String
decimal v
  | isNaN v || isInfinite v = "0"
  | otherwise = case reverse (showFFloat (Just 2) v "") of
    '0' : '0' : '.' : whole -> unsigned (reverse whole)
    '0' : rest -> reverse rest
    digits -> reverse digits
  where
    unsigned "-0" = "0"
    unsigned s = s

code :: Colour -> String
code (Colour r g b) = '#' : concatMap hex [r, g, b]
  where
    hex :: Word8 -> String
    hex v = [intToDigit (fromIntegral (v `div` 16)), intToDigit (fromIntegral (v `mod` 16))]
