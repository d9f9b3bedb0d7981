-- | A sky with a checkerboard, which makes visible how the hole distorts the sky.
module BlackHole.Trace.Grid (gridRadiance) where

import BlackHole.Light.Radiance
import BlackHole.Vector.XYZ (XYZ (..))

-- | The radiance in this direction: squares of 10° in longitude and latitude, warm on
-- the disk's upper side and cool on its lower side.
gridRadiance :: XYZ -> Radiance
gridRadiance (XYZ x y z)
  | y >= 0 = scaleRadiance shade (Radiance 1 0.6 0.25)
  | otherwise = scaleRadiance shade (Radiance 0.25 0.6 1)
  where
    -- The set of borders that a direction has passed determines its square, without
    -- computing an angle. The grid is symmetric about the coordinate planes, which are
    -- borders, and about the planes midway between +x and ±z, which are not.
    shade = if even (signs + meridians + parallels) then 0.8 else 0.15
    signs = passed x 0 + passed y 0 + passed z 0
    meridians =
      passed (tan10 * far) near + passed (tan20 * far) near + passed (tan30 * far) near
        + passed (tan40 * far) near
    far = max (abs x) (abs z)
    near = min (abs x) (abs z)
    parallels
      | abs y < sin40 = passed sin10 (abs y) + passed sin20 (abs y) + passed sin30 (abs y)
      | otherwise =
        4 + passed sin50 (abs y) + passed sin60 (abs y) + passed sin70 (abs y)
          + passed sin80 (abs y)
    passed border v = if v > border then 1 else 0 :: Int

tan10, tan20, tan30, tan40 :: Double
tan10 = 0.17632698070846498
tan20 = 0.36397023426620234
tan30 = 0.5773502691896257
tan40 = 0.8390996311772799

sin10, sin20, sin30, sin40, sin50, sin60, sin70, sin80 :: Double
sin10 = 0.17364817766693033
sin20 = 0.3420201433256687
sin30 = 0.5
sin40 = 0.6427876096865393
sin50 = 0.766044443118978
sin60 = 0.8660254037844386
sin70 = 0.9396926207859083
sin80 = 0.984807753012208
