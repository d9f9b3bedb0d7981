-- | Draws the plots of docs/validation.md as SVG files with the program's own modules.
-- The argument is the folder to write to.
module Main (main) where

import BlackHole.Numeric.Bisection (bisect)
import BlackHole.SelfTest.Physics (deflectionReferences)
import BlackHole.Spacetime.Fate (Fate (..))
import BlackHole.Spacetime.Kerr.Landmarks (spin)
import BlackHole.Spacetime.Kerr.Path
import BlackHole.Spacetime.Kerr.Shadow
import BlackHole.Spacetime.Kerr.Sight
import BlackHole.Spacetime.Kerr.SkyTable
import BlackHole.Spacetime.LightPath
import BlackHole.Spacetime.Observer
import BlackHole.Spacetime.Photon
import BlackHole.Spacetime.Schwarzschild.Deflection
import BlackHole.Spacetime.Schwarzschild.Leapfrog
import BlackHole.Spacetime.Schwarzschild.Orbit (orbit, orbitFate, orbitSweep)
import BlackHole.Spacetime.Schwarzschild.StepRule
import BlackHole.Spacetime.Types (Spacetime (..))
import BlackHole.Vector.XYZ (XYZ (..))
import qualified BlackHole.Vector.XYZ as XYZ
import Data.Maybe (mapMaybe)
import Numeric (showFFloat)
import System.Environment (getArgs)
import System.Exit (die)
import System.FilePath ((</>))

main :: IO ()
main = do
  arguments <- getArgs
  case arguments of
    [folder] ->
      mapM_
        (\(name, plot) -> writeFile (folder </> name) (plotSvg plot))
        [ ("deflection.svg", deflectionPlot),
          ("leapfrog-order.svg", orderPlot),
          ("shadow-radius.svg", shadowPlot),
          ("kerr-shadow.svg", kerrShadowPlot),
          ("kerr-table-error.svg", kerrTablePlot)
        ]
    _ -> die "usage: ValidationPlots FOLDER"

-- | The deflection of light against its distance from capture.
deflectionPlot :: Plot
deflectionPlot =
  Plot
    { plotTitle = "Deflection of light from infinity",
      plotAcross = Axis "b / b_c - 1" (decades (-6) 3),
      plotUp = Axis "deflection (rad)" (decades (-3) 2),
      plotSeries =
        [ Curve "#999999" "weak field, 2/b" [(e, 2 / b e) | e <- offsets],
          Curve
            "#d08020"
            "strong field, -ln(b/b_c - 1) + ln(216 (7 - 4√3)) - π"
            [(e, v) | e <- offsets, let v = strong e, v > 1e-3],
          Curve "#2060c0" "closed form" (mapMaybe (\e -> (,) e <$> deflectionAngle (b e)) offsets),
          Points
            "#c02020"
            "reference, 30 digits"
            [(q / critical - 1, v) | (q, v) <- deflectionReferences]
        ]
    }
  where
    offsets = geometric 1e-6 1e3 240
    b e = critical * (1 + e)
    strong e = negate (log e) + log (216 * (7 - 4 * sqrt 3)) - pi

-- | The error of the leapfrog's direction of escape against its step.
orderPlot :: Plot
orderPlot =
  Plot
    { plotTitle = "Leapfrog: error of the direction in which light leaves",
      plotAcross = Axis "step (Schwarzschild radii)" (decades (-2) 0),
      plotUp = Axis "error (rad)" (decades (-7) 3),
      plotSeries =
        concat
          [ [ Curve
                "#999999"
                (if b == 5 then "second order" else "")
                [(l, c * l * l) | l <- [0.01, 1]],
              Points
                colour
                ("b = " ++ show b)
                [(l, directionError b l) | l <- geometric 0.0125 0.4 5]
            ]
            | (b, colour) <- [(2.7, "#c02020"), (3.5, "#d08020"), (5, "#2060c0")],
              let c = directionError b 0.025 / (0.025 * 0.025)
          ]
    }

-- | The shadow seen by an observer at rest against the observer's distance.
shadowPlot :: Plot
shadowPlot =
  Plot
    { plotTitle = "Radius of the shadow for an observer at rest",
      plotAcross = Axis "r (Schwarzschild radii)" (decades 0 2),
      plotUp = Axis "angle (degrees)" (Steps [0, 30 .. 180]),
      plotSeries =
        [ Curve "#999999" "Synge's formula" [(r, synge r) | r <- geometric 1.0001 100 300],
          Points
            "#2060c0"
            "where lines of sight begin to miss the hole"
            [(r, seenBy Static r) | r <- places],
          Points
            "#c02020"
            "the same, directions taken for coordinate directions"
            [(r, seenBy Coordinate r) | r <- places]
        ]
    }
  where
    places = [1.05, 1.2, 1.5, 2, 2.5, 3, 4, 6, 8, 10, 14, 20, 30, 50, 80]
    synge r =
      (if r < 1.5 then (180 -) else id) (180 / pi * asin (min 1 (critical * sqrt (1 - 1 / r) / r)))

