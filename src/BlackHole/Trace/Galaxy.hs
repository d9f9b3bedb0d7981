-- | How our galaxy lies in the sky of the scene: tilted against the disk, with
-- its bright middle not far from straight behind the hole for the camera of the
-- default scene.
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

-- | The direction to the middle of the galaxy (unit length).
galacticCentre :: XYZ
galacticCentre = unit (XYZ 0.12 0.2 (-1))

-- | The direction at right angles to the galaxy's plane (unit length).
galacticPole :: XYZ
galacticPole = unit (towards ^-^ XYZ.dot towards galacticCentre *^ galacticCentre)
  where
    towards = XYZ 0.85 0.35 0.1

-- | The third axis, along the plane.
galacticEast :: XYZ
galacticEast = XYZ.cross galacticPole galacticCentre

-- | From galactic coordinates (towards the middle, along the plane, towards the
-- pole) to the scene's.
fromGalactic :: XYZ -> XYZ
fromGalactic (XYZ c e p) = c *^ galacticCentre ^+^ e *^ galacticEast ^+^ p *^ galacticPole

-- | The inverse of 'fromGalactic'.
toGalactic :: XYZ -> XYZ
toGalactic d = XYZ (XYZ.dot d galacticCentre) (XYZ.dot d galacticEast) (XYZ.dot d galacticPole)

unit :: XYZ -> XYZ
unit v = fromMaybe v (XYZ.normalize v)
