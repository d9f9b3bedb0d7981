-- | The figure of parallel light rays that pass the hole.
module BlackHole.Figure.RayFan
  ( RayFan (..),
    defaultRayFan,
    fanImpactParameters,
    fanCriticalParameters,
    RayClass (..),
    rayClass,
    rayFanFigure,
  )
where

import BlackHole.Figure.Figure
import BlackHole.Numeric.Angle (Radians (..))
import BlackHole.Spacetime.Fate
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

-- | The parameters of the figure.
data RayFan = RayFan
  { -- | Number of rays.
    fanRays :: !Int,
    -- | Half the figure's width in Schwarzschild radii, at least 4: the critical impact
    -- parameter must fit into three quarters of it.
    fanExtent :: !Double,
    -- | Width of the whole figure in pixels.
    fanWidth :: !Int,
    -- | The hole's spin. With spin the rays lie in the equatorial plane, seen from the
    -- side of the spin vector: a positive spin turns anticlockwise.
    fanSpin :: !Spin
  }
  deriving (Eq, Show)

-- | 31 rays, eight Schwarzschild radii to either side, 1200 pixels, and no spin.
defaultRayFan :: RayFan
defaultRayFan = RayFan 31 8 1200 noSpin

-- | The ratio of height to width of the plotted rectangle.
aspect :: Double
aspect = 0.75

-- | The impact parameters, signed as the height at which the light comes in, that lead
-- to the photon orbits: below the hole and above it. Light that passes below turns
-- anticlockwise.
fanCriticalParameters :: Spin -> (Double, Double)
fanCriticalParameters hole
  | hole == noSpin = (negate criticalImpactParameter, criticalImpactParameter)
  | otherwise =
    ( negate (criticalAngularMomentum RightHanded hole),
      negate (criticalAngularMomentum LeftHanded hole)
    )

-- | The signed impact parameters of the rays in ascending order. From eight rays on,
-- four of them lie within a thousandth of the critical impact parameters, on both sides
-- of them and of the hole. The others are evenly spaced over the figure's height.
fanImpactParameters :: RayFan -> [Double]
fanImpactParameters (RayFan count extent _ hole)
  | count < 8 = spread count
  | otherwise = merge (spread (count - 4)) critical
  where
    top = 0.96 * aspect * extent
    spread n
      | n <= 1 = [0 | n == 1]
      | otherwise = [top * (2 * fromIntegral k / fromIntegral (n - 1) - 1) | k <- [0 .. n - 1]]
    critical =
      [b * f | (b, f) <- [(below, 1.001), (below, 0.999), (above, 0.999), (above, 1.001)]]
    (below, above) = fanCriticalParameters hole
    merge (a : as) (b : bs)
      | a <= b = a : merge as (b : bs)
      | otherwise = b : merge (a : as) bs
    merge as bs = as ++ bs

-- | The classes of rays, which determine their colours.
data RayClass
  = -- | The ray leaves again.
    Escaping
  | -- | The ray falls in.
    Falling
  | -- | The ray goes around the hole at least once, whatever its end.
    Winding
  deriving (Eq, Show, Enum, Bounded)

-- | The class of a ray.
rayClass :: Trajectory -> RayClass
rayClass trajectory
  | trajectorySweep trajectory >= 2 * pi = Winding
  | otherwise = case trajectoryFate trajectory of
    Escaped _ -> Escaping
    _ -> Falling

-- | The class of a ray around a rotating hole, with its turns counted down to midway
-- between the horizon and the innermost photon orbit: farther in all light turns with
-- the hole.
equatorialClass :: Spin -> EquatorialRay -> RayClass
equatorialClass hole ray
  | abs (sum (zipWith turned azimuths (drop 1 azimuths))) >= 2 * pi = Winding
  | equatorialEscapes ray = Escaping
  | otherwise = Falling
  where
    azimuths = [phi | (r, phi) <- equatorialPoints ray, r > innermost]
    innermost =
      0.5
        * ( Kerr.horizonRadius hole
              + min (photonOrbitRadius RightHanded hole) (photonOrbitRadius LeftHanded hole)
          )
    turned from to = let d = to - from in d - 2 * pi * fromIntegral (round (d / (2 * pi)) :: Int)