-- | The edge of the shadow around holes of several spins.
kerrShadowPlot :: Plot
kerrShadowPlot =
  Plot
    { plotTitle = "Edge of the shadow for an observer at rest, r = 20, inclination 80°",
      plotAcross = Axis "degrees to the right" (Steps [-10, -7 .. 17]),
      plotUp = Axis "degrees upwards" (Steps [-8, -4 .. 8]),
      plotSeries =
        Points
          "#222222"
          "reference, 30 and 45 digits"
          ( concat
              [ [(left, 0), (right, 0), (0, up), (0, negate up)]
                | (_, _, left, right, up) <- references
              ]
          ) :
          [ Curve colour ("spin " ++ show s) (map (outline hole) [0, 0.01 .. 2 * pi + 0.01])
            | (s, colour, _, _, _) <- reverse references,
              Just hole <- [spin s]
          ]
    }
  where
    -- From test/reference/kerr-shadow.csv: along the horizontal and upwards.
    references =
      [ (-0.7, "#d08020", -9.0167011701096698, 5.0518184862784752, 7.0026789044901205),
        (0, "#999999", -7.2740048811844336, 7.2740048811844336, 7.2740048811844336),
        (0.6, "#2060c0", -5.4354263001410861, 8.7818693523571488, 7.0793515563852235),
        (0.999, "#c02020", -3.0169931180405048, 9.698938177063176, 6.651632434663172)
      ]
    outline hole alpha = case shadow hole (Place 20 (80 * pi / 180)) of
      Just edge
        | Direction nr ntheta nphi <- shadowEdge edge alpha ->
          (180 / pi * atan2 nphi (negate nr), 180 / pi * atan2 (negate ntheta) (negate nr))
      Nothing -> (0 / 0, 0 / 0)

-- | The error of the table of the sky around rotating holes.
kerrTablePlot :: Plot
kerrTablePlot =
  Plot
    { plotTitle = "Table of the sky, r = 30, inclination 80°: error of the direction",
      plotAcross = Axis "angle from the edge of the shadow (rad)" (decades (-7) 0),
      plotUp = Axis "error (rad)" (decades (-12) (-5)),
      plotSeries =
        [ Points
            colour
            ("spin " ++ show s)
            ( concat
                [ errors hole (skyTable hole place) around away
                  | around <- [0.2, 0.7 .. 6.2],
                    away <- geometric 1e-7 1 30
                ]
            )
          | (s, colour) <- [(0.998, "#c02020"), (0.9, "#d08020"), (0.3, "#2060c0")],
            Just hole <- [spin s]
        ]
    }
  where
    place = Place 30 (80 * pi / 180)
    errors hole table alpha away =
      [ (away, XYZ.distance found known)
        | Just edge <- [shadow hole place],
          let Direction nr ntheta nphi = shadowEdge edge alpha
              across = sqrt (ntheta * ntheta + nphi * nphi)
              psi = atan2 across (negate nr) + away
              tilt = sin psi / across
              direction = Direction (negate (cos psi)) (tilt * ntheta) (tilt * nphi),
          Just ray <- [lightRay hole place AtRest direction],
          Just (Escaped found) <- [tabulatedFate table (BoyerLindquist 0) ray],
          Escaped known <- [kerrFate (kerrPath hole (BoyerLindquist 0) ray)]
      ]

-- | Degrees between the direction of the hole and the edge of the shadow.
seenBy :: Observer -> Double -> Double
seenBy observer r = 180 / pi * bisect dark 0 pi
  where
    dark psi =
      case sightLine Schwarzschild observer (XYZ 0 0 r) (XYZ (sin psi) 0 (negate (cos psi))) of
        Just (SightLine photon _) | Escaped _ <- orbitFate (orbitOf photon) -> False
        _ -> True
    orbitOf photon@(Photon x v) = orbit r (XYZ.dot x v / r) (XYZ.norm (angularMomentum photon) / r)

-- | The error of the direction of light from r = 30 with this impact parameter,
-- relative to the closed form.
directionError :: Double -> Double -> Double
directionError b l =
  case ( followedFate
           (followLeapfrog settings Schwarzschild emptyRegion photon (\() _ -> Continue ()) ()),
         orbitFate path
       ) of
    (Escaped d, Escaped _) ->
      XYZ.distance d (XYZ (sin (alpha + orbitSweep path)) 0 (cos (alpha + orbitSweep path)))
    _ -> 0 / 0
  where
    path = orbit 30 (XYZ.dot x v / 30) (b / 30)
    settings = defaultLeapfrog {leapfrogSteps = EqualSteps l, leapfrogSkyRadius = 2000}
    speed = sqrt (1 + b * b / 27000)
    p = b / speed
    photon@(Photon x@(XYZ px _ pz) v) =
      Photon (XYZ p 0 (sqrt (900 - p * p))) (XYZ 0 0 (negate speed))
    alpha = atan2 px pz

