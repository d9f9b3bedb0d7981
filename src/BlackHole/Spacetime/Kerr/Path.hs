-- | Whole light paths around a Kerr hole, traced backwards from an observer: where
-- they run, where they end, and where they cross the equatorial plane. In closed
-- form ("BlackHole.Spacetime.Kerr.Radial", "BlackHole.Spacetime.Kerr.Latitude"), but
-- for rays so close to radial that they never turn
-- ("BlackHole.Spacetime.Kerr.PowerSeries").
module BlackHole.Spacetime.Kerr.Path
  ( KerrPath,
    kerrPath,
    kerrPathWith,
    Precision (..),
    kerrFate,
    kerrMinoTime,
    KerrPoint (..),
    kerrPoint,
    kerrPlanePoints,
    kerrPassages,
    kerrSweptAngle,
    kerrStraightAngle,
    ingoingLead,
  )
where

import BlackHole.Numeric.Angle (arcTangent2)
import BlackHole.Spacetime.Fate
import BlackHole.Spacetime.Kerr.Landmarks
import BlackHole.Spacetime.Kerr.Latitude
import BlackHole.Spacetime.Kerr.PowerSeries
import BlackHole.Spacetime.Kerr.Precision
import BlackHole.Spacetime.Kerr.Radial
import BlackHole.Spacetime.Kerr.RadialPotential (radialPotential)
import BlackHole.Spacetime.Kerr.Sight
import BlackHole.Vector.XYZ (XYZ (..))

-- | A light path.
data KerrPath = KerrPath
  { -- | The Mino time from the observer to the end, infinite for a path that
    -- approaches a photon orbit for ever.
    kerrMinoTime :: Double,
    -- | How the path ends.
    kerrFate :: Fate XYZ,
    -- | The point after a Mino time, which must not exceed that of the whole path.
    kerrPoint :: Double -> KerrPoint,
    -- | Where the path crosses the equatorial plane outside the horizon, in the
    -- order met from the observer, whose own place does not count. None for a
    -- path that lies in the plane; at most a thousand for one that circles for
    -- ever.
    kerrPlanePoints :: [KerrPoint],
    -- | @kerrPassages path r c@: the Mino times between which the path is within the
    -- radius @r@ and can have @|cos θ| ≤ c@, in order and apart from each other. At most
    -- a thousand for a path that circles for ever.
    kerrPassages :: Double -> Double -> [(Double, Double)],
    -- | The angle in radians swept to the end along the great circle that precesses;
    -- 'Nothing' for a ray without one, which is nearly radial.
    kerrSweptAngle :: Maybe Double
  }

-- | A point of a path.
data KerrPoint = KerrPoint
  { -- | Boyer–Lindquist's r.
    pointRadius :: !Double,
    -- | cos θ.
    pointCosine :: !Double,
    -- | Boyer–Lindquist's φ in radians, in [−π, π]; inside the horizon the ingoing
    -- azimuth.
    pointAzimuth :: !Double,
    -- | Whether the radius grows along the tracing.
    pointGrows :: !Bool,
    -- | d(cos θ)\/dτ.
    pointCosineRate :: !Double
  }
  deriving (Eq, Show)

-- | The angle that a straight line would sweep from the start of a ray to infinity.
kerrStraightAngle :: LightRay -> Double
kerrStraightAngle ray =
  arcTangent2
    (rayRadius ray * sqrt (turning * turning + rayPolarRate ray * rayPolarRate ray))
    (rayRadialRate ray)
  where
    turning = rayLambda ray / raySine ray

-- | The path of a ray from an observer at an azimuth.
kerrPath :: Spin -> Azimuth -> LightRay -> KerrPath
kerrPath = kerrPathWith FullPrecision

-- | 'kerrPath' with a choice of precision.
kerrPathWith :: Precision -> Spin -> Azimuth -> LightRay -> KerrPath
kerrPathWith precision hole azimuth ray =
  case (radial precision hole ray, latitude precision hole ray) of
    (Just r, Just l) -> closedPath hole azimuth ray r l
    _ -> seriesOnly hole azimuth ray