-- | The line of sight whose plane contains the rays. It comes from +y, which the figure
-- turns to its left edge.
fanSight :: Sight
fanSight = Sight (Radians 0) (Radians 0)

-- | The figure: rays from the left edge, the hole, the photon sphere, the critical
-- impact parameter, axes in Schwarzschild radii, and a legend.
rayFanFigure :: RayFan -> Figure
rayFanFigure fan@(RayFan _ extent width rotation) =
  Figure
    { figureWidth = width,
      figureHeight = ceiling (top + plotHeight + 3.4 * font),
      figureTitle =
        "Parallel light rays from infinity "
          ++ ( if rotating
                 then "in the equatorial plane of a black hole with spin " ++ spinText
                 else "around a black hole"
             )
          ++ ", lengths in Schwarzschild radii",
      figureShapes =
        [ Clipped
            plot
            (if rotating then hole ++ rayShapes ++ asymptotes else rayShapes ++ asymptotes ++ hole),
          frame
        ]
          ++ concatMap xTick ticks
          ++ concatMap yTick yTicks
          ++ titles
          ++ legend
          ++ marks
    }
  where
    w = fromIntegral width
    font = w / 58
    left = 4 * font
    top = 3.2 * font
    plotWidth = w - left - 1.2 * font
    plotHeight = aspect * plotWidth
    unit = plotWidth / (2 * extent)
    plot = Box left top plotWidth plotHeight
    at x y = XY (left + 0.5 * plotWidth + unit * x) (top + 0.5 * plotHeight - unit * y)
    hairline = max 0.8 (w / 1200)

    rotating = rotation /= noSpin
    rayShapes = concatMap drawnRay drawingOrder
    spinText = show (dimensionlessSpin rotation)
    (criticalBelow, criticalAbove) = fanCriticalParameters rotation

    -- Winding rays are on top, because they share their paths with others.
    drawingOrder =
      [ (kind, points)
        | kind <- [Escaping, Falling, Winding],
          b <- fanImpactParameters fan,
          let (found, points) = if rotating then rotatingRay b else staticRay b,
          found == kind
      ]
    staticRay b =
      (rayClass trajectory, map (spot (b < 0)) (trajectoryPoints farthest 0.03 trajectory))
      where
        trajectory = trajectoryFromInfinity fanSight (abs b)
    rotatingRay b =
      ( equatorialClass rotation ray,
        [at (r * cos phi) (r * sin phi) | (r, phi) <- equatorialPoints ray]
      )
      where
        ray = equatorialRay rotation farthest 0.03 pi (negate b)
    farthest = 1.6 * extent
    drawnRay (kind, points) =
      case points of
        [] -> []
        _ ->
          Polyline (Stroke (classColour kind) (1.9 * hairline) Nothing) points :
          arrowOn
            (classColour kind)
            points
    spot mirrored (TrajectoryPoint _ (Photon (XYZ x y _) _)) =
      at
        (negate y)
        (if mirrored then negate x else x)

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
    XY arrowLine _ = at (-0.56 * extent) 0

    asymptotes =
      [ Polyline
          (Stroke ink (1.5 * hairline) (Just (7 * hairline, 5 * hairline)))
          [at (-extent) b, at extent b]
        | b <- [criticalAbove, criticalBelow]
      ]
    hole
      | rotating =
        [ Disc ergosphereColour (at 0 0) (unit * ergosphereRadius rotation 0),
          Disc ink (at 0 0) (unit * Kerr.horizonRadius rotation),
          Ring
            (Stroke ink (1.5 * hairline) nearDashes)
            (at 0 0)
            (unit * photonOrbitRadius prograde rotation),
          Ring
            (Stroke ink (1.5 * hairline) farDashes)
            (at 0 0)
            (unit * photonOrbitRadius retrograde rotation)
        ]
      | otherwise =
        [ Disc ink (at 0 0) (unit * horizonRadius),
          Ring (Stroke ink (1.5 * hairline) nearDashes) (at 0 0) (unit * photonSphereRadius)
        ]
    nearDashes = Just (4 * hairline, 5 * hairline)
    farDashes = Just (9 * hairline, 4 * hairline)
    (prograde, retrograde)
      | dimensionlessSpin rotation < 0 = (LeftHanded, RightHanded)
      | otherwise = (RightHanded, LeftHanded)
    marks =
      [ Words . Label (at (-0.97 * extent) (b + rise * font / unit)) AtStart font ink True $
          [ Plain ("b = " ++ sign ++ "b"),
            Subscript "c",
            Plain (" = " ++ sign ++ decimals 3 (abs b))
          ]
        | (b, sign, rise) <- [(criticalAbove, "", 0.5), (criticalBelow, "\8722", -1.15)]
      ]

    frame =
      Polyline
        (Stroke axisColour hairline Nothing)
        [at (-extent) h, at extent h, at extent (-h), at (-extent) (-h), at (-extent) h]
    h = aspect * extent
    spacing = tickSpacing extent
    ticks = tickPlaces extent
    yTicks = tickPlaces h
    tickPlaces reach =
      let n = floor (reach / spacing * (1 + 1e-9)) :: Int
       in [spacing * fromIntegral k | k <- [-n .. n]]
    tick = 0.4 * font
    xTick x =
      let XY px py = at x (-h)
       in [ Polyline (Stroke axisColour hairline Nothing) [XY px py, XY px (py + tick)],
            plain AtMiddle (XY px (py + tick + font)) (tickText x)
          ]
    yTick y =
      let XY px py = at (-extent) y
       in [ Polyline (Stroke axisColour hairline Nothing) [XY px py, XY (px - tick) py],
            plain AtEnd (XY (px - 1.6 * tick) (py + 0.35 * font)) (tickText y)
          ]
    plain anchor place s = Words (Label place anchor font axisColour False [Plain s])
    titles =
      [ Words
          ( Label
              (let XY px py = at 0 (-h) in XY px (py + 2.9 * font))
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

    legend = concat (zipWith entry [0 :: Int ..] legendEntries)
    legendEntries =
      [ (sampleLine (classColour Escaping) Nothing, "escapes"),
        (sampleLine (classColour Falling) Nothing, "captured"),
        (sampleLine (classColour Winding) Nothing, "winds around the hole")
      ]
        ++ landmarkEntries
    landmarkEntries
      | rotating =
        [ (sampleDisc ink, "horizon, " ++ decimals 3 (Kerr.horizonRadius rotation)),
          (sampleDisc ergosphereColour, "ergosphere, 1"),
          ( sampleLine ink nearDashes,
            "prograde, " ++ decimals 3 (photonOrbitRadius prograde rotation)
          ),
          ( sampleLine ink farDashes,
            "retrograde photon orbit, " ++ decimals 3 (photonOrbitRadius retrograde rotation)
          )
        ]
      | otherwise =
        [ (sampleDisc ink, "horizon, r = 1"),
          (sampleLine ink nearDashes, "photon sphere, r = 1.5")
        ]
    -- Space for the preceding entries in units of the legend's font size, sufficient
    -- for the widest common sans-serif fonts.
    legendStart n = left + legendFont * sum (take n widths)
    widths = [7.8, 8.6, 15.4] ++ (if rotating then [11, 10.5, 11] else [11 :: Double])
    legendFont = (if rotating then 0.66 else 0.86) * font
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
      [Polyline (Stroke colour (2.2 * hairline) gaps) [XY x y, XY (x + 1.7 * legendFont) y]]
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
