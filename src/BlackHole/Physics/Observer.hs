{-# LANGUAGE BangPatterns #-}

-- | Observers: how the directions they see become light paths, and how their motion and
-- position shift the frequency of light.
--
-- Directions refer to the observer's own orthonormal frame, written in the Cartesian
-- components of pseudo-space: the radial unit vector is @x/r@, and the azimuthal one is
-- that of the right-handed rotation about @+y@. Formulas: Misner, Thorne and Wheeler
-- 1973, /Gravitation/, §25 and box 31.2.
module BlackHole.Physics.Observer
  ( Observer (..),
    observerName,
    observerRange,
    SightLine (..),
    Eye,
    eye,
    eyePlace,
    sightFrom,
    sightLine,
  )
where

import BlackHole.Physics.Photon
import BlackHole.Physics.Spacetime (Spacetime (..))
import BlackHole.Vector.XYZ (XYZ (..), (*^), (^+^), (^-^))
import qualified BlackHole.Vector.XYZ as XYZ
import Data.Maybe (fromMaybe)
import GHC.Exts (lazy)

-- | The motion of the observer.
data Observer
  = -- | At rest, hovering on rockets.
    Static
  | -- | On the circular geodesic through the observer's position, right-handed about
    -- the axis through the hole that lies closest to @+y@.
    Orbiting
  | -- | Falling straight in from rest at infinity.
    Falling
  | -- | The camera of the design report (Will Yager, "Accurately Rendering a Black
    -- Hole"), which corresponds to no physical observer. It interprets directions as
    -- coordinate directions, which makes the hole appear too large, and it does not
    -- shift light.
    Coordinate
  deriving (Eq, Show, Read, Enum, Bounded)

-- | The observer's name on the command line.
observerName :: Observer -> String
observerName observer = case observer of
  Static -> "static"
  Orbiting -> "orbiting"
  Falling -> "falling"
  Coordinate -> "coordinate"

-- | The radius above which such an observer can exist.
observerRange :: Spacetime -> Observer -> Double
observerRange Flat _ = 1
observerRange Schwarzschild observer = case observer of
  Static -> 1
  Orbiting -> 1.5
  Falling -> 0
  Coordinate -> 1

-- | One line of sight.
data SightLine = SightLine
  { -- | The photon to follow backwards, of unit energy.
    sightPhoton :: !Photon,
    -- | Frequency seen by the observer over the frequency at infinity. This factor
    -- shifts the light of the sky.
    sightFrequency :: {-# UNPACK #-} !Double
  }
  deriving (Eq, Show)

-- | An observer at a position, prepared with everything that all lines of sight share.
data Eye = Eye
  { _eyeKind :: !EyeKind,
    -- | The observer's position.
    eyePlace :: {-# UNPACK #-} !XYZ,
    -- | Unit vector away from the hole.
    _eyeRadial :: {-# UNPACK #-} !XYZ,
    -- | √(1 − 1/r).
    _eyeDilation :: {-# UNPACK #-} !Double,
    -- | √(1/r), the speed of an observer who falls in from rest at infinity.
    _eyeInfall :: {-# UNPACK #-} !Double,
    -- | The direction of circular motion, and its speed relative to the static
    -- observer.
    _eyeAzimuthal :: {-# UNPACK #-} !XYZ,
    _eyeSpeed :: {-# UNPACK #-} !Double
  }

-- | How directions become paths.
data EyeKind
  = -- | No such observer can exist there.
    Nobody
  | -- | Space without gravity.
    InFlatSpace
  | Near !Observer

-- | Prepares an observer at a position for 'sightFrom'.
eye :: Spacetime -> Observer -> XYZ -> Eye
eye space observer place = Eye kind place radial (sqrt (1 - 1 / r)) (sqrt (1 / r)) (orbitDirection radial) (sqrt (1 / (2 * (r - 1))))
  where
    r = XYZ.norm place
    radial = (1 / r) *^ place
    kind = case space of
      Flat -> InFlatSpace
      Schwarzschild
        | r <= observerRange Schwarzschild observer || isNaN r -> Nobody
        | otherwise -> Near observer

-- | @sightLine space observer place = 'sightFrom' ('eye' space observer place)@.
sightLine :: Spacetime -> Observer -> XYZ -> XYZ -> Maybe SightLine
sightLine space observer place = sightFrom (eye space observer place)

-- | The light path that the observer sees in a direction (of unit length, pointing away
-- from the observer). 'Nothing' if no light from outside arrives along it, which
-- happens inside the horizon, or if no such observer exists ('observerRange').
sightFrom :: Eye -> XYZ -> Maybe SightLine
sightFrom prepared !direction = case kind of
  Nobody -> Nothing
  InFlatSpace -> XYZ.normalize direction >>= \d -> along (Photon place d) 1
  Near Coordinate -> withUnitEnergy (Photon place direction) >>= \photon -> along photon 1
  Near Static -> static direction
  Near Orbiting ->
    -- The light moves along −direction, so the momentum to boost back into the static
    -- frame is −direction. Its reverse is the direction seen there.
    let forwards = XYZ.dot azimuthal direction
        -- Frequency in the static frame of light that has frequency one here.
        frequency = gamma * (1 - speed * forwards)
        momentum = direction ^+^ ((gamma - 1) * forwards - gamma * speed) *^ azimuthal
     in static ((1 / frequency) *^ momentum) >>= \(SightLine photon shift) -> along photon (shift / frequency)
  Near Falling -> fromEnergy (1 + infall * XYZ.dot radial direction) (direction ^+^ infall *^ radial)
  where
    -- Makes GHC pass the components of the direction one by one instead of those of the
    -- prepared observer, so that no direction is allocated.
    Eye kind place radial dilation infall azimuthal speed = lazy prepared
    gamma = 1 / sqrt (1 - speed * speed)
    along photon shift = Just $! SightLine photon shift
    -- Light of frequency one for the observer has this energy at infinity and this
    -- pseudo-velocity. Scale both to unit energy.
    fromEnergy energy velocity
      | energy > 0 = along (Photon place ((1 / energy) *^ velocity)) (1 / energy)
      | otherwise = Nothing
    -- The static observer's radial unit of length is shorter than the coordinate's, so
    -- only the radial component of a direction changes.
    static d = fromEnergy dilation (d ^-^ ((1 - dilation) * XYZ.dot radial d) *^ radial)

-- | The direction of circular motion: right-handed about @+y@. Over the poles, where it
-- is undefined, @+x@.
orbitDirection :: XYZ -> XYZ
orbitDirection radial =
  fromMaybe (XYZ 1 0 0) (XYZ.normalize (XYZ.cross (XYZ 0 1 0) radial))
