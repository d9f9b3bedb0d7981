-- | How far a path whose every point is known exactly may advance at once.
--
-- Outside the gas nothing happens, so the step is as long as the distance to
-- it allows; inside, it is short against the gas's structure. The steps decide
-- where the gas is sampled, never where the light goes.
module BlackHole.Physics.March
  ( marchLength,
    enclosingRadius,
  )
where

import BlackHole.Physics.LightPath
import BlackHole.Vector.XYZ (XYZ (..))

-- | Length in Schwarzschild radii of the stretch that begins at a point, for a
-- path that climbs at this rate there (height per length, −1…1).
marchLength :: Region -> XYZ -> Double -> Double
marchLength region (XYZ x y z) climb
  | gap > inside = min (0.7 * gap) (0.3 * sqrt (rho2 + y * y))
  | otherwise = inside
  where
    rho2 = x * x + z * z
    rho = sqrt rho2
    height = halfHeightAt region rho
    flare = regionFlare region
    -- A lower bound of the distance to the region. It is measured in a straight
    -- line and the path's length is predicted from its start, so a part of it
    -- is kept back: with no more than 0.3 of the radius at once, the length
    -- walked exceeds the one predicted by less than that part.
    gap = max ((abs y - height) / sqrt (1 + flare * flare)) (rho - regionRadius region)
    -- On the axis of a flared region the height vanishes; the gas there lies
    -- inside the hole.
    inside =
      min (regionLongestStep region * max 0.5 rho) $
        regionVerticalStep region * max (0.5 * flare) height / max 1e-3 (abs climb)
{-# INLINE marchLength #-}

-- | Radius of the sphere that holds the whole region; 0 if it is empty.
enclosingRadius :: Region -> Double
enclosingRadius region
  | height < 0 || radius <= 0 = 0
  | otherwise = sqrt (radius * radius + height * height)
  where
    radius = regionRadius region
    height = halfHeightAt region radius
