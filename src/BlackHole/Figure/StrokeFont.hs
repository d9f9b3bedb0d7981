-- | A small stroke font for raster figures.
--
-- It contains the characters that figures use: lower-case Latin letters, digits and
-- some signs. Any other character becomes a blank.
module BlackHole.Figure.StrokeFont
  ( textLines,
    textWidth,
    glyph,
  )
where

import BlackHole.Figure.Figure (Run (..))
import BlackHole.Vector.XY (XY (..))
import Data.Maybe (fromMaybe)

-- | @textLines size runs@ returns the strokes of a text whose baseline starts at the
-- origin, with y downwards. Lower-case letters are about half as high as the size.
textLines :: Double -> [Run] -> [[XY]]
textLines size = snd . layOut size

-- | The width of that text, in the unit of the size.
textWidth :: Double -> [Run] -> Double
textWidth size = fst . layOut size

layOut :: Double -> [Run] -> (Double, [[XY]])
layOut size = go 0
  where
    go x [] = (x, [])
    go x (run : rest) =
      let (end, here) = placed x run
          (width, others) = go end rest
       in (width, here ++ others)
    placed x (Plain s) = characters (size / 10) 0 x s
    placed x (Subscript s) = characters (0.07 * size) (0.22 * size) x s
    characters _ _ x [] = (x, [])
    characters unit down x (c : rest) =
      let Glyph width strokes = fromMaybe (Glyph 2.4 []) (glyph c)
          (end, others) = characters unit down (x + unit * (width + 1.3)) rest
       in ( end,
            [[XY (x + unit * px) (down - unit * py) | XY px py <- stroke] | stroke <- strokes]
              ++ others
          )

-- | The width without the space to the next glyph, and the strokes, with y upwards, in
-- tenths of the size.
data Glyph = Glyph !Double ![[XY]]

line :: [(Double, Double)] -> [XY]
line = map (uncurry XY)

-- | An elliptic arc: centre, semi-axes, and start and end angle in degrees.
arc :: Double -> Double -> Double -> Double -> Double -> Double -> [XY]
arc x y rx ry from to =
  [ XY (x + rx * cos a) (y + ry * sin a)
    | k <- [0 .. 16 :: Int],
      let a = (from + (to - from) * fromIntegral k / 16) * pi / 180
  ]

-- | The strokes of a character; 'Nothing' if the font lacks it.
glyph :: Char -> Maybe Glyph
glyph c = uncurry Glyph <$> lookup c glyphs