critical :: Double
critical = 1.5 * sqrt 3

geometric :: Double -> Double -> Int -> [Double]
geometric from to count =
  [from * (to / from) ** (fromIntegral i / fromIntegral count) | i <- [0 .. count]]

-- | A diagram with a legend.
data Plot = Plot
  { plotTitle :: String,
    plotAcross :: Axis,
    plotUp :: Axis,
    plotSeries :: [Series]
  }

-- | A metadata and a scale.
data Axis = Axis String Scale

-- | The metadata of a scale; the first and the last are at its ends.
data Scale
  = -- | Powers of ten.
    Powers [Int]
  | Steps [Double]

decades :: Int -> Int -> Scale
decades from to = Powers [from .. to]

-- | Colour, name in the legend (none if empty), and points.
data Series
  = Curve String String [(Double, Double)]
  | Points String String [(Double, Double)]

-- | The position of a number on a scale, 0 to 1.
position :: Scale -> Double -> Double
position scale v = case scale of
  Powers marks -> between (map fromIntegral marks) (logBase 10 v)
  Steps marks -> between marks v
  where
    between marks x = (x - minimum marks) / (maximum marks - minimum marks)

plotSvg :: Plot -> String
plotSvg (Plot title (Axis labelX scaleX) (Axis labelY scaleY) series) =
  unlines $
    [ "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 640 420\" width=\"640\" \
      \height=\"420\" font-family=\"sans-serif\" font-size=\"12\">",
      "<rect width=\"640\" height=\"420\" fill=\"#ffffff\"/>",
      "<clipPath id=\"frame\"><rect x=\"70\" y=\"40\" width=\"540\" height=\"320\"/></clipPath>",
      text 340 24 "middle" 15 title,
      text 340 402 "middle" 12 labelX,
      "<g transform=\"translate(18 200) rotate(-90)\">" ++ text 0 0 "middle" 12 labelY ++ "</g>"
    ]
      ++ concat
        [ line x 40 x 360 "#e4e4e4" ++ [text x 378 "middle" 12 mark]
          | (v, mark) <- marks scaleX,
            let x = across v
        ]
      ++ concat
        [ line 70 y 610 y "#e4e4e4" ++ [text 64 (y + 4) "end" 12 mark]
          | (v, mark) <- marks scaleY,
            let y = up v
        ]
      ++ [ "<rect x=\"70\" y=\"40\" width=\"540\" height=\"320\" fill=\"none\" \
           \stroke=\"#444444\"/>",
           "<g clip-path=\"url(#frame)\">"
         ]
      ++ concatMap draw series
      ++ ["</g>"]
      ++ concat (zipWith legend [58, 76 ..] [s | s <- reverse series, not (null (named s))])
      ++ ["</svg>"]
  where
    across v = 70 + 540 * position scaleX v
    up v = 360 - 320 * position scaleY v
    marks (Powers powers) = [(10 ^^ n, if abs n > 3 then "1e" ++ show n else plain n) | n <- powers]
    marks (Steps values) = [(v, short v) | v <- values]
    plain n =
      if n >= 0 then show (10 ^ n :: Int) else showFFloat (Just (negate n)) (10 ^^ n :: Double) ""
    short v = show (round v :: Int)
    named (Curve _ name _) = name
    named (Points _ name _) = name
    draw (Curve colour _ places) =
      [ "<polyline fill=\"none\" stroke=\"" ++ colour ++ "\" stroke-width=\"1.5\" points=\""
          ++ unwords [number (across x) ++ "," ++ number (up y) | (x, y) <- places]
          ++ "\"/>"
      ]
    draw (Points colour _ places) = [dot colour (across x) (up y) | (x, y) <- places, not (isNaN y)]
    legend y s = case s of
      Curve colour name _ -> line 560 y 590 y colour ++ [text 552 (y + 4) "end" 12 name]
      Points colour name _ -> [dot colour 575 y, text 552 (y + 4) "end" 12 name]
    dot :: String -> Double -> Double -> String
    dot colour x y =
      "<circle cx=\"" ++ number x ++ "\" cy=\"" ++ number y ++ "\" r=\"3\" fill=\"" ++ colour
        ++ "\"/>"
    line :: Double -> Double -> Double -> Double -> String -> [String]
    line x1 y1 x2 y2 colour =
      [ "<line x1=\"" ++ number x1 ++ "\" y1=\"" ++ number y1 ++ "\" x2=\"" ++ number x2
          ++ "\" y2=\""
          ++ number y2
          ++ "\" stroke=\""
          ++ colour
          ++ "\" stroke-width=\"1.5\"/>"
      ]
    text :: Double -> Double -> String -> Int -> String -> String
    text x y anchor size content =
      "<text x=\"" ++ number x ++ "\" y=\"" ++ number y ++ "\" text-anchor=\"" ++ anchor
        ++ "\" font-size=\""
        ++ show size
        ++ "\">"
        ++ content
        ++ "</text>"
    number v = showFFloat (Just 1) v ""
