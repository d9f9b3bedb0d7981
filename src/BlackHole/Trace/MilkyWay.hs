-- | A random band like the Milky Way: the light of stars too numerous to be seen one by
-- one, behind dust. "BlackHole.Trace.RealSky" has the real one.
module BlackHole.Trace.MilkyWay
  ( milkyWay,
  )
where

import BlackHole.Light.Radiance
import BlackHole.Noise.CachedNoise
import BlackHole.Noise.Lattice (unitLevel)
import BlackHole.Noise.PerlinG (Seed (..))
import BlackHole.Noise.Profile (normalised, octaves)
import BlackHole.Trace.EnvironmentMap
import BlackHole.Trace.Galaxy (toGalactic)
import BlackHole.Vector.XYZ (XYZ (..), (*^), (^+^))

-- | The band as an image of the sky, with radiance 1 where it is brightest. Clouds and
-- dust are noise on the sphere, the dust finer and closer to the middle of the band; a
-- bulge surrounds the galactic centre.
milkyWay :: Seed -> EnvironmentMap
milkyWay (Seed seed) = environmentMapFromDirections milkyWayRings (light . toGalactic)
  where
    light d@(XYZ c _ p)
      -- Less than a thousandth of the halo's light would come of more care.
      | abs p > 0.05 + 5.2 * width = scaleRadiance (halo p) warm
      | abs waver > 0.26 = scaleRadiance (glow + halo p) warm
      | otherwise =
        let lanes = perlin dust (dustMiddle ^+^ 5.3 *^ d)
            -- Sharp ridges where the noise crosses zero: filaments of dust.
            filaments = max 0 (1 - 5.5 * abs lanes)
            shade = max 0 (0.3 + 1.9 * perlin patches (patchMiddle ^+^ 4.1 *^ d))
            depth =
              1.9 * exp (-(square ((waver - 0.012) / 0.085))) * (0.4 + 0.6 * bulge + 0.35 * (1 + c))
                * (0.9 * shade + 0.7 * filaments * filaments)
         in reddened depth (scaleRadiance (glow + halo p) warm)
      where
        bulge = exp (-(1 - c) / 0.22)
        width = 0.07 + 0.06 * bulge
        -- Along the band the clouds swell and the plane wavers.
        swell = perlin clouds (cloudMiddle ^+^ 3.1 *^ d)
        waver = p + 0.05 * swell
        across = abs waver / width
        band = exp (negate (across * sqrt across))
        glow = (0.34 + 0.16 * c + 0.6 * bulge) * band * exp (1.6 * swell)
    square v = v * v
    -- The light of the old stars of the disk, some 4900 K.
    warm = Radiance 1 0.81 0.6
    halo p = 0.035 * exp (negate (abs p / 0.4))
    -- Dust takes more of the blue light than of the red one.
    reddened depth (Radiance r g b) =
      Radiance (r * exp (-(0.8 * depth))) (g * exp (-depth)) (b * exp (-(1.25 * depth)))
    perlin noise = cachedPerlin3 noise 9
    clouds = table 0 3 cloudMiddle 3.1
    dust = table 1 4 dustMiddle 5.3
    patches = table 2 3 patchMiddle 4.1
    -- For the ball that is asked for.
    table n count (XYZ x y z) radius =
      cacheNoise
        100000
        (Seed (seed + n))
        (normalised (octaves unitLevel count 0.55))
        (XYZ (x - radius) (y - radius) (z - radius))
        (XYZ (x + radius) (y + radius) (z + radius))
    cloudMiddle = offset 3.37
    dustMiddle = offset 1.71
    patchMiddle = offset 7.13
    -- Off the lattice points in which all octaves vanish.
    offset v = XYZ v (0.77 * v) (-(0.59 * v))

-- | Rings of the image: fields of 0.56°. The finest dust is 2.5 fields wide.
milkyWayRings :: Int
milkyWayRings = 320