glyphs :: [(Char, (Double, [[XY]]))]
glyphs =
  [ (' ', (1.6, [])),
    ('a', (4.2, [bowl, line [(4.2, 5), (4.2, 0)]])),
    ('b', (4.2, [bowl, line [(0, 7.3), (0, 0)]])),
    ('c', (3.9, [arc 2.1 2.5 2.1 2.5 45 315])),
    ('d', (4.2, [bowl, line [(4.2, 7.3), (4.2, 0)]])),
    ('e', (4.2, [XY 0 2.6 : arc 2.1 2.5 2.1 2.5 2 315])),
    ('f', (2.4, [arc 2.2 6 1.2 1.3 90 180 ++ line [(1, 0)], line [(0, 5), (2.3, 5)]])),
    ('g', (4.2, [bowl, XY 4.2 5 : arc 2.1 0 2.1 2 0 (-150)])),
    ('h', (4, [line [(0, 7.3), (0, 0)], arch 0 4])),
    ('i', (0.2, [line [(0.1, 5), (0.1, 0)], dot 0.1 6.8])),
    ('j', (0.8, [XY 0.8 5 : arc (-0.4) (-0.8) 1.2 1.2 0 (-90), dot 0.8 6.8])),
    ('k', (3.7, [line [(0, 7.3), (0, 0)], line [(3.4, 5), (0, 1.9)], line [(1.3, 3.1), (3.7, 0)]])),
    ('l', (0.2, [line [(0.1, 7.3), (0.1, 0)]])),
    ('m', (6.4, [line [(0, 5), (0, 0)], arch 0 3.2, arch 3.2 6.4])),
    ('n', (4, [line [(0, 5), (0, 0)], arch 0 4])),
    ('o', (4.4, [arc 2.2 2.5 2.2 2.5 0 360])),
    ('p', (4.2, [bowl, line [(0, 5), (0, -2)]])),
    ('q', (4.2, [bowl, line [(4.2, 5), (4.2, -2)]])),
    ('r', (2.3, [line [(0, 5), (0, 0)], arc 2.1 2.9 2.1 2.1 180 90])),
    ('s', (3.5, [arc 1.75 3.75 1.6 1.25 35 270 ++ arc 1.75 1.25 1.7 1.25 90 (-150)])),
    ( 't',
      (2.4, [line [(1, 6.6), (1, 1.2)] ++ arc 2.2 1.2 1.2 1.2 180 270, line [(0, 5), (2.3, 5)]])
    ),
    ('u', (4, [XY 0 5 : arc 2 2 2 2 180 360, line [(4, 5), (4, 0)]])),
    ('v', (4, [line [(0, 5), (2, 0), (4, 5)]])),
    ('w', (5.8, [line [(0, 5), (1.45, 0), (2.9, 5), (4.35, 0), (5.8, 5)]])),
    ('x', (3.8, [line [(0, 5), (3.8, 0)], line [(0, 0), (3.8, 5)]])),
    ('y', (4, [line [(0, 5), (2, 0)], line [(4, 5), (1.6, -1), (0.4, -2)]])),
    ('z', (3.6, [line [(0.1, 5), (3.5, 5), (0, 0), (3.6, 0)]])),
    ('0', (4.3, [arc 2.15 3.5 2.15 3.5 0 360])),
    ('1', (4.3, [line [(0.7, 5.5), (2.4, 7), (2.4, 0)]])),
    ('2', (4.3, [arc 2.15 4.9 2 2.1 165 (-35) ++ line [(0.1, 0), (4.3, 0)]])),
    ('3', (4.3, [arc 2.1 5.25 1.8 1.75 155 (-90) ++ arc 2.1 1.75 2.1 1.75 90 (-155)])),
    ('4', (4.3, [line [(3.3, 0), (3.3, 7), (0, 2), (4.3, 2)]])),
    ('5', (4.3, [line [(4, 7), (0.7, 7), (0.4, 3.7)] ++ arc 2.1 2.3 2.15 2.3 130 (-150)])),
    ( '6',
      (4.3, [arc 2.15 2.2 2.15 2.2 0 360, line [(0, 2.2), (0, 3.4)] ++ arc 2.4 3.6 2.4 3.4 180 55])
    ),
    ('7', (4.3, [line [(0, 7), (4.2, 7), (1.5, 0)]])),
    ('8', (4.3, [arc 2.15 5.3 1.8 1.7 0 360, arc 2.15 1.85 2.15 1.85 0 360])),
    ( '9',
      ( 4.3,
        [arc 2.15 4.8 2.15 2.2 0 360, line [(4.3, 4.8), (4.3, 3.6)] ++ arc 1.9 3.4 2.4 3.4 0 (-125)]
      )
    ),
    ('.', (0.8, [dot 0.4 0.1])),
    (',', (0.5, [line [(0.4, 0.2), (0, -1.2)]])),
    (':', (0.8, [dot 0.4 0.1, dot 0.4 4.2])),
    ('=', (4.4, [line [(0, 4.2), (4.4, 4.2)], line [(0, 2.3), (4.4, 2.3)]])),
    ('+', (4.4, [line [(0, 3.2), (4.4, 3.2)], line [(2.2, 1), (2.2, 5.4)]])),
    ('-', (2.2, [line [(0, 2.6), (2.2, 2.6)]])),
    ('\8722', (4.4, [line [(0, 3.2), (4.4, 3.2)]])),
    ( '\177',
      (4.4, [line [(0, 4), (4.4, 4)], line [(2.2, 1.9), (2.2, 6.1)], line [(0, 0.6), (4.4, 0.6)]])
    ),
    ('\8776', (4.4, [wave 4.2, wave 2.2])),
    ('/', (2.8, [line [(0, -0.8), (2.8, 7.3)]])),
    ('(', (1.4, [arc 3 2.7 3 5.2 130 230])),
    (')', (1.4, [arc (-1.6) 2.7 3 5.2 (-50) 50]))
  ]
  where
    bowl = arc 2.1 2.5 2.1 2.5 0 360
    arch from to =
      let half = 0.5 * (to - from)
       in arc (from + half) 3 half 2 180 0 ++ [XY to 0]
    dot x y = arc x y 0.3 0.3 0 360
    wave y =
      [ XY (0.275 * fromIntegral k) (y + 0.6 * sin (2 * pi * fromIntegral k / 16))
        | k <- [0 .. 16 :: Int]
      ]
