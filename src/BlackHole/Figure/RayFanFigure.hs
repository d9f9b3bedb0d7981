-- | The drawing of the rays that pass the hole.
module BlackHole.Figure.RayFanFigure
  ( rayFanFigure,
  )
where

import BlackHole.Figure.Figure
import BlackHole.Figure.RayFan
import BlackHole.Spacetime.Kerr.EquatorialRay
import BlackHole.Spacetime.Kerr.Landmarks hiding (horizonRadius)
import qualified BlackHole.Spacetime.Kerr.Landmarks as Kerr
import BlackHole.Spacetime.Photon (Photon (..))
import BlackHole.Spacetime.Schwarzschild.Radii
import BlackHole.Spacetime.Schwarzschild.Trajectory
import BlackHole.Spacetime.Schwarzschild.TrajectoryPoints
import BlackHole.Vector.XY (XY (..))
import qualified BlackHole.Vector.XY as XY
import BlackHole.Vector.XYZ (XYZ (..))
import Numeric (showFFloat)

-- | The figure: rays from the left edge, the hole, the photon sphere, the critical
-- impact parameter, axes in Schwarzschild radii, and a legend.
rayFanFigure :: RayFan -> Figure
rayFanFigure fan =
  Figure
    { figureWidth = fanWidth fan,
      figureHeight = ceiling (top + height + 3.4 * plotFont plot),
      figureTitle =
        "Parallel light rays from infinity "
          ++ ( if isRotating fan
                 then
                   "in the equatorial plane of a black hole with spin "
                     ++ show (dimensionlessSpin (fanSpin fan))
                 else "around a black hole"
             )
          ++ ", lengths in Schwarzschild radii",
      figureShapes =
        [ Clipped
            (plotBox plot)
            ( if isRotating fan
                then holeShapes plot ++ rayShapes plot ++ asymptotes plot
                else rayShapes plot ++ asymptotes plot ++ holeShapes plot
            ),
          frame plot
        ]
          ++ axes plot
          ++ legend plot
          ++ marks plot
    }
  where
    plot = plotOf fan
    Box _ top _ height = plotBox plot

-- | The figure with its plotted rectangle, in pixels.
data Plot = Plot
  { plotFan :: !RayFan,
    -- | The size of the letters.
    plotFont :: !Double,
    plotBox :: !Box,
    -- | Pixels per Schwarzschild radius.
    plotUnit :: !Double
  }

plotOf :: RayFan -> Plot
plotOf fan@(RayFan _ extent width _) =
  Plot fan font (Box left (3.2 * font) plotWidth (aspect * plotWidth)) (plotWidth / (2 * extent))
  where
    w = fromIntegral width
    font = w / 58
    left = 4 * font
    plotWidth = w - left - 1.2 * font

-- | The pixel of a point in Schwarzschild radii.
at :: Plot -> Double -> Double -> XY
at (Plot _ _ (Box left top width height) unit) x y =
  XY (left + 0.5 * width + unit * x) (top + 0.5 * height - unit * y)

-- | The width of thin lines.
hairline :: Plot -> Double
hairline plot = max 0.8 (fromIntegral (fanWidth (plotFan plot)) / 1200)

isRotating :: RayFan -> Bool
isRotating fan = fanSpin fan /= noSpin

-- | The photon orbits with and against the hole's rotation.
prograde, retrograde :: Spin -> Handedness
prograde hole = if dimensionlessSpin hole < 0 then LeftHanded else RightHanded
retrograde hole = if dimensionlessSpin hole < 0 then RightHanded else LeftHanded

-- | The rays with their arrows.
rayShapes :: Plot -> [Shape]
rayShapes plot = concatMap drawnRay drawingOrder
  where
    fan@(RayFan _ extent _ rotation) = plotFan plot
    font = plotFont plot
    -- Winding rays are on top, because they share their paths with others.
    drawingOrder =
      [ (kind, points)
        | kind <- [Escaping, Falling, Winding],
          b <- fanImpactParameters fan,
          let (found, points) = if isRotating fan then rotatingRay b else staticRay b,
          found == kind
      ]
    staticRay b =
      (rayClass trajectory, map (spot (b < 0)) (trajectoryPoints farthest 0.03 trajectory))
      where
        trajectory = trajectoryFromInfinity fanSight (abs b)
    rotatingRay b =
      ( equatorialClass rotation ray,
        [at plot (r * cos phi) (r * sin phi) | (r, phi) <- equatorialPoints ray]
      )
      where
        ray = equatorialRay rotation farthest 0.03 pi (negate b)
    farthest = 1.6 * extent
    drawnRay (kind, points) =
      if null points
        then []
        else
          Polyline (Stroke (classColour kind) (1.9 * hairline plot) Nothing) points :
          arrowOn (classColour kind) points
    spot mirrored (TrajectoryPoint _ (Photon (XYZ x y _) _)) =
      at plot (negate y) (if mirrored then negate x else x)

    -- Where a ray first crosses a line to the left of the hole, pointing along the ray.
    arrowOn colour points =
      take
        1
        [ Polygon
            colour
            [ XY (x + 0.45 * font) y,
              XY (x - 0.3 * font) (y + 0.28 * font),
              XY (x - 0.3 * font) (y - 0.28 * font)
            ]
          | (p@(XY px _), q@(XY qx _)) <- zip points (drop 1 points),
            px < arrowLine,
            qx >= arrowLine,
            let XY x y = XY.lerp ((arrowLine - px) / (qx - px)) p q
        ]
    XY arrowLine _ = at plot (-0.56 * extent) 0

