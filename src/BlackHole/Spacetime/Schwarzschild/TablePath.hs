{-# LANGUAGE BangPatterns #-}

-- | Light paths evaluated only where they pass through the gas.
--
-- The plane of a path cuts the disk's plane every half turn, at swept angles that
-- follow from the directions alone. Each of these crossings lies in an interval in
-- which the path can be inside the gas; outside these intervals nothing needs to be
-- evaluated. Within an interval the path is a power series
-- ("BlackHole.Spacetime.Schwarzschild.OrbitSeries").
module BlackHole.Spacetime.Schwarzschild.TablePath
  ( followTable,
    tableFate,
    criticalOffset,
  )
where

import BlackHole.Spacetime.Fate
import BlackHole.Spacetime.LightPath
import BlackHole.Spacetime.Momentum
import BlackHole.Spacetime.PathPlane
import BlackHole.Spacetime.Photon
import BlackHole.Spacetime.Schwarzschild.GasLayer
import BlackHole.Spacetime.Schwarzschild.LensTable
import BlackHole.Spacetime.Schwarzschild.OrbitSeries
import BlackHole.Spacetime.Types (Spacetime (..), pullOfGravity)
import BlackHole.Vector.XY (XY (..))
import BlackHole.Vector.XYZ (XYZ (..), (*^), (^+^))

-- | The path of a photon of unit energy from its start at the table's radius, from the
-- table; a straight line without gravity.
seriesOf :: Spacetime -> LensTable -> Launch -> OrbitSeries
seriesOf Flat table (Launch _ radial tangential) = lineSeries u (negate radial * u / tangential)
  where
    u = 1 / lensTableRadius table
seriesOf _ table (Launch _ radial tangential) = lensSeries table radial tangential
{-# NOINLINE seriesOf #-}

-- | Follows a photon of unit energy ('withUnitEnergy') that starts at the table's
-- radius to its end. The phase, 0 to 1, is the length of the first segment in the gas
-- as a fraction of a whole step. Give neighbouring pixels different phases; otherwise
-- they all sample the gas at the same places.
-- Costs one step per segment of gas and about fifty nanoseconds per crossing.
--
-- The function is long because its three loops, from crossing to crossing, from cell to
-- cell and from sample to sample, call each other and keep their state in registers.
followTable ::
  Spacetime ->
  LensTable ->
  Region ->
  Double ->
  Photon ->
  (a -> PathSegment -> Continue a) ->
  a ->
  Followed a
followTable space table region phase photon gather = start
  where
    !r0 = lensTableRadius table
    !started@(Launch plane@(PathPlane e1@(XYZ x1 _ z1) e2@(XYZ x2 _ z2)) _ tangential) =
      launch r0 photon
    !b = r0 * tangential
    !affinePerArea = 1 / b
    !lambda = b * (x1 * z2 - z1 * x2)
    !(OrbitSeries fate lastAngle cellCount waypoints) = seriesOf space table started
    !spacing = lastAngle / fromIntegral cellCount
    !pull = pullOfGravity space
    end !n state = Followed (inSpace plane <$> fate) state n

    -- The sine of the latitude along the path is sine1 cos φ + sine2 sin φ.
    !(XYZ _ sine1 _) = e1
    !(XYZ _ sine2 _) = e2
    tilt = sqrt (sine1 * sine1 + sine2 * sine2)
    !layer = gasLayer region
    -- Light that starts outside the horizon never passes inside.
    steepestAll = steepest layer (min (layerInner layer) (max 1 (1 / r0)))
    widest = arcSine (min 1 (steepestAll / tilt))

    start state
      | regionHalfHeight region < 0 || regionRadius region <= 0 = end 0 state
      -- The path stays as close to the plane as the gas does.
      | steepestAll >= tilt = cells 0 phase 0 lastAngle (1 / 0) state
      -- A crossing before the start may reach to the start.
      | otherwise =
        let first =
              firstCrossing plane
         in crossing 0 (if first - pi + widest < 0 then first else first - pi) state

    crossing !n !angle !state
      | angle - widest > lastAngle = end n state
      | otherwise =
        let !cell = cellOf angle
            !(u, slope) = waypoint waypoints spacing cell
            !path = expand pull u slope
         in case reachOfCrossing layer tilt widest path (angle - middleOf cell) of
              NoReach -> crossing n (angle + pi) state
              Reach before after ->
                cells
                  n
                  phase
                  (max 0 (angle - before))
                  (min lastAngle (angle + after))
                  (angle + pi)
                  state

    cellOf angle = max 0 (min (cellCount - 1) (truncate (angle / spacing)))
    middleOf cell = (fromIntegral cell + 0.5) * spacing

    -- Gathers between two angles, cell by cell, and continues with the next crossing.
    cells !n !lead !from !to !next !state
      | from >= to = crossing n next state
      | otherwise =
        let !cell = cellOf from
            !middle = middleOf cell
            -- Rounding may leave an angle at the far end of its cell.
            !upper =
              if cell == cellCount - 1
                then to
                else min to (max (from + 1e-9) (middle + 0.5 * spacing))
            !(u, slope) = waypoint waypoints spacing cell
            !path = expand pull u slope
            cosine = cos middle
            sine = sin middle
            outward@(XYZ _ latitude _) = inSpace plane (XY cosine sine)
            onward@(XYZ _ climb _) = onwardAt plane cosine sine
            !t1 = upper - middle
         in case partOfCell layer path latitude climb (from - middle) t1 of
              Missed -> cells n lead upper to next state
              CellPart begin final leaving turn ->
                let -- A last step ends with the gas; a step that ends with the cell
                    -- continues into the next cell.
                    !limit = if final < leaving || upper < to && final >= t1 then 1 / 0 else final
                    !done = if final < leaving then middle + final else upper
                 in samples
                      n
                      begin
                      (lead * turn)
                      final
                      limit
                      turn
                      path
                      outward
                      onward
                      done
                      middle
                      to
                      next
                      state

    samples !n !t !wanted !final !limit !turn !path !out0 !on0 !upper !middle !to !next !state
      | t >= final = cells n 1 (max upper (middle + t)) to next state
      | otherwise =
        let !step = if limit - t < 1.4 * wanted then limit - t else wanted
            !tM = t + 0.5 * step
            !u = expansionValue path tM
            !slope = expansionSlope path tM
            !t2 = tM * tM
            !c = 1 - t2 * (0.5 - t2 * (1 / 24 - t2 * (1 / 720 - t2 * (1 / 40320))))
            !s = tM * (1 - t2 * (1 / 6 - t2 * (1 / 120 - t2 * (1 / 5040 - t2 * (1 / 362880)))))
            !outward@(XYZ _ sineLatitude _) = c *^ out0 ^+^ s *^ on0
            !grown = turn * growthAt layer u sineLatitude
            goOn =
              samples
                (n + 1)
                (t + step)
                grown
                final
                limit
                turn
                path
                out0
                on0
                upper
                middle
                to
                next
            {-# INLINE goOn #-}
         in if abs sineLatitude > steepest layer u || u < layerOuter layer || u > layerInner layer
              then goOn state
              else case gather state (segmentAt step u slope outward (c * climb - s * latitude)) of
                Continue state' -> goOn state'
                Stop state' -> Followed Opaque state' (n + 1)
      where
        XYZ _ latitude _ = out0
        XYZ _ climb _ = on0

    segmentAt step u slope outward@(XYZ _ sineLatitude _) climbing =
      PathSegment
        { segmentMiddle = r *^ outward,
          segmentRadius = r,
          segmentAffineLength = affinePerArea * area,
          segmentLength = area * sqrt (slope * slope + u * u),
          segmentRadialStep = negate slope * area,
          segmentVerticalStep = area * (u * climbing - slope * sineLatitude),
          segmentMomentum = Momentum (b * slope / (1 - u)) lambda
        }
      where
        r = 1 / u
        -- r² dφ: by it an angle becomes a length.
        area = step * r * r
    {-# INLINE segmentAt #-}
{-# INLINE followTable #-}

-- | The fate of the path that 'followTable' follows, if nothing is in the way.
tableFate :: Spacetime -> LensTable -> Photon -> Fate XYZ
tableFate space table photon = case space of
  Flat -> inSpace plane <$> seriesFate (seriesOf Flat table started)
  _ -> inSpace plane <$> lensFate table radial tangential
  where
    !started@(Launch plane radial tangential) = launch (lensTableRadius table) photon

-- | The 'lensOffset' of a photon of unit energy at the table's radius.
criticalOffset :: LensTable -> Photon -> Double
criticalOffset table photon = case launch (lensTableRadius table) photon of
  Launch _ radial tangential -> lensOffset table radial tangential