closedPath :: Spin -> Azimuth -> LightRay -> Radial -> Latitude -> KerrPath
closedPath hole azimuth ray r l =
  KerrPath
    { kerrMinoTime = time,
      kerrFate = case end of
        _ | isInfinite time -> Circles
        AtHorizon -> Captured
        AtInfinity ->
          let phase = phaseAfter l time
              (z, x) = turned phase (stateAtEnd r)
           in Escaped (XYZ x (phaseCosine l phase) z),
      kerrPoint = \t -> pointAt t (phaseAfter l t),
      kerrPlanePoints =
        map (uncurry pointAt) (takeWhile ((< time) . fst) (take 1000 (planeCrossingTimes l))),
      kerrPassages = \limit steepest ->
        maybe [] (uncurry (timesNearPlane l steepest)) (timeWithin r limit),
      kerrSweptAngle =
        if isInfinite time
          then Nothing
          else Just (phaseAngle (phaseAfter l time) - phaseAngle (phaseAtStart l))
    }
  where
    (end, time) = radialEnd r
    a = spinLength hole
    lambda = rayLambda ray
    kappa = rayKappa ray
    inside = rayRadius ray <= horizonRadius hole
    pointAt t phase =
      KerrPoint
        { pointRadius = radius,
          pointCosine = phaseCosine l phase,
          pointAzimuth = arcTangent2 x z - correction,
          pointGrows = stateGrows state,
          pointCosineRate = phaseRate l phase
        }
      where
        state = stateAfter r t
        radius = stateRadius state
        (z, x) = turned phase state
        correction = if inside && radius > horizonRadius hole then ingoingLead hole radius else 0
    -- From inside the horizon light comes in the ingoing azimuth, which has no
    -- pole on its way.
    turned phase state =
      against (start + arcTangent2 s0 c0 - precession l phase - dragged) (greatCircle l phase)
      where
        dragged
          | inside = regularDragging regular r state
          | otherwise = dragging hole lambda r state
    start = case azimuth of
      Ingoing phi | not inside -> phi - ingoingLead hole (rayRadius ray)
      Ingoing phi -> phi
      BoyerLindquist phi -> phi
    (c0, s0) = greatCircle l (phaseAtStart l)
    regular q =
      a * kappa / (q * q + a * (a - lambda) + sqrt (max 0 (radialPotential hole ray q))) - a

seriesOnly :: Spin -> Azimuth -> LightRay -> KerrPath
seriesOnly hole azimuth ray =
  KerrPath
    { kerrMinoTime = time,
      kerrFate =
        if outward
          then
            let end = seriesPoint path time
                (z, x) = turned end
             in Escaped (XYZ x (seriesCosine end) z)
          else Captured,
      kerrPoint = pointAt,
      kerrPlanePoints =
        filter ((> horizonRadius hole) . pointRadius) (map pointAt (seriesCrossingTimes path)),
      kerrPassages = \limit steepest ->
        if steepest < 0.999 * leastCosine then [] else seriesPassages path limit steepest,
      kerrSweptAngle = Nothing
    }
  where
    path = seriesPath hole ray
    time = seriesEnd path
    -- The least |cos θ|: light with η < 0 stays on one side of the plane.
    leastCosine
      | rayEta ray < 0 = sqrt (max 0 (-2 * rayEta ray / (excess + sqrt (max 0 discriminant))))
      | otherwise = 0
    discriminant = excess * excess + 4 * a2 * rayEta ray
    excess = a2 - rayEta ray - rayLambda ray * rayLambda ray
    a2 = spinLength hole * spinLength hole
    outward = rayRadialRate ray > 0
    -- The azimuth in which the frame of the series turns: ingoing for light that
    -- falls towards the hole, whose tracing leads outwards, else outgoing.
    regular q = if outward then ingoingLead hole q else negate (ingoingLead hole q)
    start = case azimuth of
      Ingoing phi | outward -> phi
      Ingoing phi -> phi - 2 * ingoingLead hole (rayRadius ray)
      BoyerLindquist phi -> phi + regular (rayRadius ray)
    turned point =
      let (c, s) = seriesHorizontal point in against (start - seriesFrame point) (c, negate s)
    pointAt t =
      KerrPoint
        { pointRadius = r,
          pointCosine = seriesCosine point,
          pointAzimuth = arcTangent2 x z - (if r > horizonRadius hole then regular r else 0),
          pointGrows = outward,
          pointCosineRate = seriesCosineRate path t
        }
      where
        point = seriesPoint path t
        r = seriesRadius point
        (z, x) = turned point

-- | How far the ingoing azimuth is ahead of Boyer–Lindquist's at a radius.
ingoingLead :: Spin -> Double -> Double
ingoingLead hole r = spinLength hole / (outer - inner) * log (abs ((r - outer) / (r - inner)))
  where
    outer = horizonRadius hole
    inner = innerHorizonRadius hole

-- | @against φ (c, s)@: cosine and sine of φ less the angle with the cosine and sine
-- given, times the length of that pair.
against :: Double -> (Double, Double) -> (Double, Double)
against phi (c, s) = (cos phi * c + sin phi * s, sin phi * c - cos phi * s)