-- | The lines of rays with the critical impact parameters.
asymptotes :: Plot -> [Shape]
asymptotes plot =
  [ Polyline
      (Stroke ink (1.5 * hairline plot) (Just (7 * hairline plot, 5 * hairline plot)))
      [at plot (-extent) b, at plot extent b]
    | b <- [criticalAbove, criticalBelow]
  ]
  where
    extent = fanExtent (plotFan plot)
    (criticalBelow, criticalAbove) = fanCriticalParameters (fanSpin (plotFan plot))

-- | The hole, its ergosphere and its photon orbits.
holeShapes :: Plot -> [Shape]
holeShapes plot
  | isRotating fan =
    [ Disc ergosphereColour (at plot 0 0) (unit * ergosphereRadius rotation 0),
      Disc ink (at plot 0 0) (unit * Kerr.horizonRadius rotation),
      Ring
        (Stroke ink (1.5 * hairline plot) (nearDashes plot))
        (at plot 0 0)
        (unit * photonOrbitRadius (prograde rotation) rotation),
      Ring
        (Stroke ink (1.5 * hairline plot) (farDashes plot))
        (at plot 0 0)
        (unit * photonOrbitRadius (retrograde rotation) rotation)
    ]
  | otherwise =
    [ Disc ink (at plot 0 0) (unit * horizonRadius),
      Ring
        (Stroke ink (1.5 * hairline plot) (nearDashes plot))
        (at plot 0 0)
        (unit * photonSphereRadius)
    ]
  where
    fan@(RayFan _ _ _ rotation) = plotFan plot
    unit = plotUnit plot

-- | The dashes of the nearer photon orbit and of the farther one.
nearDashes, farDashes :: Plot -> Maybe (Double, Double)
nearDashes plot = Just (4 * hairline plot, 5 * hairline plot)
farDashes plot = Just (9 * hairline plot, 4 * hairline plot)

-- | The labels of the critical impact parameters.
marks :: Plot -> [Shape]
marks plot =
  [ Words . Label (at plot (-0.97 * extent) (b + rise * font / unit)) AtStart font ink True $
      [ Plain ("b = " ++ sign ++ "b"),
        Subscript name,
        Plain (" = " ++ sign ++ decimals 3 (abs b))
      ]
    | (b, sign, rise, name) <-
        [ (criticalAbove, "", 0.5, sense LeftHanded),
          (criticalBelow, "\8722", -1.15, sense RightHanded)
        ]
  ]
  where
    -- Light that passes below the hole turns right-handed.
    sense handedness
      | not (isRotating fan) = "c"
      | handedness == prograde (fanSpin fan) = "prograde"
      | otherwise = "retrograde"
    fan = plotFan plot
    extent = fanExtent fan
    font = plotFont plot
    unit = plotUnit plot
    (criticalBelow, criticalAbove) = fanCriticalParameters (fanSpin fan)

-- | The border of the plotted rectangle.
frame :: Plot -> Shape
frame plot =
  Polyline
    (Stroke axisColour (hairline plot) Nothing)
    [ at plot (-extent) h,
      at plot extent h,
      at plot extent (-h),
      at plot (-extent) (-h),
      at plot (-extent) h
    ]
  where
    extent = fanExtent (plotFan plot)
    h = aspect * extent

