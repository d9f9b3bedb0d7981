-- | World lines of observers on geodesics: their position when their own clock shows a given
-- time, in any of the spacetimes. In flat space the observers move as around a hole
-- without spin.
module BlackHole.Spacetime.WorldLine
  ( fallTime,
    fallRadius,
    orbitPhase,
  )
where

import BlackHole.Spacetime.Kerr.WorldLine
import BlackHole.Spacetime.Schwarzschild.FreeFall
import BlackHole.Spacetime.Types

-- | @fallTime space cosine from to@ is the proper time in r_s\/c that an observer who
-- falls from rest at infinity, at this cosine of the polar angle, takes between two radii,
-- of which the first is the greater.
fallTime :: Spacetime -> Double -> Double -> Double -> Double
fallTime space cosine = case space of
  Kerr hole -> kerrInfallTime hole cosine
  _ -> infallTime

-- | @fallRadius space cosine from time@ is the radius of that observer after a proper time
-- since a radius; 'Nothing' once the observer has reached the centre.
fallRadius :: Spacetime -> Double -> Double -> Double -> Maybe Double
fallRadius space cosine = case space of
  Kerr hole -> kerrInfallRadius hole cosine
  _ -> infallRadius

-- | @orbitPhase space r time@ is the angle in radians by which an observer on the
-- right-handed circular geodesic in the disk's plane has turned after a proper time;
-- 'Nothing' where there is no such geodesic.
orbitPhase :: Spacetime -> Double -> Double -> Maybe Double
orbitPhase space = case space of
  Kerr hole -> kerrOrbitalPhase hole
  _ -> orbitalPhase
