-- | The step length along a path whose points are all known exactly.
--
-- Outside the gas a step is as long as the distance to the gas allows; inside, it is
-- short compared with the structure of the gas. The steps decide where the gas is
-- sampled, never where the light goes.
module BlackHole.Spacetime.March
  ( marchLength,
    enclosingRadius,
  )
where

import BlackHole.Spacetime.LightPath
import BlackHole.Vector.XYZ (XYZ (..))

-- | Length in Schwarzschild radii of the segment that begins at a point, for a path
-- with this rate of climb (height per length, −1 to 1).
marchLength :: Region -> XYZ -> Double -> Double
marchLength region (XYZ x y z) climb
  | gap > inside = min (0.7 * gap) (0.3 * sqrt (rho2 + y * y))
  | otherwise = inside
  where
    rho2 = x * x + z * z
    rho = sqrt rho2
    height = halfHeightAt region rho
    flare = regionFlare region
    -- A lower bound on the distance to the region. It is measured along a straight line
    -- and the path's length is predicted from its start, so the step keeps a margin:
    -- for at most 0.3 of the radius at a time, the length travelled exceeds the
    -- predicted one by less than the margin.
    gap = max ((abs y - height) / sqrt (1 + flare * flare)) (rho - regionRadius region)
    -- On the axis of a flared region the height vanishes; the gas there is inside the
    -- hole.
    inside =
      min (regionLongestStep region * max 0.5 rho) $
        regionVerticalStep region * max (0.5 * flare) height / max 1e-3 (abs climb)
{-# INLINE marchLength #-}

-- | Radius of the sphere around the whole region; 0 if the region is empty.
enclosingRadius :: Region -> Double
enclosingRadius region
  | height < 0 || radius <= 0 = 0
  | otherwise = sqrt (radius * radius + height * height)
  where
    radius = regionRadius region
    height = halfHeightAt region radius