-- | Ticks with their numbers, and the axes' titles.
axes :: Plot -> [Shape]
axes plot = concatMap xTick ticks ++ concatMap yTick yTicks ++ titles
  where
    extent = fanExtent (plotFan plot)
    font = plotFont plot
    Box _ top _ _ = plotBox plot
    h = aspect * extent
    spacing = tickSpacing extent
    ticks = tickPlaces extent
    yTicks = tickPlaces h
    tickPlaces reach =
      let n = floor (reach / spacing * (1 + 1e-9)) :: Int
       in [spacing * fromIntegral k | k <- [-n .. n]]
    tick = 0.4 * font
    xTick x =
      let XY px py = at plot x (-h)
       in [ Polyline (Stroke axisColour (hairline plot) Nothing) [XY px py, XY px (py + tick)],
            plain AtMiddle (XY px (py + tick + font)) (tickText x)
          ]
    yTick y =
      let XY px py = at plot (-extent) y
       in [ Polyline (Stroke axisColour (hairline plot) Nothing) [XY px py, XY (px - tick) py],
            plain AtEnd (XY (px - 1.6 * tick) (py + 0.35 * font)) (tickText y)
          ]
    plain anchor place s = Words (Label place anchor font axisColour False [Plain s])
    titles =
      [ Words
          ( Label
              (let XY px py = at plot 0 (-h) in XY px (py + 2.9 * font))
              AtMiddle
              font
              axisColour
              False
              [Plain "x / r", Subscript "s"]
          ),
        Words
          ( Label
              (XY (0.6 * font) (top - 0.7 * font))
              AtStart
              font
              axisColour
              False
              [Plain "y / r", Subscript "s"]
          )
      ]
    tickText v
      | spacing >= 1 = signed (show (round (abs v) :: Int))
      | otherwise = signed (decimals 1 (abs v))
      where
        signed s = if v < -0.01 * spacing then '\8722' : s else s

-- | The colours of the rays, and the hole's parts with their radii.
legend :: Plot -> [Shape]
legend plot = concat (zipWith entry [0 :: Int ..] legendEntries)
  where
    fan@(RayFan _ _ _ rotation) = plotFan plot
    font = plotFont plot
    Box left top _ _ = plotBox plot
    legendEntries =
      [ (sampleLine (classColour Escaping) Nothing, "escapes"),
        (sampleLine (classColour Falling) Nothing, "captured"),
        (sampleLine (classColour Winding) Nothing, "winds around the hole")
      ]
        ++ landmarkEntries
    landmarkEntries
      | isRotating fan =
        [ (sampleDisc ink, "horizon, " ++ decimals 3 (Kerr.horizonRadius rotation)),
          (sampleDisc ergosphereColour, "ergosphere, 1"),
          (sampleLine ink (nearDashes plot), "prograde photon orbit, " ++ orbit prograde),
          (sampleLine ink (farDashes plot), "retrograde photon orbit, " ++ orbit retrograde)
        ]
      | otherwise =
        [ (sampleDisc ink, "horizon, r = 1"),
          (sampleLine ink (nearDashes plot), "photon sphere, r = 1.5")
        ]
    orbit sense = decimals 3 (photonOrbitRadius (sense rotation) rotation)
    -- Space for the preceding entries in units of the legend's font size, sufficient
    -- for the widest common sans-serif fonts.
    legendStart n = left + legendFont * sum (take n widths)
    widths = [7.8, 8.6, 15.4] ++ (if isRotating fan then [11, 10.5, 18] else [11 :: Double])
    legendFont = (if isRotating fan then 0.6 else 0.86) * font
    entry n (sample, s) =
      let x = legendStart n
          y = 0.45 * top
       in sample x y
            ++ [ Words
                   ( Label
                       (XY (x + 2.3 * legendFont) (y + 0.35 * legendFont))
                       AtStart
                       legendFont
                       axisColour
                       False
                       [Plain s]
                   )
               ]
    sampleLine colour gaps x y =
      [Polyline (Stroke colour (2.2 * hairline plot) gaps) [XY x y, XY (x + 1.7 * legendFont) y]]
    sampleDisc colour x y = [Disc colour (XY (x + 1.2 * legendFont) y) (0.5 * legendFont)]

-- | The distance between the axes' labels: 1, 2 or 5 times a power of ten, chosen to
-- give at most eight labels on each side.
tickSpacing :: Double -> Double
tickSpacing extent =
  firstOf
    [s | e <- [-1 .. 6 :: Int], m <- [1, 2, 5], let s = m * 10 ^^ e, extent / s <= 8.01]
  where
    firstOf candidates = case candidates of
      s : _ -> s
      [] -> extent

decimals :: Int -> Double -> String
decimals n v = showFFloat (Just n) v ""

-- | Colours that colour-blind readers can tell apart (after Okabe and Ito 2008).
classColour :: RayClass -> Colour
classColour kind = case kind of
  Escaping -> Colour 0 114 178
  Falling -> Colour 213 94 0
  Winding -> Colour 0 158 115

ink, axisColour, ergosphereColour :: Colour
ink = Colour 26 28 34
axisColour = Colour 70 74 84
ergosphereColour = Colour 204 206 212
