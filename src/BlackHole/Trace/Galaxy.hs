-- | How the galaxy lies in the sky of the scene: for a camera that looks at the hole
-- from a little above the disk, at azimuth 90°, the Milky Way rises on the right of the
-- hole, opposite to the side of the disk that approaches, with the galactic centre at
-- the upper right. North is on the left, as seen from inside: nothing is mirrored.
module BlackHole.Trace.Galaxy
  ( galacticPole,
    galacticCentre,
    fromGalactic,
    toGalactic,
  )
where

import BlackHole.Vector.XYZ (XYZ (..), (*^), (^+^), (^-^))
import qualified BlackHole.Vector.XYZ as XYZ
import Data.Maybe (fromMaybe)

-- | The direction to the galactic centre (unit length).
galacticCentre :: XYZ
galacticCentre = unit (XYZ 0.22 (-0.009) (-1))

-- | The direction of the north galactic pole (unit length).
galacticPole :: XYZ
galacticPole = unit (towards ^-^ XYZ.dot towards galacticCentre *^ galacticCentre)
  where
    towards = XYZ (-0.974) 0.191 (-0.213)

-- | The third axis, in the plane, at longitude 90°.
galacticEast :: XYZ
galacticEast = XYZ.cross galacticPole galacticCentre

-- | A direction of the scene from its galactic components: towards the centre, towards
-- longitude 90° in the plane, and towards the north pole.
fromGalactic :: XYZ -> XYZ
fromGalactic (XYZ c e p) = c *^ galacticCentre ^+^ e *^ galacticEast ^+^ p *^ galacticPole

-- | The inverse of 'fromGalactic'.
toGalactic :: XYZ -> XYZ
toGalactic d = XYZ (XYZ.dot d galacticCentre) (XYZ.dot d galacticEast) (XYZ.dot d galacticPole)

unit :: XYZ -> XYZ
unit v = fromMaybe v (XYZ.normalize v)
